#include "app/explore/draft_task_form.h"

#include "app/explore/short_text.h"
#include "app/explore/value_list.h"
#include "lessons/lesson/condition.h"
#include "lessons/lesson/entry_names.h"
#include "lessons/lesson/live_values.h"
#include "widgets/repolish.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>

namespace halfspace {
namespace {

constexpr int linesOfInstruction = 3;

/// A value as the list of them tells it: with what it is now, and the other words that it can be.
QString toldAs(const OfferedValue &value, const Evaluation &now) {
  const QString text = QString::fromStdString(liveText(value.name, now));
  QStringList others;
  for (const std::string &word : value.value.words)
    if (!holds({value.name, Condition::Relation::Equal, word}, now))
      others << QString::fromStdString(word);
  return others.isEmpty() ? text : DraftTaskForm::tr("%1, or %2").arg(text, others.join(", "));
}

} // namespace

DraftTaskForm::DraftTaskForm(const Evaluation &start)
    : QGroupBox(tr("&Give something to do")), m_start(start),
      m_instruction(shortText("instruction", linesOfInstruction)), m_condition(new QLineEdit),
      m_values(new ValueList), m_now(new QLabel) {
  setObjectName("task");
  setCheckable(true);
  setChecked(false);
  m_condition->setObjectName("condition");
  m_values->setObjectName("values");
  for (const OfferedValue &each : comparableValues(start.scene))
    m_values->add(toldAs(each, start), each.name);
  m_values->setAccessibleName(tr("A value for the condition"));
  m_now->setObjectName("conditionNow");
  m_now->setWordWrap(true);
  m_now->setAlignment(Qt::AlignTop);
  auto *condition = new QHBoxLayout;
  condition->addWidget(m_condition, 1);
  condition->addWidget(m_values);
  auto *form = new QFormLayout(this);
  form->addRow(tr("What to &do:"), m_instruction);
  auto *words = new QLabel(tr("Do&ne when:"));
  words->setBuddy(m_condition);
  form->addRow(words, condition);
  form->addRow(QString(), m_now);
  connect(m_instruction, &QPlainTextEdit::textChanged, this, &DraftTaskForm::changed);
  connect(m_condition, &QLineEdit::textChanged, this, &DraftTaskForm::changed);
  connect(this, &QGroupBox::toggled, this, &DraftTaskForm::changed);
  connect(this, &DraftTaskForm::changed, this, &DraftTaskForm::tellNow);
  connect(m_values, &ValueList::taken, this, &DraftTaskForm::insert);
  tellNow();
}

void DraftTaskForm::insert(const QString &name) {
  const bool isSecond = parseConditions(m_condition->text().trimmed().toStdString()).operator bool();
  m_condition->end(false);
  m_condition->insert((isSecond ? " and " : "") + name + " ");
  m_condition->setFocus();
}

void DraftTaskForm::tellNow() {
  const auto conditions = parseConditions(m_condition->text().trimmed().toStdString());
  const bool holdsNow =
      conditions && std::all_of(conditions->begin(), conditions->end(),
                                [&](const Condition &condition) { return holds(condition, m_start); });
  m_now->setText(
      !conditions ? tr("Write it as side = negative, or as t < 0 and s != 1.")
      : holdsNow
          ? tr("This holds already as the scene is now: as the first task of a lesson it would be done at "
               "the start.")
          : tr("This does not hold as the scene is now: it can be brought about."));
  m_now->setProperty("wrong", holdsNow);
  repolish(*m_now);
}

void DraftTaskForm::fill(const std::optional<DraftTask> &task) {
  const QSignalBlocker untold(this);
  const DraftTask filled = task.value_or(DraftTask());
  setChecked(task.has_value());
  m_instruction->setPlainText(QString::fromStdString(filled.instruction));
  m_condition->setText(QString::fromStdString(filled.condition));
  tellNow();
}

std::optional<DraftTask> DraftTaskForm::task() const {
  if (!isChecked())
    return {};
  return DraftTask{m_instruction->toPlainText().toStdString(), m_condition->text().toStdString()};
}

} // namespace halfspace
