#include "app/work/lesson_works.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <vector>

namespace halfspace {
namespace {

QString text(const std::string &words) { return QString::fromStdString(words); }
std::string wordsIn(const QJsonValue &json) { return json.toString().toStdString(); }

QJsonArray toJson(const std::vector<std::string> &names) {
  QJsonArray json;
  for (const std::string &name : names)
    json.append(text(name));
  return json;
}

std::vector<std::string> namesFrom(const QJsonValue &json) {
  std::vector<std::string> names;
  for (const QJsonValue &name : json.toArray())
    names.push_back(wordsIn(name));
  return names;
}

QJsonValue toJson(const std::optional<DraftQuestion> &question) {
  if (!question)
    return {};
  QJsonArray choices;
  for (const DraftChoice &choice : question->choices)
    choices.append(QJsonObject{{"word", text(choice.word)}, {"text", text(choice.text)}});
  return QJsonObject{{"ask", text(question->ask)},
                     {"value", text(question->value)},
                     {"choices", choices},
                     {"why", text(question->why)}};
}

std::optional<DraftQuestion> questionFrom(const QJsonValue &json) {
  if (!json.isObject())
    return {};
  DraftQuestion question{wordsIn(json["ask"]), wordsIn(json["value"]), {}, wordsIn(json["why"])};
  for (const QJsonValue &choice : json["choices"].toArray())
    question.choices.push_back({wordsIn(choice["word"]), wordsIn(choice["text"])});
  return question;
}

QJsonValue toJson(const std::optional<DraftTask> &task) {
  if (!task)
    return {};
  return QJsonObject{{"instruction", text(task->instruction)}, {"condition", text(task->condition)}};
}

std::optional<DraftTask> taskFrom(const QJsonValue &json) {
  if (!json.isObject())
    return {};
  return DraftTask{wordsIn(json["instruction"]), wordsIn(json["condition"])};
}

QJsonObject toJson(const DraftStep &step) {
  return {{"title", text(step.title)},         {"words", text(step.words)},
          {"workings", toJson(step.workings)}, {"hidden", toJson(step.hidden)},
          {"question", toJson(step.question)}, {"task", toJson(step.task)}};
}

DraftStep stepFrom(const QJsonValue &json) {
  return {wordsIn(json["title"]),    wordsIn(json["words"]),         namesFrom(json["workings"]),
          namesFrom(json["hidden"]), questionFrom(json["question"]), taskFrom(json["task"])};
}

QJsonObject toJson(const LessonWork &work) {
  QJsonArray steps;
  for (const DraftStep &step : work.draft.steps)
    steps.append(toJson(step));
  return {{"title", text(work.draft.title)},  {"steps", steps},
          {"path", work.file.path},           {"text", text(work.file.text)},
          {"lesson", text(work.file.lesson)}, {"saved", work.isSaved}};
}

LessonWork workFrom(const QJsonValue &json) {
  LessonWork work{{"", wordsIn(json["title"]), {}},
                  {json["path"].toString(), wordsIn(json["text"]), wordsIn(json["lesson"])},
                  json["saved"].toBool()};
  for (const QJsonValue &step : json["steps"].toArray())
    work.draft.steps.push_back(stepFrom(step));
  return work;
}

} // namespace

bool hasUnsaved(const LessonWorks &works) {
  return std::any_of(works.begin(), works.end(), [](const auto &each) { return !each.second.isSaved; });
}

QJsonValue toJson(const LessonWorks &works) {
  QJsonObject json;
  for (const auto &[lesson, work] : works)
    json[text(lesson)] = toJson(work);
  return json;
}

LessonWorks lessonWorksFrom(const QJsonValue &json) {
  LessonWorks works;
  const QJsonObject all = json.toObject();
  for (auto each = all.begin(); each != all.end(); ++each)
    if (LessonWork work = workFrom(each.value()); !work.draft.steps.empty()) // a draft has one at least
      works.emplace(each.key().toStdString(), std::move(work));
  return works;
}

} // namespace halfspace
