#include "app/main_window.h"

#include "app/standard_streams.h"
#include "app/window_style.h"
#include "widgets/lesson/lesson_panel.h"
#include "widgets/mark_ink.h"
#include "widgets/numbers/inspector.h"
#include "widgets/repolish.h"
#include "widgets/text/unbroken.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"
#include "widgets/working/working_practice.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QRandomGenerator>
#include <QScreen>
#include <QStatusBar>

#include <algorithm>

namespace halfspace {
namespace {

// In milliseconds.
/// Unsaved work is kept so long after a change.
constexpr int keepDelay = 800;
/// Whoever lives so long after the first picture of a session has not ended for it.
constexpr int openedDelay = 1500;

constexpr QSize usualSize(1280, 800);
constexpr int usualFrameHeight = 40;

} // namespace

MainWindow::MainWindow(LessonLibrary library)
    : m_model(std::move(library)), m_editor(m_model), m_typesetter(std::make_unique<Typesetter>()),
      m_theme(themes().front()) {
  setObjectName("main");
  m_scene = new SceneView(m_model, labelPainter(*m_typesetter));
  createPanels();
  createMenus();
  m_unkept = new QLabel;
  m_unkept->setObjectName("complaint");
  m_unkept->setTextFormat(Qt::PlainText);
  m_unkept->hide();
  statusBar()->addPermanentWidget(m_unkept);

  for (QTimer *timer : {&m_keepTimer, &m_openedTimer})
    timer->setSingleShot(true);
  m_keepTimer.setInterval(keepDelay);
  m_openedTimer.setInterval(openedDelay);
  connect(&m_keepTimer, &QTimer::timeout, this, [this] {
    if (m_model.inGesture())
      keepUnsavedSoon();
    else
      keepOrForget();
  });
  connect(&m_openedTimer, &QTimer::timeout, this, [this] { m_recovery.opened(); });
  connect(&m_model, &SessionModel::lessonChanged, this, &MainWindow::showLesson);
  connect(&m_model, &SessionModel::stepChanged, this, [this] {
    m_lessonPanel->setStep(m_model.session().step);
    progress().tasks.arrive();
  });
  connect(&m_model, &SessionModel::outcomeChanged, this, &MainWindow::showOutcome);
  connect(&m_model.history(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
  connect(&m_model.history(), &QUndoStack::cleanChanged, this, &MainWindow::keepUnsavedSoon);
  connect(&m_model.history(), &QUndoStack::indexChanged, this, &MainWindow::keepUnsavedSoon);
  connect(m_scene, &SceneView::markHovered, this, &MainWindow::hoverMark);
  connect(m_practice, &WorkingPractice::blanksChanged, this, &MainWindow::showOutcome);
  connect(m_practice, &WorkingPractice::newNumbersRequested, this, [this] {
    m_working->dropTyped(); // it was about the numbers that go
    m_inspector->dropTyped();
    m_model.renewNumbers(QRandomGenerator::global()->generate64());
  });
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

const LessonStep *MainWindow::currentStep() const {
  const auto step = static_cast<std::size_t>(m_model.session().step);
  return step < m_model.lesson().steps.size() ? &m_model.lesson().steps[step] : nullptr;
}

StepProgress &MainWindow::progress() {
  return m_progress[{m_model.session().lesson, m_model.session().step}];
}

bool MainWindow::isPredicting() {
  const LessonStep *step = currentStep();
  return step && step->prediction && !progress().chosen;
}

bool MainWindow::hidesNumbers() { return isPredicting() || m_practice->hasBlanks(); }

void MainWindow::showLesson() {
  m_lessonList->setCurrentItem(nullptr); // a file may name a lesson that is not there
  for (int row = 0; row < m_lessonList->count(); ++row)
    if (m_lessonList->item(row)->data(Qt::UserRole).toString().toStdString() == m_model.session().lesson)
      m_lessonList->setCurrentRow(row);
  m_lessonPanel->setLesson(m_model.lesson());
  m_lessonPanel->setStep(m_model.session().step);
  m_lessonPanel->parentWidget()->setWindowTitle(QString::fromStdString(m_model.lesson().title));
  updateTitle();
}

void MainWindow::showOutcome() {
  const LessonStep *step = currentStep();
  m_practice->setStep(m_model.session().lesson, m_model.session().step, step ? step->blank : std::nullopt);
  m_practice->setWorking(m_model.shown().working, isPredicting());
  m_inspector->setResultsHidden(hidesNumbers());
  m_scene->setNumbersHidden(hidesNumbers());
  m_inspector->showSession();
  m_downRay->setEnabled(firstRay(m_model.session().scene).has_value());
  showStepWords();
  showCase();
}

void MainWindow::showStepWords() {
  const LessonStep *step = currentStep();
  if (!step)
    return m_lessonPanel->setMarkdown({});
  static const Evaluation nothing;
  const Evaluation &evaluation = m_model.evaluation();
  StepProgress &done = progress();
  done.tasks.observe(step->tasks, evaluation);
  m_lessonPanel->setMarkdown(QString::fromStdString(
      withLiveValues(step->markdown, m_model.session().scene, hidesNumbers() ? nothing : evaluation)));
  m_lessonPanel->setTasksDone(done.tasks.done());
  if (step->prediction)
    m_lessonPanel->setPredictionAnswer(done.chosen, done.right);
}

std::string MainWindow::rightAnswer(const Prediction &prediction) const {
  // Where the learner has changed so much that no choice fits, the question is about the start.
  for (const Evaluation &evaluation : {m_model.evaluation(), evaluate(m_model.lesson().scene)})
    for (const Prediction::Choice &choice : prediction.choices)
      if (holds({prediction.value, Condition::Relation::Equal, choice.word}, evaluation))
        return choice.word;
  return {};
}

void MainWindow::showCase() {
  const Shown &shown = m_model.shown();
  if (isPredicting())
    m_caseLabel->setText(tr("Answer the question below first: the numbers are hidden until you do."));
  else if (m_practice->hasBlanks() && !shown.degenerate)
    m_caseLabel->setText(
        tr("Fill in the blank lines of the working: other numbers are hidden until you do."));
  else
    m_caseLabel->setText(unbroken(QString::fromStdString(shown.description)));
  if (m_caseLabel->property("degenerate") != shown.degenerate) {
    m_caseLabel->setProperty("degenerate", shown.degenerate);
    repolish(*m_caseLabel);
  }
  // In a drag the label only grows: the picture above it would jump back and forth with the numbers.
  m_caseLabel->setMinimumHeight(m_model.inGesture() ? m_caseLabel->height() : 0);
  m_scene->setAccessibleDescription(m_caseLabel->text());
}

void MainWindow::choose(const QString &answer) {
  // Judged now: the learner may drag on afterwards.
  progress().chosen = answer.toStdString();
  progress().right = rightAnswer(*currentStep()->prediction);
  keepUnsavedSoon();
  showOutcome();
}

void MainWindow::hoverMark(const QString &markId) {
  m_hoveredMark = markId;
  showHighlights();
}

void MainWindow::showHighlights() {
  std::set<std::string> marks = m_working->traced().marks;
  if (!m_hoveredMark.isEmpty())
    marks.insert(m_hoveredMark.toStdString());
  m_working->setHighlighted(marks);
  m_scene->setHighlighted(std::move(marks));
}

void MainWindow::updateTitle() {
  const QString name =
      m_file ? QFileInfo(m_file->path).fileName() : QString::fromStdString(m_model.lesson().title);
  setWindowTitle(name + "[*] — Halfspace");
  setWindowModified(!m_model.history().isClean());
}

void MainWindow::setThemeNamed(const QString &name) {
  const Theme *theme = findTheme(name.toStdString());
  if (!theme)
    return;
  m_theme = *theme;
  applyLook();
}

double MainWindow::sizeScale() const { return std::min(m_sizeScale, largestSizeScale / m_theme.textScale); }

void MainWindow::setSizeScale(double scale) {
  m_sizeScale = std::clamp(scale, smallestSizeScale, largestSizeScale);
  applyLook();
}

void MainWindow::applyLook() {
  Theme panels = m_theme;
  panels.textScale *= sizeScale();
  applyStyle(*qApp, panels);
  m_scene->setTheme(m_theme);
  m_scene->setSizeScale(sizeScale());
  m_working->setTheme(panels);
  m_inspector->setTheme(panels);
  m_lessonPanel->setTheme(panels);
  m_working->setInkOf(markInk(m_model, panels));
  m_larger->setEnabled(panels.textScale < largestSizeScale);
  m_smaller->setEnabled(m_sizeScale > smallestSizeScale);
}

void MainWindow::showFitting() {
  const QSize room = screen()->availableSize() - QSize(0, usualFrameHeight);
  if (width() > room.width() || height() > room.height())
    showMaximized();
  else
    show();
}

void MainWindow::complain(const QString &sentence) {
  QMessageBox box(QMessageBox::Warning, tr("Halfspace"), sentence, QMessageBox::Ok, this);
  box.setTextFormat(Qt::PlainText); // it may quote a stranger's file
  box.exec();
}

void MainWindow::say(const QString &sentence) {
  constexpr int readingTime = 8000; // milliseconds
  statusBar()->showMessage(sentence, readingTime);
}

void MainWindow::restoreSettings() {
  const auto stored = readSettings(settingsFile());
  if (!stored)
    statusBar()->showMessage(QString::fromStdString(stored.problem().text()));
  const Settings settings = stored ? *stored : Settings();
  setSizeScale(settings.sizeScale.value_or(usualSizeScale(*screen())));
  setThemeNamed(settings.theme);
  m_motion->setChecked(settings.motion);
  m_practice->setUsual(settings.blank);
  if (!restoreGeometry(settings.window))
    resize((usualSize * sizeScale()).boundedTo(screen()->availableSize()));
  if (!restoreState(settings.panels))
    arrangePanels();
}

void MainWindow::storeSettings() {
  Settings settings;
  settings.theme = QString::fromStdString(m_theme.name);
  settings.motion = m_motion->isChecked();
  settings.blank = m_practice->usual();
  if (m_sizeScale != usualSizeScale(*screen())) // another screen may have another usual one
    settings.sizeScale = m_sizeScale;
  settings.window = saveGeometry();
  settings.panels = saveState();
  // The window is on its way out: there is nowhere else to say it.
  if (const auto problem = writeSettings(settings, settingsFile()))
    printError(problem->text());
}

} // namespace halfspace
