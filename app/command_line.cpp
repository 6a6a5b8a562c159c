#include "app/command_line.h"

#include "app/animate_options.h"
#include "app/batch_options.h"
#include "app/completion.h"
#include "app/figure_options.h"
#include "app/handout_options.h"
#include "app/manual_page.h"
#include "app/parse_refusal.h"
#include "lessons/guess.h"
#include "lessons/words.h"
#include "widgets/carriers/carrier.h"
#include "widgets/mesh_files/serve_mesh.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace halfspace {
namespace {

/// Frames are counted up to here, which is more than anybody draws.
constexpr int highestFrame = 999'999;

std::string summary() {
  return words("drag planes, points, rays and triangles, and read the exact working live");
}

PrintCommand complaint(const std::string &sentence) { return {sentence, true}; }

/// A whole number ≥ 0, and no more than highestFrame.
std::optional<int> parseFrame(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0 || value > highestFrame)
    return {};
  return value;
}

/// A:B, or A alone.
std::optional<std::pair<int, int>> parseFrames(std::string_view text) {
  const auto colon = text.find(':');
  const auto first = parseFrame(text.substr(0, colon));
  const auto last = colon == std::string_view::npos ? first : parseFrame(text.substr(colon + 1));
  if (!first || !last || *last < *first)
    return {};
  return std::pair(*first, *last);
}

/// Those of pictures that can be opened again.
std::string carrierEndings(const std::string &separator) {
  std::string endings;
  for (const Carrier &carrier : carriers())
    endings += (endings.empty() ? "" : separator) + carrier.ending;
  return endings;
}

/// What CLI11 writes into while it parses.
struct Arguments {
  WindowCommand window;
  LessonsCommand lessons;
  CheckCommand check;
  ExplainCommand explain;
  RenderCommand render;
  EvalCommand eval;
  NewLessonCommand newLesson;
  ReadMeshCommand readMesh;
  OwnLessons ownLessons;
  int step = 0;
  std::string frame;
  std::string frames;
  FigureOptions figure;
  BatchOptions batch;
  HandoutOptions handout;
  AnimateOptions animate;
};

void addOwnLessons(CLI::App &app, OwnLessons &folders) {
  app.add_option(ownLessonsOption, folders, words("A folder of lessons of your own (can be repeated)"))
      ->type_name("FOLDER")
      ->allow_extra_args(false)
      ->take_all();
}

void addAssignments(CLI::App &app, std::vector<std::string> &assignments) {
  app.add_option("--set", assignments,
                 words("Give a coordinate a value: Q=11,15,8 or E.n=0,0,1 (can be repeated)"))
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false) // one value each time: what follows it is another word
      ->take_all();
}

void addSubject(CLI::App &app, std::string &subject, std::vector<std::string> &assignments) {
  app.add_option("subject", subject,
                 words("A lesson's id, its .md file, a .halfspace file or a picture with a scene"))
      ->type_name("LESSON|FILE")
      ->required();
  addAssignments(app, assignments);
}

/// What stands without a command.
void addWindow(CLI::App &app, WindowCommand &command) {
  app.add_option("subject", command.subject,
                 words("A lesson's id, its .md file, a .halfspace file or a picture with a scene to open in "
                       "the window"))
      ->type_name("LESSON|FILE");
  app.add_option("--mesh", command.mesh, words("A mesh to aim at: an STL, OBJ or PLY file"))
      ->type_name("FILE");
}

CLI::App *addExplain(CLI::App &app, ExplainCommand &command) {
  auto *explain =
      app.add_subcommand("explain", words("Print values, worked lines and the case in plain words"));
  auto *subject =
      explain
          ->add_option("subject", command.subject,
                       words("A lesson's id, its .md file, a .halfspace file or a picture with a scene"))
          ->type_name("LESSON|FILE");
  addAssignments(*explain, command.assignments);
  explain
      ->add_option(
          "--typed", command.typedFile,
          words("In its place a scene as it is typed, an entry a line: Q = (1, 2, 3); - reads what comes in"))
      ->type_name("FILE")
      ->excludes(subject);
  explain->add_option("--format", command.format, words("How it is written"))
      ->type_name("text|latex|mathml|json")
      ->check(CLI::IsMember({"text", "latex", "mathml", "json"}).description(""))
      ->capture_default_str();
  return explain;
}

