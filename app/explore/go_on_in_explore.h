// From a lesson to Explore.
#pragma once

#include "widgets/session_model.h"

namespace halfspace {

class SessionFiles;

/// Takes scenes of lessons to Explore. The lesson stays as it is, and what was in Explore before comes back
/// with Undo; its file, if it has one, is not written over.
class GoOnInExplore : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  GoOnInExplore(SessionModel &model, SessionFiles &files, QObject *parent);

  /// Opens Explore with a scene, seen as the present one is seen.
  void with(const Scene &scene);

signals:
  void begun(const halfspace::Lesson &lesson); ///< which is left then
private:
  SessionModel &m_model;
  SessionFiles &m_files;
};

} // namespace halfspace
