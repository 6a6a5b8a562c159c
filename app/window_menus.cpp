// The menus of the window: every action, its key, and what it calls.
#include "app/help_dialog.h"
#include "app/main_window.h"
#include "app/step/flight_keys.h"
#include "app/work/picture_export.h"
#include "widgets/view/flat_view.h"

#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>

namespace halfspace {
namespace {

template <class Receiver, class Slot>
QAction *addItem(QMenu &menu, const QString &text, const QKeySequence &key, Receiver *on, Slot slot) {
  QAction *action = menu.addAction(text);
  action->setShortcut(key);
  QObject::connect(action, &QAction::triggered, on, slot);
  return action;
}

} // namespace

void MainWindow::createMenus() {
  createFileMenu();
  createEditMenu();
  createViewMenu();
  createLessonMenu();
  createHelpMenu();
}

void MainWindow::createFileMenu() {
  QMenu &menu = *menuBar()->addMenu(tr("&File"));
  auto *pictures = new PictureExport(m_model, *m_scene, m_look, m_panels.typesetter(), m_messages, this);
  addItem(menu, tr("&Open…"), QKeySequence::Open, &m_files, &SessionFiles::askAndOpen);
  addItem(menu, tr("Open &Mesh…"), QKeySequence("Ctrl+M"), &m_meshes, &SceneMeshes::askAndOpen);
  addItem(menu, tr("&Save"), QKeySequence::Save, &m_files, &SessionFiles::save)->setObjectName("save");
  addItem(menu, tr("Save &As…"), QKeySequence::SaveAs, &m_files, &SessionFiles::saveAs);
  QMenu &unsaved = *menu.addMenu(tr("&Unsaved Work"));
  unsaved.setObjectName("unsavedWork");
  connect(&unsaved, &QMenu::aboutToShow, &m_leftovers, [this, &unsaved] { m_leftovers.fillMenu(unsaved); });
  menu.addSeparator();
  addItem(menu, tr("Save &Picture…"), QKeySequence("Ctrl+E"), pictures, &PictureExport::askAndSave);
  addItem(menu, tr("&Copy Picture"), QKeySequence("Ctrl+Shift+C"), pictures, &PictureExport::copy);
  menu.addSeparator();
  addItem(menu, tr("&Quit"), QKeySequence::Quit, this, &MainWindow::close);
}

void MainWindow::connectInstead(QAction &action, void (SessionModel::*step)()) {
  disconnect(&action, &QAction::triggered, nullptr, nullptr);
  connect(&action, &QAction::triggered, &m_model, step);
}

void MainWindow::createEditMenu() {
  QMenu &menu = *menuBar()->addMenu(tr("&Edit"));
  QAction *undo = m_model.history().createUndoAction(this, tr("&Undo"));
  connectInstead(*undo, &SessionModel::undo);
  undo->setShortcut(QKeySequence::Undo);
  QAction *redo = m_model.history().createRedoAction(this, tr("&Redo"));
  connectInstead(*redo, &SessionModel::redo);
  redo->setShortcuts({QKeySequence::Redo, QKeySequence("Ctrl+Y")});
  menu.addAction(undo);
  menu.addAction(redo);
  menu.addSeparator();
  addItem(menu, tr("&Start Over"), QKeySequence("Ctrl+R"), this, [this] { m_step.freshStart().startOver(); });
  createCornerItems(menu);
  createMeshItems(menu);
  QMenu &snap = *menu.addMenu(tr("S&nap To"));
  snap.setObjectName("snap");
  createSnapMenu(snap);
}

/// For a selected corner of a polygon or a prism.
void MainWindow::createCornerItems(QMenu &menu) {
  QAction *add =
      addItem(menu, tr("&Add a Corner Here"), Qt::Key_Insert, m_scene, [this] { m_scene->addCorner(); });
  QAction *remove = addItem(menu, tr("Re&move the Corner"), QKeySequence::Delete, m_scene,
                            [this] { m_scene->removeCorner(); });
  const auto enable = [this, add, remove] {
    add->setEnabled(m_scene->isCornerSelected());
    remove->setEnabled(m_scene->isCornerSelected());
  };
  connect(m_scene, &SceneView::selectionChanged, this, enable);
  enable();
}

void MainWindow::createMeshItems(QMenu &menu) {
  QAction *copy = addItem(menu, tr("A&nother Such Mesh"), QKeySequence("Ctrl+D"), this,
                          [this] { m_meshes.copySelected(); });
  QAction *remove = addItem(menu, tr("Remo&ve the Mesh"), QKeySequence::Delete, this,
                            [this] { m_meshes.removeSelected(); });
  const auto enable = [this, copy, remove] {
    copy->setEnabled(m_meshes.canCopySelected());
    remove->setEnabled(m_meshes.canRemoveSelected());
  };
  connect(m_scene, &SceneView::selectionChanged, this, enable);
  enable();
}

void MainWindow::createSnapMenu(QMenu &menu) {
  auto *group = new QActionGroup(this);
  const std::pair<QString, Rational> steps[] = {{tr("Whole numbers"), 1},
                                                {tr("Halves"), Rational(1, 2)},
                                                {tr("Quarters"), Rational(1, 4)},
                                                {tr("Tenths"), Rational(1, 10)}};
  for (const auto &[text, step] : steps) {
    QAction *action = menu.addAction(text);
    action->setCheckable(true);
    group->addAction(action);
    connect(&menu, &QMenu::aboutToShow, action, [this, action, step = step] {
      action->setChecked(m_model.isSnapping() && step == m_model.snapStep());
    });
    connect(action, &QAction::triggered, this, [this, step = step] {
      m_model.setSnapStep(step);
      m_model.setSnapping(true);
    });
  }
  QAction *nothing = menu.addAction(tr("Nothing (thousandths)"));
  nothing->setCheckable(true);
  group->addAction(nothing);
  connect(nothing, &QAction::triggered, this, [this] { m_model.setSnapping(false); });
  connect(&menu, &QMenu::aboutToShow, nothing,
          [this, nothing] { nothing->setChecked(!m_model.isSnapping()); });
  menu.addSeparator();
  menu.addAction(tr("Hold Ctrl while dragging for thousandths"))->setEnabled(false);
}

void MainWindow::createViewMenu() {
  QMenu &menu = *menuBar()->addMenu(tr("&View"));
  createCameraItems(menu);
  menu.addSeparator();
  createSizeMenu(*menu.addMenu(tr("&Size of Text and Lines")));
  createThemeMenu(*menu.addMenu(tr("Th&eme")));
  menu.addAction(&m_look.motion());
  menu.addSeparator();
  createLayoutItems(menu);
}

void MainWindow::createLayoutItems(QMenu &menu) {
  QAction *numbers = m_panels.numbersDock().toggleViewAction();
  numbers->setText(tr("All &Numbers"));
  numbers->setShortcut(QKeySequence("Ctrl+I"));
  menu.addAction(numbers);
  m_flat->unfolded().setShortcut(QKeySequence("6"));
  menu.addAction(&m_flat->unfolded());
  menu.addActions(m_layout.actions());
}

void MainWindow::createCameraItems(QMenu &menu) {
  m_fit = addItem(menu, tr("&Fit"), QKeySequence("F"), this, [this] { m_scene->fit(); });
  m_home = addItem(menu, tr("&Home"), QKeySequence("H"), this, [this] { m_scene->goHome(); });
  QAction *previous =
      addItem(menu, tr("Pre&vious View"), QKeySequence("V"), this, [this] { m_scene->showPreviousView(); });
  previous->setObjectName("previousView");
  const auto enablePrevious = [this, previous] { previous->setEnabled(m_scene->hasPreviousView()); };
  connect(m_scene, &SceneView::previousViewsChanged, this, enablePrevious);
  enablePrevious();
  addItem(menu, tr("From the &Front (x)"), QKeySequence("1"), this,
          [this] { m_scene->setAxisView(AxisView::Front); });
  addItem(menu, tr("From the &Right (y)"), QKeySequence("2"), this,
          [this] { m_scene->setAxisView(AxisView::Right); });
  addItem(menu, tr("From the &Top (z)"), QKeySequence("3"), this,
          [this] { m_scene->setAxisView(AxisView::Top); });
  m_alongPlane =
      addItem(menu, tr("Along the &Plane"), QKeySequence("4"), this, [this] { m_scene->lookAlongPlane(); });
  QAction *face =
      addItem(menu, tr("Fa&ce the Plane"), QKeySequence("7"), this, [this] { m_scene->facePlane(); });
  face->setObjectName("facePlane");
  auto *planeViews = new QActionGroup(this);
  planeViews->addAction(m_alongPlane);
  planeViews->addAction(face);
  auto *courses = new QActionGroup(this);
  const auto addCourse = [&](const QString &text, const char *key, const char *name, AlongCourse way) {
    QAction *action =
        addItem(menu, text, QKeySequence(key), this, [this, way] { m_scene->lookAlongCourse(way); });
    action->setObjectName(name);
    courses->addAction(action);
  };
  addCourse(tr("&Down the Ray or Line"), "5", "downCourse", AlongCourse::Down);
  addCourse(tr("&Against the Ray or Line"), "8", "againstCourse", AlongCourse::Against);
  const auto enable = [this, planeViews, courses] {
    planeViews->setEnabled(showsPlane(m_model.figure()));
    courses->setEnabled(firstCourse(m_model.shown().figure).has_value());
  };
  connect(&m_model, &SessionModel::outcomeChanged, this, enable);
  enable();
  QAction *orthographic = menu.addAction(tr("&Orthographic"));
  orthographic->setCheckable(true);
  orthographic->setShortcut(QKeySequence("O"));
  connect(orthographic, &QAction::triggered, this, [this](bool on) { m_scene->setOrthographic(on); });
  connect(m_scene, &SceneView::orthographicChanged, orthographic, &QAction::setChecked);
}

void MainWindow::createSizeMenu(QMenu &menu) {
  WindowLook &look = m_look;
  const Messages messages = m_messages;
  const auto changeBy = [&look, messages](int steps) {
    look.changeSizeBy(steps);
    messages.say(tr("Text and lines at %1 %.").arg(qRound(look.sizeScale() * 100)));
  };
  QAction *larger = addItem(menu, tr("&Larger"), {}, this, [changeBy] { changeBy(1); });
  larger->setObjectName("larger");
  larger->setShortcuts({QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")}); // with and without Shift
  QAction *smaller =
      addItem(menu, tr("&Smaller"), QKeySequence("Ctrl+-"), this, [changeBy] { changeBy(-1); });
  smaller->setObjectName("smaller");
  addItem(menu, tr("&Usual Size"), QKeySequence("Ctrl+0"), &look, &WindowLook::chooseUsualSize)
      ->setObjectName("usualSize");
  connect(&look, &WindowLook::changed, this, [&look, larger, smaller] {
    larger->setEnabled(look.canGrow());
    smaller->setEnabled(look.canShrink());
  });
}

void MainWindow::createThemeMenu(QMenu &menu) {
  WindowLook &look = m_look;
  auto *group = new QActionGroup(this);
  for (const Theme &theme : themes()) {
    QString name = QString::fromStdString(theme.name);
    QAction *action = menu.addAction(name.left(1).toUpper() + name.mid(1));
    action->setCheckable(true);
    action->setData(name);
    group->addAction(action);
    connect(action, &QAction::triggered, &look, [&look, name] { look.chooseTheme(name); });
  }
  connect(&menu, &QMenu::aboutToShow, this, [&look, group] {
    for (QAction *action : group->actions())
      action->setChecked(action->data().toString().toStdString() == look.theme().name);
  });
}

void MainWindow::createLessonMenu() {
  QMenu &menu = *menuBar()->addMenu(tr("&Lesson"));
  addItem(menu, tr("&Next Step"), QKeySequence("Ctrl+Right"), this,
          [this] { m_model.setStep(m_model.session().step + 1); });
  addItem(menu, tr("&Previous Step"), QKeySequence("Ctrl+Left"), this,
          [this] { m_model.setStep(m_model.session().step - 1); });
  addItem(menu, tr("Next &Lesson"), QKeySequence("Ctrl+Shift+Right"), this,
          [this] { m_step.page().openNextLesson(); });
  addItem(menu, tr("&Contents"), QKeySequence("Ctrl+L"), this, [this] { m_contents.show(); });
  createFlightMenu(menu);
  menu.addSeparator();
  QMenu &own = *menu.addMenu(tr("Your &Own Lessons"));
  own.setObjectName("ownLessons");
  connect(&own, &QMenu::aboutToShow, this, [this, &own] { m_ownLessons.fillMenu(own); });
}

/// There in steps with a flight alone. The keys are those of the window, as the page may be hidden.
void MainWindow::createFlightMenu(QMenu &menu) {
  QMenu &flight = *menu.addMenu(tr("&Torpedo"));
  FlightPlayer &player = m_step.flight().player();
  const auto add = [&flight, &player](const QString &text, FlightControl control, auto slot) {
    addItem(flight, text, keysOf(control), &player, slot);
  };
  add(tr("&Fire"), FlightControl::Fire, [&player] { player.fire(); });
  add(tr("&Play or Pause"), FlightControl::Play, [&player] { player.play(!player.state().isPlaying); });
  add(tr("One Frame &Back"), FlightControl::StepBack, [&player] { player.step(-1); });
  add(tr("One Frame &On"), FlightControl::StepForward, [&player] { player.step(1); });
  connect(&m_step.flight(), &FlightPresenter::controllable, flight.menuAction(), &QAction::setVisible);
}

void MainWindow::createHelpMenu() {
  QMenu &menu = *menuBar()->addMenu(tr("&Help"));
  addItem(menu, tr("&Mouse and Keys"), QKeySequence::HelpContents, this, [this] { HelpDialog(this).exec(); });
  addItem(menu, tr("&About Halfspace"), {}, this, [this] {
    QMessageBox::about(
        this, tr("About Halfspace"),
        tr("<h3>Halfspace %1</h3><p>Drag planes, points, rays and triangles, and read the "
           "exact working live.</p><p>Formulas are set in Latin Modern Math (GUST Font License) and "
           "CMU Serif (SIL Open Font License).</p>")
            .arg(QApplication::applicationVersion()));
  });
}

} // namespace halfspace
