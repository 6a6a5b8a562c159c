#include "lessons/typed/typed_scene.h"

#include "lessons/formula/read_formula.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/point.h"
#include "lessons/scene/fresh_names.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/text.h"
#include "lessons/typed/mend_line.h"
#include "lessons/typed/read_line.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// The column of a byte, counted in characters from 1.
std::size_t columnOf(std::string_view line, std::size_t at) {
  std::size_t column = 1;
  for (std::string_view before = line.substr(0, at); !before.empty();
       before.remove_prefix(std::max<std::size_t>(characterLength(before), 1)))
    ++column;
  return column;
}

Problem problemOf(const TypedFault &fault, std::string_view line, int number, const Scene &above,
                  const std::string &file, char decimalMark) {
  std::string sentence =
      words("Column {column}: {sentence}",
            {{"column", std::to_string(columnOf(line, fault.at))}, {"sentence", fault.sentence}});
  if (const auto mends = mendsOf(line, above, decimalMark, 1); !mends.empty())
    sentence += " " + words("Perhaps you meant: {line}", {{"line", mends.front()}});
  return {std::move(sentence), file, number, ""};
}

/// What parts the numbers of a point: a semicolon or a tab where there is one, else a comma, else blanks.
char separatorIn(std::string_view numbers, char decimalMark) {
  for (const char separator : {';', '\t'})
    if (numbers.find(separator) != std::string_view::npos)
      return separator;
  return decimalMark != ',' && numbers.find(',') != std::string_view::npos ? ',' : ' ';
}

std::vector<std::string_view> parted(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    if (const std::string_view part = trimmed(text.substr(0, end)); !part.empty())
      parts.push_back(part);
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
  const std::vector<std::string_view> numbers = parted(line, separatorIn(line, decimalMark));
  const auto isNumber = [&](std::string_view text) { return spellsNumber(text, decimalMark); };
  if (numbers.size() != 3 || !std::all_of(numbers.begin(), numbers.end(), isNumber))
    return {};
  const std::string separator = decimalMark == ',' ? "; " : ", ";
  std::string point = FreshNames(above).ofKind(*findKind(PointObject::kind)) + " = (";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    point += (i > 0 ? separator : "") + std::string(numbers[i]);
  return point + ")";
}

} // namespace

Result<Scene> readTypedScene(std::string_view text, const std::string &file, char decimalMark, Scene above) {
  if (const auto at = firstNoText(text))
    return Problem{
        words("This is no text."), file,
        static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*at), '\n')) + 1,
        ""};
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(byteOrderMark))
    text.remove_prefix(byteOrderMark.size());
  Scene scene = std::move(above);
  int number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view whole = text.substr(0, std::min(end, text.find('#')));
    const std::string_view said = trimmed(whole);
    const std::string_view line =
        whole.substr(0, said.empty() ? 0 : static_cast<std::size_t>(said.end() - whole.begin()));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty())
      continue;
    if (scene.entries.size() == maxSceneEntries)
      return Problem{tooManyEntries().sentence, file, number, ""};
    auto entry =
        readLine(pointLine(line, scene, decimalMark).value_or(std::string(line)), scene, decimalMark);
    if (const auto *fault = std::get_if<TypedFault>(&entry))
      return problemOf(*fault, line, number, scene, file, decimalMark);
    scene.entries.push_back(std::get<Entry>(std::move(entry)));
  }
  return scene;
}

} // namespace halfspace
