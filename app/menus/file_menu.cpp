#include "app/menus/file_menu.h"

#include "app/explore/scene_lesson.h"
#include "app/export/figure_export.h"
#include "app/menus/add_item.h"
#include "app/work/animation_export.h"
#include "app/work/handout_export.h"
#include "app/work/leftover_work.h"
#include "app/work/scene_meshes.h"
#include "app/work/session_files.h"

namespace halfspace {

FileMenu::FileMenu(SessionFiles &files, SceneMeshes &meshes, LeftoverWork &leftovers, FigureExport &figures,
                   HandoutExport &handouts, AnimationExport &animations, SceneLesson &lesson, QWidget *parent)
    : QMenu(tr("&File"), parent) {
  addItem(*this, tr("&New"), QKeySequence::New, &files, &SessionFiles::startNew)->setObjectName("new");
  addItem(*this, tr("&Open…"), QKeySequence::Open, &files, &SessionFiles::askAndOpen);
  addItem(*this, tr("Open &Mesh…"), QKeySequence("Ctrl+M"), &meshes, &SceneMeshes::askAndOpen);
  addItem(*this, tr("&Save"), QKeySequence::Save, &files, &SessionFiles::save)->setObjectName("save");
  addItem(*this, tr("Save &As…"), QKeySequence::SaveAs, &files, &SessionFiles::saveAs);
  addAction(&lesson.item());
  QMenu &unsaved = *addMenu(tr("&Unsaved Work"));
  unsaved.setObjectName("unsavedWork");
  connect(&unsaved, &QMenu::aboutToShow, &leftovers, [&leftovers, &unsaved] { leftovers.fillMenu(unsaved); });
  addSeparator();
  addItem(*this, tr("&Export Figure…"), QKeySequence("Ctrl+E"), &figures, &FigureExport::open);
  addItem(*this, tr("Save &Handout…"), QKeySequence("Ctrl+Shift+E"), &handouts, &HandoutExport::askAndSave);
  addItem(*this, tr("Save A&nimation…"), QKeySequence("Ctrl+Shift+A"), &animations,
          &AnimationExport::askAndSave);
  addSeparator();
  addItem(*this, tr("&Quit"), QKeySequence::Quit, this, &FileMenu::quitWanted);
}

} // namespace halfspace
