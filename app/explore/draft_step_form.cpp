#include "app/explore/draft_step_form.h"

#include "app/explore/check_list.h"
#include "app/explore/draft_question_form.h"
#include "app/explore/draft_task_form.h"
#include "app/explore/value_list.h"
#include "lessons/language.h"
#include "lessons/lesson/live_values.h"
#include "lessons/typed/write_line.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QVBoxLayout>

namespace halfspace {
namespace {

/// The entries of a scene for which a predicate holds, as they are typed.
template <class Predicate> std::vector<CheckItem> entriesOf(const Scene &scene, Predicate isMeant) {
  std::vector<CheckItem> items;
  for (const Entry &entry : scene.entries)
    if (isMeant(entry)) {
      const std::string line = lineFor(entry, language().decimalMark);
      items.push_back({entry.name, QString::fromStdString(line.empty() ? entry.name : line)});
    }
  return items;
}

bool isConstruction(const Entry &entry) { return std::holds_alternative<ConstructionUse>(entry.content); }

} // namespace

DraftStepForm::DraftStepForm(const Evaluation &start)
    : m_title(new QLineEdit), m_words(new QPlainTextEdit),
      m_workings(new CheckList(tr("Shows the &working of"), entriesOf(start.scene, isConstruction))),
      m_hidden(new CheckList(tr("Hi&des"), entriesOf(start.scene, isDrawn))),
      m_question(new DraftQuestionForm(start)), m_task(new DraftTaskForm(start)), m_tabs(new QTabWidget) {
  m_title->setObjectName("stepTitle");
  m_words->setObjectName("words");
  m_words->setTabChangesFocus(true);
  m_workings->setObjectName("workings");
  m_hidden->setObjectName("hidden");
  m_tabs->setObjectName("stepTabs");
  m_tabs->addTab(wordsPage(start), tr("Words"));
  m_tabs->addTab(shownPage(), tr("Shown"));
  m_tabs->addTab(m_question, tr("Question"));
  m_tabs->addTab(m_task, tr("Task"));
  auto *title = new QFormLayout;
  title->addRow(tr("Ste&p:"), m_title);
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(title);
  column->addWidget(m_tabs, 1);
  connect(m_title, &QLineEdit::textChanged, this, &DraftStepForm::changed);
  connect(m_words, &QPlainTextEdit::textChanged, this, &DraftStepForm::changed);
  for (const CheckList *list : {m_workings, m_hidden})
    connect(list, &CheckList::changed, this, &DraftStepForm::changed);
  connect(m_question, &DraftQuestionForm::changed, this, &DraftStepForm::changed);
  connect(m_task, &DraftTaskForm::changed, this, &DraftStepForm::changed);
}

void DraftStepForm::showWords() { m_tabs->setCurrentIndex(0); }

QWidget *DraftStepForm::wordsPage(const Evaluation &start) {
  const std::vector<std::string> values = liveNames(start);
  auto *hint = new QLabel(tr("Markdown, with LaTeX between dollars, and live values in braces: {%1} is what "
                             "%1 is at the moment.")
                              .arg(values.empty() ? "Q" : QString::fromStdString(values.front())));
  hint->setObjectName("wordsHint");
  hint->setWordWrap(true);
  m_words->setAccessibleName(tr("Words of the step"));
  m_words->setAccessibleDescription(hint->text());
  auto *page = new QWidget;
  auto *column = new QVBoxLayout(page);
  column->addWidget(m_words, 1);
  column->addWidget(hint);
  auto *insert = new ValueList;
  insert->setObjectName("wordsValues");
  insert->setAccessibleName(tr("A value for the words"));
  for (const std::string &name : values)
    insert->add(QString::fromStdString(liveText(name, start)), name);
  column->addWidget(insert, 0, Qt::AlignLeft);
  connect(insert, &ValueList::taken, this, [this](const QString &name) {
    m_words->insertPlainText("{" + name + "}");
    m_words->setFocus();
  });
  return page;
}

QWidget *DraftStepForm::shownPage() {
  auto *page = new QWidget;
  auto *row = new QHBoxLayout(page);
  row->addWidget(m_workings);
  row->addWidget(m_hidden);
  return page;
}

void DraftStepForm::fill(const DraftStep &step) {
  const QSignalBlocker untold(this);
  m_title->setText(QString::fromStdString(step.title));
  m_words->setPlainText(QString::fromStdString(step.words));
  m_workings->setChecked(step.workings);
  m_hidden->setChecked(step.hidden);
  m_question->fill(step.question);
  m_task->fill(step.task);
}

DraftStep DraftStepForm::step() const {
  return {m_title->text().toStdString(), m_words->toPlainText().toStdString(),
          m_workings->checked(),         m_hidden->checked(),
          m_question->question(),        m_task->task()};
}

} // namespace halfspace
