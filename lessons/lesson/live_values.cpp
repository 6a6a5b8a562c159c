#include "lessons/lesson/live_values.h"

#include "lessons/lesson/condition.h"
#include "lessons/term/among_words.h"
#include "lessons/term/latex.h"
#include "lessons/term/written.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Stands for a value that the present case does not have.
constexpr std::string_view noValue = "—";
/// Stands for a value that the learner is to find.
constexpr std::string_view hiddenValue = "?";

/// Braces further apart than this hold no name.
constexpr std::size_t longestName = 80;

std::string latexAmongWords(const Term &term) {
  return latexOf(amongWords(term), LatexMarks::Without, Fractions::Flat);
}

/// How large a root is, which nobody sees by looking at it: ≈ 7.348; empty behind other values.
std::string sizeOfRoot(const Value &value) {
  const auto *number = std::get_if<Surd>(&value);
  return number && !number->isRational()
             ? "\\approx " + latexAmongWords(decimalOf(*number, digitsAmongWords).term)
             : "";
}

/// A value as Markdown: numbers as LaTeX, with ≈ when they are rounded, words as they are.
std::string markdownOf(const Value &value) {
  if (const auto *word = std::get_if<std::string>(&value))
    return *word;
  const auto term = termOf(value);
  if (!term)
    return std::string(noValue);
  return showsRounded(*term) ? "$\\approx " + latexAmongWords(*term) + "$"
                             : "$" + latexAmongWords(*term) + sizeOfRoot(value) + "$";
}

std::string markdownOf(std::string_view name, const Scene &scene, const Evaluation &evaluation,
                       LiveValues values) {
  if (const auto value = findValue(evaluation, name))
    return values == LiveValues::Hidden ? std::string(hiddenValue) : markdownOf(*value);
  if (const auto id = findCoordinate(scene, name)) {
    const Object &object = *findObject(scene, id->object);
    const ExactVec3 &at = object[id->index];
    const bool isSingle = numbersIn(coordinatesOf(object)[id->index].role) == 1;
    return markdownOf(isSingle ? Value(Surd(at.x)) : std::vector<Surd>{at.x, at.y, at.z});
  }
  return std::string(noValue);
}

/// The length of a formula or of code that starts here, where braces mean something else; 0 elsewhere.
std::size_t verbatimLength(std::string_view text) {
  if (text.front() == '\\' && text.size() > 1)
    return 2;
  if (text.front() != '$' && text.front() != '`')
    return 0;
  const std::string_view fence = text.substr(0, std::min(text.find_first_not_of(text.front()), text.size()));
  const auto end = text.find(fence, fence.size());
  return end == std::string_view::npos ? fence.size() : end + fence.size();
}

} // namespace

std::vector<LiveName> liveNamesIn(std::string_view markdown) {
  std::vector<LiveName> names;
  for (std::size_t place = 0; place < markdown.size();) {
    const std::string_view rest = markdown.substr(place);
    const auto close = rest.front() == '{' ? rest.substr(0, longestName).find('}') : std::string_view::npos;
    if (close == std::string_view::npos || !isValueName(rest.substr(1, close - 1))) {
      place += std::max<std::size_t>(verbatimLength(rest), 1);
      continue;
    }
    names.push_back({std::string(rest.substr(1, close - 1)), place});
    place += close + 1;
  }
  return names;
}

std::string withLiveValues(const std::string &markdown, const Scene &scene, const Evaluation &evaluation,
                           LiveValues values) {
  constexpr std::size_t braces = 2;
  std::string filled;
  std::size_t done = 0;
  for (const LiveName &live : liveNamesIn(markdown)) {
    filled += markdown.substr(done, live.place - done);
    const std::string value = markdownOf(live.name, scene, evaluation, values);
    // “t = ≈ 3.14” says it twice, and once wrongly.
    if (filled.ends_with("= ") && value.starts_with("$\\approx"))
      filled.erase(filled.size() - 2);
    filled += value;
    done = live.place + live.name.size() + braces;
  }
  return filled + markdown.substr(done);
}

} // namespace halfspace
