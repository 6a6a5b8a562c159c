// A lesson: a Markdown file with YAML front matter (id, title, sources, macros, scene, camera, shadows,
// flat), its steps as second-level headings.
//
//   ---
//   id: signed-distance
//   title: How far is a point from a plane?
//   order: 2
//   chapter: Distances
//   needs: [plane-implicit]
//   sources: [PG 3.4, PG 3.5]
//   macros: {length: '\lvert #1\rvert'}
//   scene:
//     - {name: E, plane: {P0: [5, 4, 7], n: [1, 2, 2]}}
//     - {name: Q, point: [11, 15, 8]}
//     - {name: distance, construction: signed-distance, of: {E: E, Q: Q}}
//   camera: {from: [1.25, -0.1, 0.6], at: [6, 8, 4], height: 21}
//   ---
//   ## The side
//   Words with $f(Q)$ in LaTeX and live values by name: f(Q) is now {f}.
//   ```lines
//   f, side
//   ```
//   ```blank
//   last
//   ```
//   ```task
//   do: Drag Q to the other side.
//   when: side = negative
//   hints: ['The sign of f(Q) tells the side.', 'Drag Q through E.']
//   ```
//   ```predict
//   ask: On which side of the plane is Q?
//   answer: side
//   choices: {positive: The side that n points to, negative: The other side, on: On the plane}
//   why: The sign of f(Q) tells.
//   ```
//   ```draw
//   F
//   ```
//   ```hide
//   E
//   ```
//   ```flight
//   {frame: frame, seed: seed, hits: nearest, first-seed: 7}
//   ```
//   ```fragments
//   {hits: nearest}
//   ```
//   ```cost
//   {hits: nearest}
//   ```
//   ```term
//   {name: signed distance, also: [signed distances], means: How far a point is from a plane.}
//   ```
//   ```formulas
//   The signed distance of $Q$ from the plane:
//
//   $$d = \frac{f(Q)}{\lvert\vec n\rvert}$$
//   ```
//   ```note
//   A slip in the lecture notes
//   Words that are folded away.
//   ```
#pragma once

#include "lessons/construction/condition.h"
#include "lessons/lesson/macros.h"
#include "lessons/lesson/practice.h"
#include "lessons/reading/markdown_text.h"
#include "lessons/result.h"
#include "lessons/scene/camera_view.h"
#include "lessons/scene/evaluation.h"

#include <filesystem>
#include <variant>

