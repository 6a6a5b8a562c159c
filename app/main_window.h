// The window: scene, working, inspector, lesson words and list of lessons, put together.
#pragma once

#include "app/recovery.h"
#include "lessons/task_progress.h"
#include "widgets/scene_view.h"
#include "widgets/session_model.h"

#include <QMainWindow>
#include <QTimer>

#include <map>

class QActionGroup;
class QDockWidget;
class QLabel;
class QListWidget;

namespace halfspace {

class Inspector;
class LessonPanel;
class Typesetter;
class WorkingPanel;
class WorkingPractice;

class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  explicit MainWindow(LessonLibrary library);
  ~MainWindow() override;

  /// Starts with a session; `file` is where Save writes it (empty: Save asks).
  void startWith(const Session &session, const QString &file = {});
  /// Shows the window, maximized where it would not fit the screen with its frame.
  void showFitting();
  /// Takes up what an earlier run left behind when it was cut off, if there is anything.
  void restoreUnsaved();
  /// Opens a .halfspace file; on failure says why and leaves the session as it is.
  void openFile(const QString &file);
  /// Writes the session; on failure says why and returns false.
  bool saveTo(const QString &file);
  /// Writes the 3D view as a PNG file, twice as fine as on the screen.
  bool savePicture(const QString &file);
  void copyPicture();
  void setThemeNamed(const QString &name);

  [[nodiscard]] SessionModel &model() { return m_model; }
  [[nodiscard]] SceneView &sceneView() { return *m_scene; }

protected:
  void closeEvent(QCloseEvent *event) override;

private:
  /// What a learner has done in one step of a lesson.
  struct StepProgress {
    std::optional<std::string> chosen; ///< the answer to the step's question
    std::string right;                 ///< what was right when it was given
    TaskProgress tasks;
  };

  void createPanels();
  void createMenus();
  void createFileMenu();
  void createEditMenu();
  void createViewMenu();
  void createSnapMenu(QMenu &menu);
  void createThemeMenu(QMenu &menu);
  void createLessonMenu();
  void createHelpMenu();
  QDockWidget *addPanel(const QString &title, const char *name, QWidget *content, Qt::DockWidgetArea area);

  void showLesson();
  void showOutcome();
  void showStepWords();
  void highlight(const QString &markId);
  void showCase();
  void updateTitle();
  void complain(const QString &sentence);
  [[nodiscard]] StepProgress &progress();
  [[nodiscard]] const LessonStep *currentStep() const;
  /// Whether the step asks a question that is not answered yet: then the numbers are hidden.
  [[nodiscard]] bool isPredicting();
  /// Whether numbers are hidden, until a question is answered or blank lines are filled in.
  [[nodiscard]] bool hidesNumbers();
  [[nodiscard]] std::string rightAnswer(const Prediction &prediction) const;
  bool askToKeepChanges();
  [[nodiscard]] QString askForFile(const QString &title, const QString &filter, const QString &suffix);
  bool save();
  bool saveAs();
  void open();
  void exportPicture();
  [[nodiscard]] std::optional<QImage> pictureOfScene(double scale);
  void restoreSettings();
  void storeSettings();

  SessionModel m_model;
  std::unique_ptr<Typesetter> m_typesetter;
  SceneView *m_scene = nullptr;
  WorkingPractice *m_practice = nullptr;
  WorkingPanel *m_working = nullptr; ///< in m_practice
  Inspector *m_inspector = nullptr;
  LessonPanel *m_lessonPanel = nullptr;
  QListWidget *m_lessonList = nullptr;
  QLabel *m_caseLabel = nullptr;
  QActionGroup *m_themeActions = nullptr;
  QString m_file;           ///< where Save writes; empty: it asks
  std::string m_fileLesson; ///< the lesson of that file
  Theme m_theme;
  Recovery m_recovery;
  QTimer
      m_panelTimer; ///< the panels follow a drag at most this often, so that the picture never waits for them
  std::map<std::pair<std::string, int>, StepProgress> m_progress;
};

} // namespace halfspace
