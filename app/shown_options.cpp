#include "app/shown_options.h"

#include "app/option_text.h"
#include "lessons/words.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>

namespace halfspace {
namespace {

constexpr const char *showOption = "--show";
constexpr const char *withoutOption = "--without";

std::string partNames(const std::string &separator) {
  return joinedNames(shownPartNames, &ShownPartName::name, separator);
}

void addParts(CLI::App &command, const char *option, std::vector<std::string> &names,
              const std::string &meaning) {
  command.add_option(option, names, meaning)
      ->type_name(partNames("|"))
      ->delimiter(',')
      ->allow_extra_args(false) // what follows is another word
      ->take_all();
}

/// Switches parts on or off; a sentence for a name of none.
std::optional<Problem> switchParts(ShownParts &shown, const char *option,
                                   const std::vector<std::string> &names, bool isOn) {
  for (const std::string &name : names) {
    const auto part = std::find_if(shownPartNames.begin(), shownPartNames.end(),
                                   [&](const ShownPartName &each) { return each.name == name; });
    if (part == shownPartNames.end())
      return refused(words("{option} takes some of {parts}, with commas between several, not “{name}”.",
                           {{"option", option}, {"parts", partNames(", ")}, {"name", name}}));
    shown.*(part->part) = isOn;
  }
  return {};
}

} // namespace

void addShownOptions(CLI::App &command, ShownOptions &options) {
  addParts(command, showOption, options.with,
           words("Draw a part of the picture that is left out else: coordinates behind the letters of "
                 "points, lines from them down to the ground"));
  addParts(command, withoutOption, options.without,
           words("Leave parts of the picture out (with commas between several)"));
}

Result<ShownParts> shownPartsOf(const ShownOptions &options) {
  ShownParts shown;
  if (auto problem = switchParts(shown, showOption, options.with, true))
    return std::move(*problem);
  if (auto problem = switchParts(shown, withoutOption, options.without, false))
    return std::move(*problem);
  for (const std::string &name : options.with)
    if (std::find(options.without.begin(), options.without.end(), name) != options.without.end())
      return refused(words("“{name}” is to be shown and left out: give it once.", {{"name", name}}));
  return shown;
}

} // namespace halfspace
