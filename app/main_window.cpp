#include "app/main_window.h"

#include "app/check.h"
#include "app/lessons_folder.h"
#include "app/panels/scene_column.h"
#include "app/panels/unfinished_input.h"
#include "app/panels/window_header.h"
#include "app/standard_streams.h"
#include "app/window_style.h"
#include "widgets/lesson/contents_drawer.h"
#include "widgets/mark_ink.h"
#include "widgets/view/case_line.h"
#include "widgets/view/flat_view.h"
#include "widgets/view/scene_frame.h"
#include "widgets/working/working_practice.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QUrl>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

constexpr int usualFrameHeight = 40;

/// The one local file that is dropped; empty for anything else.
QString fileIn(const QMimeData &data) {
  const QList<QUrl> urls = data.urls();
  return urls.size() == 1 ? urls.front().toLocalFile() : QString();
}

} // namespace

MainWindow::MainWindow(LessonLibrary library)
    : m_model(std::move(library)), m_progress(m_model, m_putAside), m_panels(*this, m_model),
      m_messages(m_panels.messages()), m_look(*this), m_layout(*this, m_panels),
      m_step(m_model, m_panels, m_progress),
      m_meshes(m_model, m_panels.scene().view(), m_step.flight().player(), m_messages),
      m_files(m_model, m_panels.input(), m_messages),
      m_autosave(m_model, m_files, m_panels.input(), m_progress, m_messages),
      m_leftovers(m_model, m_files, m_autosave, m_panels.input(), m_panels.scene().view(), m_messages),
      m_scene(&m_panels.scene().view()), m_frame(&m_panels.scene().frame()), m_flat(&m_panels.scene().flat()),
      m_caseLine(&m_panels.scene().caseLine()), m_contents(&m_panels.contents()) {
  setObjectName("main");
  setAcceptDrops(true);
  connect(m_contents, &ContentsDrawer::lessonChosen, this,
          [this](const QString &id) { m_model.openLesson(id.toStdString()); });
  createMenus();
  createHeader();
  createSceneTools();

  connect(&m_model, &SessionModel::lessonChanged, this, &MainWindow::showLesson);
  connect(&m_step.question(), &StepQuestion::changed, &m_autosave, &Autosave::keepSoon);
  connect(&m_model.history(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
  connect(&m_files, &SessionFiles::changed, this, &MainWindow::updateTitle);
  connect(&m_watch, &LessonWatch::changed, this, &MainWindow::reloadLesson);
  restoreSettings();
  showLesson();
  m_step.showAll();
}

MainWindow::~MainWindow() {
  // Nobody hears of the end of the history.
  m_model.disconnect();
  m_model.history().disconnect();
}

void MainWindow::chooseOwnLessons() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of your own lessons"),
                                                           m_ownLessons.value(m_ownLessons.size() - 1));
  if (!folder.isEmpty())
    addOwnLessonsOf(folder);
}

void MainWindow::addOwnLessonsOf(const QString &folder) {
  if (m_ownLessons.contains(folder))
    return m_messages.say(tr("The lessons of %1 are there already.").arg(folder));
  LessonLibrary library = m_model.library();
  library.problems.clear();
  addOwnLessons(library, folder.toStdString());
  const QString problem =
      library.problems.empty() ? QString() : QString::fromStdString(library.problems.front().text());
  m_ownLessons << folder;
  m_progress.nameSteps(library.lessons);
  m_model.setLibrary(std::move(library));
  m_messages.say(problem.isEmpty() ? tr("The lessons of %1 stand at the end of the contents.").arg(folder)
                                   : problem);
}

void MainWindow::removeOwnLessonsOf(const QString &folder) {
  LessonLibrary library = m_model.library();
  std::erase_if(library.lessons, [&](const Lesson &lesson) {
    return areOneFolder(std::filesystem::path(lesson.file).parent_path(), folder.toStdString());
  });
  m_ownLessons.removeAll(folder);
  m_model.setLibrary(std::move(library));
  m_messages.say(tr("The lessons of %1 are not in the contents any more. Their files stay.").arg(folder));
}

void MainWindow::fillOwnLessonsMenu(QMenu &menu) {
  menu.clear();
  menu.addAction(tr("&Add a Folder…"), this, &MainWindow::chooseOwnLessons);
  if (m_ownLessons.isEmpty())
    return;
  menu.addSeparator();
  for (const QString &folder : m_ownLessons)
    menu.addAction(tr("Remove %1").arg(QString(folder).replace("&", "&&")), this,
                   [this, folder] { removeOwnLessonsOf(folder); });
}

void MainWindow::reloadLesson() {
  auto lesson = readLesson(m_model.lesson().file);
  if (!lesson)
    return m_messages.say(QString::fromStdString(lesson.problem().text()));
  if (lesson->id != m_model.lesson().id)
    return m_messages.say(tr("The lesson has another id now: it is read at the next start."));
  lesson->chapter = m_model.lesson().chapter;
  const std::vector<Problem> problems = problemsIn(*lesson);
  m_model.renewLesson(std::move(*lesson));
  m_messages.say(problems.empty() ? tr("The lesson's file has changed: it is read anew.")
                                  : QString::fromStdString(problems.front().text()));
}

void MainWindow::showLesson() {
  m_watch.watch(m_model.lesson().file);
  m_contents->close();
  updateTitle();
}

