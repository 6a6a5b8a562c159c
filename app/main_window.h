// The window: its panels, and the parts that work in them, put together.
#pragma once

#include "app/panels/window_layout.h"
#include "app/panels/window_look.h"
#include "app/panels/window_panels.h"
#include "app/step/step_presenter.h"
#include "app/work/autosave.h"
#include "app/work/learner_progress.h"
#include "app/work/leftover_work.h"
#include "app/work/put_aside.h"
#include "app/work/scene_meshes.h"
#include "app/work/session_files.h"
#include "widgets/session_model.h"

#include <QMainWindow>

#include <memory>

namespace halfspace {

class CameraActions;
class ContentsPresenter;
class ExplorePresenter;
class FigureExport;
class GoOnInExplore;
class OwnLessonFolders;
class WindowSettings;
struct Settings;

/// Each part has one task, and knows those that it needs.
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  /// On a session, with the settings as they were read; `file` is where Save writes it (null: Save asks).
  MainWindow(LessonLibrary library, Session session, const Result<Settings> &settings,
             std::shared_ptr<const KnownFile> file = {});
  ~MainWindow() override;

  /// Shows the window, maximized where it would not fit the screen with its frame.
  void showFitting();
  void complain(const QString &sentence);
  /// Tells which files of the program's own could not be read and stand aside. For the event loop: it asks.
  void tellPutAside();
  /// Keeps all that is unsaved for the next start, without a question: the program ends now.
  void endWithoutQuestions();
  /// The same for a window that is busy with a frame; from any thread. Keeps the scene as it is shown, not
  /// what is typed and not entered.
  void endWhileBusy();

  [[nodiscard]] SessionModel &model() { return m_model; }
  [[nodiscard]] SceneView &sceneView();
  [[nodiscard]] SessionFiles &files() { return m_files; }
  [[nodiscard]] LeftoverWork &leftovers() { return m_leftovers; }
  [[nodiscard]] SceneMeshes &meshes() { return m_meshes; }
  [[nodiscard]] WindowLook &look() { return m_look; }

signals:
  /// All that is unsaved is kept, and nothing is done any more: the program can end.
  void closed();

protected:
  void closeEvent(QCloseEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  void dragEnterEvent(QDragEnterEvent *event) override;
  void dropEvent(QDropEvent *event) override;

private:
  void createMenus(OwnLessonFolders &ownLessons, ContentsPresenter &contents, FigureExport &figures,
                   GoOnInExplore &goOn);
  void createHeader(ContentsPresenter &contents);
  void createSceneTools(CameraActions &camera);
  /// The field above the scene with what is typed there, and the menu of the scene behind the others.
  void createExplore(GoOnInExplore &goOn);
  void connectParts();
  void showLook();
  void updateTitle();
  /// Nothing is done any more.
  void leave();

  SessionModel m_model;
  PutAsideFiles m_putAside;
  LearnerProgress m_progress; ///< outlives the panels: the model asks it for what they change at their end
  WindowPanels m_panels;
  WindowLook m_look;
  WindowLayout m_layout;
  StepPresenter m_step;
  SceneMeshes m_meshes;
  SessionFiles m_files;
  Autosave m_autosave;
  LeftoverWork m_leftovers;
  ExplorePresenter *m_explore = nullptr; ///< belongs to the window
  std::unique_ptr<WindowSettings> m_settings;
};

} // namespace halfspace
