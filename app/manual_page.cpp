#include "app/manual_page.h"

#include "lessons/text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// A text that roff shows as it is: a hyphen stays one when it is copied, and no line begins a request.
std::string roff(const std::string &text) {
  return "\\&" + replacedAll(replacedAll(text, "\\", "\\e"), "-", "\\-");
}

std::string bold(const std::string &text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string &text) { return "\\fI" + roff(text) + "\\fR"; }

/// LESSON, [FILE] or [FILE]...
std::string argument(const OptionDescription &option) {
  const std::string name = italic(option.typeName);
  const std::string many = option.mostValues > 1 ? "..." : "";
  return (option.isRequired ? name : "[" + name + "]") + many;
}

std::string arguments(const CommandDescription &command) {
  std::string all;
  for (const OptionDescription &option : command.options)
    if (option.isArgument)
      all += " " + argument(option);
  return all;
}

/// -o FILE, --output FILE
std::string optionNames(const OptionDescription &option) {
  std::string names;
  const auto add = [&](const std::string &name) {
    names += (names.empty() ? "" : ", ") + bold(name);
    if (option.takesValue())
      names += " " + italic(option.typeName);
  };
  for (const std::string &name : option.shortNames)
    add("-" + name);
  for (const std::string &name : option.longNames)
    add("--" + name);
  return names;
}

std::string paragraph(const std::string &title, const std::string &text) {
  return ".TP\n" + title + "\n" + text + "\n";
}

/// Arguments first, as they are written.
std::string optionParagraphs(const CommandDescription &command) {
  std::string positional;
  std::string named;
  for (const OptionDescription &option : command.options) {
    std::string text = roff(option.description + ".");
    if (!option.usual.empty())
      text += " Without it: " + roff(option.usual) + ".";
    if (option.isArgument)
      positional += paragraph(argument(option), text);
    else
      named += paragraph(optionNames(option), text);
  }
  return positional + named;
}

std::string exitStatuses() {
  return paragraph("0", roff(words("What was asked for is done."))) +
         paragraph("1", roff(words("Something is wrong with what was looked at, or some of several figures "
                                   "could not be made; what it is is told."))) +
         paragraph("2", roff(words("It could not be done; the sentence on standard error says why.")));
}

} // namespace

std::string manualPage(const CommandDescription &program, const std::string &summary,
                       const std::string &version) {
  std::string commands;
  for (const CommandDescription &command : program.commands)
    if (command.isListed)
      commands += ".SS " + bold(command.name) + arguments(command) + "\n" + roff(command.description + ".") +
                  "\n" + optionParagraphs(command);
  return ".TH HALFSPACE 1 \"\" \"" + version + "\" \"User Commands\"\n" +                              //
         ".SH NAME\n" + program.name + " \\- " + summary + "\n" +                                      //
         ".SH SYNOPSIS\n" + bold(program.name) + " [" + italic("OPTIONS") + "]" + arguments(program) + //
         "\n.br\n" + bold(program.name) + " " + italic("COMMAND") + " ...\n" +                         //
         ".SH DESCRIPTION\n" + roff(program.description) + "\n" +                                      //
         ".SH OPTIONS\n" + optionParagraphs(program) +                                                 //
         ".SH COMMANDS\n" + commands +                                                                 //
         ".SH EXIT STATUS\n" + exitStatuses();
}

} // namespace halfspace
