#include "lessons/typed/line_with_name.h"

#include "lessons/construction/construction.h"
#include "lessons/formula/read_formula.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/scene/fresh_names.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/text.h"
#include "lessons/typed/read_line.h"
#include "lessons/typed/scene_names.h"

#include <algorithm>

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

/// The line of a point with these coordinates, under a name that is free where it has none; nothing where
/// they are not three numbers.
std::optional<std::string> pointLine(std::string_view name, const std::vector<std::string> &numbers,
                                     const Scene &above, char decimalMark) {
  const auto isNumber = [&](std::string_view text) { return spellsNumber(text, decimalMark); };
  if (numbers.size() != 3 || !std::all_of(numbers.begin(), numbers.end(), isNumber))
    return {};
  const std::string between = decimalMark == ',' ? "; " : ", ";
  return (name.empty() ? FreshNames(above).ofKind(*findKind(PointObject::kind)) : std::string(name)) +
         " = (" + numbers[0] + between + numbers[1] + between + numbers[2] + ")";
}

/// Three numbers alone as the line of a point; nothing for any other line.
std::optional<std::string> pointOfNumbers(std::string_view line, const Scene &above, char decimalMark) {
  if (line.size() > 2 && line.front() == '(' && line.back() == ')')
    line = line.substr(1, line.size() - 2);
  const char separator = separatorIn(line, decimalMark);
  std::vector<std::string> numbers = parted(line, separator);
  if (separator == ';' || separator == '\t') // then a comma can only be a decimal one
    for (std::string &number : numbers)
      std::replace(number.begin(), number.end(), ',', decimalMark);
  return pointLine({}, numbers, above, decimalMark);
}

/// P = (1, 2, 3) for P(1|2|3), as some schools write it; nothing for any other line.
std::optional<std::string> pointWithBars(std::string_view line, const Scene &above, char decimalMark) {
  const std::string_view text = trimmed(line);
  const std::size_t open = text.find('(');
  if (open == std::string_view::npos || text.back() != ')')
    return {};
  const std::string_view name = trimmed(text.substr(0, open));
  if (!name.empty() && !canBeName(name))
    return {};
  return pointLine(name, parted(text.substr(open + 1, text.size() - open - 2), '|'), above, decimalMark);
}

/// What stands before the first sign of a name, if that can be a name; else empty.
std::string_view nameIn(std::string_view line) {
  const std::size_t sign = line.find_first_of("=:");
  const std::string_view name = trimmed(line.substr(0, std::min(sign, line.size())));
  return sign != std::string_view::npos && canBeName(name) ? name : std::string_view();
}

/// Whether a word may be a part of an equation: x, and the x-1 of x-1 = 0.
bool hasUnknown(std::string_view word) {
  const std::vector<std::string> parts = parted(word, '-');
  return std::any_of(parts.begin(), parts.end(),
                     [](const std::string &part) { return part == "x" || part == "y" || part == "z"; });
}

/// Whether a sign of equality stands in it that is none of a condition, as in t >= 0.
bool isEquation(std::string_view line) {
  for (std::size_t at = line.find('='); at != std::string_view::npos; at = line.find('=', at + 1))
    if (at > 0 && line[at - 1] != '<' && line[at - 1] != '>')
      return true;
  return false;
}

/// Whether a formula is a direction rather than a place: u × v, B − A, half of a vector.
bool isDirection(const Formula &formula, const SceneNames &names) {
  const auto isPart = [&](std::size_t part) { return isDirection(formula.parts[part], names); };
  switch (formula.kind) {
  case FormulaKind::Name: {
    const auto value = names.value(formula.name);
    return value && value->role == CoordinateRole::Direction;
  }
  case FormulaKind::Cross:
  case FormulaKind::Shortest:
    return true;
  case FormulaKind::Difference: // of two places, or of two directions
    return isPart(0) == isPart(1);
  case FormulaKind::Sum:
    return isPart(0) && isPart(1);
  case FormulaKind::Product:
    return isPart(0) || isPart(1);
  case FormulaKind::Negative:
  case FormulaKind::Quotient:
    return isPart(0);
  default:
    return false;
  }
}

/// Of what a line without a name says: its kind's usual name, or its construction's.
std::string usualName(const Entry &entry, const Scene &above) {
  const FreshNames names(above);
  if (const auto *use = std::get_if<ConstructionUse>(&entry.content))
    return names.ofUse(*findConstruction(use->id));
  const auto *derived = std::get_if<DerivedObject>(&entry.content);
  const bool isVector = derived && derived->kind->word == PointObject::kind &&
                        isDirection(derived->coordinates.front(), SceneNames(above));
  return names.ofKind(isVector ? *findKind(VectorObject::kind) : *kindOf(entry));
}

/// A free name that means nothing: a point's, of which no line is a ray.
std::string plainName(const Scene &above) {
  std::string name = "P";
  for (int number = 1; above.entries.find(name); ++number)
    name = "P" + std::to_string(number);
  return name;
}

LineWithName under(std::string name, std::string_view line, bool isPlane) {
  name += isPlane ? ": " : " = ";
  return {name + std::string(line), name.size()};
}

} // namespace

LineWithName withName(std::string_view line, const Scene &above, char decimalMark) {
  if (const auto point = pointWithBars(line, above, decimalMark))
    return {*point};
  if (const auto point = pointOfNumbers(line, above, decimalMark))
    return {*point};
  const std::string_view name = nameIn(line);
  if (!name.empty() && !hasUnknown(name))
    return {std::string(line)};
  const bool isPlane = isEquation(line);
  const LineWithName plain = under(plainName(above), line, isPlane);
  const auto read = readLine(plain.line, above, decimalMark);
  if (const auto *entry = std::get_if<Entry>(&read))
    return under(usualName(*entry, above), line, isPlane);
  return name.empty() ? plain : LineWithName{std::string(line)};
}

LineWithName withName(std::string_view line, const std::string &name) {
  return nameIn(line).empty() ? under(name, line, isEquation(line)) : LineWithName{std::string(line)};
}

} // namespace halfspace
