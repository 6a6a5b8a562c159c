#include "app/completion.h"

#include "lessons/text.h"

#include <algorithm>
#include <cctype>

namespace halfspace {
namespace {

bool isOption(std::string_view word) { return word.starts_with('-'); }

const CLI::App *commandAmong(const CLI::App &app, const std::vector<std::string> &words) {
  for (const CLI::App *command : app.get_subcommands({}))
    if (std::find(words.begin(), words.end(), command->get_name()) != words.end())
      return command;
  return nullptr;
}

/// The option that the next word is a value of: the last word is its name.
const CLI::Option *openOption(const CLI::App &app, const CLI::App &command,
                              const std::vector<std::string> &words) {
  if (words.empty() || !isOption(words.back()))
    return nullptr;
  for (const CLI::App *each : {&command, &app})
    if (const CLI::Option *option = each->get_option_no_throw(words.back()))
      return option->get_items_expected_max() > 0 ? option : nullptr;
  return nullptr;
}

/// Every folder that stands behind --lessons.
OwnLessons ownLessonsAmong(const std::vector<std::string> &words) {
  OwnLessons folders;
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (words[i] == ownLessonsOption)
      folders.push_back(words[i + 1]);
  return folders;
}

bool standsForItself(std::string_view typeName) {
  return std::all_of(typeName.begin(), typeName.end(), [](unsigned char c) { return std::islower(c); });
}

void addType(CompleteCommand &complete, const std::string &typeName) {
  for (const std::string_view part : partsOf(typeName, "|"))
    if (part == "LESSON")
      complete.lessons = true;
    else if (part == "FILE")
      complete.files = CompleteCommand::Files::All;
    else if (part == "FOLDER")
      complete.files = std::max(complete.files, CompleteCommand::Files::Folders);
    else if (standsForItself(part))
      complete.words.emplace_back(part);
}

void addOptions(CompleteCommand &complete, const CLI::App &app) {
  for (const CLI::Option *option : app.get_options())
    for (const std::string &name : option->get_lnames())
      complete.words.push_back("--" + name);
}

void addArguments(CompleteCommand &complete, const CLI::App &app) {
  for (const CLI::Option *option : app.get_options())
    if (option->get_positional())
      addType(complete, option->get_type_name());
}

void addCommands(CompleteCommand &complete, const CLI::App &app) {
  for (const CLI::App *command : app.get_subcommands({}))
    if (!command->get_group().empty())
      complete.words.push_back(command->get_name());
}

} // namespace

CompleteCommand completionOf(const CLI::App &app, std::vector<std::string> words) {
  if (words.empty() || words.back() == "=")
    words.emplace_back();
  std::erase(words, "=");
  CompleteCommand complete;
  complete.typed = words.back();
  words.pop_back();
  complete.ownLessons = ownLessonsAmong(words);

  const CLI::App *named = commandAmong(app, words);
  const CLI::App &command = named ? *named : app;
  if (const CLI::Option *option = openOption(app, command, words)) {
    addType(complete, option->get_type_name());
  } else if (isOption(complete.typed)) {
    addOptions(complete, command);
  } else {
    addArguments(complete, command);
    if (!named)
      addCommands(complete, app);
  }
  std::erase_if(complete.words, [&](const std::string &word) { return !word.starts_with(complete.typed); });
  return complete;
}

} // namespace halfspace
