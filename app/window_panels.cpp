// What the window is made of and where it stands.
#include "app/main_window.h"
#include "app/page_width.h"
#include "widgets/lesson/contents_drawer.h"
#include "widgets/lesson/lesson_page.h"
#include "widgets/numbers/inspector.h"
#include "widgets/numbers/number_card.h"
#include "widgets/view/case_line.h"
#include "widgets/view/flat_view.h"
#include "widgets/view/scene_frame.h"
#include "widgets/working/working_practice.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

namespace halfspace {

void MainWindow::createPanels() {
  m_practice = new WorkingPractice(*m_typesetter);
  m_working = &m_practice->working();
  m_page = new LessonPage(*m_typesetter, *m_practice);
  m_split = new QSplitter;
  m_split->setChildrenCollapsible(false);
  m_split->addWidget(createScene());
  m_split->addWidget(m_page);
  m_split->setStretchFactor(0, 1);
  m_split->setStretchFactor(1, 0);
  connect(m_split, &QSplitter::splitterMoved, this, [this] { m_isSplitChosen = true; });
  auto *center = new QWidget;
  auto *layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_split);
  setCentralWidget(center);
  createInspector();
  createContents();
  connectWorking();
  connectPage();
  connectFlight();
  connectMeshes();
}

QWidget *MainWindow::createScene() {
  m_card = new NumberCard(m_model, *m_typesetter);
  m_frame = new SceneFrame(*m_scene, *m_card);
  m_flat = new FlatView(m_model, *m_typesetter, m_frame);
  m_frame->setFlatView(*m_flat);
  connect(m_flat, &FlatView::markHovered, this, &MainWindow::hoverMark);
  connect(m_flat, &FlatView::handleGrabbed, m_scene,
          [this](const QString &id) { m_scene->selectHandle(id.toStdString()); });
  m_caseLine = new CaseLine;
  connect(m_caseLine, &CaseLine::nearbyChosen, this, &MainWindow::goToNearby);
  connect(m_caseLine, &CaseLine::afreshChosen, this, &MainWindow::startOver);
  m_sceneColumn = new QWidget;
  auto *column = new QVBoxLayout(m_sceneColumn);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(m_frame, 1);
  column->addWidget(m_caseLine);
  return m_sceneColumn;
}

void MainWindow::createInspector() {
  m_inspector = new Inspector(m_model, *m_typesetter);
  m_numbersDock = new QDockWidget(tr("Numbers"), this);
  m_numbersDock->setObjectName("numbersDock");
  m_numbersDock->setWidget(m_inspector);
  addDockWidget(Qt::LeftDockWidgetArea, m_numbersDock);
  m_numbersDock->hide();
  // Once what it takes, or gives back, is known.
  connect(m_numbersDock, &QDockWidget::visibilityChanged, this, &MainWindow::sharePage, Qt::QueuedConnection);
}

void MainWindow::createContents() {
  m_contents = new ContentsDrawer(centralWidget()); // a splitter would make it a third part
  connect(m_contents, &ContentsDrawer::lessonChosen, this,
          [this](const QString &id) { m_model.openLesson(id.toStdString()); });
}

/// In the row of the menus: the way to the contents, and the lesson's title.
void MainWindow::createHeader() {
  m_contentsButton = new QToolButton;
  m_contentsButton->setObjectName("contentsButton");
  m_contentsButton->setToolTip(tr("All lessons"));
  m_contentsButton->setAccessibleName(tr("Contents"));
  m_contentsButton->setAutoRaise(true);
  m_contentsButton->setCheckable(true);
  connect(m_contentsButton, &QToolButton::clicked, this, [this](bool open) {
    if (open)
      showContents();
    else
      m_contents->close();
  });
  connect(m_contents, &ContentsDrawer::openChanged, m_contentsButton, &QToolButton::setChecked);
  m_lessonTitle = new QLabel;
  m_lessonTitle->setObjectName("lessonTitle");
  m_lessonTitle->setTextFormat(Qt::PlainText);
  menuBar()->setCornerWidget(m_contentsButton, Qt::TopLeftCorner);
  menuBar()->setCornerWidget(m_lessonTitle, Qt::TopRightCorner);
}

void MainWindow::createSceneTools() {
  m_frame->addTool(*m_home, ToolIcon::Home);
  m_frame->addTool(*m_fit, ToolIcon::Fit);
  m_frame->addTool(*m_alongPlane, ToolIcon::AlongPlane);
  m_frame->addTool(*m_numbersDock->toggleViewAction(), ToolIcon::Numbers);
}

