#include "lessons/lesson/lesson_fields.h"

#include "lessons/lesson/condition.h"
#include "lessons/lesson/lesson_markup.h"
#include "lessons/reading/value_name.h"
#include "lessons/scene/file/camera_reader.h"
#include "lessons/scene/file/scene_reader.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <sstream>

namespace halfspace {
namespace {

/// Front matter nests five deep: scene, entry, object, vector, number.
constexpr int maxFrontMatterDepth = 12;
constexpr int highestOrder = 10000;

/// A text is neither empty nor longer than others in the file.
void checkText(const DocumentNode &text, const std::string &field, FieldReader &fields) {
  if (text.text.empty())
    fields.complain(text, field, words("This text is empty: write it, or take it away."));
  if (text.text.size() > maxFieldText)
    fields.complain(text, field,
                    words("This text is too long: at most {limit} bytes are read.",
                          {{"limit", std::to_string(maxFieldText)}}));
}

/// The texts of a list, or one alone; none where nothing stands there.
std::vector<const DocumentNode *> textsIn(const DocumentNode &node, const std::string &field,
                                          FieldReader &fields) {
  std::vector<const DocumentNode *> texts;
  if (node.kind == DocumentNode::Kind::Text && !node.text.empty())
    texts.push_back(&node);
  for (const DocumentNode &child : node.children)
    if (child.kind == DocumentNode::Kind::Text && child.key.empty())
      texts.push_back(&child);
    else
      fields.complain(child, field, words("Here a list of texts is expected."));
  for (const DocumentNode *text : texts)
    checkText(*text, field, fields);
  return texts;
}

CameraView readCamera(const DocumentNode &node, FieldReader &lesson) {
  CameraView camera;
  FieldReader fields(node, lesson.file(), "camera");
  fields.allowOnly({"from", "at", "height"});
  readCameraView(node, "camera", fields, camera);
  if (fields.problem())
    lesson.keep(*fields.problem());
  return camera;
}

CoordinateId readDirection(const std::string &key, const Scene &scene, FieldReader &fields,
                           const DocumentNode &node) {
  const std::string name = fields.text(key);
  const auto found = findCoordinate(scene, name);
  const Object *object = found ? findObject(scene, found->object) : nullptr;
  if (object && coordinatesOf(*object)[found->index].role == CoordinateRole::Direction)
    return *found;
  if (!fields.problem())
    fields.complain(*node.find(key), "flat." + key,
                    words("“{name}” is no direction of the scene: name one, as E.n or L.r.",
                          {{"name", shortened(name)}}));
  return {};
}

FlatPage readFlatPage(const DocumentNode &node, const Scene &scene, FieldReader &lesson) {
  FieldReader fields(node, lesson.file(), "flat");
  fields.allowOnly({"up", "right"});
  FlatPage page{readDirection("up", scene, fields, node), readDirection("right", scene, fields, node)};
  if (fields.problem())
    lesson.keep(*fields.problem());
  return page;
}

bool isMacroName(const std::string &name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), isLetter);
}

void readMacro(const DocumentNode &node, FieldReader &fields, Macros &macros) {
  const std::string field = "macros." + node.key;
  if (!isMacroName(node.key))
    return fields.complain(node, field,
                           words("“{name}” cannot be the name of a macro: write letters from a to z without "
                                 "the backslash.",
                                 {{"name", shortened(node.key)}}));
  if (node.kind != DocumentNode::Kind::Text || node.text.empty())
    return fields.complain(node, field, words("Here LaTeX in single quotes is expected, as '\\mathbb{R}'."));
  if (node.text.size() > longestMacro)
    return fields.complain(node, field,
                           words("This macro is too long: at most {limit} bytes are read.",
                                 {{"limit", std::to_string(longestMacro)}}));
  auto macro = macroOf(node.text);
  if (!macro)
    return fields.complain(node, field,
                           words("A # in a macro stands before the number of an argument: #1 to #9."));
  macros[node.key] = std::move(*macro);
}

