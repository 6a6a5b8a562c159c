// Opens a mesh file beside the window that goes on.
#pragma once

#include "widgets/mesh_loader.h"

#include <QTimer>

#include <functional>

class QProgressDialog;

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
  void showProgress(double part, const QString &what);
  void endProgress();
  void handOut();

  QWidget &m_window;
  std::function<bool()> m_isInHand;
  MeshLoader m_loader;
  std::optional<LoadedMesh> m_waiting;
  QTimer m_nextLook;
  QProgressDialog *m_progress = nullptr; ///< null while no mesh is read
};

} // namespace halfspace
