// What a shell may put in the place of the word that is being typed.
#pragma once

#include "app/command_description.h"
#include "app/command_line.h"

namespace halfspace {

/// Listed in no help: it is for the shell alone.
inline constexpr const char *completeCommand = "complete-words";

/// `words`: what stands behind the program's name, the last of them being typed. A shell may have cut
/// `--theme=dark` into three.
///
/// Options say what they take by the name of their type: words in small letters stand for themselves, LESSON
/// for a lesson's id, FILE and FOLDER for those.
[[nodiscard]] CompleteCommand completionOf(const CommandDescription &program, std::vector<std::string> words);

} // namespace halfspace
