#include "app/main_window.h"

#include "app/check.h"
#include "app/lessons_folder.h"
#include "app/panels/scene_column.h"
#include "app/panels/unfinished_input.h"
#include "app/standard_streams.h"
#include "app/window_style.h"
#include "lessons/lesson/live_values.h"
#include "lessons/lesson/short_move.h"
#include "widgets/lesson/contents_drawer.h"
#include "widgets/lesson/lesson_page.h"
#include "widgets/mark_ink.h"
#include "widgets/numbers/inspector.h"
#include "widgets/text/unbroken.h"
#include "widgets/view/case_line.h"
#include "widgets/view/flat_view.h"
#include "widgets/view/scene_frame.h"
#include "widgets/working/working_practice.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QRandomGenerator>
#include <QScreen>
#include <QSplitter>
#include <QToolButton>

#include <algorithm>
#include <utility>

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
    : m_model(std::move(library)), m_progress(m_model, m_putAside), m_panels(*this, m_model),
      m_messages(m_panels.messages()), m_player(m_model),
      m_meshes(*this, [this] { return m_model.inGesture() && !m_player.state().isPlaying; }),
      m_input(m_panels.input()), m_scene(&m_panels.scene().view()), m_frame(&m_panels.scene().frame()),
      m_flat(&m_panels.scene().flat()), m_caseLine(&m_panels.scene().caseLine()),
      m_sceneColumn(&m_panels.scene()), m_practice(&m_panels.practice()), m_working(&m_practice->working()),
      m_page(&m_panels.page()), m_split(&m_panels.split()), m_numbersDock(&m_panels.numbersDock()),
      m_inspector(&m_panels.inspector()), m_contents(&m_panels.contents()), m_theme(themes().front()) {
  setObjectName("main");
  connectPanels();
  createMenus();
  createHeader();
  createSceneTools();

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
    m_shownAtStart.reset();
    m_page->setStep(m_model.session().step);
    m_scene->selectHandle({}); // its tools would stand in the next step's figure
    m_progress.ofStep().tasks.arrive();
    takeQuestion();
  });
  connect(&m_model, &SessionModel::outcomeChanged, this, &MainWindow::showOutcome);
  connect(&m_model, &SessionModel::gestureChanged, this, &MainWindow::followGesture);
  connect(&m_model.history(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
  connect(&m_model.history(), &QUndoStack::cleanChanged, this, &MainWindow::keepUnsavedSoon);
  connect(&m_model.history(), &QUndoStack::indexChanged, this, &MainWindow::keepUnsavedSoon);
  connect(&m_model, &SessionModel::outcomeChanged, this, &MainWindow::keepUnsavedSoon); // under the hand, too
  connect(&m_input, &UnfinishedInput::typing, this, &MainWindow::prepareUnsaved);
  connect(m_scene, &SceneView::markHovered, this, &MainWindow::hoverMark);
  connect(m_practice, &WorkingPractice::blanksChanged, this, &MainWindow::showOutcome);
  connect(m_practice, &WorkingPractice::newNumbersRequested, this, [this] {
    m_input.drop(); // it was about the numbers that go
    if (predictionOf(m_model.step()))
      reopenQuestion();                 // so was the answer
    m_progress.ofStep().tasks.arrive(); // other numbers are no deed of the learner
    m_model.renewNumbers(QRandomGenerator::global()->generate64());
    m_scene->showAnother();
  });
  connect(&m_watch, &LessonWatch::changed, this, &MainWindow::reloadLesson);
  restoreSettings();
  showLesson();
  takeQuestion();
  showOutcome();
}

MainWindow::~MainWindow() {
  // Nobody hears of the end of the history.
  m_model.disconnect();
  m_model.history().disconnect();
}

bool MainWindow::isPredicting() { return predictionOf(m_model.step()) && !m_progress.ofStep().chosen; }

bool MainWindow::hidesNumbers() { return isPredicting() || m_practice->hasBlanks(); }

void MainWindow::takeQuestion() { m_model.setQuestion(isPredicting() ? Question::Open : Question::Answered); }

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
  m_page->setLesson(m_model.lesson(), m_model.session().step);
  const Lesson *next = nextLesson();
  m_page->setNextLesson(next ? QString::fromStdString(next->title) : QString());
  showLessonTitle();
  updateTitle();
}