void MainWindow::connectPage() {
  connect(m_page, &LessonPage::stepRequested, this, [this](int step) { m_model.setStep(step); });
  connect(m_page, &LessonPage::nextLessonRequested, this, &MainWindow::openNextLesson);
  connect(m_page, &LessonPage::predictionChosen, this, &MainWindow::choose);
  connect(m_page, &LessonPage::predictionReopened, this, &MainWindow::reopenQuestion);
}

void MainWindow::connectWorking() {
  m_working->setWholeWorking([this] { return workingOf(m_model.evaluation()); });
  connect(m_working, &StepWorking::markHovered, this, &MainWindow::hoverMark);
  connect(m_scene, &SceneView::dismissed, m_working, &StepWorking::endTrace);
  connect(m_working, &StepWorking::traceChanged, this, &MainWindow::showHighlights);
  connect(m_working, &StepWorking::coordinateTyped, this,
          [this](const CoordinateSource &source, const Rational &value) {
            if (const auto number = numberOf(source))
              m_editor.change(*number, value);
          });
  connect(m_working, &StepWorking::coordinateStepped, this,
          [this](const CoordinateSource &source, int steps) {
            if (const auto number = numberOf(source))
              m_editor.step(*number, steps);
          });
  connect(m_working, &StepWorking::scrubStarted, this, [this](const CoordinateSource &source) {
    if (const auto number = numberOf(source))
      m_editor.beginScrub(*number);
  });
  connect(m_working, &StepWorking::scrubbed, this, [this](int steps) { m_editor.scrub(steps); });
  connect(m_working, &StepWorking::scrubEnded, this, [this](bool keep) { m_editor.endScrub(keep); });
}

std::optional<CoordinateNumber> MainWindow::numberOf(const CoordinateSource &source) const {
  const auto id = coordinateOf(m_model.session().scene, source);
  return id ? std::optional(CoordinateNumber{*id, source.component.value_or(0)}) : std::nullopt;
}

void MainWindow::sharePage() {
  const bool below = isPageBelow(size());
  m_split->setOrientation(below ? Qt::Vertical : Qt::Horizontal);
  if (m_isSplitChosen)
    return;
  // The split's own width is that of before while the window is on its way to another size.
  const bool isDocked = m_numbersDock->isVisible() && !m_numbersDock->isFloating();
  const int whole = below ? m_split->height() : width() - (isDocked ? m_numbersDock->width() : 0);
  const int page =
      below ? static_cast<int>(pageShareBelow * whole) : pageWidthIn(whole, m_page->fontMetrics());
  m_split->setSizes({whole - page, page});
}

double MainWindow::pageTypeScale() const {
  return m_sceneColumn->isHidden()
             ? typeScaleAlone(width(), LessonPage::longestLine(QFontMetrics(QApplication::font())))
             : 1;
}

void MainWindow::showPageLook() {
  m_pageTypeScale = pageTypeScale();
  Theme theme = m_theme;
  theme.textScale *= sizeScale() * m_pageTypeScale;
  QFont type = QApplication::font();
  type.setPointSizeF(type.pointSizeF() * m_pageTypeScale);
  m_page->setFont(type);
  m_page->setTheme(theme);
  sharePage();
  // Once all parts have their new sizes: the page may have been wider than it must be now.
  QTimer::singleShot(0, this, &MainWindow::sharePage);
}

void MainWindow::resizeEvent(QResizeEvent *event) {
  QMainWindow::resizeEvent(event);
  if (pageTypeScale() != m_pageTypeScale)
    showPageLook();
  sharePage();
  m_caseLine->setWindowHeight(height());
  showLessonTitle();
}

void MainWindow::showLessonTitle() {
  m_lessonTitle->setText(QString::fromStdString(m_model.lesson().title));
  m_lessonTitle->hide(); // the menus alone
  m_lessonTitle->setVisible(menuBar()->sizeHint().width() + m_lessonTitle->sizeHint().width() <= width());
}

void MainWindow::showParts(Parts parts) {
  m_sceneColumn->setVisible(parts != Parts::PageOnly);
  m_page->setVisible(parts != Parts::SceneOnly);
  m_sceneOnly->setChecked(parts == Parts::SceneOnly);
  m_pageOnly->setChecked(parts == Parts::PageOnly);
  showPageLook();
}

void MainWindow::setFullScreen(bool on) {
  m_fullScreen->setChecked(on);
  setWindowState(on ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
}

void MainWindow::restoreLayout() {
  showParts(Parts::Both);
  setFullScreen(false);
  m_numbersDock->setFloating(false);
  m_numbersDock->hide();
  m_isSplitChosen = false;
  sharePage();
}

} // namespace halfspace
