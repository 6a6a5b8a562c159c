#include "widgets/lesson/step_blocks.h"

#include "lessons/lesson/term_links.h"
#include "widgets/lesson/note_fold.h"
#include "widgets/working/step_working.h"

#include <QApplication>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace halfspace {

StepBlocks::StepBlocks(const Typesetter &typesetter, const LessonStep &step, const Glossary &glossary,
                       LessonPictures pictures, StepWorking &working, FlightBlocks &flight)
    : m_typesetter(typesetter), m_pictures(std::move(pictures)), m_working(working), m_flight(flight) {
  working.dropBlocks();
  flight.dropBlocks();
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  TermLinks links(glossary, step);
  const Overloaded makeBlock{[&](const StepWords &words) { return blockOf(words, links); },
                             [this](const auto &each) { return blockOf(each); }};
  for (const StepBlock &block : step.blocks) {
    if (m_prediction && !m_behindQuestion)
      column = columnBehindQuestion(*column);
    column->addWidget(std::visit(makeBlock, block));
  }
}

void StepBlocks::setGap(int gap) {
  layout()->setSpacing(gap);
  if (m_behindQuestion)
    m_behindQuestion->layout()->setSpacing(gap);
}

QVBoxLayout *StepBlocks::columnBehindQuestion(QVBoxLayout &column) {
  m_behindQuestion = new QWidget;
  m_behindQuestion->hide();
  column.addWidget(m_behindQuestion);
  auto *behind = new QVBoxLayout(m_behindQuestion);
  behind->setContentsMargins(0, 0, 0, 0);
  return behind;
}

QWidget *StepBlocks::blockOf(const StepWords &words, TermLinks &links) {
  auto *label = new RichLabel(m_typesetter);
  Markdown linked = words.text.markdown();
  links.addTo(linked);
  add(std::move(linked), *label);
  return label;
}

QWidget *StepBlocks::blockOf(const StepLines &) { return m_working.addBlock(); }

QWidget *StepBlocks::blockOf(const StepNote &note) {
  auto *fold = new NoteFold(m_typesetter, QString::fromStdString(note.title));
  m_notes.push_back(fold);
  add(note.words.text.markdown(), fold->words());
  connect(fold, &NoteFold::opened, this, [this, fold] { emit reached(fold); });
  return fold;
}

QWidget *StepBlocks::blockOf(const Task &task) {
  auto *row = new TaskRow(m_typesetter);
  m_tasks.push_back(row);
  connect(row, &TaskRow::hintTold, this, [this, row] { emit reached(row); });
  const auto fill = [this, row, task] {
    row->setWords(filledIn(task.instruction.markdown(), m_valueOf), filledWhenSeen(task.now),
                  filledWhenSeen(task.answer));
    std::vector<Lazy<FilledMarkdown>> hints;
    for (const Task::Hint &hint : task.hints)
      hints.push_back(filledWhenSeen(hint.text));
    row->setHints(std::move(hints));
  };
  m_filled.push_back({std::make_unique<WhenSeen>(*row, fill), true}); // the lazy parts of most are
  return row;
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

void StepBlocks::add(Markdown words, RichLabel &label) {
  label.setPictures(m_pictures);
  m_labels.push_back(&label);
  const bool areLive = hasLiveValues(words);
  const auto fill = [this, &label, words = std::move(words)] { label.setWords(filledIn(words, m_valueOf)); };
  m_filled.push_back({std::make_unique<WhenSeen>(label, fill), areLive});
}

void StepBlocks::showWords(LiveValueOf valueOf) {
  const bool areFirst = !m_valueOf;
  m_valueOf = std::move(valueOf);
  for (const auto &[words, areLive] : m_filled)
    if (areFirst || areLive)
      words->renew();
  // What needs another place has it before it is seen.
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
}

Lazy<FilledMarkdown> StepBlocks::filledWhenSeen(const MarkdownText &words) const {
  return Lazy<FilledMarkdown>([this, words] { return filledIn(words.markdown(), m_valueOf); });
}

void StepBlocks::setTaskStates(const std::vector<TaskState> &states) {
  for (std::size_t i = 0; i < m_tasks.size(); ++i)
    m_tasks[i]->setState(i < states.size() ? states[i] : TaskState::Open);
  const auto due =
      std::find_if(m_tasks.begin(), m_tasks.end(), [](const TaskRow *task) { return task->isDue(); });
  const TaskRow *now = states.empty() || due == m_tasks.end() ? nullptr : *due;
  const TaskRow *before = std::exchange(m_dueTask, now);
  if (states.empty() || !before || before == now)
    return;
  emit reached(before); // its answer
  if (now)
    emit reached(now);
}

void StepBlocks::setAnswer(const std::optional<GivenAnswer> &answer) {
  if (!m_prediction)
    return;
  m_prediction->setAnswer(answer);
  if (!m_behindQuestion)
    return;
  if (!answer && m_behindQuestion->isAncestorOf(QApplication::focusWidget()))
    setFocus(); // what goes would hand it to a number field
  m_behindQuestion->setVisible(answer.has_value());
}

void StepBlocks::setHeld(bool held) {
  m_flight.setHeld(held);
  for (RichLabel *label : m_labels)
    label->setHeld(held);
  for (TaskRow *task : m_tasks)
    task->setHeld(held);
  m_working.setHeld(held);
}

void StepBlocks::setTheme(const Theme &theme) {
  for (RichLabel *label : m_labels)
    label->setInk(theme.ink, theme);
  for (NoteFold *note : m_notes)
    note->setTheme(theme);
  for (TaskRow *task : m_tasks)
    task->setTheme(theme);
  m_flight.setTheme(theme);
  if (m_prediction)
    m_prediction->setTheme(theme);
}

} // namespace halfspace
