#include "lessons/lesson/line_practice.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Whether some of the lines would ask for a number, if the learner chose so.
bool asksForSome(const Working &working) {
  const auto isSome = [&](const auto &asks) {
    return std::any_of(working.lines.begin(), working.lines.end(), asks);
  };
  return isSome([](const WorkingLine &line) { return line.asked != Asked::Nothing; }) ||
         isSome(
             [choice = GapChoice(working)](const WorkingLine &line) { return choice.of(line).has_value(); });
}

} // namespace

bool LinePractice::setStep(const std::string &lesson, int step, std::optional<Fading> asked) {
  m_asked = asked;
  Step next(lesson, step);
  return std::exchange(m_step, next) != next;
}

void LinePractice::setWorking(const Working &working, bool hidden) {
  m_working = working;
  m_hidden = hidden;
  refresh();
}

void LinePractice::choose(Fading fading) {
  m_chosen[m_step.first] = fading;
  here() = {fading};
  refresh();
}

void LinePractice::forgetLines() {
  here().lines.clear();
  refresh();
}

bool LinePractice::answer(const std::string &line, const std::string &typed) {
  const WorkingLine *asking = findLine(m_working, line);
  const auto gap = m_fade.gaps.find(line);
  if (!asking || gap == m_fade.gaps.end())
    return false;
  const Judgement judgement = judge(*asking, gap->second, typed);
  LineRecord &record = recordOf(line);
  record.remark = {judgement.sentence, judgement.right};
  record.isOpen = judgement.right;
  if (judgement.isAnswer)
    count(record, judgement.right);
  refresh();
  return true;
}

void LinePractice::open(const std::string &line) {
  LineRecord &record = recordOf(line);
  record.isOpen = true;
  record.remark = {};
  count(record, false);
  refresh();
}

Fading LinePractice::fading() const {
  const auto here = m_records.find(m_step);
  if (here != m_records.end() && here->second.fading)
    return *here->second.fading;
  const auto chosen = m_chosen.find(m_step.first);
  return m_asked.value_or(chosen == m_chosen.end() ? Fading::None : chosen->second);
}

LinePractice::Score LinePractice::score() const {
  const auto here = m_records.find(m_step);
  return here == m_records.end() ? Score() : here->second.score;
}

std::map<std::string, AnswerRemark> LinePractice::remarks() const {
  std::map<std::string, AnswerRemark> remarks;
  const auto here = m_records.find(m_step);
  if (m_hidden || here == m_records.end())
    return remarks;
  for (const auto &[line, record] : here->second.lines)
    if (!record.remark.text.empty())
      remarks[line] = record.remark;
  return remarks;
}

void LinePractice::refresh() {
  if (!m_hidden) // else these may not be the numbers of the scene
    endRecordsOfOtherNumbers();
  m_fade = m_hidden ? withheld(m_working) : halfspace::fade(m_working, fading(), openedLines());
  m_hasNumbersToFind = !m_fade.gaps.empty() || asksForSome(m_working);
}

void LinePractice::endRecordsOfOtherNumbers() {
  for (auto &[line, record] : here().lines) {
    if (textOf(line) == record.text)
      continue;
    AnswerRemark said = std::move(record.remark);
    said.isOfNow = false;
    record = {textOf(line), false, std::move(said)};
  }
}

void LinePractice::count(LineRecord &record, bool right) {
  if (std::exchange(record.isCounted, true))
    return;
  Score &score = here().score;
  ++score.tried;
  score.right += right ? 1 : 0;
}

std::set<std::string> LinePractice::openedLines() {
  std::set<std::string> lines;
  for (const auto &[line, record] : here().lines)
    if (record.isOpen)
      lines.insert(line);
  return lines;
}

LinePractice::LineRecord &LinePractice::recordOf(const std::string &line) {
  LineRecord &record = here().lines[line];
  record.text = textOf(line);
  return record;
}

std::string LinePractice::textOf(const std::string &line) const {
  const WorkingLine *found = findLine(m_working, line);
  return found ? plainText(*found) : std::string();
}

} // namespace halfspace
