#include "widgets/working/block_pointer.h"

#include "widgets/numbers/number_words.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <utility>

namespace halfspace {

BlockPointer::BlockPointer(QWidget &block, const BlockLayout &layout, LineCursor &cursor, BlankFields &blanks,
                           CoordinateInput &coordinates)
    : m_block(block), m_layout(layout), m_cursor(cursor), m_blanks(blanks), m_coordinates(coordinates) {
  block.setMouseTracking(true);
  block.installEventFilter(this);
  // What was scrubbed was not clicked, even if the button goes up over it.
  connect(&coordinates, &CoordinateInput::scrubEnded, this, [this] { m_pressed.reset(); });
}

bool BlockPointer::eventFilter(QObject *watched, QEvent *event) {
  switch (event->type()) {
  case QEvent::MouseMove:
    move(static_cast<const QMouseEvent &>(*event));
    return true;
  case QEvent::MouseButtonPress:
    press(static_cast<const QMouseEvent &>(*event));
    return true;
  case QEvent::MouseButtonRelease:
    release(static_cast<const QMouseEvent &>(*event));
    return true;
  case QEvent::MouseButtonDblClick:
    doubleClick(static_cast<const QMouseEvent &>(*event));
    return true;
  case QEvent::ToolTip:
    showTip(static_cast<const QHelpEvent &>(*event));
    return true;
  case QEvent::Leave:
    hoverMark({});
    hoverNumber({});
    [[fallthrough]];
  default:
    return QObject::eventFilter(watched, event);
  }
}

void BlockPointer::move(const QMouseEvent &event) {
  if (m_coordinates.isPressed())
    return m_coordinates.move(event); // wherever the number goes
  const QPointF position = QPointF(event.pos());
  hoverMark(m_layout.markAt(position));
  hoverNumber(m_layout.numbers().at(position));
}

void BlockPointer::press(const QMouseEvent &event) {
  const QPointF position = QPointF(event.pos());
  if (event.button() == Qt::LeftButton) {
    if (const auto number = m_layout.numbers().at(position))
      return pressNumber(*number, event);
    emit traceDropped();
  }
  m_cursor.goTo(m_layout.lineAt(position));
  if (m_cursor.line())
    m_blanks.focusIn(*m_cursor.line());
}

void BlockPointer::pressNumber(const NumberPlace &number, const QMouseEvent &event) {
  m_pressed = number;
  m_cursor.goToLineOf(number);
  if (number.coordinate())
    m_coordinates.press(*number.coordinate(), event);
}

void BlockPointer::release(const QMouseEvent &event) {
  if (event.button() != Qt::LeftButton || !m_pressed)
    return;
  const NumberPlace pressed = *std::exchange(m_pressed, {});
  const bool wasScrubbed = m_coordinates.isScrubbing();
  m_coordinates.endScrub(true);
  if (!wasScrubbed && m_layout.numbers().at(QPointF(event.pos())) == pressed)
    emit traceRequested(pressed);
}

void BlockPointer::doubleClick(const QMouseEvent &event) {
  const auto number =
      event.button() == Qt::LeftButton ? m_layout.numbers().at(QPointF(event.pos())) : std::nullopt;
  if (number && number->coordinate())
    m_coordinates.openField(*number);
  else
    press(event);
}

void BlockPointer::hoverMark(const QString &markId) {
  if (markId == m_hoveredMark)
    return;
  m_hoveredMark = markId;
  emit markHovered(markId);
}

void BlockPointer::hoverNumber(std::optional<NumberPlace> number) {
  if (number == m_hoveredNumber)
    return;
  m_hoveredNumber = std::move(number);
  if (!m_hoveredNumber)
    m_block.unsetCursor();
  else
    m_block.setCursor(m_hoveredNumber->coordinate() ? Qt::SizeHorCursor : Qt::PointingHandCursor);
  m_block.update();
}

void BlockPointer::showTip(const QHelpEvent &event) {
  const auto place = m_layout.numbers().at(QPointF(event.pos()));
  const Term *number = place ? m_layout.numbers().numberAt(*place) : nullptr;
  if (number)
    QToolTip::showText(m_block.mapToGlobal(event.pos()), tipOf(*number).toHtmlEscaped(), &m_block);
  else
    QToolTip::hideText();
}

} // namespace halfspace
