#include "widgets/working/sentence_breaker.h"

#include "widgets/text/unbroken.h"

#include <QTextLayout>

namespace halfspace {
namespace {

/// So many sentences are remembered: more than a working has, fewer than a long drag makes.
constexpr std::size_t mostRemembered = 200;

std::vector<SentenceBreaker::Line> broken(const QString &sentence, const QFont &font, double width) {
  const QString text = unbroken(sentence);
  std::vector<SentenceBreaker::Line> lines;
  QTextLayout layout(text, font);
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(width);
    lines.push_back({text.mid(line.textStart(), line.textLength()), line.ascent(), line.height()});
  }
  layout.endLayout();
  return lines;
}

} // namespace

const std::vector<SentenceBreaker::Line> &SentenceBreaker::lines(const QString &sentence, const QFont &font,
                                                                 double width) {
  if (font != m_font || m_broken.size() >= mostRemembered)
    m_broken.clear();
  m_font = font;
  const auto found = m_broken.find({sentence, width});
  return found != m_broken.end()
             ? found->second
             : m_broken.emplace(std::pair(sentence, width), broken(sentence, font, width)).first->second;
}

} // namespace halfspace
