// File: sessions, meshes, pictures, animations.
#pragma once

#include <QMenu>

namespace halfspace {

class AnimationExport;
class HandoutExport;
class LeftoverWork;
class PictureExport;
class SceneMeshes;
class SessionFiles;

class FileMenu : public QMenu {
  Q_OBJECT
public:
  /// All must outlive it.
  FileMenu(SessionFiles &files, SceneMeshes &meshes, LeftoverWork &leftovers, PictureExport &pictures,
           HandoutExport &handouts, AnimationExport &animations, QWidget *parent);

signals:
  void quitWanted();
};

} // namespace halfspace
