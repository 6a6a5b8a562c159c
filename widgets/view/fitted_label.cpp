#include "widgets/view/fitted_label.h"

#include "widgets/text/indices.h"

#include <QEvent>

namespace halfspace {

FittedLabel::FittedLabel(const char *name) {
  setObjectName(name);
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
  setIndent(0); // where it is not centred Qt would leave some room above or below
}

void FittedLabel::setWords(const QString &words) {
  if (words == m_words)
    return;
  m_words = words;
  fit();
}

bool FittedLabel::fits() const { return QLabel::heightForWidth(width()) <= height(); }

void FittedLabel::fit() {
  showWords(*this, m_words);
  setToolTip({});
  if (height() == 0 || fits())
    return;
  setToolTip(richTextOf(m_words)); // rich, so that it is wrapped
  qsizetype shown = 0;
  // As many words as fit, by halving.
  for (qsizetype tooMany = m_words.size(); tooMany - shown > 1;) {
    const qsizetype middle = (shown + tooMany) / 2;
    showWords(*this, m_words.left(static_cast<int>(middle)).trimmed() + QStringLiteral("…"));
    (fits() ? shown : tooMany) = middle;
  }
  const int end = m_words.lastIndexOf(' ', static_cast<int>(shown));
  showWords(*this, m_words.left(end < 0 ? static_cast<int>(shown) : end) + QStringLiteral(" …"));
}

void FittedLabel::resizeEvent(QResizeEvent *event) {
  QLabel::resizeEvent(event);
  fit();
}

void FittedLabel::changeEvent(QEvent *event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange)
    fit();
}

} // namespace halfspace
