#include "widgets/working/shown_lines.h"

#include <QStringList>

#include <algorithm>
#include <utility>

namespace halfspace {

ShownLines::ShownLines(Working working, LineRange range, Fade fade)
    : m_working(std::move(working)), m_fade(std::move(fade)) {
  const std::size_t end = std::min(range.end, m_working.lines.size());
  for (std::size_t i = range.begin; i < end; ++i) {
    const WorkingLine &line = m_working.lines[i];
    m_lines.push_back(hides(line.id) ? asDemand(line) : line);
  }
}

const Gap *ShownLines::gapOf(const std::string &lineId) const {
  const auto gap = m_fade.gaps.find(lineId);
  return gap == m_fade.gaps.end() ? nullptr : &gap->second;
}

bool ShownLines::hides(const std::string &lineId) const {
  return gapOf(lineId) || m_fade.waiting.contains(lineId);
}

std::vector<Chain> ShownLines::toldFor(const WorkingLine &line, const Gap &gap) const {
  return halfspace::toldFor(line, gap, m_working);
}

QString ShownLines::spoken() const {
  QStringList lines;
  for (const WorkingLine &line : m_lines)
    lines << QString::fromStdString(spokenOf(line));
  return lines.join(u'\n');
}

std::string ShownLines::spokenOf(const WorkingLine &line) const {
  if (const Gap *gap = gapOf(line.id))
    return questionText(line, *gap);
  if (hides(line.id))
    return waitingText(line);
  return halfspace::spoken(line) + (line.sentence.empty() ? "" : ". " + line.sentence);
}

std::vector<ToldLine> ShownLines::told() const {
  std::vector<ToldLine> told;
  told.reserve(m_lines.size());
  for (const WorkingLine &line : m_lines)
    told.push_back({&line, !hides(line.id)});
  return told;
}

} // namespace halfspace
