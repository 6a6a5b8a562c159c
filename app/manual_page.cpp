#include "app/manual_page.h"

#include "lessons/text.h"

namespace halfspace {
namespace {

/// A text that roff shows as it is: a hyphen stays one when it is copied, and no line begins a request.
std::string roff(const std::string &text) {
  return "\\&" + replacedAll(replacedAll(text, "\\", "\\e"), "-", "\\-");
}

std::string bold(const std::string &text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string &text) { return "\\fI" + roff(text) + "\\fR"; }

/// LESSON, [FILE] or [FILE]...
std::string argument(const CLI::Option &option) {
  const std::string name = italic(option.get_type_name());
  const std::string many = option.get_items_expected_max() > 1 ? "..." : "";
  return (option.get_required() ? name : "[" + name + "]") + many;
}

std::string arguments(const CLI::App &app) {
  std::string all;
  for (const CLI::Option *option : app.get_options())
    if (option->get_positional())
      all += " " + argument(*option);
  return all;
}

/// -o FILE, --output FILE
std::string optionNames(const CLI::Option &option) {
  std::string names;
  const auto add = [&](const std::string &name) {
    names += (names.empty() ? "" : ", ") + bold(name);
    if (option.get_items_expected_max() > 0)
      names += " " + italic(option.get_type_name());
  };
  for (const std::string &name : option.get_snames())
    add("-" + name);
  for (const std::string &name : option.get_lnames())
    add("--" + name);
  return names;
}

std::string paragraph(const std::string &title, const std::string &text) {
  return ".TP\n" + title + "\n" + text + "\n";
}

/// Arguments first, as they are written.
std::string optionParagraphs(const CLI::App &app) {
  std::string positional;
  std::string named;
  for (const CLI::Option *option : app.get_options()) {
    std::string text = roff(option->get_description() + ".");
    if (const std::string usual = option->get_default_str(); !usual.empty())
      text += " Without it: " + roff(usual) + ".";
    if (option->get_positional())
      positional += paragraph(argument(*option), text);
    else
      named += paragraph(optionNames(*option), text);
  }
  return positional + named;
}

} // namespace

std::string manualPage(const CLI::App &app, const std::string &summary) {
  const std::string name = app.get_name();
  std::string commands;
  for (const CLI::App *command : app.get_subcommands({}))
    if (!command->get_group().empty())
      commands += ".SS " + bold(command->get_name()) + arguments(*command) + "\n" +
                  roff(command->get_description() + ".") + "\n" + optionParagraphs(*command);
  return ".TH HALFSPACE 1 \"\" \"" + app.version() + "\" \"User Commands\"\n" +                        //
         ".SH NAME\n" + name + " \\- " + summary + "\n" +                                              //
         ".SH SYNOPSIS\n" + bold(name) + " [" + italic("OPTIONS") + "]" + arguments(app) + "\n.br\n" + //
         bold(name) + " " + italic("COMMAND") + " ...\n" +                                             //
         ".SH DESCRIPTION\n" + roff(app.get_description() + " " + app.get_footer()) + "\n" +           //
         ".SH OPTIONS\n" + optionParagraphs(app) +                                                     //
         ".SH COMMANDS\n" + commands;
}

} // namespace halfspace
