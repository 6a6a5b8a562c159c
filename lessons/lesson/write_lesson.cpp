#include "lessons/lesson/write_lesson.h"

#include "lessons/lesson/lesson_markup.h"
#include "lessons/reading/yaml_text.h"
#include "lessons/scene/file/large_meshes.h"
#include "lessons/scene/file/scene_yaml.h"
#include "lessons/text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace halfspace {
namespace {

/// A name between the fields of a document, or in a block.
std::string field(std::string_view name, std::string_view text) {
  return std::string(name) + ": " + yamlLines(text) + "\n";
}

/// In decimals, without those behind a millionth.
std::string decimalOf(double number) {
  constexpr int places = 6;
  std::array<char, 400> digits{}; // the largest double has 309 before the point
  const auto written =
      std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::fixed, places);
  std::string text(digits.data(), written.ptr);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.')
    text.pop_back();
  return text;
}

std::string placeOf(const glm::dvec3 &place) {
  return "[" + decimalOf(place.x) + ", " + decimalOf(place.y) + ", " + decimalOf(place.z) + "]";
}

std::string frontMatterOf(const LessonDraft &draft, const Scene &scene, const CameraView &camera) {
  return "---\n" + field("id", draft.id) + field("title", draft.title) +
         (scene.entries.empty() ? "scene: []\n" : "scene:\n" + yamlOf(scene)) +
         "camera: {from: " + placeOf(camera.from) + ", at: " + placeOf(camera.at) +
         ", height: " + decimalOf(camera.height) + "}\n---\n";
}

/// A fence that no line of a text closes.
std::string fenceAround(std::string_view text) {
  constexpr std::size_t shortest = 3;
  std::size_t longest = 0;
  std::size_t run = 0;
  for (const char c : text) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  std::string fence(std::max(shortest, longest + 1), '`');
  return fence;
}

/// A block of its step, behind an empty line.
std::string block(std::string_view word, const std::string &content) {
  const std::string fence = fenceAround(content);
  return "\n" + fence + std::string(word) + "\n" + content + fence + "\n";
}

std::string listed(const std::vector<std::string> &names, std::string_view behindEach) {
  std::string list;
  for (const std::string &name : names)
    list += (list.empty() ? "" : ", ") + name + std::string(behindEach);
  return list + "\n";
}

std::string questionBlock(const DraftQuestion &question) {
  std::string fields = field("ask", question.ask) + field("answer", question.value) + "choices:\n";
  for (const DraftChoice &choice : question.choices)
    fields += "  " + yamlText(choice.word) + ": " + replacedAll(yamlLines(choice.text), "\n", "\n  ") + "\n";
  return block("predict", fields + field("why", question.why));
}

/// What a step shows of a scene with constructions: their lines where it says so, all of the picture.
std::string shownBlocks(const DraftStep &step) {
  return block("lines", step.workings.empty() ? std::string(noLines) + "\n" : listed(step.workings, ".*")) +
         block("draw", std::string(allMarks) + "\n");
}

std::string textOf(const DraftStep &step, bool hasConstructions) {
  std::string text = "## " + step.title + "\n";
  if (!step.words.empty())
    text += "\n" + step.words + "\n";
  if (step.question)
    text += questionBlock(*step.question);
  if (step.task) // above the lines, which are of different length while somebody does it
    text += block("task", field("do", step.task->instruction) + field("when", step.task->condition));
  if (hasConstructions)
    text += shownBlocks(step);
  if (!step.hidden.empty())
    text += block("hide", listed(step.hidden, ""));
  return text;
}

} // namespace

std::optional<std::size_t> WrittenLesson::stepAt(int line) const {
  const auto behind = std::upper_bound(stepLines.begin(), stepLines.end(), line) - stepLines.begin();
  return behind == 0 ? std::nullopt : std::optional(static_cast<std::size_t>(behind) - 1);
}

WrittenLesson writeLesson(const LessonDraft &draft, const Scene &scene, const CameraView &camera) {
  const LessonDraft tidy = tidied(draft);
  const Scene written = withoutLargeMeshes(scene);
  const bool hasConstructions =
      std::any_of(written.entries.begin(), written.entries.end(),
                  [](const Entry &entry) { return std::holds_alternative<ConstructionUse>(entry.content); });
  WrittenLesson lesson{frontMatterOf(tidy, written, camera), {}};
  for (const DraftStep &step : tidy.steps) {
    if (!lesson.stepLines.empty())
      lesson.text += "\n";
    const auto before = std::count(lesson.text.begin(), lesson.text.end(), '\n');
    lesson.stepLines.push_back(static_cast<int>(before) + 1);
    lesson.text += textOf(step, hasConstructions);
  }
  return lesson;
}

} // namespace halfspace
