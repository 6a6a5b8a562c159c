#include "widgets/view/letter_room.h"

#include "widgets/text/indices.h"

namespace halfspace {

LetterRoom::LetterRoom(const char *name, QWidget *parent) : WrappedLabel(name, parent) {
  setTextFormat(Qt::RichText);
  hide();
  ensurePolished(); // what is never shown has no style else
}

void LetterRoom::setLetters(int letters, int rows) {
  const QString word = QStringLiteral("letter_s ");
  const QString row = richTextOf(word.repeated(letters / rows / static_cast<int>(word.size())).trimmed());
  setText(row + (QStringLiteral("<br>") + row).repeated(rows - 1));
  forgetHeight();
}

} // namespace halfspace
