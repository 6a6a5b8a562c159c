#include "app/main_window.h"

#include "app/explore/explore_presenter.h"
#include "app/explore/field_presenter.h"
#include "app/explore/go_on_in_explore.h"
#include "app/explore/scene_lesson.h"
#include "app/export/figure_export.h"
#include "app/export/scene_paste.h"
#include "app/library/contents_presenter.h"
#include "app/library/formula_presenter.h"
#include "app/library/glossary_presenter.h"
#include "app/library/lesson_reloader.h"
#include "app/library/own_lesson_folders.h"
#include "app/menus/camera_actions.h"
#include "app/menus/edit_menu.h"
#include "app/menus/file_menu.h"
#include "app/menus/help_menu.h"
#include "app/menus/lesson_menu.h"
#include "app/menus/scene_menu.h"
#include "app/menus/view_menu.h"
#include "app/open_session.h"
#include "app/panels/scene_column.h"
#include "app/panels/unfinished_input.h"
#include "app/panels/window_header.h"
#include "app/panels/window_style.h"
#include "app/standard_streams.h"
#include "app/window_settings.h"
#include "app/work/animation_export.h"
#include "app/work/handout_export.h"
#include "app/work/working_copy.h"
#include "widgets/explore/explore_panel.h"
#include "widgets/mark_ink.h"
#include "widgets/view/case_line.h"
#include "widgets/view/flat_view.h"
#include "widgets/view/scene_frame.h"
#include "widgets/view/scene_view.h"
#include "widgets/working/working_practice.h"

#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QToolButton>
#include <QUrl>

#include <utility>