const Lesson *MainWindow::nextLesson() const {
  const std::vector<Lesson> &lessons = m_model.library().lessons;
  const auto shown = std::find_if(lessons.begin(), lessons.end(), [this](const Lesson &lesson) {
    return lesson.id == m_model.session().lesson;
  });
  return shown == lessons.end() || shown + 1 == lessons.end() ? nullptr : &*(shown + 1);
}

void MainWindow::openNextLesson() {
  if (const Lesson *next = nextLesson())
    m_model.openLesson(next->id);
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

void MainWindow::showOutcome() {
  m_practice->setStep(m_model.session().lesson, m_model.session().step, m_model.step().blank);
  // Which lines there are would tell what is asked: the open question has those of the lesson's own numbers.
  const Shown &lines = isPredicting() && m_model.isChanged() ? shownAtStart() : m_model.shown();
  m_practice->setWorking(lines.working, lines.linesIn, isPredicting());
  m_inspector->setResultsHidden(hidesNumbers());
  m_scene->setNumbersHidden(hidesNumbers());
  m_inspector->showSession();
  m_planeViews->setEnabled(showsPlane(m_model.figure()));
  m_alongCourse->setEnabled(firstCourse(m_model.shown().figure).has_value());
  showStepWords();
  showFlight();
  showCase();
}

void MainWindow::showStepWords() {
  const LiveValues shown = hidesNumbers() ? LiveValues::Hidden : LiveValues::Shown;
  m_page->showWords([&](const std::string &name) {
    return liveValue(name, m_model.session().scene, m_model.evaluation(), shown);
  });
  if (!m_model.inGesture()) // what is only passed in a drag does not count
    judgeStep();
}

void MainWindow::judgeStep() {
  const LessonStep &step = m_model.step();
  StepProgress &done = m_progress.ofStep();
  if (isPredicting()) { // whether a task holds would give the answer away
    m_page->setAnswer({});
    m_page->setTaskStates({});
    return;
  }
  done.tasks.observe(tasksOf(step), m_model.evaluation());
  m_page->setTaskStates(done.tasks.states());
  if (const Prediction *question = predictionOf(step))
    m_page->setAnswer(
        GivenAnswer{*done.chosen, done.right, rightChoice(*question, m_model.evaluation()) == done.right});
}

void MainWindow::followGesture() {
  m_page->setHeld(m_model.inGesture());
  if (m_model.inGesture())
    m_caseLine->endMessage();
  else
    judgeStep();
}

void MainWindow::showCase() {
  const Shown &shown = m_model.shown();
  QString words = unbroken(QString::fromStdString(shown.description));
  if (isPredicting())
    words = tr("Answer the question first: the numbers are hidden until you do.");
  else if (m_practice->hasBlanks())
    words = tr("Fill in the blank lines: other numbers are hidden until you do.");
  m_caseLine->setCase(words, shown.degenerate && !hidesNumbers());
  m_scene->setAccessibleDescription(words);
  m_caseLine->offerAfresh(!isPredicting() && lacksLines());
  showNearby();
}

void MainWindow::showNearby() {
  std::set<std::string> entries;
  for (const WorkingLine &line : m_model.shown().working.lines)
    entries.insert(entryOf(line.id));
  m_nearby = specialCasesNear(m_model.session().scene, m_model.evaluation(), entries);
  if (m_nearby.empty() || hidesNumbers())
    return m_caseLine->setNearby({}, {});
  std::vector<NearbyCase> cases;
  for (const NearSpecialCase &near : m_nearby)
    cases.push_back({unbroken(QString::fromStdString(near.sentence)), near.change.has_value()});
  const QString words = tr("Close by: %1").arg(cases.front().words);
  m_caseLine->setNearby(
      cases.front().canBeReached ? words : tr("%1 There, coordinates have roots.").arg(words), cases);
}

const Shown &MainWindow::shownAtStart() {
  if (!m_shownAtStart)
    m_shownAtStart = shownIn(m_model.step(), evaluate(m_model.lesson().scene));
  return *m_shownAtStart;
}

bool MainWindow::lacksLines() {
  // Unchanged, nothing is evaluated for it: neither when the window opens nor when a step is turned to.
  return m_model.isChanged() && m_model.shown().working.lines.size() < shownAtStart().working.lines.size();
}

void MainWindow::startOver() {
  m_input.drop(); // what was refused is gone too
  if (predictionOf(m_model.step()))
    reopenQuestion(); // the next group in class begins anew
  m_model.resetScene();
}

void MainWindow::goToNearby(int which) {
  const NearSpecialCase near = m_nearby.at(static_cast<std::size_t>(which));
  const Rational step = m_model.snapStep() * m_model.stage().unit();
  if (const QString refused =
          m_model.edit(shortMoveTo(near, m_model.session().scene, step), tr("Go to the special case"));
      !refused.isEmpty())
    m_messages.say(refused);
}

void MainWindow::choose(const QString &answer) {
  // Judged now: the learner may drag on afterwards.
  m_progress.ofStep().chosen = answer.toStdString();
  m_progress.ofStep().right = rightChoice(*predictionOf(m_model.step()), m_model.evaluation());
  keepUnsavedSoon();
  takeQuestion();
}

void MainWindow::reopenQuestion() {
  m_progress.ofStep().chosen.reset();
  keepUnsavedSoon();
  takeQuestion();
}

void MainWindow::hoverMark(const QString &markId) {
  m_hoveredMark = markId;
  showHoveredFragment();
  showHighlights();
}

void MainWindow::showHighlights() {
  std::set<std::string> marks = m_working->traced().marks;
  if (!m_hoveredMark.isEmpty())
    marks.insert(m_hoveredMark.toStdString());
  marks.insert(m_hoveredFragment.begin(), m_hoveredFragment.end());
  m_working->setHighlighted(marks);
  m_flat->setHighlighted(marks);
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
  m_panels.setLook(m_theme, sizeScale(), panels);
  m_contentsButton->setIcon(iconOf(ToolIcon::Contents, toQColor(panels.ink)));
  showPageLook();
  showLessonTitle();
  m_working->setInkOf(markInk(m_model, panels));
  m_larger->setEnabled(panels.textScale < largestSizeScale);
  m_smaller->setEnabled(m_sizeScale > smallestSizeScale);
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
  if (!restoreGeometry(settings.window))
    resize((usualSize * settings.sizeScale.value_or(usualSizeScale(*screen())))
               .boundedTo(screen()->availableSize()));
  setSizeScale(settings.sizeScale.value_or(usualSizeScale(*screen())));
  setThemeNamed(settings.theme);
  m_motion->setChecked(settings.motion);
  m_model.setSnapStep(settings.snapStep);
  m_model.setSnapping(settings.snapping);
  m_ownLessons = settings.ownLessons;
  m_flat->unfolded().setChecked(settings.flatPicture);
  restoreState(settings.panels);
  m_isSplitChosen = m_split->restoreState(settings.split);
  sharePage();
}

void MainWindow::putLook(Settings &settings) const {
  settings.theme = QString::fromStdString(m_theme.name);
  const bool suitsTheScreen = m_sizeScale == usualSizeScale(*screen()); // another screen may have another one
  settings.sizeScale = suitsTheScreen ? std::nullopt : std::optional(m_sizeScale);
}

void MainWindow::storeLook() {
  auto settings = readSettings(settingsFile());
  if (!settings)
    return; // it is put aside at the end, and written anew
  putLook(*settings);
  if (const auto problem = writeSettings(*settings, settingsFile()))
    printError(problem->text());
}

void MainWindow::storeSettings() {
  Settings settings;
  putLook(settings);
  settings.motion = m_motion->isChecked();
  settings.snapStep = m_model.snapStep();
  settings.snapping = m_model.isSnapping();
  settings.ownLessons = m_ownLessons;
  settings.flatPicture = m_flat->unfolded().isChecked();
  setFullScreen(false); // the next start is a window again
  settings.window = saveGeometry();
  settings.panels = saveState();
  if (m_isSplitChosen)
    settings.split = m_split->saveState();
  const auto stored = readSettings(settingsFile());
  auto problem = stored ? std::nullopt : m_putAside.add(stored.problem());
  if (!problem)
    problem = writeSettings(settings, settingsFile());
  // The window is on its way out: there is nowhere else to say it.
  if (problem)
    printError(problem->text());
}

} // namespace halfspace
