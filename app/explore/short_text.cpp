#include "app/explore/short_text.h"

namespace halfspace {

QPlainTextEdit *shortText(const QString &name, int lines) {
  auto *field = new QPlainTextEdit;
  field->setObjectName(name);
  field->setTabChangesFocus(true);
  const int margins = 2 * (field->frameWidth() + static_cast<int>(field->document()->documentMargin()));
  field->setFixedHeight(lines * field->fontMetrics().lineSpacing() + margins);
  return field;
}

} // namespace halfspace
