#include "widgets/lesson/lesson_page.h"

#include "widgets/colors.h"
#include "widgets/flow_layout.h"
#include "widgets/lesson/note_fold.h"
#include "widgets/working/working_practice.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>
#include <utility>

namespace halfspace {

namespace {

// In pixels, at the usual size of text.
constexpr QSize smallestButton(64, 24);
constexpr int margin = 20;
constexpr int footMargin = 10;
constexpr int blockGap = 10;
constexpr int headGap = 4;
constexpr int headSpacing = 6;
constexpr QSize usualSize(430, 600);
/// The title's size, in sizes of the words.
constexpr double titleSize = 1.4;
/// A line of words has at most so many letters: longer ones are hard to follow.
constexpr int mostLettersInLine = 78;

/// Empty for a lesson of no file, and where the working folder that its path begins in is gone.
std::filesystem::path folderOf(const Lesson &lesson) {
  std::error_code error;
  return lesson.file.empty() ? std::filesystem::path()
                             : std::filesystem::absolute(lesson.file, error).parent_path();
}

void setInk(QWidget &widget, Color color) {
  QPalette palette = widget.palette();
  palette.setColor(QPalette::WindowText, toQColor(color));
  widget.setPalette(palette);
}

QLabel *plainLabel() {
  auto *label = new QLabel;
  label->setTextFormat(Qt::PlainText); // lesson files come from strangers
  return label;
}

} // namespace

LessonPage::LessonPage(const Typesetter &typesetter, WorkingPractice &practice, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter), m_theme(themes().front()), m_practice(practice) {
  setAutoFillBackground(true);
  auto *content = new QWidget;
  m_page = new QVBoxLayout(content);
  makeHead(*m_page, practice);
  m_blocks = new QWidget;
  m_page->addWidget(m_blocks);
  m_page->addStretch(1);

  m_scroll = new QScrollArea;
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->setWidgetResizable(true);
  m_scroll->setWidget(content);
  m_scroll->viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);

  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_scroll, 1);
  makeFoot(*layout);
  connect(m_scroll->verticalScrollBar(), &QScrollBar::rangeChanged, this, &LessonPage::setMargins);
  connect(&practice.working(), &StepWorking::reached, this, [this](WorkingBlock *block, const QRect &place) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // it may just have become higher
    const QRect there(block->mapTo(m_scroll->widget(), place.topLeft()), place.size());
    m_scroll->ensureVisible(there.center().x(), there.center().y(), 0, there.height() / 2);
  });
  setTheme(m_theme);
}

// The words look at the typesetter, and the plots at the job of m_flight.
LessonPage::~LessonPage() { delete m_scroll; }

void LessonPage::makeHead(QBoxLayout &layout, WorkingPractice &practice) {
  m_stepNumber = plainLabel();
  m_stepTitle = plainLabel();
  m_stepTitle->setWordWrap(true);
  auto *above = new FlowLayout;
  m_above = above;
  above->addWidget(m_stepNumber);
  above->addWidget(&practice);
  m_head = new QVBoxLayout;
  m_head->addLayout(above);
  m_head->addWidget(m_stepTitle);
  layout.addLayout(m_head);
}

void LessonPage::makeFoot(QBoxLayout &layout) {
  m_back = new QPushButton(tr("Back"));
  m_next = new QPushButton(tr("Next"));
  m_next->setObjectName("next");
  m_dots = new StepDots;
  auto *foot = new QHBoxLayout;
  m_foot = foot;
  // No margins: in a page that becomes narrower these may, too.
  for (QSpacerItem *&side : m_footSides)
    side = new QSpacerItem(0, 0, QSizePolicy::Preferred);
  foot->addItem(m_footSides.front());
  foot->addWidget(m_back);
  foot->addStretch(1);
  foot->addWidget(m_dots);
  foot->addStretch(1);
  foot->addWidget(m_next);
  foot->addItem(m_footSides.back());
  layout.addLayout(foot);
  connect(m_back, &QPushButton::clicked, this, [this] { emit stepRequested(m_step - 1); });
  connect(m_next, &QPushButton::clicked, this, &LessonPage::goOn);
  connect(m_dots, &StepDots::clicked, this, &LessonPage::stepRequested);
}

void LessonPage::setLesson(const Lesson &lesson, int step) {
  m_lesson = lesson;
  m_typesetter = m_typesetter.with(lesson.macros);
  QStringList titles;
  for (const LessonStep &each : lesson.steps)
    titles << QString::fromStdString(each.title);
  m_dots->setSteps(titles);
  m_step = std::clamp(step, 0, lastStep());
  showStep();
}

