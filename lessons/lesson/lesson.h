// A lesson: a Markdown file with YAML front matter (id, title, sources, macros, scene, camera), its steps as
// second-level headings.
//
//   ---
//   id: signed-distance
//   title: How far is a point from a plane?
//   order: 2
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
//   ```
//   ```predict
//   ask: On which side of the plane is Q?
//   answer: side
//   choices: {positive: The side that n points to, negative: The other side, on: On the plane}
//   why: The sign of f(Q) tells.
//   ```
#pragma once

#include "lessons/lesson/macros.h"
#include "lessons/lesson/practice.h"
#include "lessons/reading/problem.h"
#include "lessons/scene/evaluation.h"

#include <filesystem>

namespace halfspace {

/// One comparison of a named value with a number or a word; `when:` lines join them with `and`.
struct Condition {
  enum class Relation { Equal, NotEqual, Less, LessOrEqual, Greater, GreaterOrEqual };
  std::string value; ///< the name of a value, see findValue
  Relation relation = Relation::Equal;
  std::string against; ///< a word, or a number as parseRational reads it
};

/// Something to bring about in the scene; it is done once all conditions hold.
struct Task {
  std::string instruction;
  std::vector<Condition> conditions;
  int line = 0; ///< of the instruction in the file
};

/// A question that hides the numbers until the learner has chosen an answer.
struct Prediction {
  struct Choice {
    std::string word; ///< what the value must be for this choice to be right
    std::string text;
    int line = 0; ///< in the file
  };
  std::string question;
  std::string value; ///< the name of the value that decides, see findValue
  std::vector<Choice> choices;
  std::string reason;
  // In the file:
  int questionLine = 0;
  int reasonLine = 0;
};

struct LessonStep {
  std::string title;
  std::string markdown; ///< the words, without the title and the fenced blocks above
  /// The worked lines shown: `distance.f`, `f` where only one construction has an f, or `distance.*` for all
  /// of one; empty: all.
  std::vector<std::string> lines;
  std::vector<Task> tasks;
  std::optional<Prediction> prediction;
  std::optional<Fading> blank{};    ///< which lines the step leaves to the learner; nothing: as it was before
  std::vector<int> markdownLines{}; ///< where each line of the words stands in the file
};

/// Where the camera stands: it looks from the direction `from` at the point `at`, and `height` scene units
/// fill the view from bottom to top there.
struct CameraView {
  glm::dvec3 from{1.25, -0.10, 0.60};
  glm::dvec3 at{6.0, 8.0, 4.0};
  double height = 21;
};

struct Lesson {
  std::string id;
  std::string title;
  int order = 0;    ///< its place in the list of lessons
  std::string file; ///< that it was read from
  std::vector<std::string> sources;
  Macros macros; ///< of the LaTeX in its words
  Scene scene;
  CameraView camera;
  std::vector<LessonStep> steps;
};

/// A piece of a lesson's words, with `$…$` LaTeX.
struct LessonWords {
  std::string text;
  std::vector<int> lines; ///< where its lines stand in the file; one for all where YAML has folded them
  std::string field;      ///< of a block; empty for the words of a step

  /// The line of the file that a place in the text is of.
  [[nodiscard]] int lineAt(std::size_t place) const;
};

/// All words that are set with their formulas, from top to bottom within a step.
[[nodiscard]] std::vector<LessonWords> wordsOf(const Lesson &lesson);

/// Reads a lesson from the text of a file; `file` is only named in problems.
[[nodiscard]] Result<Lesson> parseLesson(std::string_view text, const std::string &file);

/// Reads a lesson file of at most `maxLessonBytes`.
[[nodiscard]] Result<Lesson> readLesson(const std::filesystem::path &file);
inline constexpr std::size_t maxLessonBytes = 1 << 20;
inline constexpr std::size_t mostMacros = 100;
inline constexpr std::size_t longestMacro = 500; ///< bytes

/// The lessons of a folder in their order, and what kept others from being read.
struct LessonLibrary {
  std::vector<Lesson> lessons;
  std::vector<Problem> problems;

  [[nodiscard]] const Lesson *find(std::string_view id) const;
};
[[nodiscard]] LessonLibrary readLessons(const std::filesystem::path &folder);

/// Whether a condition holds; false for a value that the case does not have.
[[nodiscard]] bool holds(const Condition &condition, const Evaluation &evaluation);
[[nodiscard]] bool isDone(const Task &task, const Evaluation &evaluation);

/// The markdown with each `{name}` of a value replaced by the value, as `$…$` LaTeX for numbers.
/// `{Q}` and `{E.n}` name the scene's coordinates.
[[nodiscard]] std::string withLiveValues(const std::string &markdown, const Scene &scene,
                                         const Evaluation &evaluation);

/// What a step shows of a scene.
struct Shown {
  Working working;
  Figure figure;
  std::string description; ///< the cases of the constructions whose lines are shown, in plain words
  bool degenerate = false; ///< one of them is a warning
};

/// The step's lines and, of the figure, which is that of the evaluation, the given marks, those that these
/// lines name, and what accompanies them. Where the step names no lines, all marks and the lines of the last
/// `mostWorkings` constructions.
[[nodiscard]] Shown shownIn(const LessonStep &step, const Evaluation &evaluation, Figure figure);
[[nodiscard]] inline Shown shownIn(const LessonStep &step, const Evaluation &evaluation) {
  return shownIn(step, evaluation, figureOf(evaluation));
}
inline constexpr std::size_t mostWorkings = 4;

} // namespace halfspace
