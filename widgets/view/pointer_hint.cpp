#include "widgets/view/pointer_hint.h"

#include <QFontMetrics>

#include <algorithm>

namespace halfspace {
namespace {

/// So far right of and below the pointer, in pixels: its arrow, or its cross, does not cover them.
constexpr int besidePointer = 16;
/// A row has about so many letters at most.
constexpr int lettersInRow = 36;
constexpr int edge = 5;

} // namespace

PointerHint::PointerHint(QWidget &over) : QLabel(&over) {
  setObjectName("pointer-hint");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setTextFormat(Qt::PlainText);
  setMargin(edge);
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  setForegroundRole(QPalette::ToolTipText);
  hide();
}

void PointerHint::showAt(const QPoint &place, const QString &words) {
  if (words.isEmpty())
    return hide();
  setText(words);
  const QFontMetrics letters = fontMetrics();
  const int row = letters.averageCharWidth() * lettersInRow;
  setWordWrap(letters.horizontalAdvance(words) > row);
  const int width = wordWrap() ? row + 2 * (edge + frameWidth()) : sizeHint().width();
  resize(width, wordWrap() ? heightForWidth(width) : sizeHint().height());
  const QSize room = parentWidget()->size() - size();
  // Where there is no room on that side it stands on the other.
  const auto beside = [](int at, int length, int most) {
    return at + besidePointer <= most ? at + besidePointer : std::max(0, at - besidePointer - length);
  };
  move(beside(place.x(), this->width(), room.width()), beside(place.y(), height(), room.height()));
  show();
  raise();
}

} // namespace halfspace
