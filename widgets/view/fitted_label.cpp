#include "widgets/view/fitted_label.h"

#include "widgets/text/indices.h"

#include <vector>

namespace halfspace {
namespace {

/// Where the first words end: of none, one, two, … but not of all.
std::vector<int> wordEnds(const QString &words) {
  std::vector<int> ends{0};
  for (int i = 1; i < words.size(); ++i)
    if (words[i] == u' ')
      ends.push_back(i);
  return ends;
}

} // namespace

FittedLabel::FittedLabel(const char *name) : WrappedLabel(name) {}

void FittedLabel::setWords(const QString &words) {
  if (words == m_words)
    return;
  m_words = words;
  forgetHeight();
  fit();
}

int FittedLabel::measuredHeight(int width) {
  showWords(*this, m_words);
  const int height = QLabel::heightForWidth(width);
  showWords(*this, m_shown);
  return height;
}

bool FittedLabel::fits() const { return QLabel::heightForWidth(width()) <= height(); }

void FittedLabel::showOnly(const QString &words) {
  m_shown = words;
  showWords(*this, words);
}

void FittedLabel::fit() {
  showOnly(m_words);
  if (height() == 0 || heightIn(width()) <= height())
    return setToolTip({});
  setToolTip(richTextOf(m_words)); // rich, so that it is wrapped
  const std::vector<int> ends = wordEnds(m_words);
  const auto cut = [&](std::size_t words) { return m_words.left(ends[words]) + QStringLiteral("\u00a0…"); };
  // As many words as fit, by halving.
  std::size_t shown = 0;
  for (std::size_t tooMany = ends.size(); tooMany - shown > 1;) {
    const std::size_t middle = (shown + tooMany) / 2;
    showOnly(cut(middle));
    (fits() ? shown : tooMany) = middle;
  }
  showOnly(cut(shown));
}

void FittedLabel::resizeEvent(QResizeEvent *event) {
  QLabel::resizeEvent(event);
  fit();
}

void FittedLabel::changeEvent(QEvent *event) {
  WrappedLabel::changeEvent(event);
  if (changesType(*event))
    fit();
}

} // namespace halfspace
