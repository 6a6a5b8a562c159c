#include "widgets/explore/entry_field.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace halfspace {
namespace {

// Of the wavy line, in pixels.
constexpr double waveLength = 5;
constexpr double waveHeight = 2;
constexpr double waveWidth = 1.3;

QPainterPath waves(double from, double to, double height) {
  QPainterPath path({from, height});
  bool isUp = true;
  for (double x = from; x < to; x += waveLength / 2, isUp = !isUp)
    path.lineTo(x + waveLength / 2, height + (isUp ? -waveHeight : 0));
  return path;
}

} // namespace

EntryField::EntryField(QWidget *parent) : QLineEdit(parent) {
  connect(this, &QLineEdit::textChanged, this, [this] { setFault({}); });
}

void EntryField::setFault(const std::optional<Part> &part) {
  m_fault = part;
  update();
}

bool EntryField::event(QEvent *event) {
  // What is undone is the scene where nothing was typed: the key is left to the menu.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto &key = static_cast<const QKeyEvent &>(*event);
    if ((key.matches(QKeySequence::Undo) && !isUndoAvailable()) ||
        (key.matches(QKeySequence::Redo) && !isRedoAvailable())) {
      event->ignore();
      return true;
    }
  }
  // Before Tab leads to the next widget, and before Escape and Enter reach shortcuts.
  if (event->type() == QEvent::KeyPress) {
    const auto &key = static_cast<const QKeyEvent &>(*event);
    if (key.matches(QKeySequence::Paste) && QGuiApplication::clipboard()->text().trimmed().contains('\n')) {
      emit linesPasted(QGuiApplication::clipboard()->text());
      return true;
    }
    const bool isPlain = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    if (isPlain && takeKey(key.key()))
      return true;
  }
  return QLineEdit::event(event);
}

bool EntryField::takeKey(int key) {
  switch (key) {
  case Qt::Key_Up:
    emit stepped(-1);
    return true;
  case Qt::Key_Down:
    emit stepped(1);
    return true;
  case Qt::Key_Tab:
    if (m_canComplete)
      emit completing();
    return m_canComplete;
  case Qt::Key_Return:
  case Qt::Key_Enter:
    emit entering();
    return true;
  case Qt::Key_Escape:
    emit dismissed();
    return true;
  default:
    return false;
  }
}

double EntryField::placeOf(int character) const {
  const QFontMetricsF type(font());
  const double fromCursor =
      type.horizontalAdvance(text().left(character)) - type.horizontalAdvance(text().left(cursorPosition()));
  return cursorRect().center().x() + fromCursor;
}

void EntryField::focusOutEvent(QFocusEvent *event) {
  m_canComplete = false; // suggestions go with the focus
  QLineEdit::focusOutEvent(event);
}

void EntryField::paintEvent(QPaintEvent *event) {
  QLineEdit::paintEvent(event);
  if (!m_fault)
    return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(m_faultInk, waveWidth));
  const double from = placeOf(m_fault->begin);
  const double to = std::max(placeOf(m_fault->begin + m_fault->length), from + 2 * waveLength);
  painter.drawPath(waves(from, to, cursorRect().bottom()));
}

} // namespace halfspace
