#include "app/lesson_progress.h"

#include <QJsonArray>
#include <QJsonObject>

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

} // namespace

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