void LessonPage::setStep(int step) {
  if (std::exchange(m_step, std::clamp(step, 0, lastStep())) != m_step)
    showStep();
}

void LessonPage::showStep() {
  m_stepNumber->setText(stepCount() > 0 ? tr("Step %1/%2").arg(m_step + 1).arg(stepCount()) : QString());
  m_stepTitle->setText(QString::fromStdString(stepOf(m_lesson, m_step).title));
  m_dots->setCurrent(m_step);
  // What is disabled or goes would hand its focus to a number field, and the next key would change the scene.
  if (isAncestorOf(QApplication::focusWidget()))
    setFocus();
  m_back->setEnabled(m_step > 0);
  showNextButton();
  makeBlocks();
  m_scroll->verticalScrollBar()->setValue(0);
}

void LessonPage::setNextLesson(const QString &title) {
  m_nextLesson = title;
  showNextButton();
}

void LessonPage::showNextButton() {
  const bool isLast = m_step + 1 >= stepCount();
  const bool endsLesson = isLast && !m_nextLesson.isEmpty();
  m_next->setText(endsLesson ? tr("Next lesson") : tr("Next"));
  m_next->setToolTip(endsLesson ? m_nextLesson : QString());
  m_next->setEnabled(!isLast || endsLesson);
  keepButtonsWhole();
}

void LessonPage::keepButtonsWhole() {
  for (QPushButton *button : {m_back, m_next})
    button->setMinimumSize((smallestButton * m_theme.textScale).expandedTo({button->sizeHint().width(), 0}));
}

void LessonPage::goOn() {
  if (m_step + 1 < stepCount())
    emit stepRequested(m_step + 1);
  else
    emit nextLessonRequested();
}

void LessonPage::makeBlocks() {
  m_practice.working().dropBlocks();
  m_pictures = {folderOf(m_lesson)};
  m_words.clear();
  m_notes.clear();
  m_tasks.clear();
  m_dueTask = nullptr;
  m_flight.dropBlocks();
  m_prediction = nullptr;
  auto *blocks = new QWidget;
  auto *column = new QVBoxLayout(blocks);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(scaled(blockGap));
  for (const StepBlock &block : stepOf(m_lesson, m_step).blocks)
    column->addWidget(std::visit([this](const auto &each) { return blockOf(each); }, block));
  delete m_page->replaceWidget(m_blocks, blocks);
  m_blocks->hide();
  m_blocks->deleteLater(); // a click on one of its buttons may have led here
  m_blocks = blocks;
  setTheme(m_theme);
}

QWidget *LessonPage::blockOf(const StepWords &words) {
  auto *label = new RichLabel(m_typesetter);
  add(words, *label);
  return label;
}

QWidget *LessonPage::blockOf(const StepLines &) { return m_practice.working().addBlock(); }

QWidget *LessonPage::blockOf(const StepNote &note) {
  m_notes.push_back(new NoteFold(m_typesetter, QString::fromStdString(note.title)));
  add(note.words, m_notes.back()->words());
  connect(m_notes.back(), &NoteFold::opened, this, [this, fold = m_notes.back()] { scrollTo(*fold); });
  return m_notes.back();
}

QWidget *LessonPage::blockOf(const Task &task) {
  m_tasks.push_back(
      {readWords(task.instruction), readWords(task.now), readWords(task.answer), new TaskRow(m_typesetter)});
  return m_tasks.back().row;
}

QWidget *LessonPage::blockOf(const Prediction &prediction) {
  m_prediction = new PredictionBox(m_typesetter, prediction);
  connect(m_prediction, &PredictionBox::chosen, this, [this](const QString &word) {
    // The choices are disabled now: the next widget that takes keys may be a number.
    if (m_next->isEnabled())
      m_next->setFocus();
    else
      setFocus();
    emit predictionChosen(word);
    scrollTo(*m_prediction->reason());
  });
  connect(m_prediction, &PredictionBox::reopened, this, [this] {
    emit predictionReopened();
    m_prediction->choices().front()->setFocus();
  });
  return m_prediction;
}

void LessonPage::add(const StepWords &words, RichLabel &label) {
  m_words.push_back({readWords(words.markdown), &label});
  label.setPictures(m_pictures);
}

