// Figures of the window, for files and for the clipboard.
#pragma once

#include "app/export/window_figure.h"
#include "app/panels/messages.h"

#include <QObject>
#include <QPointer>

namespace halfspace {

class ExportWindow;
class SceneColumn;
struct Settings;

/// Knows what was chosen last of figures.
class FigureExport : public QObject {
  Q_OBJECT
public:
  /// Model and scene must outlive it.
  FigureExport(SessionModel &model, SceneColumn &scene, Messages messages, QObject *parent);

  /// Shows the export window, with what was chosen last.
  void open();
  /// Copies the figure as it was chosen last, at once.
  void copy();

  /// What was chosen last, and the folder that the last figure went to.
  void take(const Settings &settings);
  void put(Settings &settings) const;

signals:
  void chosen(); ///< by the user, something else

private:
  void takeFrom(const ExportWindow &window);

  SessionModel &m_model;
  WindowFigure m_figure;
  Messages m_messages;
  ExportChoices m_choices;
  QString m_folder;
  QPointer<ExportWindow> m_window; ///< while it is open
};

} // namespace halfspace