CLI::App *addHandout(CLI::App &app, HandoutOptions &options) {
  auto *handout = app.add_subcommand(
      "handout", words("Write a lesson as pages to be handed out: words, figures and worked lines as a PDF"));
  addSubject(*handout, options.command.subject, options.command.assignments);
  addHandoutOptions(*handout, options);
  return handout;
}

/// Listed in no help: it is for the window alone.
CLI::App *addReadMesh(CLI::App &app, ReadMeshCommand &command) {
  auto *readMesh = app.add_subcommand(readMeshCommand, "")->group("");
  readMesh->add_option("file", command.file, "")->required();
  return readMesh;
}

CLI::App *addRender(CLI::App &app, Arguments &arguments) {
  auto *render =
      app.add_subcommand("render", words("Draw figures, of pixels or of vectors; needs no display"));
  RenderCommand &command = arguments.render;
  render
      ->add_option(
          "subject", command.subjects,
          words("A lesson's id, its .md file, a .halfspace file or a picture with a scene, or several"))
      ->type_name("LESSON|FILE");
  addAssignments(*render, command.assignments);
  addFigureOptions(*render, arguments.figure);
  render
      ->add_flag("--anonymous", command.anonymous,
                 words("Leave the scene out of the file: {endings} can be opened again with it",
                       {{"endings", carrierEndings(", ")}}))
      ->excludes(render->get_option("--qr"));
  render->add_flag("--flat", command.flat, words("The lesson's flat picture, seen from the side"));
  auto *step =
      render
          ->add_option("--step", arguments.step,
                       words("The lesson's step to show, counted from 1; without it that of a session, the "
                             "whole figure of a lesson, or, for frames, the last step with the flight"))
          ->type_name("NUMBER");
  auto *frame =
      render->add_option("--frame", arguments.frame, words("A frame of the lesson's flight, counted from 0"))
          ->type_name("NUMBER");
  auto *frames =
      render
          ->add_option("--frames", arguments.frames,
                       words("Its frames from A to B, each in a file of its own: -o frames/%04d.png"))
          ->type_name("A:B")
          ->excludes(frame, render->get_option("--qr")); // of which one may be larger than another
  addBatchOptions(*render, arguments.batch)->excludes(step)->excludes(frame)->excludes(frames);
  return render;
}

/// The frames that are asked for; nothing where none are.
Result<std::optional<std::pair<int, int>>> framesOf(const Arguments &arguments, const CLI::App &render) {
  const bool framesGiven = render.count("--frames") > 0;
  if (!framesGiven && render.count("--frame") == 0)
    return std::optional<std::pair<int, int>>();
  const std::string &typed = framesGiven ? arguments.frames : arguments.frame;
  const auto frames = parseFrames(typed);
  if (!frames || (!framesGiven && frames->first != frames->second))
    return Problem{
        words(
            "--frame takes a number of a frame, and --frames the first and the last: 0:120, not “{frames}”.",
            {{"frames", typed}}),
        "", 0, ""};
  return frames;
}

CLI::App *addAnimate(CLI::App &app, Arguments &arguments) {
  auto *animate = app.add_subcommand(
      "animate", words("Show the scene in motion: as GIF, as a video, or as pictures; needs no display"));
  addSubject(*animate, arguments.animate.subject, arguments.animate.assignments);
  addAnimateOptions(*animate, arguments.animate);
  return animate;
}

/// `animate` is where the arguments come from.
Command finishAnimate(const Arguments &arguments, const CLI::App &animate) {
  auto command = animateCommandOf(arguments.animate, animate);
  if (!command)
    return complaint(command.problem().sentence);
  command->ownLessons = arguments.ownLessons;
  return *command;
}

