#include "widgets/lesson/lesson_panel.h"

#include "widgets/colors.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {

namespace {

constexpr int margin = 16;
constexpr int columnGap = 28;
/// The title's size, in sizes of the words.
constexpr double titleSize = 1.3;
/// A panel at least so wide, in letters, has two columns.
constexpr int twoColumnLetters = 66;
constexpr QSize usualSize(420, 360);

void setInk(QWidget &widget, Color color) {
  QPalette palette = widget.palette();
  palette.setColor(QPalette::WindowText, toQColor(color));
  widget.setPalette(palette);
}

QLabel *makeTitle() {
  auto *label = new QLabel;
  label->setTextFormat(Qt::PlainText); // lesson files come from strangers
  label->setWordWrap(true);
  return label;
}

} // namespace

LessonPanel::LessonPanel(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter), m_theme(themes().front()) {
  setAutoFillBackground(true);
  auto *content = new QWidget;
  auto *page = new QVBoxLayout(content);
  page->setContentsMargins(margin, margin / 2, margin, margin / 2);
  page->setSpacing(4);
  makeHead(*page);
  m_words = new RichLabel(m_typesetter);
  m_columns = new QBoxLayout(QBoxLayout::TopToBottom);
  m_columns->setSpacing(14);
  m_columns->addWidget(m_words, 3, Qt::AlignTop);
  page->addLayout(m_columns);
  page->addStretch(1);

  m_scroll = new QScrollArea;
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->setWidgetResizable(true);
  m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_scroll->setWidget(content);
  m_scroll->viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);

  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_scroll, 1);
  makeFoot(*layout);
  setTheme(m_theme);
}

LessonPanel::~LessonPanel() { delete m_scroll; } // its words look at the typesetter

void LessonPanel::makeHead(QBoxLayout &layout) {
  m_stepTitle = makeTitle();
  layout.addWidget(m_stepTitle);
  layout.addSpacing(4);
}

void LessonPanel::makeFoot(QBoxLayout &layout) {
  m_back = new QPushButton(tr("Back"));
  m_next = new QPushButton(tr("Next"));
  m_dots = new StepDots;
  auto *foot = new QHBoxLayout;
  foot->setContentsMargins(margin, 6, margin, 8);
  foot->addWidget(m_back);
  foot->addStretch(1);
  foot->addWidget(m_dots);
  foot->addStretch(1);
  foot->addWidget(m_next);
  layout.addLayout(foot);
  connect(m_back, &QPushButton::clicked, this, [this] { emit stepRequested(m_step - 1); });
  connect(m_next, &QPushButton::clicked, this, [this] { emit stepRequested(m_step + 1); });
  connect(m_dots, &StepDots::clicked, this, &LessonPanel::stepRequested);
}

const LessonStep *LessonPanel::step() const {
  return m_lesson.steps.empty() ? nullptr : &m_lesson.steps[static_cast<std::size_t>(m_step)];
}

void LessonPanel::setLesson(const Lesson &lesson) {
  m_lesson = lesson;
  m_words->setMarkdown({}); // the same words may mean something else
  m_typesetter = m_typesetter.with(lesson.macros);
  QStringList titles;
  for (const LessonStep &step : lesson.steps)
    titles << QString::fromStdString(step.title);
  m_dots->setSteps(titles);
  setStep(0);
}

void LessonPanel::setStep(int step) {
  m_step = std::clamp(step, 0, std::max(0, stepCount() - 1));
  const LessonStep *current = this->step();
  m_stepTitle->setText(current ? QString::fromStdString(current->title) : QString());
  m_dots->setCurrent(m_step);
  // A button that is disabled would hand its focus to a number field, and the next key would change the
  // scene.
  if (m_next->hasFocus() || m_back->hasFocus())
    setFocus();
  m_back->setEnabled(m_step > 0);
  m_next->setEnabled(m_step + 1 < stepCount());
  makeExercises();
  m_scroll->verticalScrollBar()->setValue(0);
}

void LessonPanel::makeExercises() {
  if (m_exercises) { // later: a click on one of its buttons may have led here
    m_exercises->hide();
    m_columns->removeWidget(m_exercises);
    m_exercises->deleteLater();
    m_exercises = nullptr;
  }
  m_tasks.clear();
  m_prediction = nullptr;
  const LessonStep *current = step();
  if (!current || (current->tasks.empty() && !current->prediction))
    return;
  m_exercises = new QWidget;
  auto *layout = new QVBoxLayout(m_exercises);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (const Task &task : current->tasks) {
    m_tasks.push_back(new TaskRow(m_typesetter, QString::fromStdString(task.instruction)));
    m_tasks.back()->setTheme(m_theme);
    layout->addWidget(m_tasks.back());
  }
  if (current->prediction) {
    layout->addSpacing(current->tasks.empty() ? 0 : 10);
    m_prediction = new PredictionBox(m_typesetter, *current->prediction);
    m_prediction->setTheme(m_theme);
    connect(m_prediction, &PredictionBox::chosen, this, [this](const QString &word) {
      m_next->setFocus(); // the choices are disabled now
      emit predictionChosen(word);
      showReason();
    });
    layout->addWidget(m_prediction);
  }
  m_columns->addWidget(m_exercises, 2, Qt::AlignTop);
}

void LessonPanel::showReason() {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // it gets its place
  m_scroll->ensureWidgetVisible(m_prediction->reason(), 0, margin / 2);
}

void LessonPanel::setMarkdown(const QString &markdown) { m_words->setMarkdown(markdown); }

void LessonPanel::setTasksDone(const std::vector<bool> &done) {
  for (std::size_t i = 0; i < m_tasks.size(); ++i)
    m_tasks[i]->setDone(i < done.size() && done[i]);
}

void LessonPanel::setPredictionAnswer(const std::optional<std::string> &chosen, const std::string &right) {
  if (m_prediction)
    m_prediction->setAnswer(chosen, right);
}

void LessonPanel::setTheme(const Theme &theme) {
  m_theme = theme;
  QPalette background = palette();
  background.setColor(QPalette::Window, toQColor(theme.panel));
  setPalette(background);
  setInk(*m_stepTitle, theme.ink);
  QFont titleFont = font();
  titleFont.setPointSizeF(titleFont.pointSizeF() * titleSize);
  titleFont.setBold(true);
  m_stepTitle->setFont(titleFont);
  m_words->setInk(toQColor(theme.ink), toQColor(theme.warning));
  m_dots->setTheme(theme);
  for (TaskRow *task : m_tasks)
    task->setTheme(theme);
  if (m_prediction)
    m_prediction->setTheme(theme);
}

QSize LessonPanel::sizeHint() const { return usualSize; }

void LessonPanel::resizeEvent(QResizeEvent *event) {
  const bool wide = width() >= twoColumnLetters * fontMetrics().averageCharWidth();
  m_columns->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  m_columns->setSpacing(wide ? columnGap : 14);
  QWidget::resizeEvent(event);
}

} // namespace halfspace