namespace halfspace {

/// Something to bring about in the scene; it is done once all conditions hold.
struct Task {
  struct Hint {
    MarkdownText text;
    int line = 0; ///< in the file
  };
  MarkdownText instruction;
  Conditions conditions; ///< of values as findValue finds them; `when:` lines join them with `and`
  MarkdownText now{};    ///< how far the learner is, told until the task is done; may be empty
  MarkdownText answer{}; ///< to what the instruction asks, told once it is done; empty where it asks nothing
  std::vector<Hint> hints{}; ///< told one by one, when asked for; each leads farther than the one before
  // In the file:
  int line = 0; ///< of the instruction
  int conditionsLine = 0;
  int nowLine = 0;
  int answerLine = 0;
};

/// The word of a choice that is right when none of the others is.
inline constexpr const char *otherwise = "otherwise";

/// A question that hides the numbers until the learner has chosen an answer. Its words hold whatever the
/// scene is: a live value stands there as it is written.
struct Prediction {
  struct Choice {
    std::string word; ///< what the value must be for this choice to be right, or `otherwise`
    MarkdownText text;
    int line = 0; ///< in the file
  };
  MarkdownText question;
  std::string value; ///< the name of the value that decides, see findValue
  std::vector<Choice> choices;
  MarkdownText reason;
  // In the file:
  int questionLine = 0;
  int valueLine = 0;
  int reasonLine = 0;
};

/// Markdown with LaTeX and live values. Its pictures are shown; those of all other texts of a step are
/// described.
struct StepWords {
  MarkdownText text;
  std::vector<int> lines{}; ///< where each of its lines stands in the file
};

/// Worked lines, by their ids: `distance.f`, `f` where only one construction has an f, or `distance.*` for
/// all of one; empty: all; `none`: none.
struct StepLines {
  std::vector<std::string> ids;
  std::vector<int> lines{}; ///< where each of them stands in the file
};

/// Words that are folded away under their title, for those whom they concern.
struct StepNote {
  std::string title; ///< plain text, as those of steps
  StepWords words;
};

/// Seeds of chance go from 1 to this.
inline constexpr int largestSeed = 999;

/// The controls of a torpedo's flight, with the axis of its parameter. All are names of the scene's entries.
struct StepFlight {
  std::string frame; ///< the number that the clock moves
  std::string seed;  ///< the number that is 0 as long as the saucer is fired by hand
  std::string hits;  ///< the construction whose crossings the axis shows
  int firstSeed = 1; ///< with which it fires by itself at first
  int line = 0;      ///< in the file
};

/// A table of what a ray meets of many triangles.
struct StepFragments {
  std::string hits;      ///< the construction whose crossings it shows
  bool byNumber = false; ///< as they are asked one after the other, not sorted by their parameters
  int line = 0;          ///< in the file
};

/// A plot, measured on the spot, of what it costs to find the nearest hit of a ray in the scene, and among
/// ever more triangles.
struct StepCost {
  std::string hits; ///< the entry whose ray it is, and whose triangles
  int line = 0;     ///< in the file
};

/// What stands on the page of a step.
using StepBlock =
    std::variant<StepWords, StepLines, StepNote, Task, Prediction, StepFlight, StepFragments, StepCost>;

/// A term that a step introduces, for the glossary. Plain text but for its meaning.
struct TaughtTerm {
  std::string name;
  std::vector<std::string> also{}; ///< its other forms and names
  MarkdownText meaning;            ///< a sentence, without live values
  // In the file:
  int line = 0;
  int meaningLine = 0;
};

struct LessonStep {
  std::string title;
  std::vector<StepBlock> blocks; ///< from top to bottom; at least one StepLines and at most one Prediction
  /// The marks that its figure has besides the given ones and those that its lines speak of, named as lines
  /// are.
  std::vector<std::string> drawn{};
  /// It has the results of all constructions, and all marks of those whose lines it shows.
  bool drawsAllResults = false;
  std::optional<Fading> blank{}; ///< which lines the step leaves to the learner; nothing: as it was before
  std::vector<int> drawnLines{}; ///< where each of the marks is named in the file
  std::vector<TaughtTerm> terms{};
  std::vector<StepWords> formulas{}; ///< to be kept; not on the page, see chapter_formulas.h
  std::vector<std::string> hidden{}; ///< entries of the scene of which its figure has nothing
  std::vector<int> hiddenLines{};    ///< where each of them is named in the file
};

// The blocks of one sort, from top to bottom.

/// Null in a step without a flight.
[[nodiscard]] const StepFlight *flightOf(const LessonStep &step);
/// Null in a step that asks nothing.
[[nodiscard]] const Prediction *predictionOf(const LessonStep &step);
/// Their places among the tasks of the step number what a learner has done.
[[nodiscard]] std::vector<Task> tasksOf(const LessonStep &step);

/// How a lesson's second, flat picture lies: two directions of its scene span the page. Both are seen in
/// their true length, and so is every angle between what lies along them.
struct FlatPage {
  CoordinateId up;    ///< points upwards
  CoordinateId right; ///< points to the right, and up or down as far as it is not at a right angle to that
  bool operator==(const FlatPage &) const = default;
};

/// A lesson that another builds on.
struct Need {
  std::string id;
  int line = 0; ///< of the file
};

struct Lesson {
  std::string id;
  int idLine = 0; ///< of the file
  std::string title;
  int order = 0;       ///< its place in the list of lessons
  std::string chapter; ///< that it stands in, as people read it; may be empty
  std::vector<Need> needs;
  std::string file; ///< that it was read from
  std::string text; ///< of that, as it was read
  std::vector<std::string> sources;
  Macros macros; ///< of the LaTeX in its words
  Scene scene;
  CameraView camera;
  bool hasShadows = true;         ///< on the ground of its picture
  std::optional<FlatPage> flat{}; ///< nothing: there is only the picture in space
  std::vector<LessonStep> steps;
};

/// The words behind the fences of blocks that are no code: `lines`, `task`.
[[nodiscard]] const std::vector<std::string> &instructionBlocks();

/// Reads a lesson from the text of a file; `file` is only named in problems.
[[nodiscard]] Result<Lesson> parseLesson(std::string_view text, const std::string &file);

/// Reads a lesson file of at most `maxLessonBytes`.
[[nodiscard]] Result<Lesson> readLesson(const std::filesystem::path &file);
inline constexpr std::size_t maxLessonBytes = 1 << 20;
inline constexpr std::size_t mostMacros = 100;
inline constexpr std::size_t mostHints = 3;      ///< of a task
inline constexpr std::size_t longestMacro = 500; ///< bytes

/// The step of this number, counted from 0; where the lesson has none, one that shows everything.
[[nodiscard]] const LessonStep &stepOf(const Lesson &lesson, int step);

/// The lessons of a folder in their order, and what kept others from being read.
struct LessonLibrary {
  std::vector<Lesson> lessons;
  std::vector<Problem> problems;

  /// The lesson with an id, or null; see also `exploreLesson`, which is no lesson of a folder.
  [[nodiscard]] const Lesson *find(std::string_view id) const;
  /// Puts a lesson into the place of the one with its id, in whose chapter it stands then, or behind all
  /// others, as one of a teacher's own.
  void put(Lesson lesson);
};
[[nodiscard]] LessonLibrary readLessons(const std::filesystem::path &folder);

/// Goes on with a teacher's own lessons of a folder, in their order. Those that name no chapter stand in one
/// of their own; one whose id is taken is a problem.
void addOwnLessons(LessonLibrary &library, const std::filesystem::path &folder);

/// Whether a condition holds of a value as findValue finds it; false for one that the case does not have.
[[nodiscard]] bool holds(const Condition &condition, const Evaluation &evaluation);
[[nodiscard]] bool isDone(const Task &task, const Evaluation &evaluation);

/// The word of the choice that is right for what a scene comes to; empty where none is.
[[nodiscard]] std::string rightChoice(const Prediction &prediction, const Evaluation &evaluation);

} // namespace halfspace