/// `render` is where the arguments come from.
Command finishRender(const Arguments &arguments, const CLI::App &render) {
  RenderCommand command = arguments.render;
  const auto frames = framesOf(arguments, render);
  if (!frames)
    return complaint(frames.problem().sentence);
  command.frames = *frames;
  for (const std::string &output : arguments.figure.outputs) {
    const auto choices = choicesOf(output, arguments.figure, render);
    if (!choices)
      return complaint(choices.problem().sentence);
    const auto name = OutputName::parse(output, command.frames.has_value());
    if (!name)
      return complaint(name.problem().sentence);
    command.outputs.push_back({*name, *choices});
  }
  const bool stepGiven = render.count("--step") > 0;
  if (stepGiven && arguments.step < 1)
    return complaint(words("--step counts from 1."));
  if (stepGiven)
    command.steps = {arguments.step};
  if (const auto problem = takeBatchOptions(arguments.batch, render, command))
    return complaint(problem->sentence);
  return command;
}

OptionDescription descriptionOf(const CLI::Option &option) {
  return {option.get_snames(),      option.get_lnames(),      option.get_type_name(),
          option.get_description(), option.get_default_str(), option.get_items_expected_max(),
          option.get_positional(),  option.get_required()};
}

CommandDescription descriptionOf(const CLI::App &app) {
  CommandDescription command{app.get_name(), app.get_description(), !app.get_group().empty(), {}, {}};
  if (!app.get_parent()) // CLI11 hands the footer on to all commands
    command.description += " " + app.get_footer();
  for (const CLI::Option *option : app.get_options())
    command.options.push_back(descriptionOf(*option));
  for (const CLI::App *subcommand : app.get_subcommands({}))
    command.commands.push_back(descriptionOf(*subcommand));
  return command;
}

/// What a shell or the build asks about the command line itself: it is not read as arguments.
std::optional<Command> aboutItself(const CLI::App &app, int argc, const char *const *argv) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty())
    return {};
  if (words.front() == completeCommand)
    return completionOf(descriptionOf(app), {words.begin() + 1, words.end()});
  if (words.front() == manualPageCommand)
    return PrintCommand{manualPage(descriptionOf(app), summary(), app.version())};
  return {};
}

/// A guess where what stands in the place of a lesson is nearly a command: `explin`; else empty.
std::string commandMeant(const CLI::App &app, const std::optional<std::string> &subject) {
  std::vector<std::string> names;
  for (const CLI::App *command : app.get_subcommands({}))
    if (!command->get_group().empty())
      names.push_back(command->get_name());
  const std::string meant = subject ? nearestOf(*subject, names) : std::string();
  return meant.empty() ? std::string()
                       : words("Perhaps the command “{command}” is meant.", {{"command", meant}});
}

std::string refusalOf(const CLI::ParseError &error, const std::string &guess) {
  const std::string problem = parseRefusal(error.what());
  return guess.empty()
             ? words("{problem}. Try halfspace --help.", {{"problem", problem}})
             : words("{problem}. {guess} Try halfspace --help.", {{"problem", problem}, {"guess", guess}});
}

/// What CLI11 would say of itself.
void translateHelp(CLI::App &app) {
  app.option_defaults()->group(words("Options"));
  app.set_help_flag("-h,--help", words("Print this help message and exit"));
  app.set_version_flag("--version", "halfspace " HALFSPACE_VERSION,
                       words("Display program version information and exit"));
  const auto formatter = std::make_shared<CLI::Formatter>();
  for (const auto &[label, text] : {std::pair("Usage", words("Usage")),
                                    {"OPTIONS", words("OPTIONS")},
                                    {"SUBCOMMAND", words("SUBCOMMAND")},
                                    {"SUBCOMMANDS", words("SUBCOMMANDS")},
                                    {"Positionals", words("Positionals")},
                                    {"REQUIRED", words("REQUIRED")},
                                    {"Excludes", words("Excludes")}})
    formatter->label(label, text);
  app.formatter(formatter);
}

} // namespace