std::size_t parametersIn(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (parameterAt(text, at) > 0)
      ++count;
  return count;
}

/// Outside quotes YAML takes ` #1` for the beginning of a comment, and nobody would notice.
void refuseLostArguments(const DocumentNode &node, const TextBlock &block, FieldReader &fields) {
  std::map<int, std::size_t> read; // by line
  for (const DocumentNode &macro : node.children)
    read[macro.line] += parametersIn(macro.text);
  std::istringstream lines(block.text);
  std::string text;
  for (int line = block.firstLine; std::getline(lines, text); ++line)
    for (const DocumentNode &macro : node.children)
      if (macro.line == line && parametersIn(text) > read[line])
        return fields.complain(macro, "macros." + macro.key,
                               words("What follows # is not read here: put the macro in single quotes."));
}

Macros readMacros(const DocumentNode &node, const TextBlock &block, FieldReader &fields) {
  Macros macros;
  if (node.kind != DocumentNode::Kind::Map || node.children.size() > mostMacros) {
    fields.complain(node, "macros",
                    words("Here at most {limit} macros are expected, each as `name: 'LaTeX'`.",
                          {{"limit", std::to_string(mostMacros)}}));
    return macros;
  }
  refuseLostArguments(node, block, fields);
  for (const DocumentNode &child : node.children)
    readMacro(child, fields, macros);
  if (const auto name = findRecursion(macros))
    fields.complain(*node.find(*name), "macros." + *name, words("This macro uses itself."));
  return macros;
}

std::vector<Prediction::Choice> readChoices(const DocumentNode &node, FieldReader &fields) {
  std::vector<Prediction::Choice> choices;
  for (const DocumentNode &child : node.children) {
    if (child.kind != DocumentNode::Kind::Text || child.key.empty() || child.text.empty())
      fields.complain(child, "choices", words("Each choice is written as `value: what the learner reads`."));
    choices.push_back({child.key, child.text, child.line});
  }
  if (choices.size() < 2)
    fields.complain(node, "choices", words("A question needs at least two choices."));
  return choices;
}

std::vector<Task::Hint> readHints(const DocumentNode &node, FieldReader &fields) {
  std::vector<Task::Hint> hints;
  for (const DocumentNode *text : textsIn(node, "hints", fields))
    hints.push_back({text->text, text->line});
  if (hints.size() > mostHints)
    fields.complain(node, "hints",
                    words("A task has at most {limit} hints.", {{"limit", std::to_string(mostHints)}}));
  return hints;
}

/// What stands between commas or spaces, with the lines of the file.
StepLines namesIn(const TextBlock &block) {
  constexpr std::string_view between = ", \t\r\n";
  const std::string &text = block.text;
  StepLines names;
  for (auto begin = text.find_first_not_of(between); begin != std::string::npos;) {
    const auto end = text.find_first_of(between, begin);
    names.ids.push_back(text.substr(begin, end - begin));
    const auto before = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
    names.lines.push_back(block.firstLine + static_cast<int>(before));
    begin = text.find_first_not_of(between, end);
  }
  return names;
}

/// A block that has fields, by what reads them.
template <class Block, class Read>
Result<Block> readFields(const TextBlock &block, const std::string &file, const char *name,
                         std::initializer_list<std::string_view> keys, Read read) {
  const auto root = parseYaml(block.text, file, block.firstLine, maxFrontMatterDepth);
  if (!root)
    return root.problem();
  FieldReader fields(*root, file, name);
  fields.allowOnly(keys);
  Block made = read(fields);
  if (fields.problem())
    return *fields.problem();
  return made;
}

} // namespace

