// Loads a learner's own mesh while the window goes on.
#pragma once

#include "widgets/latest_job.h"
#include "widgets/mesh_files/make_shape.h"
#include "widgets/mesh_files/serve_mesh.h"

#include <QObject>
#include <QString>

#include <chrono>

namespace halfspace {

/// Reads one mesh file at a time: in a process of its own, which the file may crash, and then in a thread,
/// which makes the mesh ready. Nothing of it is done on the thread of the caller, who hears of it by signals
/// from the event loop. What it does is cancelled with it, within a moment.
class MeshLoader : public QObject {
  Q_OBJECT
public:
  explicit MeshLoader(QObject *parent = nullptr);

  /// The program that is started as `program read-mesh FILE`; until told otherwise, this one.
  void setProgram(const QString &program) { m_program = program; }
  /// How long that program may take; then it is ended, and loading fails.
  void setLongestReading(std::chrono::milliseconds longest) { m_longestReading = longest; }

  /// What is being loaded is cancelled first. Exactly one of loaded, failed and cancelled follows.
  void start(const QString &file);
  /// Nothing more is told of what is being loaded than that it is cancelled, at once; its process is killed
  /// and its thread ended, but not waited for. Without anything to cancel nothing happens.
  void cancel();
  [[nodiscard]] bool isLoading() const { return m_job.isRunning(); }

signals:
  /// How much is done, from 0 to 1, or below 0 where that is not known, and what is being done, in words.
  void progressed(double part, const QString &what);
  void loaded(const halfspace::LoadedMesh &mesh);
  void failed(const QString &sentence);
  void cancelled();

private:
  void end(const Result<LoadedMesh> &result);

  QString m_program;
  std::chrono::milliseconds m_longestReading = longestReading;
  LatestJob m_job; ///< ended before the rest of this
};

} // namespace halfspace

Q_DECLARE_METATYPE(halfspace::LoadedMesh)
