#include "app/lesson_progress.h"

#include "app/folders.h"
#include "lessons/files/read_file.h"
#include "lessons/files/write_file.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include <algorithm>

namespace halfspace {
namespace {

QJsonObject toJson(const StepProgress &step) {
  QJsonArray tasks;
  for (const bool done : step.tasks.done())
    tasks.append(done);
  QJsonObject json{{"tasks", tasks}};
  if (step.chosen) {
    json["chosen"] = QString::fromStdString(*step.chosen);
    json["right"] = QString::fromStdString(step.right);
  }
  return json;
}

StepProgress stepFrom(const QJsonObject &json) {
  StepProgress step;
  if (json["chosen"].isString()) {
    step.chosen = json["chosen"].toString().toStdString();
    step.right = json["right"].toString().toStdString();
  }
  std::vector<bool> tasksDone;
  for (const QJsonValue &done : json["tasks"].toArray())
    tasksDone.push_back(done.toBool());
  step.tasks = TaskProgress(std::move(tasksDone));
  return step;
}

constexpr std::size_t maxProgressBytes = 1U << 20U;

bool isDone(const LessonStep &step, const StepProgress &progress) {
  const std::vector<bool> &tasks = progress.tasks.done();
  const std::size_t count = tasksOf(step).size();
  return (!predictionOf(step) || progress.chosen) && tasks.size() >= count &&
         std::all_of(tasks.begin(), tasks.begin() + static_cast<std::ptrdiff_t>(count),
                     [](bool done) { return done; });
}

bool asks(const LessonStep &step) { return predictionOf(step) || !tasksOf(step).empty(); }

bool isBegun(const StepProgress &progress) {
  const std::vector<bool> &tasks = progress.tasks.done();
  return progress.chosen || std::find(tasks.begin(), tasks.end(), true) != tasks.end();
}

TaskProgress merged(const TaskProgress &first, const TaskProgress &second) {
  std::vector<bool> done(std::max(first.done().size(), second.done().size()));
  for (const TaskProgress *each : {&first, &second})
    for (std::size_t i = 0; i < each->done().size(); ++i)
      done[i] = done[i] || each->done()[i];
  return TaskProgress(std::move(done));
}

} // namespace

LessonState stateOf(const Lesson &lesson, const LessonProgress &progress) {
  bool begun = false;
  bool all = true;
  bool any = false;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const auto found = progress.find({lesson.id, static_cast<int>(i)});
    const StepProgress step = found == progress.end() ? StepProgress() : found->second;
    begun = begun || isBegun(step);
    any = any || asks(lesson.steps[i]);
    all = all && (!asks(lesson.steps[i]) || isDone(lesson.steps[i], step));
  }
  return any && all ? LessonState::Done : begun ? LessonState::Begun : LessonState::New;
}

LessonProgress merged(LessonProgress first, const LessonProgress &second) {
  for (const auto &[place, step] : second) {
    StepProgress &both = first[place];
    if (!both.chosen) {
      both.chosen = step.chosen;
      both.right = step.right;
    }
    both.tasks = merged(both.tasks, step.tasks);
  }
  return first;
}

QString progressFile() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return folder.isEmpty() ? QString() : folder + "/progress.json";
}

LessonProgress readProgress(const QString &file) {
  const auto text = readFile(file.toStdString(), maxProgressBytes);
  return text ? progressFrom(QJsonDocument::fromJson(QByteArray::fromStdString(*text)).array())
              : LessonProgress();
}

std::optional<Problem> addProgress(const LessonProgress &progress, const QString &file) {
  if (auto problem = makeFolder(QFileInfo(file).path()))
    return problem;
  const QJsonArray json = toJson(merged(progress, readProgress(file)));
  return writeFile(file.toStdString(), QJsonDocument(json).toJson().toStdString(), Readers::OwnerOnly);
}

QJsonArray toJson(const LessonProgress &progress) {
  QJsonArray json;
  for (const auto &[place, step] : progress) {
    QJsonObject entry = toJson(step);
    entry["lesson"] = QString::fromStdString(place.first);
    entry["step"] = place.second;
    json.append(entry);
  }
  return json;
}

LessonProgress progressFrom(const QJsonArray &json) {
  LessonProgress progress;
  for (const QJsonValue &value : json) {
    const QJsonObject entry = value.toObject();
    if (entry["lesson"].isString() && entry["step"].isDouble())
      progress[{entry["lesson"].toString().toStdString(), entry["step"].toInt()}] = stepFrom(entry);
  }
  return progress;
}

} // namespace halfspace
