#include "app/main_window.h"

#include "app/session_files.h"
#include "app/window_style.h"
#include "lessons/session_file.h"
#include "widgets/colors.h"
#include "widgets/inspector.h"
#include "widgets/lesson_panel.h"
#include "widgets/scene/offscreen.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"
#include "widgets/unbroken.h"
#include "widgets/working_practice.h"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QSaveFile>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {
namespace {

/// The panels are brought up to date at most this often while something is dragged, in milliseconds.
constexpr int panelInterval = 30;
constexpr int messageTime = 8000;
/// Pictures are made this much finer than the screen shows them.
constexpr double pictureScale = 2;

constexpr int usualWidth = 1280;
constexpr int usualHeight = 800;
constexpr int usualFrameHeight = 40;

} // namespace

MainWindow::MainWindow(LessonLibrary library)
    : m_model(std::move(library)), m_typesetter(std::make_unique<Typesetter>()), m_theme(themes().front()) {
  setObjectName("main");
  m_scene = new SceneView(m_model, labelPainter(*m_typesetter));
  createPanels();
  createMenus();
  resize(QSize(usualWidth, usualHeight).boundedTo(screen()->availableSize()));

  m_panelTimer.setSingleShot(true);
  connect(&m_panelTimer, &QTimer::timeout, this, &MainWindow::showOutcome);
  connect(&m_model, &SessionModel::lessonChanged, this, &MainWindow::showLesson);
  connect(&m_model, &SessionModel::stepChanged, this, [this] {
    m_lessonPanel->setStep(m_model.session().step);
    progress().tasks.arrive();
  });
  connect(&m_model, &SessionModel::outcomeChanged, this, [this] {
    if (!m_panelTimer.isActive())
      m_panelTimer.start(m_model.inGesture() ? panelInterval : 0);
  });
  connect(&m_model.history(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
  connect(&m_model.history(), &QUndoStack::indexChanged, this, [this] {
    if (m_model.history().isClean())
      m_recovery.forget();
    else
      m_recovery.keep(m_model.session());
  });
  connect(m_typesetter.get(), &Typesetter::ready, m_scene, &SceneView::refreshLabels);
  connect(m_scene, &SceneView::markHovered, this, &MainWindow::highlight);
  connect(m_working, &WorkingPanel::markHovered, this, &MainWindow::highlight);
  connect(m_practice, &WorkingPractice::blanksChanged, this, &MainWindow::showOutcome);
  connect(m_scene, &SceneView::hint, this, [this](const QString &words) { statusBar()->showMessage(words); });

  restoreSettings();
  showLesson();
  showOutcome();
}

MainWindow::~MainWindow() {
  // The panels look at members: they go first, and hear nothing of the end of the history.
  m_model.disconnect();
  m_model.history().disconnect();
  delete takeCentralWidget();
  qDeleteAll(findChildren<QDockWidget *>());
}

// --- panels
// --------------------------------------------------------------------------------------------------------

QDockWidget *MainWindow::addPanel(const QString &title, const char *name, QWidget *content,
                                  Qt::DockWidgetArea area) {
  auto *dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  addDockWidget(area, dock);
  return dock;
}

void MainWindow::createPanels() {
  m_caseLabel = new QLabel;
  m_caseLabel->setObjectName("case");
  m_caseLabel->setWordWrap(true);
  m_caseLabel->setTextFormat(Qt::PlainText);
  auto *center = new QWidget;
  auto *layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_scene, 1);
  layout->addWidget(m_caseLabel);
  setCentralWidget(center);

  m_practice = new WorkingPractice(*m_typesetter);
  m_working = &m_practice->panel();
  m_inspector = new Inspector(m_model, *m_typesetter);
  m_lessonPanel = new LessonPanel(*m_typesetter);
  m_lessonList = new QListWidget;
  m_lessonList->setObjectName("lessonList");
  m_lessonList->setWordWrap(true);
  m_lessonList->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_lessonList->setTextElideMode(Qt::ElideNone);
  m_lessonList->setResizeMode(QListView::Adjust); // wrap anew at every width
  m_lessonList->setAccessibleName(tr("Lessons"));
  for (const Lesson &lesson : m_model.library().lessons) {
    auto *item = new QListWidgetItem(QString::fromStdString(lesson.title), m_lessonList);
    item->setData(Qt::UserRole, QString::fromStdString(lesson.id));
    item->setToolTip(QString::fromStdString(lesson.id));
  }
  connect(m_lessonList, &QListWidget::itemClicked, this, [this](QListWidgetItem *item) {
    m_model.openLesson(item->data(Qt::UserRole).toString().toStdString());
  });
  connect(m_lessonList, &QListWidget::itemActivated, this, [this](QListWidgetItem *item) {
    m_model.openLesson(item->data(Qt::UserRole).toString().toStdString());
  });
  connect(m_lessonPanel, &LessonPanel::stepRequested, this, [this](int step) { m_model.setStep(step); });
  connect(m_lessonPanel, &LessonPanel::predictionChosen, this, [this](const QString &word) {
    // Judged now: the learner may drag on afterwards.
    progress().chosen = word.toStdString();
    progress().right = rightAnswer(*currentStep()->prediction);
    showOutcome();
  });

  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  auto *working = addPanel(tr("Working"), "workingDock", m_practice, Qt::RightDockWidgetArea);
  auto *inspector = addPanel(tr("Numbers"), "numbersDock", m_inspector, Qt::RightDockWidgetArea);
  auto *lessons = addPanel(tr("Lessons"), "lessonsDock", m_lessonList, Qt::BottomDockWidgetArea);
  auto *words = addPanel(tr("Lesson"), "lessonDock", m_lessonPanel, Qt::BottomDockWidgetArea);
  splitDockWidget(working, inspector, Qt::Vertical);
  splitDockWidget(lessons, words, Qt::Horizontal);
  resizeDocks({working, inspector}, {400, 300}, Qt::Vertical);
  resizeDocks({working}, {400}, Qt::Horizontal);
  resizeDocks({lessons, words}, {225, 655}, Qt::Horizontal);
  resizeDocks({lessons}, {260}, Qt::Vertical);
}

// --- what is shown
// -------------------------------------------------------------------------------------------------

const LessonStep *MainWindow::currentStep() const {
  const auto step = static_cast<std::size_t>(m_model.session().step);
  return step < m_model.lesson().steps.size() ? &m_model.lesson().steps[step] : nullptr;
}

MainWindow::StepProgress &MainWindow::progress() {
  return m_progress[{m_model.session().lesson, m_model.session().step}];
}

bool MainWindow::isPredicting() {
  const LessonStep *step = currentStep();
  return step && step->prediction && !progress().chosen;
}

bool MainWindow::hidesNumbers() { return isPredicting() || m_practice->hasBlanks(); }

void MainWindow::showLesson() {
  for (int row = 0; row < m_lessonList->count(); ++row)
    if (m_lessonList->item(row)->data(Qt::UserRole).toString().toStdString() == m_model.session().lesson)
      m_lessonList->setCurrentRow(row);
  m_lessonPanel->setLesson(m_model.lesson());
  m_lessonPanel->setStep(m_model.session().step);
  m_lessonPanel->parentWidget()->setWindowTitle(QString::fromStdString(m_model.lesson().title));
  updateTitle();
}

void MainWindow::showOutcome() {
  const Outcome &shown = m_model.shownOutcome();
  const LessonStep *step = currentStep();
  m_practice->setStep(m_model.session().lesson, m_model.session().step, step ? step->blank : std::nullopt);
  m_practice->setWorking(shown.working, isPredicting());
  m_inspector->setResultsHidden(hidesNumbers());
  m_scene->setNumbersHidden(hidesNumbers());
  m_inspector->showSession();
  showStepWords();
  showCase();
}

void MainWindow::showStepWords() {
  const LessonStep *step = currentStep();
  if (!step)
    return m_lessonPanel->setMarkdown({});
  const Outcome &outcome = m_model.outcome();
  StepProgress &done = progress();
  done.tasks.observe(step->tasks, outcome);
  m_lessonPanel->setMarkdown(QString::fromStdString(
      withLiveValues(step->markdown, m_model.session().scene, hidesNumbers() ? Outcome() : outcome)));
  m_lessonPanel->setTasksDone(done.tasks.done());
  if (step->prediction)
    m_lessonPanel->setPredictionAnswer(done.chosen, done.right);
}

std::string MainWindow::rightAnswer(const Prediction &prediction) const {
  // Where the learner has changed so much that no choice fits, the question is about the start.
  for (const Outcome &outcome : {m_model.outcome(), evaluate(m_model.lesson().scene)})
    for (const Prediction::Choice &choice : prediction.choices)
      if (holds({prediction.value, Condition::Relation::Equal, choice.word}, outcome))
        return choice.word;
  return {};
}

void MainWindow::showCase() {
  const Outcome &outcome = m_model.outcome();
  if (isPredicting())
    m_caseLabel->setText(tr("Answer the question below first: the numbers are hidden until you do."));
  else if (m_practice->hasBlanks() && !outcome.degenerate)
    m_caseLabel->setText(
        tr("Fill in the blank lines of the working: other numbers are hidden until you do."));
  else
    m_caseLabel->setText(unbroken(QString::fromStdString(outcome.description)));
  if (m_caseLabel->property("degenerate") != outcome.degenerate) {
    m_caseLabel->setProperty("degenerate", outcome.degenerate);
    repolish(*m_caseLabel);
  }
  m_scene->setAccessibleDescription(m_caseLabel->text());
}

void MainWindow::highlight(const QString &markId) {
  std::set<std::string> marks;
  if (!markId.isEmpty())
    marks.insert(markId.toStdString());
  m_working->setHighlighted(marks);
  m_scene->setHighlighted(std::move(marks));
}

void MainWindow::updateTitle() {
  const QString name =
      m_file.isEmpty() ? QString::fromStdString(m_model.lesson().title) : QFileInfo(m_file).fileName();
  setWindowTitle(name + "[*] — Halfspace");
  setWindowModified(!m_model.history().isClean());
}

void MainWindow::setThemeNamed(const QString &name) {
  const Theme *theme = findTheme(name.toStdString());
  if (!theme)
    return;
  m_theme = *theme;
  applyStyle(*qApp, m_theme);
  m_scene->setTheme(m_theme);
  m_working->setTheme(m_theme);
  m_inspector->setTheme(m_theme);
  m_lessonPanel->setTheme(m_theme);
  m_working->setInkOf([this](const QString &markId) {
    const Mark *mark = findMark(m_model.outcome().figure, markId.toStdString());
    return toQColor(mark ? m_theme.inkOf(baseOf(*mark).subject) : m_theme.ink);
  });
}

void MainWindow::complain(const QString &sentence) { QMessageBox::warning(this, tr("Halfspace"), sentence); }

// --- files
// ---------------------------------------------------------------------------------------------------------

void MainWindow::startWith(const Session &session, const QString &file) {
  m_file = file;
  m_fileLesson = session.lesson;
  m_model.startWith(session);
  updateTitle();
}

void MainWindow::showFitting() {
  const QSize room = screen()->availableSize() - QSize(0, usualFrameHeight);
  if (width() > room.width() || height() > room.height())
    showMaximized();
  else
    show();
}

void MainWindow::restoreUnsaved() {
  const auto session = m_recovery.leftBehind();
  if (!session)
    return;
  m_model.startWith(*session);
  m_model.history().resetClean();
  updateTitle();
  statusBar()->showMessage(tr("Your work from last time is back. Edit > Start Over begins the lesson anew."),
                           messageTime);
}

void MainWindow::openFile(const QString &file) {
  const auto session = readSessionFile(file.toStdString());
  if (!session)
    return complain(QString::fromStdString(session.problem().text()));
  startWith(*session, file);
}

bool MainWindow::saveTo(const QString &file) {
  if (const auto problem = writeSessionFile(m_model.session(), file)) {
    complain(QString::fromStdString(problem->text()));
    return false;
  }
  m_file = file;
  m_fileLesson = m_model.session().lesson;
  m_model.history().setClean();
  m_recovery.forget();
  updateTitle();
  statusBar()->showMessage(tr("Saved."), messageTime);
  return true;
}

bool MainWindow::save() {
  // A file keeps its lesson: another one that was opened meanwhile asks for a file of its own.
  const bool belongs = !m_file.isEmpty() && m_model.session().lesson == m_fileLesson;
  return belongs ? saveTo(m_file) : saveAs();
}

QString MainWindow::askForFile(const QString &title, const QString &filter, const QString &suffix) {
  QFileDialog dialog(this, title, {}, filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  dialog.selectFile(QString::fromStdString(m_model.session().lesson) + "." + suffix);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

bool MainWindow::saveAs() {
  const QString file = askForFile(tr("Save session"), tr("Halfspace sessions (*.halfspace)"), "halfspace");
  return !file.isEmpty() && saveTo(file);
}

void MainWindow::open() {
  if (!askToKeepChanges())
    return;
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open session"), {}, tr("Halfspace sessions (*.halfspace)"));
  if (!file.isEmpty())
    openFile(file);
}

bool MainWindow::askToKeepChanges() {
  // What has no file comes back with the next start, without a question.
  if (m_file.isEmpty() || m_model.history().isClean())
    return true;
  const auto answer =
      QMessageBox::question(this, tr("Halfspace"), tr("Save your changes to this session first?"),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

std::optional<QImage> MainWindow::pictureOfScene(double scale) {
  PictureRequest request;
  request.content = m_scene->pictureContent();
  request.camera = m_scene->camera();
  request.theme = m_theme;
  const PixelSize size = m_scene->pixelSize();
  const double fitting = std::min(scale, double(maxPictureSide) / std::max(size.width, size.height));
  request.size = {static_cast<int>(size.width * fitting), static_cast<int>(size.height * fitting)};
  // The picture is drawn in a context of its own; two current ones in a thread clash.
  m_scene->doneCurrent();
  const auto picture = drawOffscreen(request, blockingLabelPainter(*m_typesetter));
  if (!picture) {
    complain(QString::fromStdString(picture.problem().text()));
    return {};
  }
  return QImage(picture->rgba.data(), picture->width, picture->height, picture->width * 4,
                QImage::Format_RGBA8888)
      .copy();
}

bool MainWindow::savePicture(const QString &file) {
  const auto image = pictureOfScene(pictureScale);
  if (!image)
    return false;
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly) || !image->save(&out, "PNG") || !out.commit()) {
    complain(tr("The picture could not be saved: %1.").arg(out.errorString()));
    return false;
  }
  statusBar()->showMessage(tr("Picture saved."), messageTime);
  return true;
}

void MainWindow::exportPicture() {
  const QString file = askForFile(tr("Save picture"), tr("PNG pictures (*.png)"), "png");
  if (!file.isEmpty())
    savePicture(file);
}

void MainWindow::copyPicture() {
  if (const auto image = pictureOfScene(pictureScale)) {
    QApplication::clipboard()->setImage(*image);
    statusBar()->showMessage(tr("Picture copied."), messageTime);
  }
}

// --- start and end
// -------------------------------------------------------------------------------------------------

void MainWindow::restoreSettings() {
  const QSettings settings;
  setThemeNamed(settings.value("theme", "light").toString());
  restoreGeometry(settings.value("geometry").toByteArray());
  restoreState(settings.value("docks").toByteArray());
}

void MainWindow::storeSettings() {
  QSettings settings;
  settings.setValue("theme", QString::fromStdString(m_theme.name));
  settings.setValue("geometry", saveGeometry());
  settings.setValue("docks", saveState());
}

void MainWindow::closeEvent(QCloseEvent *event) {
  if (!askToKeepChanges()) {
    event->ignore();
    return;
  }
  storeSettings();
  // What has no file comes back with the next start.
  if (m_file.isEmpty() && !m_model.history().isClean())
    m_recovery.keepNow(m_model.session());
  else
    m_recovery.forget();
  event->accept();
}

} // namespace halfspace
