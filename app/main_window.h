// The window: the scene, the page beside it, and what opens on demand, put together.
#pragma once

#include "app/library/contents_presenter.h"
#include "app/library/own_lesson_folders.h"
#include "app/panels/window_layout.h"
#include "app/panels/window_look.h"
#include "app/panels/window_panels.h"
#include "app/put_aside.h"
#include "app/step/step_presenter.h"
#include "app/work/autosave.h"
#include "app/work/learner_progress.h"
#include "app/work/leftover_work.h"
#include "app/work/scene_meshes.h"
#include "app/work/session_files.h"
#include "widgets/session_model.h"
#include "widgets/view/scene_view.h"

#include <QMainWindow>
#include <QTimer>

class QAction;
class QMenu;

namespace halfspace {

class CaseLine;
class FlatView;
class SceneFrame;

class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  explicit MainWindow(LessonLibrary library);
  ~MainWindow() override;

  /// Shows the window, maximized where it would not fit the screen with its frame.
  void showFitting();
  /// Tells which files of the program's own could not be read and stand aside. For the event loop: it asks.
  void tellPutAside();
  /// Keeps all that is unsaved for the next start, without a question: the program ends now.
  void endWithoutQuestions();
  /// The same for a window that is busy with a frame; from any thread. Keeps the scene as it is shown, not
  /// what is typed and not entered.
  void endWhileBusy();
  void complain(const QString &sentence);

  [[nodiscard]] SessionModel &model() { return m_model; }
  [[nodiscard]] SceneView &sceneView() { return *m_scene; }
  [[nodiscard]] SessionFiles &files() { return m_files; }
  [[nodiscard]] LeftoverWork &leftovers() { return m_leftovers; }
  [[nodiscard]] SceneMeshes &meshes() { return m_meshes; }
  [[nodiscard]] WindowLook &look() { return m_look; }

signals:
  /// All that is unsaved is kept, and nothing is done any more: the program can end.
  void closed();

protected:
  void closeEvent(QCloseEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  void dragEnterEvent(QDragEnterEvent *event) override;
  void dropEvent(QDropEvent *event) override;

private:
  void createHeader();
  void createSceneTools();
  void createMenus();
  void createFileMenu();
  void createEditMenu();
  /// The history's own actions know nothing of what goes on under the hand.
  void connectInstead(QAction &action, void (SessionModel::*step)());
  void createViewMenu();
  void createCornerItems(QMenu &menu);
  void createMeshItems(QMenu &menu);
  void createSnapMenu(QMenu &menu);
  void createCameraItems(QMenu &menu);
  void createLayoutItems(QMenu &menu);
  void createSizeMenu(QMenu &menu);
  void createThemeMenu(QMenu &menu);
  void createFlightMenu(QMenu &menu);
  void createLessonMenu();
  void createHelpMenu();
  void updateTitle();
  void showLook();
  /// Nothing is done any more.
  void leave();
  void restoreSettings();
  void storeSettings();
  /// The theme and the size of type are stored as soon as they are chosen.
  void storeLook();

  SessionModel m_model;
  PutAsideFiles m_putAside;
  LearnerProgress m_progress;
  WindowPanels m_panels;
  Messages m_messages;
  WindowLook m_look;
  WindowLayout m_layout;
  StepPresenter m_step;
  SceneMeshes m_meshes;
  SessionFiles m_files;
  Autosave m_autosave;
  LeftoverWork m_leftovers;
  OwnLessonFolders m_ownLessons;
  ContentsPresenter m_contents;
  SceneView *m_scene;
  SceneFrame *m_frame; ///< around m_scene
  FlatView *m_flat;    ///< in m_frame
  CaseLine *m_caseLine;
  QAction *m_home = nullptr;
  QAction *m_fit = nullptr;
  QAction *m_alongPlane = nullptr;
};

} // namespace halfspace
