#include "widgets/lesson/step_blocks.h"

#include "widgets/lesson/note_fold.h"
#include "widgets/working/step_working.h"
#include "widgets/would_be_seen.h"

#include <QCoreApplication>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace halfspace {

StepBlocks::StepBlocks(const Typesetter &typesetter, const LessonStep &step, LessonPictures pictures,
                       StepWorking &working, FlightBlocks &flight)
    : m_typesetter(typesetter), m_pictures(std::move(pictures)), m_working(working), m_flight(flight) {
  working.dropBlocks();
  flight.dropBlocks();
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  for (const StepBlock &block : step.blocks)
    column->addWidget(std::visit([this](const auto &each) { return blockOf(each); }, block));
}

QWidget *StepBlocks::blockOf(const StepWords &words) {
  auto *label = new RichLabel(m_typesetter);
  add(words, *label);
  return label;
}

QWidget *StepBlocks::blockOf(const StepLines &) { return m_working.addBlock(); }

QWidget *StepBlocks::blockOf(const StepNote &note) {
  auto *fold = new NoteFold(m_typesetter, QString::fromStdString(note.title));
  m_notes.push_back(fold);
  add(note.words, fold->words());
  connect(fold, &NoteFold::opened, this, [this, fold] {
    setWords();
    emit reached(fold);
  });
  return fold;
}

QWidget *StepBlocks::blockOf(const Task &task) {
  m_tasks.push_back({task.instruction, task.now, task.answer, new TaskRow(m_typesetter)});
  return m_tasks.back().row;
}

QWidget *StepBlocks::blockOf(const Prediction &prediction) {
  m_prediction = new PredictionBox(m_typesetter, prediction);
  connect(m_prediction, &PredictionBox::chosen, this, [this](const QString &word) {
    emit predictionChosen(word);
    emit reached(m_prediction->reason());
  });
  connect(m_prediction, &PredictionBox::reopened, this, [this] {
    emit predictionReopened();
    m_prediction->choices().front()->setFocus();
  });
  return m_prediction;
}

void StepBlocks::add(const StepWords &words, RichLabel &label) {
  m_words.push_back({words.text, &label});
  label.setPictures(m_pictures);
}

void StepBlocks::showWords(LiveValueOf valueOf) {
  m_valueOf = std::move(valueOf);
  setWords();
  // What needs another place has it before it is seen.
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
}

void StepBlocks::setWords() {
  if (!m_valueOf)
    return;
  for (const auto &[words, label] : m_words)
    if (wouldBeSeen(*label))
      label->setWords(filledIn(words.markdown(), m_valueOf));
  for (const auto &[instruction, now, answer, row] : m_tasks)
    if (wouldBeSeen(*row))
      row->setWords(filledIn(instruction.markdown(), m_valueOf), filledWhenSeen(now), filledWhenSeen(answer));
}

Lazy<FilledMarkdown> StepBlocks::filledWhenSeen(const MarkdownText &words) const {
  return Lazy<FilledMarkdown>([this, words] { return filledIn(words.markdown(), m_valueOf); });
}

void StepBlocks::showEvent(QShowEvent *event) {
  setWords();
  QWidget::showEvent(event);
}

void StepBlocks::setTaskStates(const std::vector<TaskState> &states) {
  for (std::size_t i = 0; i < m_tasks.size(); ++i)
    m_tasks[i].row->setState(i < states.size() ? states[i] : TaskState::Open);
  const auto due = std::find_if(m_tasks.begin(), m_tasks.end(), [](const SetTask &task) {
    return task.row->state() == TaskState::Open || task.row->state() == TaskState::HoldsAlready;
  });
  const TaskRow *now = states.empty() || due == m_tasks.end() ? nullptr : due->row;
  const TaskRow *before = std::exchange(m_dueTask, now);
  if (states.empty() || !before || before == now)
    return;
  emit reached(before); // its answer
  if (now)
    emit reached(now);
}

void StepBlocks::setAnswer(const std::optional<GivenAnswer> &answer) {
  if (m_prediction)
    m_prediction->setAnswer(answer);
}

void StepBlocks::setHeld(bool held) {
  m_flight.setHeld(held);
  for (const SetWords &words : m_words)
    words.label->setHeld(held);
  for (const SetTask &task : m_tasks)
    task.row->setHeld(held);
  m_working.setHeld(held);
}

void StepBlocks::setTheme(const Theme &theme) {
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

} // namespace halfspace