Command parseCommandLine(int argc, const char *const *argv) {
  Arguments arguments;
  CLI::App app(words("Halfspace: {summary}.", {{"summary", summary()}}), "halfspace");
  translateHelp(app);
  app.footer(words("Without a command, `halfspace [LESSON|FILE]` opens the window."));
  addWindow(app, arguments.window);
  auto *lessons = app.add_subcommand("lessons", words("List the lessons: id and title"));
  lessons->add_flag("--json", arguments.lessons.json, words("As JSON"));
  addOwnLessons(app, arguments.ownLessons);
  addOwnLessons(*lessons, arguments.ownLessons); // what it is called itself does not fall through
  app.fallthrough();                             // it may stand behind the other commands
  auto *newLesson =
      app.add_subcommand("new-lesson", words("Write a lesson to begin with: ID.md in this folder"));
  newLesson->add_option("id", arguments.newLesson.id, words("Small letters, digits and hyphens"))
      ->type_name("ID")
      ->required();
  auto *constructionList = app.add_subcommand(
      "constructions", words("Print the names that lessons can use: cases, values, lines and marks"));
  auto *check = app.add_subcommand("check", words("Say what is wrong in lesson files, and where"));
  check
      ->add_option("paths", arguments.check.paths,
                   words("Files, or folders of them; without any, the lessons of this program"))
      ->type_name("FILE|FOLDER");
  auto *explain = addExplain(app, arguments.explain);
  auto *render = addRender(app, arguments);
  auto *handout = addHandout(app, arguments.handout);
  auto *animate = addAnimate(app, arguments);
  auto *eval = app.add_subcommand("eval", words("Answer geometry questions, one JSON object a line"));
  eval->add_option("file", arguments.eval.file,
                   words("The file with the questions; standard input without one"))
      ->type_name("FILE");
  auto *readMesh = addReadMesh(app, arguments.readMesh);
  for (CLI::App *command : app.get_subcommands({})) {
    if (!command->get_group().empty())
      command->group(words("Subcommands"));
    command->get_help_ptr()->group(
        words("Options")); // CLI11 adds it before it asks what options have in common
  }
  app.require_subcommand(0, 1);
  if (auto asked = aboutItself(app, argc, argv))
    return *asked;

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    if (error.get_exit_code() != 0)
      return complaint(refusalOf(error, commandMeant(app, arguments.window.subject)));
    std::ostringstream out;
    std::ostringstream unused;
    app.exit(error, out, unused);
    return PrintCommand{out.str()};
  }
  if (arguments.window.subject && !app.get_subcommands().empty())
    return complaint(words("“{subject}” stands before a command: the lesson or file comes after it.",
                           {{"subject", *arguments.window.subject}}));
  if (arguments.window.mesh && !app.get_subcommands().empty())
    return complaint(words("--mesh is for the window: no command draws or explains a mesh of yours."));
  arguments.window.ownLessons = arguments.lessons.ownLessons = arguments.ownLessons;
  arguments.explain.ownLessons = arguments.render.ownLessons = arguments.handout.command.ownLessons =
      arguments.ownLessons;
  if (lessons->parsed())
    return arguments.lessons;
  if (newLesson->parsed())
    return arguments.newLesson;
  if (constructionList->parsed())
    return ConstructionsCommand();
  if (check->parsed())
    return arguments.check;
  if (explain->parsed() && explain->count("subject") == 0 && !arguments.explain.typedFile)
    return complaint(words("Say what to explain: a lesson, a file, or lines with --typed."));
  if (explain->parsed())
    return arguments.explain;
  if (eval->parsed())
    return arguments.eval;
  if (readMesh->parsed())
    return arguments.readMesh;
  if (handout->parsed()) {
    const auto command = handoutCommandOf(arguments.handout);
    return command ? Command(*command) : complaint(command.problem().sentence);
  }
  if (render->parsed())
    return finishRender(arguments, *render);
  if (animate->parsed())
    return finishAnimate(arguments, *animate);
  return arguments.window;
}

} // namespace halfspace
