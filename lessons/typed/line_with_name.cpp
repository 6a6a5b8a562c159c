#include "lessons/typed/line_with_name.h"

#include "lessons/construction/construction.h"
#include "lessons/formula/read_formula.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/scene/fresh_names.h"
#include "lessons/text.h"
#include "lessons/typed/read_line.h"

#include <algorithm>
#include <cctype>

namespace halfspace {
namespace {

/// What parts the numbers of a point: a semicolon or a tab where there is one, else a comma, else blanks.
char separatorIn(std::string_view numbers, char decimalMark) {
  for (const char separator : {';', '\t'})
    if (numbers.find(separator) != std::string_view::npos)
      return separator;
  return decimalMark != ',' && numbers.find(',') != std::string_view::npos ? ',' : ' ';
}

std::vector<std::string> parted(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    if (const std::string_view part = trimmed(text.substr(0, end)); !part.empty())
      parts.emplace_back(part);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

bool spellsNumber(std::string_view text, char decimalMark) {
  const auto read = readFormula(text, decimalMark);
  const auto *formula = std::get_if<Formula>(&read);
  return formula && (isPlainNumber(*formula) ||
                     (formula->kind == FormulaKind::Negative && isPlainNumber(formula->parts.front())));
}

/// Three numbers alone as the line of a point; nothing for any other line.
std::optional<std::string> pointLine(std::string_view line, const Scene &above, char decimalMark) {
  if (line.size() > 2 && line.front() == '(' && line.back() == ')')
    line = line.substr(1, line.size() - 2);
  const char separator = separatorIn(line, decimalMark);
  std::vector<std::string> numbers = parted(line, separator);
  if (separator == ';' || separator == '\t') // then a comma can only be a decimal one
    for (std::string &number : numbers)
      std::replace(number.begin(), number.end(), ',', decimalMark);
  const auto isNumber = [&](std::string_view text) { return spellsNumber(text, decimalMark); };
  if (numbers.size() != 3 || !std::all_of(numbers.begin(), numbers.end(), isNumber))
    return {};
  const std::string between = decimalMark == ',' ? "; " : ", ";
  std::string point = FreshNames(above).ofKind(*findKind(PointObject::kind)) + " = (";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    point += (i > 0 ? between : "") + numbers[i];
  return point + ")";
}

/// P = (1, 2, 3) for P(1|2|3); nothing for any other line.
std::optional<std::string> pointWithBars(std::string_view line, char decimalMark) {
  const std::string_view text = trimmed(line);
  const std::size_t open = text.find('(');
  if (open == std::string_view::npos || text.find('|') == std::string_view::npos || text.back() != ')')
    return {};
  const std::string_view name = trimmed(text.substr(0, open));
  std::string numbers(text.substr(open));
  const std::string between = decimalMark == ',' ? "; " : ", ";
  for (std::size_t bar = numbers.find('|'); bar != std::string::npos; bar = numbers.find('|'))
    numbers.replace(bar, 1, between);
  return std::string(name) + (name.empty() ? "" : " = ") + numbers;
}

/// Whether a sign stands behind a first word, which is no coordinate of an equation: `x = 3` is a plane.
bool hasName(std::string_view line) {
  const std::string_view begin = trimmed(line);
  const std::size_t end = begin.find_first_of("=:");
  const std::string_view name = trimmed(begin.substr(0, std::min(end, begin.size())));
  const bool isWord = std::all_of(name.begin(), name.end(), [](unsigned char sign) {
    return std::isalnum(sign) || sign == '_' || sign >= 0x80; // a part of a letter beyond ASCII
  });
  const bool isAxis = name == "x" || name == "y" || name == "z";
  return end != std::string_view::npos && isWord && !isAxis;
}

/// Whether a sign of equality stands in it that is none of a condition, as in t >= 0.
bool isEquation(std::string_view line) {
  for (std::size_t at = line.find('='); at != std::string_view::npos; at = line.find('=', at + 1))
    if (at > 0 && line[at - 1] != '<' && line[at - 1] != '>')
      return true;
  return false;
}

std::string usualName(const Entry &entry, const FreshNames &names) {
  if (const Kind *kind = kindOf(entry))
    return names.ofKind(*kind);
  return names.ofUse(*findConstruction(std::get<ConstructionUse>(entry.content).id));
}

} // namespace

LineWithName withName(std::string_view line, const Scene &above, char decimalMark) {
  if (hasName(line))
    return {std::string(line)};
  if (const auto point = pointWithBars(line, decimalMark))
    return withName(*point, above, decimalMark);
  if (auto point = pointLine(line, above, decimalMark))
    return {std::move(*point)};
  const bool isPlane = isEquation(line);
  const auto under = [&](std::string name) {
    name += isPlane ? ": " : " = ";
    return LineWithName{name + std::string(line), name.size()};
  };
  const FreshNames names(above);
  LineWithName named = under(names.ofKind(*findKind(isPlane ? PlaneObject::kind : PointObject::kind)));
  const auto read = readLine(named.line, above, decimalMark);
  if (const auto *entry = std::get_if<Entry>(&read))
    return under(usualName(*entry, names));
  return named;
}

} // namespace halfspace
