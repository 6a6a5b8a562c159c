#include "widgets/view/letter_room.h"

#include "widgets/text/indices.h"

#include <QEvent>

namespace halfspace {

LetterRoom::LetterRoom(const char *name, QWidget *parent) : QLabel(parent) {
  setObjectName(name);
  setTextFormat(Qt::RichText);
  setWordWrap(true);
  setIndent(0);
  hide();
  ensurePolished(); // what is never shown has no style else
}

void LetterRoom::setLetters(int letters, int rows) {
  const QString word = QStringLiteral("letter_s ");
  const QString row = richTextOf(word.repeated(letters / rows / static_cast<int>(word.size())).trimmed());
  setText(row + (QStringLiteral("<br>") + row).repeated(rows - 1));
  m_measured = {};
}

int LetterRoom::heightIn(int width) {
  if (m_measured.width() != width)
    m_measured = {width, heightForWidth(width)};
  return m_measured.height();
}

void LetterRoom::changeEvent(QEvent *event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
    m_measured = {};
}

} // namespace halfspace
