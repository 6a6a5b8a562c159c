// What the pointer and the keys do in the lines.
#include "widgets/working/blank_field.h"
#include "widgets/working/working_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QScrollBar>

#include <algorithm>
#include <cmath>

namespace halfspace {

void WorkingPanel::resizeEvent(QResizeEvent *) { placeLines(); }

void WorkingPanel::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange)
    showLines(m_working); // the room of fields depends on it
  QAbstractScrollArea::changeEvent(event);
}

void WorkingPanel::mouseMoveEvent(QMouseEvent *event) {
  if (m_scrub.isPressed())
    return m_scrub.move(*event); // wherever the number goes
  const QPointF position = QPointF(event->pos()) + scrolled();
  hover(markAt(position));
  hoverNumber(shownNumbers().at(position));
}

void WorkingPanel::mousePressEvent(QMouseEvent *event) {
  const QPointF position = QPointF(event->pos()) + scrolled();
  if (event->button() == Qt::LeftButton) {
    if (const auto number = shownNumbers().at(position))
      return pressNumber(*number, *event);
    endTrace();
  }
  setCurrentLine(lineAt(position));
  if (const auto field = m_current ? m_fields.find(m_lines[*m_current].source.id) : m_fields.end();
      field != m_fields.end())
    field->second->setFocus();
}

void WorkingPanel::mouseReleaseEvent(QMouseEvent *event) {
  if (event->button() != Qt::LeftButton || !m_pressedNumber)
    return;
  const NumberPlace pressed = *std::exchange(m_pressedNumber, {});
  const bool wasScrubbed = m_scrub.isScrubbing();
  m_scrub.end(true);
  if (!wasScrubbed && shownNumbers().at(QPointF(event->pos()) + scrolled()) == pressed)
    trace(pressed);
}

void WorkingPanel::mouseDoubleClickEvent(QMouseEvent *event) {
  const auto number = event->button() == Qt::LeftButton
                          ? shownNumbers().at(QPointF(event->pos()) + scrolled())
                          : std::nullopt;
  if (number && number->coordinate())
    openNumberField(*number);
  else
    mousePressEvent(event);
}

bool WorkingPanel::viewportEvent(QEvent *event) {
  if (event->type() == QEvent::Leave) {
    hover({});
    hoverNumber({});
  }
  if (event->type() == QEvent::ToolTip) {
    showTip(static_cast<QHelpEvent *>(event)->pos());
    return true;
  }
  return QAbstractScrollArea::viewportEvent(event);
}

void WorkingPanel::hover(const QString &markId) {
  if (markId == m_hovered)
    return;
  m_hovered = markId;
  emit markHovered(markId);
}

void WorkingPanel::setCurrentLine(std::optional<std::size_t> line) {
  m_current = line;
  if (m_chosenNumber) {
    m_chosenNumber.reset();
    updateAccessibleText();
  }
  if (line)
    scrollTo(m_placed.lines[*line].box);
  viewport()->update();
}

void WorkingPanel::scrollTo(const QRectF &box) {
  QScrollBar &bar = *verticalScrollBar();
  const int lowest = static_cast<int>(std::ceil(box.bottom())) - viewport()->height();
  bar.setValue(std::min(std::max(bar.value(), lowest), static_cast<int>(box.top())));
}

void WorkingPanel::keyPressEvent(QKeyEvent *event) {
  if (event->matches(QKeySequence::Copy))
    copy(m_current ? latexOf(m_lines[*m_current].source) : latexOfAll());
  else if (!stepByKey(event->key()))
    QAbstractScrollArea::keyPressEvent(event);
}

bool WorkingPanel::stepByKey(int key) {
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
    endTrace();
    return hadSomething;
  }
  default:
    return false;
  }
}

bool WorkingPanel::stepLine(int way) {
  if (m_lines.empty())
    return false;
  const std::size_t last = m_lines.size() - 1;
  if (way > 0)
    setCurrentLine(m_current ? std::min(*m_current + 1, last) : 0);
  else
    setCurrentLine(m_current && *m_current > 0 ? *m_current - 1 : 0);
  return true;
}

void WorkingPanel::contextMenuEvent(QContextMenuEvent *event) {
  if (m_lines.empty())
    return;
  const auto line = lineAt(viewport()->mapFromGlobal(event->globalPos()) + scrolled());
  QMenu menu(this);
  // The lines may change while the menu is open.
  if (line)
    menu.addAction(tr("Copy this line as LaTeX"), this,
                   [this, latex = latexOf(m_lines[*line].source)] { copy(latex); });
  menu.addAction(tr("Copy all lines as LaTeX"), this, [this] { copy(latexOfAll()); });
  menu.exec(event->globalPos());
}

void WorkingPanel::copy(const QString &text) const { QApplication::clipboard()->setText(text); }

} // namespace halfspace