void LessonPage::scrollTo(const QWidget &part) {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // it gets its place
  const QRect place(part.mapTo(m_scroll->widget(), QPoint()), part.size());
  m_scroll->ensureVisible(0, place.bottom(), 0, margin);
  m_scroll->ensureVisible(0, place.top(), 0, 0); // of what is higher than the page the beginning
}

void LessonPage::showWords(const LiveValueOf &valueOf) {
  for (const auto &[words, label] : m_words)
    label->setWords(filledIn(words, valueOf));
  for (const auto &[instruction, now, answer, row] : m_tasks)
    row->setWords(filledIn(instruction, valueOf), filledIn(now, valueOf), filledIn(answer, valueOf));
  // What needs another place has it before it is seen.
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
}

void LessonPage::setHeld(bool held) {
  m_flight.setHeld(held);
  for (const SetWords &words : m_words)
    words.label->setHeld(held);
  for (const SetTask &task : m_tasks)
    task.row->setHeld(held);
  m_practice.working().setHeld(held);
}

void LessonPage::setTaskStates(const std::vector<TaskState> &states) {
  for (std::size_t i = 0; i < m_tasks.size(); ++i)
    m_tasks[i].row->setState(i < states.size() ? states[i] : TaskState::Open);
  const auto due = std::find_if(m_tasks.begin(), m_tasks.end(), [](const SetTask &task) {
    return task.row->state() == TaskState::Open || task.row->state() == TaskState::HoldsAlready;
  });
  const TaskRow *now = states.empty() || due == m_tasks.end() ? nullptr : due->row;
  const TaskRow *before = std::exchange(m_dueTask, now);
  if (states.empty() || !before || before == now)
    return;
  scrollTo(*before); // its answer
  if (now)
    scrollTo(*now);
}

void LessonPage::setAnswer(const std::optional<GivenAnswer> &answer) {
  if (m_prediction)
    m_prediction->setAnswer(answer);
}

void LessonPage::setTheme(const Theme &theme) {
  m_theme = theme;
  QPalette background = palette();
  background.setColor(QPalette::Window, toQColor(theme.panel));
  setPalette(background);
  setGaps();
  setInk(*m_stepNumber, theme.mutedInk);
  setInk(*m_stepTitle, theme.ink);
  QFont titleFont = font();
  titleFont.setPointSizeF(titleFont.pointSizeF() * titleSize);
  titleFont.setBold(true);
  m_stepTitle->setFont(titleFont);
  m_dots->setTheme(theme);
  for (const SetWords &words : m_words)
    words.label->setInk(theme.ink, theme);
  for (NoteFold *note : m_notes)
    note->setTheme(theme);
  for (const SetTask &task : m_tasks)
    task.row->setTheme(theme);
  m_flight.setTheme(theme);
  if (m_prediction)
    m_prediction->setTheme(theme);
}

QSize LessonPage::sizeHint() const { return usualSize; }

int LessonPage::longestLine(const QFontMetrics &type) { return mostLettersInLine * type.averageCharWidth(); }

void LessonPage::resizeEvent(QResizeEvent *event) {
  setMargins();
  QWidget::resizeEvent(event);
}

int LessonPage::scaled(int pixels) const { return qRound(pixels * m_theme.textScale); }

void LessonPage::setGaps() {
  m_page->setSpacing(scaled(blockGap));
  if (QLayout *column = m_blocks->layout())
    column->setSpacing(scaled(blockGap));
  m_above->setSpacing(scaled(headSpacing));
  m_head->setSpacing(scaled(headGap));
  keepButtonsWhole();
  setMargins();
}

void LessonPage::setMargins() {
  const QScrollBar &bar = *m_scroll->verticalScrollBar();
  const int besideLines = (width() - longestLine(fontMetrics())) / 2;
  const int side = std::max({scaled(margin), bar.sizeHint().width(), besideLines});
  // The scroll bar stands in the margin: no line breaks anew because it comes or goes.
  const int right = side - (bar.maximum() > 0 ? bar.sizeHint().width() : 0);
  m_page->setContentsMargins(side, scaled(margin) / 2, right, scaled(margin) / 2);
  m_foot->setContentsMargins(scaled(margin), scaled(footMargin), scaled(margin), scaled(footMargin));
  for (QSpacerItem *room : m_footSides)
    room->changeSize(std::max(besideLines - scaled(margin), 0), 0, QSizePolicy::Preferred);
  m_foot->invalidate();
}

} // namespace halfspace
