#include "widgets/working/sentence_breaker.h"

#include "widgets/text/indices.h"
#include "widgets/text/unbroken.h"

#include <QTextLayout>

#include <algorithm>

namespace halfspace {
namespace {

/// So many sentences are remembered: more than a working has, fewer than a long drag makes.
constexpr std::size_t mostRemembered = 200;

/// Where runs stand in their text.
std::vector<QTextLayout::FormatRange> rangesOf(const std::vector<TextRun> &runs, const QFont &font) {
  std::vector<QTextLayout::FormatRange> ranges;
  ranges.reserve(runs.size());
  int start = 0;
  for (const TextRun &run : runs) {
    QTextCharFormat format;
    format.setFont(run.isIndex ? indexFont(font) : font);
    const int length = static_cast<int>(run.text.size());
    ranges.push_back({start, length, format});
    start += length;
  }
  return ranges;
}

/// What of the runs stands in a line.
std::vector<SentenceBreaker::Run> runsIn(const QTextLine &line, const std::vector<TextRun> &runs) {
  std::vector<SentenceBreaker::Run> inLine;
  const int lineEnd = line.textStart() + line.textLength();
  int start = 0;
  for (const TextRun &run : runs) {
    const int first = std::max(start, line.textStart());
    const int runEnd = start + static_cast<int>(run.text.size());
    const int end = std::min(runEnd, lineEnd);
    if (first < end)
      inLine.push_back({run.text.mid(first - start, end - first), line.cursorToX(first), run.isIndex});
    start = runEnd;
  }
  return inLine;
}

std::vector<SentenceBreaker::Line> broken(const QString &sentence, const QFont &font, double width) {
  const std::vector<TextRun> runs = runsOf(unbroken(sentence));
  const auto ranges = rangesOf(runs, font);
  QString text;
  for (const TextRun &run : runs)
    text += run.text;
  std::vector<SentenceBreaker::Line> lines;
  QTextLayout layout(text, font);
  layout.setFormats({ranges.begin(), ranges.end()});
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(width);
    lines.push_back(
        {text.mid(line.textStart(), line.textLength()), runsIn(line, runs), line.ascent(), line.height()});
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
