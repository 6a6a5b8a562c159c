// What the window keeps of itself between starts.
#pragma once

#include "app/settings.h"
#include "app/work/put_aside.h"
#include "widgets/session_model.h"

#include <functional>

class QAction;

namespace halfspace {

class FigureExport;
class OwnLessonFolders;
class WindowLayout;
class WindowLook;

/// Takes the settings into the parts of the window that they are about, and back into their file.
class WindowSettings : public QObject {
  Q_OBJECT
public:
  /// `flatPicture` is checked while the flat picture is unfolded. All must outlive it.
  WindowSettings(SessionModel &model, WindowLook &look, WindowLayout &layout, OwnLessonFolders &ownLessons,
                 QAction &flatPicture, FigureExport &figures, PutAsideFiles &putAside);

  /// What was read at the start; a file that cannot be read is put aside.
  void restore(const Result<Settings> &stored);
  /// When the window is on its way out: what cannot be stored is said on standard error.
  void store();

private:
  /// The theme, the size of type and what is chosen of figures are stored as soon as they are chosen.
  void storeAtOnce(const std::function<void(Settings &)> &put);

  SessionModel &m_model;
  WindowLook &m_look;
  WindowLayout &m_layout;
  OwnLessonFolders &m_ownLessons;
  QAction &m_flatPicture;
  FigureExport &m_figures;
  PutAsideFiles &m_putAside;
};

} // namespace halfspace
