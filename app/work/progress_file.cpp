#include "app/work/progress_file.h"

#include "app/folders.h"
#include "lessons/files/read_file.h"
#include "lessons/files/write_file.h"
#include "lessons/words.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

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

} // namespace

QString progressFile() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return folder.isEmpty() ? QString() : folder + "/progress.json";
}

Result<LessonProgress> readProgress(const QString &file) {
  std::error_code error;
  if (!std::filesystem::exists(file.toStdString(), error) && !error)
    return LessonProgress();
  const auto text = readFile(file.toStdString(), maxProgressBytes);
  if (!text)
    return text.problem();
  const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(*text));
  if (!json.isArray())
    return Problem{words("This is damaged: what has been done in the lessons begins anew."),
                   file.toStdString(), 0, ""};
  return progressFrom(json.array());
}

std::optional<Problem> addProgress(const LessonProgress &progress, const QString &file) {
  if (auto problem = makeFolder(QFileInfo(file).path()))
    return problem;
  const auto before = readProgress(file);
  if (!before)
    return before.problem();
  const QJsonArray json = toJson(merged(progress, *before));
  return writeFile(file.toStdString(), QJsonDocument(json).toJson().toStdString(), Readers::OwnerOnly);
}

QJsonArray toJson(const LessonProgress &progress) {
  QJsonArray json;
  for (const auto &[place, step] : progress) {
    QJsonObject entry = toJson(step);
    entry["lesson"] = QString::fromStdString(place.first);
    entry["step"] = std::visit(
        Overloaded{[](int number) { return QJsonValue(number); },
                   [](const std::string &name) { return QJsonValue(QString::fromStdString(name)); }},
        place.second);
    json.append(entry);
  }
  return json;
}

LessonProgress progressFrom(const QJsonArray &json) {
  LessonProgress progress;
  for (const QJsonValue &value : json) {
    const QJsonObject entry = value.toObject();
    const QJsonValue step = entry["step"];
    if (entry["lesson"].isString() && (step.isString() || step.isDouble()))
      progress[{entry["lesson"].toString().toStdString(),
                step.isString() ? StepId(step.toString().toStdString()) : StepId(step.toInt())}] =
          stepFrom(entry);
  }
  return progress;
}

} // namespace halfspace
