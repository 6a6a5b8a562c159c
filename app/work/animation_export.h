// The scene in motion, in a file.
#pragma once

#include "app/panels/messages.h"
#include "app/work/animation_dialog.h"
#include "app/work/job_progress.h"
#include "widgets/animation/film.h"
#include "widgets/latest_job.h"

#include <QObject>

namespace halfspace {

class SceneView;
class SessionModel;
class WindowLook;

/// Draws the pictures of an animation in a thread while the window goes on, one animation at a time. They
/// show the scene as it was when they were begun.
class AnimationExport : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  AnimationExport(const SessionModel &model, SceneView &scene, const WindowLook &look, Messages messages,
                  QObject *parent = nullptr);

  /// Asks what is wanted, and for a file, and begins to write it.
  void askAndSave();
  /// Begins to write a file; what is being written is given up first. Says when it is there, or why it is
  /// not.
  void saveTo(const QString &file, const AnimationChoices &choices);
  [[nodiscard]] bool isSaving() const { return m_job.isRunning(); }
  /// Gives up what is being written: nothing of it is left but finished pictures.
  void cancel();

private:
  [[nodiscard]] AnimatedScene sceneFor(PixelSize size) const;
  void end(const Result<Filmed> &filmed);

  const SessionModel &m_model;
  SceneView &m_scene;
  const WindowLook &m_look;
  Messages m_messages;
  AnimationDialog *m_dialog = nullptr; ///< the window's; made when it is first asked for
  JobProgress m_progress;
  LatestJob m_job; ///< ended before the rest of this
};

} // namespace halfspace