Result<Lesson> readFrontMatter(const TextBlock &block, const std::string &file) {
  const auto root = parseYaml(block.text, file, block.firstLine, maxFrontMatterDepth);
  if (!root)
    return root.problem();
  FieldReader fields(*root, file, "");
  fields.allowOnly({"id", "title", "order", "chapter", "needs", "sources", "macros", "scene", "camera",
                    "shadows", "flat"});
  Lesson lesson;
  lesson.id = fields.lessonId("id");
  if (const DocumentNode *id = fields.optional("id"))
    lesson.idLine = id->line;
  lesson.title = printable(fields.text("title"));
  lesson.order = fields.integer("order", 0, highestOrder, 0);
  if (fields.optional("chapter"))
    lesson.chapter = printable(fields.text("chapter"));
  if (const DocumentNode *needs = fields.optional("needs"))
    for (const DocumentNode *text : textsIn(*needs, "needs", fields))
      lesson.needs.push_back({text->text, text->line});
  if (const DocumentNode *sources = fields.optional("sources"))
    for (const DocumentNode *text : textsIn(*sources, "sources", fields))
      lesson.sources.push_back(text->text);
  if (const DocumentNode *macros = fields.optional("macros"))
    lesson.macros = readMacros(*macros, block, fields);
  if (const DocumentNode *camera = fields.optional("camera"))
    lesson.camera = readCamera(*camera, fields);
  lesson.hasShadows = fields.truth("shadows", lesson.hasShadows);
  const DocumentNode *list = fields.required("scene");
  if (fields.problem())
    return *fields.problem();
  auto scene = readScene(*list, file, "scene");
  if (!scene)
    return scene.problem();
  lesson.scene = std::move(*scene);
  if (const DocumentNode *flat = fields.optional("flat"))
    lesson.flat = readFlatPage(*flat, lesson.scene, fields);
  if (fields.problem())
    return *fields.problem();
  return lesson;
}

Result<Task> readTask(const TextBlock &block, const std::string &file) {
  const auto root = parseYaml(block.text, file, block.firstLine, maxFrontMatterDepth);
  if (!root)
    return root.problem();
  FieldReader fields(*root, file, "");
  fields.allowOnly({"do", "when", "now", "hints", "done"});
  Task task;
  task.instruction = fields.text("do");
  auto conditions = parseConditions(fields.text("when"));
  if (!conditions && root->find("when"))
    fields.complain(*root->find("when"), "when", conditions.problem().sentence);
  if (fields.problem())
    return *fields.problem();
  task.conditions = std::move(*conditions);
  task.line = root->find("do")->line;
  task.conditionsLine = root->find("when")->line;
  const auto takeIfThere = [&](const char *key, MarkdownText &text, int &line) {
    if (const DocumentNode *field = fields.optional(key)) {
      text = fields.text(key);
      line = field->line;
    }
  };
  takeIfThere("now", task.now, task.nowLine);
  takeIfThere("done", task.answer, task.answerLine);
  if (const DocumentNode *hints = fields.optional("hints"))
    task.hints = readHints(*hints, fields);
  if (fields.problem())
    return *fields.problem();
  return task;
}

Result<Prediction> readPrediction(const TextBlock &block, const std::string &file) {
  const auto root = parseYaml(block.text, file, block.firstLine, maxFrontMatterDepth);
  if (!root)
    return root.problem();
  FieldReader fields(*root, file, "");
  fields.allowOnly({"ask", "answer", "choices", "why"});
  Prediction prediction;
  prediction.question = fields.text("ask");
  prediction.value = fields.text("answer");
  prediction.reason = fields.text("why");
  if (const DocumentNode *choices = fields.required("choices"))
    prediction.choices = readChoices(*choices, fields);
  if (!fields.problem() && !isValueName(prediction.value))
    fields.complain(*root->find("answer"), "answer",
                    words("Here the name of a value is expected, as side or case."));
  if (fields.problem())
    return *fields.problem();
  prediction.questionLine = root->find("ask")->line;
  prediction.valueLine = root->find("answer")->line;
  prediction.reasonLine = root->find("why")->line;
  return prediction;
}

Result<StepFlight> readFlight(const TextBlock &block, const std::string &file) {
  return readFields<StepFlight>(
      block, file, "flight", {"frame", "seed", "hits", "first-seed"}, [&block](FieldReader &fields) {
        return StepFlight{fields.text("frame"), fields.text("seed"), fields.text("hits"),
                          fields.integer("first-seed", 1, largestSeed, 1), block.firstLine};
      });
}

