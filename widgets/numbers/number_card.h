// The numbers of the selected object, at the edge of the scene.
#pragma once

#include "widgets/numbers/coordinate_rows.h"

#include <QFrame>

class QLabel;

namespace halfspace {

class FlowLayout;

/// Fields for the coordinates of what is selected, and below them what can be done with it. It follows the
/// session; what is not there any more is not shown. Without a selection it is a line of words.
class NumberCard : public QFrame {
  Q_OBJECT
public:
  NumberCard(SessionModel &model, const Typesetter &typesetter, QWidget *parent = nullptr);
  ~NumberCard() override;

  /// Shows the object of this coordinate; only the coordinate itself where the object has many.
  void setSelection(const std::optional<CoordinateId> &selected);
  void setHint(const QString &words);
  void setTheme(const Theme &theme);

  /// The fields of what is selected.
  [[nodiscard]] CoordinateRows &given() { return m_given; }

  /// Of the card for an object of two coordinates, as a ray is.
  [[nodiscard]] QSize usualSize() const;
  /// With room for the whole hint, which is cut short where there is less.
  [[nodiscard]] QSize sizeHint() const override;

protected:
  void resizeEvent(QResizeEvent *event) override;

private:
  [[nodiscard]] std::vector<CoordinateId> shownCoordinates() const;
  void showSession();
  void build(const std::vector<CoordinateId> &ids);
  void showHint();
  void elideHint();

  SessionModel &m_model;
  CoordinateRows m_given;
  Theme m_theme;
  std::optional<CoordinateId> m_selected;
  QWidget *m_numbers;
  QLabel *m_complaint;
  QLabel *m_hintLabel;
  QString m_hint;
  int m_hintRoom = 0; ///< of the longest hint since the selection: in a drag the card keeps its width
};

} // namespace halfspace