void MainWindow::showContents() {
  std::vector<ContentsDrawer::Entry> entries;
  for (const Lesson &lesson : m_model.library().lessons)
    entries.push_back({QString::fromStdString(lesson.id), QString::fromStdString(lesson.title),
                       m_progress.stateOf(lesson), QString::fromStdString(lesson.chapter),
                       m_progress.idsStillNeeded(lesson)});
  m_contents->setLessons(entries, QString::fromStdString(m_model.session().lesson));
  m_contents->open();
}

void MainWindow::updateTitle() {
  setWindowTitle(m_files.name() + "[*] — Halfspace");
  setWindowModified(!m_model.history().isClean());
}

void MainWindow::showLook() {
  const Theme panels = m_look.panelTheme();
  applyStyle(*qApp, panels);
  m_panels.setLook(m_look.theme(), m_look.sizeScale(), panels);
  m_layout.setPageTheme(panels);
  m_panels.practice().working().setInkOf(markInk(m_model, panels));
}

void MainWindow::showFitting() {
  m_scene->setFocus(); // its keys work at once
  const QSize room = screen()->availableSize() - QSize(0, usualFrameHeight);
  if (width() > room.width() || height() > room.height())
    showMaximized();
  else
    show();
}

void MainWindow::complain(const QString &sentence) { m_messages.complain(sentence); }

void MainWindow::tellPutAside() {
  if (const QString sentences = m_putAside.takeSentences(); !sentences.isEmpty())
    complain(sentences);
}

void MainWindow::restoreSettings() {
  const auto stored = readSettings(settingsFile());
  if (!stored)
    m_putAside.add(stored.problem()); // where it cannot be, it is not written either
  const Settings settings = stored ? *stored : Settings();
  m_layout.takeGeometry(settings);
  m_look.take(settings);
  m_model.setSnapStep(settings.snapStep);
  m_model.setSnapping(settings.snapping);
  m_ownLessons = settings.ownLessons;
  m_flat->unfolded().setChecked(settings.flatPicture);
  m_layout.takePanels(settings);
}

void MainWindow::storeLook() {
  auto settings = readSettings(settingsFile());
  if (!settings)
    return; // it is put aside at the end, and written anew
  m_look.putTheme(*settings);
  if (const auto problem = writeSettings(*settings, settingsFile()))
    printError(problem->text());
}

void MainWindow::storeSettings() {
  Settings settings;
  m_look.putTheme(settings);
  settings.motion = m_look.motion().isChecked();
  settings.snapStep = m_model.snapStep();
  settings.snapping = m_model.isSnapping();
  settings.ownLessons = m_ownLessons;
  settings.flatPicture = m_flat->unfolded().isChecked();
  m_layout.put(settings);
  const auto stored = readSettings(settingsFile());
  auto problem = stored ? std::nullopt : m_putAside.add(stored.problem());
  if (!problem)
    problem = writeSettings(settings, settingsFile());
  // The window is on its way out: there is nowhere else to say it.
  if (problem)
    printError(problem->text());
}

void MainWindow::createHeader() {
  auto *header = new WindowHeader(*menuBar(), m_model, *m_contents);
  connect(header, &WindowHeader::contentsWanted, this, &MainWindow::showContents);
  connect(&m_layout, &WindowLayout::sizeTaken, header, &WindowHeader::showTitle);
  connect(&m_look, &WindowLook::changed, this, &MainWindow::showLook); // first: the type is the application's
  connect(&m_look, &WindowLook::changed, header, [this, header] { header->setTheme(m_look.panelTheme()); });
  connect(&m_look, &WindowLook::chosen, this, &MainWindow::storeLook);
  connect(&m_look.motion(), &QAction::toggled, this, [this](bool on) {
    m_scene->setMotion(on);
    m_step.flight().player().setReducedMotion(!on);
  });
}

void MainWindow::createSceneTools() {
  m_frame->addTool(*m_home, ToolIcon::Home);
  m_frame->addTool(*m_fit, ToolIcon::Fit);
  m_frame->addTool(*m_alongPlane, ToolIcon::AlongPlane);
  m_frame->addTool(*m_panels.numbersDock().toggleViewAction(), ToolIcon::Numbers);
}

void MainWindow::closeEvent(QCloseEvent *event) {
  event->ignore();
  // What has no file comes back with the next start, without a question.
  if (!m_files.mayClose() || !m_autosave.keepForNextStart())
    return;
  leave();
  event->accept();
  emit closed();
}

void MainWindow::leave() {
  m_meshes.leave();
  m_autosave.recovery().leave();
  storeSettings();
}

void MainWindow::endWithoutQuestions() {
  static_cast<void>(m_panels.input().finish()); // what cannot be entered is no number
  if (const auto problem = m_autosave.keepNow())
    printError(problem->text());
  leave();
}

void MainWindow::endWhileBusy() {
  if (const auto problem = m_autosave.keepWhileBusy())
    printError(problem->text());
}

void MainWindow::resizeEvent(QResizeEvent *event) {
  QMainWindow::resizeEvent(event);
  m_layout.takeSize();
  m_caseLine->setWindowHeight(height());
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event) {
  if (!fileIn(*event->mimeData()).isEmpty())
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent *event) {
  const QString file = fileIn(*event->mimeData());
  if (file.isEmpty())
    return;
  event->setDropAction(Qt::CopyAction); // whoever moves deletes the file
  event->accept();
  if (!file.endsWith(".halfspace") && !file.endsWith(".md"))
    return m_meshes.open(file);
  QTimer::singleShot(0, this, [this, file] { // the other program does not wait for questions
    if (m_files.mayLeave())
      m_files.open(file);
  });
}

} // namespace halfspace
