// The command line: what was asked for, before anything is done about it.
#pragma once

#include "app/batch/figure_plan.h"
#include "app/figures/figure_choices.h"
#include "widgets/animation/film.h"
#include "widgets/handout/handout_look.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace halfspace {

/// Folders of a teacher's own lessons.
using OwnLessons = std::vector<std::string>;
inline constexpr const char *ownLessonsOption = "--lessons";

struct WindowCommand {
  std::optional<std::string>
      subject; ///< a lesson's id, its .md file, a .halfspace file or a picture; nothing: the first lesson
  OwnLessons ownLessons{};           ///< besides those of the settings
  std::optional<std::string> mesh{}; ///< a file to open in it
};

struct LessonsCommand {
  bool json = false;
  OwnLessons ownLessons{};
};

/// Write a lesson to begin with.
struct NewLessonCommand {
  std::string id;
};

/// Print the reference of all constructions.
struct ConstructionsCommand {};

struct CheckCommand {
  std::vector<std::string> paths; ///< lesson files and folders of them; none: the program's own lessons
};

struct ExplainCommand {
  std::string subject;
  std::optional<std::string> typedFile{}; ///< in the place of a subject: lines of a scene; -: standard input
  std::vector<std::string> assignments;   ///< name=value
  std::string format = "text";            ///< text, latex, mathml or json
  OwnLessons ownLessons{};
};

/// A file of each figure, or of several formats.
struct FigureOutput {
  OutputName name;
  FigureChoices choices{};
};

struct RenderCommand {
  std::vector<std::string> subjects;
  bool allLessons = false; ///< in the place of subjects
  std::vector<std::string> assignments;
  std::vector<FigureOutput> outputs; ///< at least one
  OwnLessons ownLessons{};
  bool anonymous = false; ///< without the session, with which the picture could be opened again
  bool flat = false;      ///< the lesson's flat picture in the place of the one in space
  /// Counted from 1, as the window counts, a figure each; none: that of a session's file, the whole figure of
  /// a lesson, or, of frames, the flight's step.
  std::vector<int> steps{};
  bool eachStep = false;                       ///< all that a lesson has
  std::optional<std::pair<int, int>> frames{}; ///< of the lesson's flight, the first and the last
  std::optional<std::string> rowsFile{};       ///< with values, a row for each figure
  bool onlyChanged = false;                    ///< figures that are there as they would be made stay
  std::string options{};                       ///< all that were given or are usual, on which looks depend
  Shard shard{};
};

/// Write a lesson as pages to be handed out.
struct HandoutCommand {
  std::string subject;
  std::vector<std::string> assignments;
  std::string output;
  std::vector<int> steps{}; ///< counted from 1, in their order; none: all
  HandoutPaper paper = HandoutPaper::A4;
  int columns = 1; ///< 1 or 2
  HiddenLines hidden = HiddenLines::Dashed;
  bool hasAnswers = false;
  bool isAnonymous = false; ///< without the session, with which the handout could be opened again
  OwnLessons ownLessons{};
};

struct AnimateCommand {
  std::string subject;
  std::vector<std::string> assignments;
  OwnLessons ownLessons{};
  const MotionKind *motion = nullptr;      ///< never null once it is read
  const AnimationFormat *format = nullptr; ///< likewise
  FilmRequest film{};
  std::optional<double> seconds{}; ///< nothing: as many as the motion takes by itself
  std::optional<int> step{}; ///< counted from 1; nothing: that of a session's file, or as the motion chooses
};

struct EvalCommand {
  std::optional<std::string> file; ///< nothing or -: standard input
};

/// Read a mesh file for the window, which starts this as a process of its own.
struct ReadMeshCommand {
  std::string file;
};

/// Tell a shell what the word that is being typed may become.
struct CompleteCommand {
  enum class Files { None, Folders, All };

  std::string typed;              ///< the word so far
  std::vector<std::string> words; ///< that begin so
  bool lessons = false;           ///< the ids of lessons may stand there, too
  Files files = Files::None;      ///< so may files and folders, which the shell knows
  OwnLessons ownLessons{};
};

/// Nothing is left to do but to print a text (--help, --version) or a complaint.
struct PrintCommand {
  std::string text;
  bool refused = false; ///< the arguments are: the text is the sentence that says why
};

using Command = std::variant<WindowCommand, LessonsCommand, NewLessonCommand, ConstructionsCommand,
                             CheckCommand, ExplainCommand, RenderCommand, HandoutCommand, AnimateCommand,
                             EvalCommand, ReadMeshCommand, CompleteCommand, PrintCommand>;

/// Reads the arguments (argv[0] included). A bad one gives a PrintCommand with one sentence.
[[nodiscard]] Command parseCommandLine(int argc, const char *const *argv);

} // namespace halfspace
