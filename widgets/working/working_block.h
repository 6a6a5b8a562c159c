// Worked lines where they stand on the page.
#pragma once

#include "widgets/when_seen.h"
#include "widgets/working/block_pointer.h"
#include "widgets/working/paint_lines.h"

namespace halfspace {

/// Shows lines of a step's working as a textbook would: formulas, their numbers, a sentence. It is as tall as
/// they need. It is put together from parts that have one task each: its layout, the pointer and the keys in
/// it, the fields of blank lines, and coordinates that are changed where they stand.
class WorkingBlock : public QWidget {
  Q_OBJECT
public:
  /// The typesetter must outlive the block.
  explicit WorkingBlock(const Typesetter &typesetter, QWidget *parent = nullptr);

  /// Shows some of a step's lines, some of them with a field for what is left out, and what is said about
  /// some.
  void setWorking(const Working &working, Fade fade = {}, LineRemarks remarks = {}, LineRange shown = {});
  /// While lines are held each keeps the height that it has had: what is dragged moves nothing else.
  void setHeld(bool held);
  void setLook(const WorkingLook &look);
  void setTrace(ShownTrace trace);

  /// The fields of the lines that leave something out.
  [[nodiscard]] BlankFields &blanks() { return m_blanks; }
  /// Coordinates that are scrubbed and typed in the lines.
  [[nodiscard]] CoordinateInput &coordinates() { return m_coordinates; }
  /// Where the keys are.
  [[nodiscard]] LineCursor &keys() { return m_cursor; }

  /// The numbers that can be touched.
  [[nodiscard]] ShownNumbers shownNumbers() const { return m_layout.numbers(); }
  /// What is shown and where.
  [[nodiscard]] const PlacedWorking &placed() const { return m_layout.placed(); }
  /// The lines as they may be taken elsewhere, until others are shown.
  [[nodiscard]] std::vector<ToldLine> toldLines() const { return m_lines.told(); }
  /// What a screen reader is told when it asks: the lines, one below the other; the number that the keys have
  /// chosen, if they have.
  [[nodiscard]] QString spoken() const;

  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  /// As narrow as its formulas can be made.
  [[nodiscard]] QSize minimumSizeHint() const override;

signals:
  /// The pointer is on a term of this mark, or (empty) on none.
  void markHovered(const QString &markId);
  /// The learner wants to see where a number comes from …
  void traceRequested(const halfspace::NumberPlace &number);
  /// … and no longer.
  void traceDropped();
  /// The keys have come to this place: it is to be in view.
  void reached(const QRect &place);

protected:
  void paintEvent(QPaintEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  bool event(QEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;

private:
  void connectParts();
  void showLines();
  void placeLines();

  const Typesetter &m_typesetter;
  WorkingLook m_look;
  ShownTrace m_trace;
  ShownLines m_lines;
  LineRemarks m_remarks;
  BlockLayout m_layout;
  LineCursor m_cursor{*this, m_layout};
  BlankFields m_blanks{*this, m_layout};
  CoordinateInput m_coordinates{*this, m_layout};
  BlockPointer m_pointer{*this, m_layout, m_cursor, m_blanks, m_coordinates};
  WhenSeen m_typeset{*this, [this] { showLines(); }};
};

} // namespace halfspace
