// What the command line takes, as a plain value: completion and the manual page are made of it.
#pragma once

#include <string>
#include <vector>

namespace halfspace {

struct OptionDescription {
  std::vector<std::string> shortNames; ///< without their hyphen; none of an argument
  std::vector<std::string> longNames;  ///< likewise
  std::string typeName;                ///< what its values are: FILE, LESSON|FILE, text|json
  std::string description;
  std::string usual;       ///< its value where it is not given; may be empty
  int mostValues = 0;      ///< 0 for a flag
  bool isArgument = false; ///< it is told by its place, not by a name
  bool isRequired = false;

  [[nodiscard]] bool takesValue() const { return mostValues > 0; }
};

/// The program or one of its commands.
struct CommandDescription {
  std::string name;
  std::string description;
  bool isListed = true;                   ///< in the help
  std::vector<OptionDescription> options; ///< in the order in which they were added, arguments among them
  std::vector<CommandDescription> commands;
};

} // namespace halfspace