Result<StepFragments> readFragments(const TextBlock &block, const std::string &file) {
  return readFields<StepFragments>(block, file, "fragments", {"hits", "by"}, [&block](FieldReader &fields) {
    const std::string order = fields.text("by", "parameter");
    if (order != "parameter" && order != "number")
      fields.complain(*fields.optional("by"), "fragments.by",
                      words("Here “parameter” or “number” is expected."));
    return StepFragments{fields.text("hits"), order == "number", block.firstLine};
  });
}

Result<StepCost> readCost(const TextBlock &block, const std::string &file) {
  return readFields<StepCost>(block, file, "cost", {"hits"}, [&block](FieldReader &fields) {
    return StepCost{fields.text("hits"), block.firstLine};
  });
}

Result<TaughtTerm> readTerm(const TextBlock &block, const std::string &file) {
  return readFields<TaughtTerm>(block, file, "term", {"name", "also", "means"}, [](FieldReader &fields) {
    TaughtTerm term;
    term.name = printable(fields.text("name"));
    term.meaning = fields.text("means");
    if (const DocumentNode *also = fields.optional("also"))
      for (const DocumentNode *form : textsIn(*also, "term.also", fields))
        term.also.push_back(printable(form->text));
    if (const DocumentNode *name = fields.optional("name"))
      term.line = name->line;
    if (const DocumentNode *meaning = fields.optional("means"))
      term.meaningLine = meaning->line;
    return term;
  });
}

Result<StepLines> readLines(const TextBlock &block, const std::string &file) {
  constexpr std::string_view allOfOne = ".*";
  StepLines lines = namesIn(block);
  for (std::size_t i = 0; i < lines.ids.size(); ++i)
    if (const std::string_view id = lines.ids[i];
        !isValueName(id.ends_with(allOfOne) ? id.substr(0, id.size() - allOfOne.size()) : id))
      return Problem{
          words("“{text}” cannot be the id of a line: write ids between commas.", {{"text", shortened(id)}}),
          file, lines.lines[i], "lines"};
  if (lines.ids.empty())
    return Problem{
        words("No line is named here. Name some, write none to show none, or leave the block out to show "
              "all."),
        file, block.firstLine, "lines"};
  return lines;
}

std::optional<Problem> readMarkIds(const TextBlock &block, const std::string &file, LessonStep &step) {
  StepLines marks = namesIn(block);
  for (std::size_t i = 0; i < marks.ids.size(); ++i)
    if (!isValueName(marks.ids[i]))
      return Problem{words("“{text}” cannot be the id of a mark: write ids between commas.",
                           {{"text", shortened(marks.ids[i])}}),
                     file, marks.lines[i], "draw"};
  if (marks.ids.empty())
    return Problem{words("No mark is named here. Name some, or leave the block out."), file, block.firstLine,
                   "draw"};
  step.drawsAllResults = marks.ids == std::vector{std::string(allMarks)};
  if (step.drawsAllResults)
    return {};
  step.drawn = std::move(marks.ids);
  step.drawnLines = std::move(marks.lines);
  return {};
}

std::optional<Problem> readHidden(const TextBlock &block, const std::string &file, LessonStep &step) {
  StepLines entries = namesIn(block);
  if (entries.ids.empty())
    return Problem{words("Nothing is named here. Name entries of the scene, or leave the block out."), file,
                   block.firstLine, "hide"};
  step.hidden = std::move(entries.ids);
  step.hiddenLines = std::move(entries.lines);
  return {};
}

Result<Fading> readFading(const TextBlock &block, const std::string &file) {
  const std::string_view word = trimmed(block.text);
  if (const auto fading = fadingNamed(word))
    return *fading;
  return Problem{words("“{text}” does not say which lines are blank: write none, gaps, last or all.",
                       {{"text", shortened(word)}}),
                 file, block.firstLine, "blank"};
}

} // namespace halfspace
