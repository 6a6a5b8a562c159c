// The fragments that a ray is held against, with its crossings of their planes.
#pragma once

#include "widgets/hit_table/paint_fragments.h"

#include <QStringList>
#include <QWidget>

namespace halfspace {

/// A row for each fragment: its name, where the ray's line crosses its plane, and a verdict in words. A rule
/// parts what lies behind the ray's start. It is told what to show and which row is chosen; a click, or a
/// key, only says which one is wanted.
class FragmentTable : public QWidget {
  Q_OBJECT
public:
  /// Further fragments are counted in a last line.
  static constexpr std::size_t mostRows = 14;

  /// The typesetter must outlive the table.
  explicit FragmentTable(const Typesetter &typesetter, QWidget *parent = nullptr);

  /// Hidden, while a question is open: neither numbers nor verdicts, nor an order that tells of them.
  void setCrossings(const Crossings &crossings, LiveValues values = LiveValues::Shown);
  /// The pointer is on this fragment somewhere else; 0 for none.
  void setHovered(std::size_t number);
  /// While it is held it becomes no lower.
  void setHeld(bool held);
  void setTheme(const Theme &theme);

  [[nodiscard]] const std::vector<FragmentRow> &rows() const { return m_shown.rows; }
  /// Where a row is, counted from 0 as they are shown.
  [[nodiscard]] QRect rowRect(std::size_t row) const;
  /// A row as it is read aloud.
  [[nodiscard]] QString spoken(std::size_t row) const;
  /// What the last line says of fragments without a row; empty where all have one.
  [[nodiscard]] QString leftOutWords() const;

  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

signals:
  void chosen(std::size_t number);
  void hovered(std::size_t number); ///< 0: none any more

protected:
  void paintEvent(QPaintEvent *event) override;
  void mouseMoveEvent(QMouseEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  void leaveEvent(QEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void focusInEvent(QFocusEvent *event) override;
  void changeEvent(QEvent *event) override;

private:
  void measure();
  void settleHeight();
  void sayChosen(); ///< by the table's accessible name
  void pointAt(std::size_t number);
  /// The number of the fragment at a place; 0 for none.
  [[nodiscard]] std::size_t numberAt(QPoint place) const;

  FragmentRows m_shown;
  QStringList m_names; ///< of all, so that the columns do not depend on which have a row
  FragmentNumbers m_numbers;
  Typesetter::Picture m_start;
  FragmentNeeds m_needs;
  std::size_t m_chosen = 0;
  std::size_t m_hovered = 0;
  LiveValues m_values = LiveValues::Shown;
  bool m_held = false;
  double m_lineCount = 0; ///< rows, and the last line where there is one; while held the most there were
  Theme m_theme;
};

} // namespace halfspace