namespace halfspace {
namespace {

/// A frame around a window is about so high, in pixels.
constexpr int usualFrameHeight = 40;

/// The one local file that is dropped; empty for anything else.
QString fileIn(const QMimeData &data) {
  const QList<QUrl> urls = data.urls();
  return urls.size() == 1 ? urls.front().toLocalFile() : QString();
}

} // namespace

MainWindow::MainWindow(LessonLibrary library, Session session, const Result<Settings> &settings,
                       std::shared_ptr<const KnownFile> file)
    : m_model(std::move(library), std::move(session)), m_progress(m_model, m_putAside),
      m_panels(*this, m_model), m_look(*this), m_layout(*this, m_panels),
      m_step(m_model, m_panels, m_progress),
      m_meshes(m_model, sceneView(), m_step.flight().player(), m_panels.messages()),
      m_files(m_model, m_panels.input(), m_panels.messages(), std::move(file)),
      m_autosave(m_model, m_files, m_panels.input(), m_progress, m_panels.messages()),
      m_leftovers(m_model, m_files, m_autosave, m_panels.input(), sceneView().drawing(),
                  m_panels.messages()) {
  setObjectName("main");
  setAcceptDrops(true);
  connect(&m_look, &WindowLook::changed, this, &MainWindow::showLook); // first: the type is the application's
  // What goes on by itself belongs to the window.
  new LessonReloader(m_model, m_panels.messages(), this);
  auto *ownLessons = new OwnLessonFolders(m_model, m_progress, m_panels.messages(), this);
  auto *contents = new ContentsPresenter(m_model, m_panels.contents(), m_progress, this);
  auto *figures = new FigureExport(m_model, m_panels.scene(), m_panels.messages(), this);
  auto *goOn = new GoOnInExplore(m_model, m_files, this);
  createMenus(*ownLessons, *contents, *figures, *goOn);
  createExplore(*goOn);
  createHeader(*contents);
  connectParts();
  m_settings = std::make_unique<WindowSettings>(m_model, m_look, m_layout, *ownLessons,
                                                m_panels.scene().flat().unfolded(), *figures, m_putAside);
  m_settings->restore(settings);
  m_step.showAll();
  updateTitle();
}

MainWindow::~MainWindow() {
  // Nobody hears of the end of the history.
  m_model.disconnect();
}

SceneView &MainWindow::sceneView() { return m_panels.scene().view(); }

void MainWindow::createMenus(OwnLessonFolders &ownLessons, ContentsPresenter &contents, FigureExport &figures,
                             GoOnInExplore &goOn) {
  auto *handouts = new HandoutExport(m_model, m_panels.typesetter(), m_panels.messages(), this);
  auto *animations = new AnimationExport(m_model, sceneView(), m_look, m_panels.messages(), this);
  auto *working = new WorkingCopy(m_panels.practice().working(), m_panels.messages(), this);
  auto *paste = new ScenePaste(m_model, m_files, m_panels.messages(), this);
  connect(paste, &ScenePaste::textPasted, &m_panels.scene().bar(), &EntryBar::linesPasted);
  auto *camera = new CameraActions(m_model, sceneView().viewpoint(), this);
  auto *glossary =
      new GlossaryPresenter(m_model, m_step.turner(), sceneView(), m_look, m_panels.typesetter(), this);
  auto *formulas = new FormulaPresenter(m_model, m_look, m_panels.typesetter(), *this);
  auto *lesson = new SceneLesson(m_model, m_files, ownLessons, m_panels.messages(), this);
  connect(&goOn, &GoOnInExplore::begun, lesson, &SceneLesson::goOnWith);
  QMenuBar *bar = menuBar();
  auto *file = new FileMenu(m_files, m_meshes, m_leftovers, figures, *handouts, *animations, *lesson, bar);
  connect(file, &FileMenu::quitWanted, this, &MainWindow::close);
  bar->addMenu(file);
  bar->addMenu(
      new EditMenu(m_model, sceneView(), m_meshes, m_step.freshStart(), *working, figures, *paste, bar));
  bar->addMenu(new ViewMenu(*camera, m_look, m_layout, m_panels, bar));
  bar->addMenu(new LessonMenu(m_step.turner(), m_step.page(), m_step.flight(), contents, *glossary, *formulas,
                              ownLessons, bar));
  bar->addMenu(new HelpMenu(*this, bar));
  createSceneTools(*camera);
}

void MainWindow::createSceneTools(CameraActions &camera) {
  SceneFrame &frame = m_panels.scene().frame();
  frame.addTool(camera.home(), ToolIcon::Home);
  frame.addTool(camera.fit(), ToolIcon::Fit);
  frame.addTool(camera.alongPlane(), ToolIcon::AlongPlane);
  frame.addTool(*m_panels.numbersDock().toggleViewAction(), ToolIcon::Numbers);
}

void MainWindow::createExplore(GoOnInExplore &goOn) {
  SceneColumn &scene = m_panels.scene();
  ExplorePanel &explore = m_panels.explore();
  auto *field =
      new FieldPresenter(m_model, goOn, scene.bar(), explore.edits(), explore.selection(), *menuBar(), this);
  m_explore = new ExplorePresenter(m_model, m_panels, m_step.highlights(), *field, this);
  connect(field, &FieldPresenter::openChanged, &scene.bar(), &EntryBar::setVisible);
  connect(field, &FieldPresenter::left, &scene.view(), [&scene] { scene.view().setFocus(); });
  connect(&explore.list(), &EntryList::lineWanted, field, &FieldPresenter::edit);
  connect(&explore.edits(), &EntryEdits::told, this,
          [this](const QString &sentence) { m_panels.messages().say(sentence); });
  scene.bar().setVisible(isExplore(m_model));
  const auto actions = menuBar()->actions();
  auto *menu = new SceneMenu(m_model, goOn, *field, scene.view().objectHand(), m_meshes, menuBar());
  menuBar()->insertMenu(actions.at(actions.size() - 2), menu);
  auto *add = new QToolButton;
  add->setObjectName("addTool");
  add->setText(tr("Add"));
  add->setMenu(&menu->tools());
  add->setPopupMode(QToolButton::InstantPopup);
  scene.bar().addTool(*add);
}

void MainWindow::createHeader(ContentsPresenter &contents) {
  auto *header = new WindowHeader(*menuBar(), m_model, m_panels.contents());
  connect(header, &WindowHeader::contentsWanted, &contents, &ContentsPresenter::show);
  connect(&m_layout, &WindowLayout::sizeTaken, header, &WindowHeader::showTitle);
  connect(&m_look, &WindowLook::changed, header, [this, header] { header->setTheme(m_look.panelTheme()); });
}

void MainWindow::connectParts() {
  connect(&m_look.motion(), &QAction::toggled, this, [this](bool on) {
    sceneView().setMotion(on);
    m_step.flight().player().setReducedMotion(!on);
  });
  connect(&m_step.question(), &StepQuestion::changed, &m_autosave, &Autosave::keepSoon);
  connect(&m_files, &SessionFiles::changed, this, &MainWindow::updateTitle);
  connect(&m_model, &SessionModel::lessonChanged, this, &MainWindow::updateTitle);
  connect(&m_model.history(), &SessionHistory::cleanChanged, this, &MainWindow::updateTitle);
}

void MainWindow::showLook() {
  const Theme panels = m_look.panelTheme();
  applyStyle(*qApp, panels);
  m_panels.setLook(m_look.theme(), m_look.sizeScale(), panels);
  m_layout.setPageTheme(panels);
  m_panels.practice().working().setInkOf(markInk(m_model, panels));
}

void MainWindow::updateTitle() {
  setWindowTitle(m_files.name() + "[*] — Halfspace");
  setWindowModified(!m_model.history().isClean());
}

void MainWindow::showFitting() {
  sceneView().setFocus(); // its keys work at once
  const QSize room = screen()->availableSize() - QSize(0, usualFrameHeight);
  if (width() > room.width() || height() > room.height())
    showMaximized();
  else
    show();
}

void MainWindow::complain(const QString &sentence) { m_panels.messages().complain(sentence); }

void MainWindow::tellPutAside() {
  if (const QString sentences = m_putAside.takeSentences(); !sentences.isEmpty())
    complain(sentences);
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
  m_settings->store();
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

void MainWindow::keyPressEvent(QKeyEvent *event) {
  if (!m_explore->pressKey(*event))
    QMainWindow::keyPressEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent *event) {
  QMainWindow::resizeEvent(event);
  m_layout.takeSize();
  m_panels.scene().caseLine().setWindowHeight(height());
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
  if (!namesSession(file.toStdString()))
    return m_meshes.open(file);
  QTimer::singleShot(0, this, [this, file] { // the other program does not wait for questions
    if (m_files.mayLeave())
      m_files.open(file);
  });
}

} // namespace halfspace
