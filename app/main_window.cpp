#include "app/main_window.h"

#include "app/library/lesson_reloader.h"
#include "app/panels/scene_column.h"
#include "app/panels/unfinished_input.h"
#include "app/panels/window_header.h"
#include "app/standard_streams.h"
#include "app/window_style.h"
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
      m_ownLessons(m_model, m_progress, m_messages, this),
      m_contents(m_model, m_panels.contents(), m_progress, this), m_scene(&m_panels.scene().view()),
      m_frame(&m_panels.scene().frame()), m_flat(&m_panels.scene().flat()),
      m_caseLine(&m_panels.scene().caseLine()) {
  setObjectName("main");
  setAcceptDrops(true);
  new LessonReloader(m_model, m_messages, this); // goes on by itself
  createMenus();
  createHeader();
  createSceneTools();

  connect(&m_model, &SessionModel::lessonChanged, this, &MainWindow::updateTitle);
  connect(&m_step.question(), &StepQuestion::changed, &m_autosave, &Autosave::keepSoon);
  connect(&m_model.history(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
  connect(&m_files, &SessionFiles::changed, this, &MainWindow::updateTitle);
  restoreSettings();
  m_step.showAll();
  updateTitle();
}

MainWindow::~MainWindow() {
  // Nobody hears of the end of the history.
  m_model.disconnect();
  m_model.history().disconnect();
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
  m_ownLessons.setFolders(settings.ownLessons);
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
  settings.ownLessons = m_ownLessons.folders();
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
  auto *header = new WindowHeader(*menuBar(), m_model, m_panels.contents());
  connect(header, &WindowHeader::contentsWanted, &m_contents, &ContentsPresenter::show);
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
