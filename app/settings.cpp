#include "app/settings.h"

#include "app/folders.h"
#include "lessons/files/read_file.h"
#include "lessons/files/write_file.h"
#include "lessons/words.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include <cmath>

namespace halfspace {
namespace {

constexpr std::size_t maxSettingsBytes = 1U << 20U;

QByteArray bytesIn(const QJsonValue &value) { return QByteArray::fromBase64(value.toString().toLatin1()); }

QString textOf(const QByteArray &bytes) { return QString::fromLatin1(bytes.toBase64()); }

/// Older programs kept one folder, as a text.
QStringList foldersIn(const QJsonValue &value) {
  QStringList folders;
  for (const QJsonValue &each : value.isArray() ? value.toArray() : QJsonArray{value})
    if (const QString folder = each.toString(); !folder.isEmpty())
      folders << folder;
  return folders;
}

Settings settingsFrom(const QJsonObject &json) {
  Settings settings;
  settings.theme = json["theme"].toString(settings.theme);
  settings.motion = json["motion"].toBool(settings.motion);
  if (const QJsonValue scale = json["sizeScale"]; scale.isDouble() && std::isfinite(scale.toDouble()))
    settings.sizeScale = scale.toDouble();
  settings.ownLessons = foldersIn(json["ownLessons"]);
  settings.flatPicture = json["flatPicture"].toBool(settings.flatPicture);
  settings.window = bytesIn(json["window"]);
  settings.panels = bytesIn(json["panels"]);
  settings.split = bytesIn(json["split"]);
  const auto step = parseRational(json["snapStep"].toString().toStdString());
  if (step && *step > 0)
    settings.snapStep = *step;
  settings.snapping = json["snapping"].toBool(settings.snapping);
  settings.figure = exportChoicesIn(json["figure"].toObject());
  settings.figureFolder = json["figureFolder"].toString();
  return settings;
}

} // namespace

QString settingsFile() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation);
  return folder.isEmpty() ? QString() : folder + "/settings.json";
}

Result<Settings> readSettings(const QString &file) {
  std::error_code error;
  if (!std::filesystem::exists(file.toStdString(), error) && !error)
    return Settings();
  const auto text = readFile(file.toStdString(), maxSettingsBytes);
  if (!text)
    return text.problem();
  const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(*text));
  if (!json.isObject())
    return Problem{words("The settings are damaged: the usual ones are in force."), file.toStdString(), 0,
                   ""};
  return settingsFrom(json.object());
}

std::optional<Problem> writeSettings(const Settings &settings, const QString &file) {
  QJsonObject json{{"theme", settings.theme},
                   {"motion", settings.motion},
                   {"ownLessons", QJsonArray::fromStringList(settings.ownLessons)},
                   {"flatPicture", settings.flatPicture},
                   {"window", textOf(settings.window)},
                   {"panels", textOf(settings.panels)},
                   {"split", textOf(settings.split)},
                   {"snapStep", QString::fromStdString(toText(settings.snapStep))},
                   {"snapping", settings.snapping},
                   {"figure", toJson(settings.figure)},
                   {"figureFolder", settings.figureFolder}};
  if (settings.sizeScale)
    json["sizeScale"] = *settings.sizeScale;
  if (auto problem = makeFolder(QFileInfo(file).path()))
    return problem;
  return writeFile(file.toStdString(), QJsonDocument(json).toJson().toStdString());
}

} // namespace halfspace
