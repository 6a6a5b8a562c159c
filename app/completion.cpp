#include "app/completion.h"

#include "lessons/text.h"

#include <algorithm>
#include <cctype>

namespace halfspace {
namespace {

bool isOption(std::string_view word) { return word.starts_with('-'); }

const CommandDescription *commandAmong(const CommandDescription &program,
                                       const std::vector<std::string> &words) {
  for (const CommandDescription &command : program.commands)
    if (std::find(words.begin(), words.end(), command.name) != words.end())
      return &command;
  return nullptr;
}

bool isCalled(const OptionDescription &option, std::string_view word) {
  const auto isWord = [word](std::string_view hyphens) {
    return [word, hyphens](const std::string &name) { return word == std::string(hyphens) + name; };
  };
  return std::any_of(option.shortNames.begin(), option.shortNames.end(), isWord("-")) ||
         std::any_of(option.longNames.begin(), option.longNames.end(), isWord("--"));
}

/// The option that the next word is a value of: the last word is its name.
const OptionDescription *openOption(const CommandDescription &program, const CommandDescription &command,
                                    const std::vector<std::string> &words) {
  if (words.empty() || !isOption(words.back()))
    return nullptr;
  for (const CommandDescription *each : {&command, &program})
    for (const OptionDescription &option : each->options)
      if (isCalled(option, words.back()))
        return option.takesValue() ? &option : nullptr;
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

void addOptions(CompleteCommand &complete, const CommandDescription &command) {
  for (const OptionDescription &option : command.options)
    for (const std::string &name : option.longNames)
      complete.words.push_back("--" + name);
}

void addArguments(CompleteCommand &complete, const CommandDescription &command) {
  for (const OptionDescription &option : command.options)
    if (option.isArgument)
      addType(complete, option.typeName);
}

void addCommands(CompleteCommand &complete, const CommandDescription &program) {
  for (const CommandDescription &command : program.commands)
    if (command.isListed)
      complete.words.push_back(command.name);
}

} // namespace

CompleteCommand completionOf(const CommandDescription &program, std::vector<std::string> words) {
  if (words.empty() || words.back() == "=")
    words.emplace_back();
  std::erase(words, "=");
  CompleteCommand complete;
  complete.typed = words.back();
  words.pop_back();
  complete.ownLessons = ownLessonsAmong(words);

  const CommandDescription *named = commandAmong(program, words);
  const CommandDescription &command = named ? *named : program;
  if (const OptionDescription *option = openOption(program, command, words)) {
    addType(complete, option->typeName);
  } else if (isOption(complete.typed)) {
    addOptions(complete, command);
  } else {
    addArguments(complete, command);
    if (!named)
      addCommands(complete, program);
  }
  std::erase_if(complete.words, [&](const std::string &word) { return !word.starts_with(complete.typed); });
  return complete;
}

} // namespace halfspace
