// The flat picture beside the scene: the same marks, seen from the one side from which their shapes are true.
#pragma once

#include "widgets/picture/flat_picture.h"
#include "widgets/picture/hand/flat_drag.h"
#include "widgets/session_model.h"
#include "widgets/typeset/flat_painter.h"

#include <QFrame>

class QAction;
class QToolButton;

namespace halfspace {

/// Lies over the scene's corner in lessons that have such a picture, and in no others. Folded, or in a very
/// small window, only its title is left.
class FlatView : public QFrame {
  Q_OBJECT
public:
  FlatView(SessionModel &model, const Typesetter &typesetter, QWidget *parent = nullptr);

  void setTheme(const Theme &theme);
  /// Makes type and lines larger; 1 is their usual size.
  void setSizeScale(double scale);
  /// The marks that stand out. Which one is hovered is only told: see markHovered.
  void setHighlighted(const std::set<std::string> &markIds);

  /// Whether the open lesson has a flat picture, and its scene what that is made of.
  [[nodiscard]] bool hasPicture() const { return m_picture.has_value(); }
  /// Nothing where it has none.
  [[nodiscard]] const std::optional<FlatPicture> &picture() const { return m_picture; }
  /// Checked while the picture is unfolded.
  [[nodiscard]] QAction &unfolded() { return *m_unfolded; }
  /// What it takes of so much room.
  [[nodiscard]] QSize sizeIn(const QSize &room) const;

  /// What is drawn now, while it has a picture, and from where.
  [[nodiscard]] const Figure &figure() const { return m_picture->figure(); }
  [[nodiscard]] const View &view() const { return m_view; }

signals:
  void markHovered(const QString &markId); ///< empty: none
  void handleGrabbed(const QString &handleId);
  void sizeChanged(); ///< it comes, goes, folds or unfolds

protected:
  void paintEvent(QPaintEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  void mouseMoveEvent(QMouseEvent *event) override;
  void mouseReleaseEvent(QMouseEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void leaveEvent(QEvent *event) override;

private:
  /// Whether there is more of it than its title: unfolded, and not too little room for that.
  [[nodiscard]] bool isOpen() const;
  void takeOutcome();
  void takePicture();
  void fit();
  /// The handle at a pixel that can be moved there; nothing for none.
  [[nodiscard]] std::optional<Handle> handleAt(glm::dvec2 pixel) const;
  void hover(const std::string &mark);
  void letGo();

  SessionModel &m_model;
  FlatPainter m_painter;
  Theme m_theme;
  double m_sizeScale = 1;
  std::optional<FlatPicture> m_picture;
  View m_view;
  std::set<std::string> m_highlighted;
  std::string m_hovered; ///< a mark's id
  std::optional<FlatDrag> m_drag;
  GestureToken m_held = GestureToken::Nobodys; ///< the model's gesture
  QAction *m_unfolded;
  QToolButton *m_title;
};

} // namespace halfspace
