// File: sessions, meshes, figures, handouts, animations.
#pragma once

#include <QMenu>

namespace halfspace {

class AnimationExport;
class FigureExport;
class HandoutExport;
class LeftoverWork;
class SceneLesson;
class SceneMeshes;
class SessionFiles;

class FileMenu : public QMenu {
  Q_OBJECT
public:
  /// All must outlive it.
  FileMenu(SessionFiles &files, SceneMeshes &meshes, LeftoverWork &leftovers, FigureExport &figures,
           HandoutExport &handouts, AnimationExport &animations, SceneLesson &lesson, QWidget *parent);

signals:
  void quitWanted();
};

} // namespace halfspace
