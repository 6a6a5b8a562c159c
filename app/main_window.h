// The window: the scene, the page beside it, and what opens on demand, put together.
#pragma once

#include "app/lesson_watch.h"
#include "app/panels/window_layout.h"
#include "app/panels/window_look.h"
#include "app/panels/window_panels.h"
#include "app/put_aside.h"
#include "app/recovery.h"
#include "app/step/step_presenter.h"
#include "app/work/learner_progress.h"
#include "app/work/scene_meshes.h"
#include "widgets/session_model.h"
#include "widgets/view/scene_view.h"

#include <QMainWindow>
#include <QTimer>

class QAction;
class QMenu;

namespace halfspace {

class CaseLine;
class ContentsDrawer;
class FlatView;
class SceneFrame;
class StepWorking;
class UnfinishedInput;

class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  explicit MainWindow(LessonLibrary library);
  ~MainWindow() override;

  /// Starts with a session; `file` is where Save writes it (nothing: Save asks).
  void startWith(const Session &session, std::optional<KnownFile> file = {});
  /// Shows the window, maximized where it would not fit the screen with its frame.
  void showFitting();
  /// Goes on with the newest work that an earlier run left unsaved, if there is any. Where that run ended
  /// while it opened the work, it is only offered. For the event loop: it may ask.
  void restoreUnsaved();
  /// Offers unsaved changes to the file that the window began with, and tells where other work waits. For the
  /// event loop: it may ask.
  void offerUnsaved();
  /// Tells which files of the program's own could not be read and stand aside. For the event loop: it asks.
  void tellPutAside();
  /// Opens a .halfspace file, or the .md file of a lesson; on failure says why and leaves the session as it
  /// is.
  void openFile(const QString &file);
  /// Writes the session to its file, or asks for one. Asks as well where the file is not any more as this
  /// window knows it. False where it is not saved.
  bool save();
  /// Writes the session; on failure says why and returns false.
  bool saveTo(const QString &file);
  /// Writes the 3D view as a PNG file, twice as fine as on the screen.
  bool savePicture(const QString &file);
  void copyPicture();
  /// Keeps all that is unsaved for the next start, without a question: the program ends now.
  void endWithoutQuestions();
  /// The same for a window that is busy with a frame; from any thread. Keeps the scene as it is shown, not
  /// what is typed and not entered.
  void endWhileBusy();
  void complain(const QString &sentence);
  /// Adds the lessons of a folder, from now on at every start.
  void addOwnLessonsOf(const QString &folder);
  /// Takes them away again; a lesson that is open stays.
  void removeOwnLessonsOf(const QString &folder);

  [[nodiscard]] SessionModel &model() { return m_model; }
  [[nodiscard]] SceneView &sceneView() { return *m_scene; }
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
  void showLesson();
  void chooseOwnLessons();
  void fillOwnLessonsMenu(QMenu &menu);
  /// Reads the file of the open lesson once more.
  void reloadLesson();
  void updateTitle();
  void showLook();
  void showContents();
  /// Whether Save may write the session to the window's file: another lesson asks for a file of its own.
  [[nodiscard]] bool belongsToFile() const;
  /// Whether another session may take the place of this one: what is typed is entered, changes are asked
  /// about.
  bool mayLeaveSession();
  bool askToKeepChanges();
  bool askToReplace(const KnownFile &file);
  /// Back to what the session's file holds.
  void dropChanges();
  /// What the next start should find is kept for it, saved to a file, or given up on purpose.
  bool keepForNextStart();
  /// Whether something in the session on the screen would be lost.
  [[nodiscard]] bool hasChanges() const;
  /// Whether changed sessions of other lessons wait to be gone on with.
  [[nodiscard]] bool hasLeftSessions() const;
  [[nodiscard]] UnsavedWork unsavedWork() const;
  /// For the end of the program at any moment from now on: what is unsaved, and what is being typed.
  void prepareUnsaved();
  /// A moment after a change, and never during a drag: the disk is waited for.
  void keepUnsavedSoon();
  /// Keeps what is unsaved, or drops what was kept when nothing is. Why it cannot be kept, which the case
  /// line says as long as it holds.
  std::optional<Problem> keepOrForget();
  void takeUp(const QString &leftover);
  void offerAgain(const Recovery::Leftover &leftover);
  void fillUnsavedMenu(QMenu &menu);
  [[nodiscard]] QString askForFile(const QString &title, const QString &filter, const QString &suffix);
  bool saveAs();
  void open();
  void exportPicture();
  [[nodiscard]] std::optional<LabelPicture> pictureOfScene();
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
  UnfinishedInput &m_input;
  SceneView *m_scene;
  SceneFrame *m_frame; ///< around m_scene
  FlatView *m_flat;    ///< in m_frame
  LessonWatch m_watch;
  QStringList m_ownLessons; ///< the folders of the settings
  CaseLine *m_caseLine;
  StepWorking *m_working;
  ContentsDrawer *m_contents;
  QAction *m_home = nullptr;
  QAction *m_fit = nullptr;
  QAction *m_alongPlane = nullptr;
  std::optional<KnownFile> m_file; ///< where Save writes; nothing: it asks
  Recovery m_recovery;
  QTimer m_keepTimer;   ///< unsaved work is kept a moment after a change
  QTimer m_openedTimer; ///< what was taken up counts as opened a moment after it is shown
};

} // namespace halfspace
