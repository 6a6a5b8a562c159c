#include "lessons/typed/typed_scene.h"

#include "lessons/scene/scene_checker.h"
#include "lessons/text.h"
#include "lessons/typed/line_with_name.h"
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

Problem problemOf(const TypedFault &fault, const LineWithName &named, int number, const Scene &above,
                  const std::string &file, char decimalMark) {
  const std::string_view typed = std::string_view(named.line).substr(named.added);
  const std::size_t at = std::max(fault.at, named.added) - named.added;
  std::string sentence =
      words("Column {column}: {sentence}",
            {{"column", std::to_string(columnOf(typed, at))}, {"sentence", fault.sentence}});
  if (const auto mends = mendsOf(named.line, above, decimalMark, 1); !mends.empty())
    sentence += " " + words("Perhaps you meant: {line}", {{"line", mends.front()}});
  return {std::move(sentence), file, number, ""};
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
    const LineWithName named = withName(line, scene, decimalMark);
    auto entry = readLine(named.line, scene, decimalMark);
    if (const auto *fault = std::get_if<TypedFault>(&entry))
      return problemOf(*fault, named, number, scene, file, decimalMark);
    scene.entries.push_back(std::get<Entry>(std::move(entry)));
  }
  return scene;
}

} // namespace halfspace
