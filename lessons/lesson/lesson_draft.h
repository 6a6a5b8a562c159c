// A lesson while somebody makes it of a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace halfspace {

/// An answer: what the value must be for it to be right, or `otherwise`, and what the learner reads.
struct DraftChoice {
  std::string word;
  std::string text;
  bool operator==(const DraftChoice &) const = default;
};

/// A question that is asked before the numbers are shown, see Prediction.
struct DraftQuestion {
  std::string ask;
  std::string value; ///< that decides, as lessons name it
  std::vector<DraftChoice> choices;
  std::string why;
  bool operator==(const DraftQuestion &) const = default;
};

/// Something to bring about, see Task.
struct DraftTask {
  std::string instruction;
  std::string condition; ///< as lessons write it: `side = negative`
  bool operator==(const DraftTask &) const = default;
};

/// A step shows all of the scene but what it hides. Its texts are Markdown, but for its title.
struct DraftStep {
  std::string title;
  std::string words;                   ///< may be empty
  std::vector<std::string> workings{}; ///< the constructions whose lines it shows
  std::vector<std::string> hidden{};   ///< the entries that it does not show
  std::optional<DraftQuestion> question{};
  std::optional<DraftTask> task{};
  bool operator==(const DraftStep &) const = default;
};

struct LessonDraft {
  std::string id;
  std::string title;
  std::vector<DraftStep> steps;
  bool operator==(const LessonDraft &) const = default;
};

/// What keeps a draft from being a lesson.
struct DraftProblem {
  std::optional<std::size_t> step; ///< counted from 0; nothing: it is of the lesson as a whole
  std::string sentence;
};

/// As files have it: without white space around its texts, every end of a line the same, texts other than the
/// words of steps without tabs; conditions as `toText` writes them.
[[nodiscard]] LessonDraft tidied(LessonDraft draft);

/// What is missing in a draft, and which of its texts would be read as something else; from top to bottom.
/// The names in it are left to the checks of the lesson.
[[nodiscard]] std::vector<DraftProblem> problemsOf(const LessonDraft &draft);

} // namespace halfspace
