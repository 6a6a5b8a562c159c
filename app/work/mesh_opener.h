// Opens a mesh file beside the window that goes on.
#pragma once

#include "app/work/job_progress.h"
#include "widgets/mesh_loader.h"

#include <QTimer>

#include <functional>

namespace halfspace {

/// Shows how far the reading is, and keeps what is read until there is a moment to take it.
class MeshOpener : public QObject {
  Q_OBJECT
public:
  /// `isInHand` tells whether something in the window is held that a new mesh would change.
  MeshOpener(QWidget &window, std::function<bool()> isInHand);

  /// Gives up what was to come.
  void open(const QString &file);
  /// Neither reads nor hands out the mesh that was to come.
  void leave();

signals:
  /// As soon as nothing is held, and no question is open that goes on with the scene as it is.
  void opened(const halfspace::LoadedMesh &mesh);
  void failed(const QString &sentence);

private:
  void handOut();

  std::function<bool()> m_isInHand;
  MeshLoader m_loader;
  JobProgress m_progress; ///< of the loader
  std::optional<LoadedMesh> m_waiting;
  QTimer m_nextLook;
};

} // namespace halfspace
