// What a user has chosen, kept between starts.
#pragma once

#include "app/export/export_choices.h"
#include "geometry/rational.h"
#include "lessons/result.h"

#include <QByteArray>
#include <QStringList>

#include <optional>

namespace halfspace {

struct Settings {
  QString theme = "light";
  bool motion = true;
  std::optional<double> sizeScale; ///< nothing: what suits the screen; always finite
  QByteArray window;               ///< size and place, as Qt saves them
  Rational snapStep = 1;           ///< in which handles move
  bool snapping = true;            ///< they do so when they are dragged
  QByteArray panels;               ///< their arrangement, as Qt saves it
  QStringList ownLessons{};        ///< folders of the user's own lessons
  bool flatPicture = true;         ///< unfolded, where a lesson has one
  QByteArray split;                ///< between scene and page, likewise; empty: as it suits the window
  ExportChoices figure{};          ///< what was chosen last of figures for files
  QString figureFolder{};          ///< where the last one went; empty: nowhere yet
  bool operator==(const Settings &) const = default;
};

/// Where the settings stand: a file of the user's configuration; empty where there is none.
[[nodiscard]] QString settingsFile();

/// The settings of a file. What it does not tell, or tells wrongly, is as usual; a file that is there and
/// cannot be read is a problem.
[[nodiscard]] Result<Settings> readSettings(const QString &file);

[[nodiscard]] std::optional<Problem> writeSettings(const Settings &settings, const QString &file);

} // namespace halfspace
