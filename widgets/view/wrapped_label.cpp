#include "widgets/view/wrapped_label.h"

#include <QEvent>

namespace halfspace {

WrappedLabel::WrappedLabel(const char *name, QWidget *parent) : QLabel(parent) {
  setObjectName(name);
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
  setIndent(0); // else Qt would leave some room at the edge that the words are aligned to
}

int WrappedLabel::heightIn(int width) {
  if (m_measured.width() != width)
    m_measured = {width, measuredHeight(width)};
  return m_measured.height();
}

void WrappedLabel::changeEvent(QEvent *event) {
  QLabel::changeEvent(event);
  if (changesType(*event))
    forgetHeight();
}

bool WrappedLabel::changesType(const QEvent &event) {
  return event.type() == QEvent::FontChange || event.type() == QEvent::StyleChange;
}

} // namespace halfspace
