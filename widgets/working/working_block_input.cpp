// What the pointer and the keys do in the lines.
#include "widgets/working/blank_field.h"
#include "widgets/working/working_block.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>

namespace halfspace {

void WorkingBlock::resizeEvent(QResizeEvent *) {
  if (m_held)
    m_held->clear(); // in another width the lines have other heights
  placeLines();
}

void WorkingBlock::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange)
    showLines(m_working); // the room of fields depends on it
  QWidget::changeEvent(event);
}

void WorkingBlock::mouseMoveEvent(QMouseEvent *event) {
  if (m_scrub.isPressed())
    return m_scrub.move(*event); // wherever the number goes
  const QPointF position = QPointF(event->pos());
  hover(markAt(position));
  hoverNumber(shownNumbers().at(position));
}

void WorkingBlock::mousePressEvent(QMouseEvent *event) {
  const QPointF position = QPointF(event->pos());
  if (event->button() == Qt::LeftButton) {
    if (const auto number = shownNumbers().at(position))
      return pressNumber(*number, *event);
    emit traceDropped();
  }
  setCurrentLine(lineAt(position));
  if (const auto field = m_current ? m_fields.find(m_lines[*m_current].source.id) : m_fields.end();
      field != m_fields.end())
    field->second->setFocus();
}

void WorkingBlock::mouseReleaseEvent(QMouseEvent *event) {
  if (event->button() != Qt::LeftButton || !m_pressedNumber)
    return;
  const NumberPlace pressed = *std::exchange(m_pressedNumber, {});
  const bool wasScrubbed = m_scrub.isScrubbing();
  m_scrub.end(true);
  if (!wasScrubbed && shownNumbers().at(QPointF(event->pos())) == pressed)
    emit traceRequested(pressed);
}

void WorkingBlock::mouseDoubleClickEvent(QMouseEvent *event) {
  const auto number =
      event->button() == Qt::LeftButton ? shownNumbers().at(QPointF(event->pos())) : std::nullopt;
  if (number && number->coordinate())
    openNumberField(*number);
  else
    mousePressEvent(event);
}

void WorkingBlock::leaveEvent(QEvent *event) {
  hover({});
  hoverNumber({});
  QWidget::leaveEvent(event);
}

bool WorkingBlock::event(QEvent *event) {
  // A field has another size, or may have got one while nobody saw it, of which nothing is told.
  if ((event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show) && !m_fields.empty())
    showLines(m_working);
  if (event->type() != QEvent::ToolTip)
    return QWidget::event(event);
  showTip(static_cast<QHelpEvent *>(event)->pos());
  return true;
}

void WorkingBlock::hover(const QString &markId) {
  if (markId == m_hovered)
    return;
  m_hovered = markId;
  emit markHovered(markId);
}

void WorkingBlock::setCurrentLine(std::optional<std::size_t> line) {
  m_current = line;
  if (m_chosenNumber) {
    m_chosenNumber.reset();
    tellSpoken();
  }
  if (line)
    emit reached(m_placed.lines[*line].box.toAlignedRect());
  update();
}

void WorkingBlock::keyPressEvent(QKeyEvent *event) {
  if (event->matches(QKeySequence::Copy))
    copy(m_current ? latexOf(m_lines[*m_current].source) : latexOfAll());
  else if (!stepByKey(event->key()))
    QWidget::keyPressEvent(event);
}

bool WorkingBlock::stepByKey(int key) {
  if (m_scrub.isScrubbing()) {
    if (key == Qt::Key_Escape)
      m_scrub.end(false);
    return true; // the hand is at work
  }
  switch (key) {
  case Qt::Key_Down:
  case Qt::Key_Up:
    return stepLine(key == Qt::Key_Down ? 1 : -1);
  case Qt::Key_Right:
    return chooseBeside(1);
  case Qt::Key_Left:
    return chooseBeside(-1);
  case Qt::Key_Return:
  case Qt::Key_Enter:
    return useChosen();
  case Qt::Key_Escape: {
    const bool hadSomething = m_tracedNumber || m_chosenNumber;
    emit traceDropped();
    return hadSomething;
  }
  default:
    return false;
  }
}

bool WorkingBlock::stepLine(int way) {
  const std::size_t count = m_lines.size();
  const std::size_t next =
      !m_current ? (way > 0 ? 0 : count - 1) : *m_current + static_cast<std::size_t>(way);
  if (next >= count) // beyond the last, or before the first
    return m_goOn && m_goOn(way);
  setCurrentLine(next);
  return true;
}

bool WorkingBlock::comeIn(int way) {
  if (m_lines.empty())
    return false;
  setFocus();
  setCurrentLine(way > 0 ? 0 : m_lines.size() - 1);
  return true;
}

void WorkingBlock::contextMenuEvent(QContextMenuEvent *event) {
  if (m_lines.empty())
    return;
  const auto line = lineAt(event->pos());
  QMenu menu(this);
  // The lines may change while the menu is open.
  if (line)
    menu.addAction(tr("Copy this line as LaTeX"), this,
                   [this, latex = latexOf(m_lines[*line].source)] { copy(latex); });
  menu.addAction(tr("Copy these lines as LaTeX"), this, [this] { copy(latexOfAll()); });
  menu.exec(event->globalPos());
}

void WorkingBlock::copy(const QString &text) const { QApplication::clipboard()->setText(text); }

} // namespace halfspace
