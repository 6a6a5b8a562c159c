// The pointer over the lines of a block.
#pragma once

#include "widgets/working/blank_fields.h"
#include "widgets/working/coordinate_input.h"
#include "widgets/working/line_cursor.h"

class QHelpEvent;

namespace halfspace {

/// Takes the mouse's events of a block before the block itself does. The pointer is on marks and numbers; a
/// click on a number asks for its trace, one that is a coordinate can be scrubbed, and typed after a double
/// click.
class BlockPointer : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  BlockPointer(QWidget &block, const BlockLayout &layout, LineCursor &cursor, BlankFields &blanks,
               CoordinateInput &coordinates);

  /// The number that the pointer is on, if it is on one.
  [[nodiscard]] const std::optional<NumberPlace> &hovered() const { return m_hoveredNumber; }

signals:
  void markHovered(const QString &markId); ///< empty: the pointer is on none any more
  void traceRequested(const halfspace::NumberPlace &number);
  void traceDropped();

protected:
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  void move(const QMouseEvent &event);
  void press(const QMouseEvent &event);
  void pressNumber(const NumberPlace &number, const QMouseEvent &event);
  void release(const QMouseEvent &event);
  void doubleClick(const QMouseEvent &event);
  void hoverMark(const QString &markId);
  void hoverNumber(std::optional<NumberPlace> number);
  void showTip(const QHelpEvent &event);

  QWidget &m_block;
  const BlockLayout &m_layout;
  LineCursor &m_cursor;
  BlankFields &m_blanks;
  CoordinateInput &m_coordinates;
  QString m_hoveredMark;
  std::optional<NumberPlace> m_hoveredNumber;
  std::optional<NumberPlace> m_pressed; ///< until the button is up, or its scrub ends
};

} // namespace halfspace
