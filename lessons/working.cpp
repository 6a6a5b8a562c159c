#include "lessons/working.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/spoken.h"

#include <algorithm>

namespace halfspace {
namespace {

void keepTelling(Blank &blank) {
  std::vector<Mistake> telling;
  for (Mistake &mistake : blank.mistakes) {
    const bool known = std::any_of(telling.begin(), telling.end(),
                                   [&](const Mistake &other) { return other.value == mistake.value; });
    if (!known && !(mistake.value == blank.answer))
      telling.push_back(std::move(mistake));
  }
  blank.mistakes = std::move(telling);
}

template <class Write> std::string joined(const std::vector<Chain> &chains, Write write) {
  std::string text;
  for (const Chain &chain : chains)
    text += (text.empty() ? "" : ", ") + write(chain);
  return text;
}

void collectMarks(const Term &term, std::vector<std::string> &marks) {
  if (!term->mark.empty() && std::find(marks.begin(), marks.end(), term->mark) == marks.end())
    marks.push_back(term->mark);
  for (const Term &part : term->parts)
    collectMarks(part, marks);
}

} // namespace

std::string plainText(const WorkingLine &line) {
  return joined(line.chains, [](const Chain &chain) { return plainText(chain); });
}

std::string spoken(const WorkingLine &line) {
  return joined(line.chains, [](const Chain &chain) { return spoken(chain); });
}

std::vector<std::string> marksIn(const WorkingLine &line) {
  std::vector<std::string> marks;
  for (const Chain &chain : line.chains)
    for (const Term &side : chain.sides())
      collectMarks(side, marks);
  return marks;
}

Working withTellingMistakes(Working working) {
  for (WorkingLine &line : working.lines)
    if (line.blank)
      keepTelling(*line.blank);
  return working;
}

} // namespace halfspace
