#include "app/window_settings.h"

#include "app/export/figure_export.h"
#include "app/library/own_lesson_folders.h"
#include "app/panels/window_layout.h"
#include "app/panels/window_look.h"
#include "app/standard_streams.h"

#include <QAction>

namespace halfspace {

WindowSettings::WindowSettings(SessionModel &model, WindowLook &look, WindowLayout &layout,
                               OwnLessonFolders &ownLessons, QAction &flatPicture, FigureExport &figures,
                               PutAsideFiles &putAside)
    : m_model(model), m_look(look), m_layout(layout), m_ownLessons(ownLessons), m_flatPicture(flatPicture),
      m_figures(figures), m_putAside(putAside) {
  connect(&look, &WindowLook::chosen, this,
          [this] { storeAtOnce([this](Settings &settings) { m_look.putTheme(settings); }); });
  connect(&figures, &FigureExport::chosen, this,
          [this] { storeAtOnce([this](Settings &settings) { m_figures.put(settings); }); });
}

void WindowSettings::restore(const Result<Settings> &stored) {
  if (!stored)
    m_putAside.add(stored.problem()); // where it cannot be, it is not written either
  const Settings settings = stored ? *stored : Settings();
  m_layout.takeGeometry(settings);
  m_look.take(settings);
  m_model.snapping().step = settings.snapStep;
  m_model.snapping().isOn = settings.snapping;
  m_ownLessons.setFolders(settings.ownLessons);
  m_flatPicture.setChecked(settings.flatPicture);
  m_figures.take(settings);
  m_layout.takePanels(settings);
}

void WindowSettings::store() {
  Settings settings;
  m_look.putTheme(settings);
  settings.motion = m_look.motion().isChecked();
  settings.snapStep = m_model.snapping().step;
  settings.snapping = m_model.snapping().isOn;
  settings.ownLessons = m_ownLessons.folders();
  settings.flatPicture = m_flatPicture.isChecked();
  m_figures.put(settings);
  m_layout.put(settings);
  const auto stored = readSettings(settingsFile());
  auto problem = stored ? std::nullopt : m_putAside.add(stored.problem());
  if (!problem)
    problem = writeSettings(settings, settingsFile());
  // The window is on its way out: there is nowhere else to say it.
  if (problem)
    printError(problem->text());
}

void WindowSettings::storeAtOnce(const std::function<void(Settings &)> &put) {
  auto settings = readSettings(settingsFile());
  if (!settings)
    return; // it is put aside at the end, and written anew
  put(*settings);
  if (const auto problem = writeSettings(*settings, settingsFile()))
    printError(problem->text());
}

} // namespace halfspace
