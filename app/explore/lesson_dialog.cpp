#include "app/explore/lesson_dialog.h"

#include "app/explore/draft_step_form.h"
#include "app/explore/draft_step_list.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// The usual size of the dialog, in letters and lines; on a small screen this part of it.
constexpr int lettersInAll = 100;
constexpr int linesInAll = 30;
constexpr double mostOfScreen = 0.9;

// Of the width.
constexpr int listShare = 1;
constexpr int formShare = 3;

QString sentenceOf(const DraftProblem &problem) {
  const QString sentence = QString::fromStdString(problem.sentence);
  return problem.step ? LessonDialog::tr("Step %1: %2").arg(*problem.step + 1).arg(sentence) : sentence;
}

} // namespace

LessonDialog::LessonDialog(LessonDraft draft, const Evaluation &start, const QString &leftOut,
                           CheckDraft check, QWidget *parent)
    : QDialog(parent), m_draft(std::move(draft)), m_check(std::move(check)), m_title(new QLineEdit),
      m_steps(new DraftStepList), m_form(new DraftStepForm(start)), m_wrong(new QLabel),
      m_save(new QPushButton(tr("Sa&ve…"))) {
  setObjectName("lessonDialog");
  setWindowTitle(tr("Save as lesson"));
  m_title->setObjectName("title");
  m_title->setText(QString::fromStdString(m_draft.title));
  m_wrong->setObjectName("complaint");
  m_wrong->setWordWrap(true);
  m_wrong->setTextFormat(Qt::PlainText);
  m_wrong->setMinimumHeight(2 * fontMetrics().lineSpacing()); // nothing moves while somebody writes
  m_save->setObjectName("saveLesson");
  auto *title = new QFormLayout;
  title->addRow(tr("Lesson &title:"), m_title);
  auto *middle = new QHBoxLayout;
  middle->addWidget(m_steps, listShare);
  middle->addWidget(m_form, formShare);
  auto *column = new QVBoxLayout(this);
  column->addLayout(title);
  column->addLayout(middle, 1);
  column->addWidget(m_wrong);
  if (!leftOut.isEmpty()) {
    auto *note = new QLabel(leftOut);
    note->setObjectName("leftOut");
    note->setWordWrap(true);
    column->addWidget(note);
  }
  column->addWidget(buttons());
  connect(m_title, &QLineEdit::textChanged, this, [this](const QString &text) {
    m_draft.title = text.toStdString();
    takeChange();
  });
  connect(m_steps, &DraftStepList::chosen, this, &LessonDialog::choose);
  connect(m_steps, &DraftStepList::addWanted, this, &LessonDialog::addStep);
  connect(m_steps, &DraftStepList::removeWanted, this, &LessonDialog::removeStep);
  connect(m_steps, &DraftStepList::moveWanted, this, &LessonDialog::moveStep);
  connect(m_form, &DraftStepForm::changed, this, &LessonDialog::takeStep);
  resize(QSize(lettersInAll * fontMetrics().averageCharWidth(), linesInAll * fontMetrics().lineSpacing())
             .boundedTo(screen()->availableSize() * mostOfScreen));
  showSteps();
  this->check(); // from then on with each change
}

QWidget *LessonDialog::buttons() {
  auto *box = new QDialogButtonBox(QDialogButtonBox::Close);
  box->addButton(m_save, QDialogButtonBox::ActionRole);
  auto *discard = box->addButton(tr("D&iscard…"), QDialogButtonBox::ResetRole);
  discard->setObjectName("discardLesson");
  connect(discard, &QPushButton::clicked, this, &LessonDialog::discardWanted);
  for (QAbstractButton *each : box->buttons()) {
    static_cast<QPushButton *>(each)->setAutoDefault(false); // Enter belongs to the fields
    each->setIcon({});                                       // a theme's own is not seen in every theme
  }
  connect(m_save, &QPushButton::clicked, this, &LessonDialog::saveWanted);
  connect(box, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return box;
}

void LessonDialog::choose(int step) {
  m_step = step;
  m_form->fill(m_draft.steps[static_cast<std::size_t>(step)]);
}

void LessonDialog::showStep(int step) {
  m_step = std::min(step, static_cast<int>(m_draft.steps.size()) - 1);
  showSteps();
}

void LessonDialog::setEditing() {
  setWindowTitle(tr("Edit lesson"));
  m_save->setText(tr("Sa&ve"));
}

void LessonDialog::takeChange() {
  check();
  emit written();
}

void LessonDialog::addStep() {
  const DraftStep &before = m_draft.steps[static_cast<std::size_t>(m_step)];
  DraftStep step{tr("Step %1").arg(m_draft.steps.size() + 1).toStdString(), "", before.workings,
                 before.hidden};
  m_draft.steps.insert(m_draft.steps.begin() + ++m_step, std::move(step));
  m_form->showWords();
  showSteps();
  takeChange();
}

void LessonDialog::removeStep() {
  m_draft.steps.erase(m_draft.steps.begin() + m_step);
  showStep(m_step);
  takeChange();
}

void LessonDialog::moveStep(int places) {
  std::swap(m_draft.steps[static_cast<std::size_t>(m_step)],
            m_draft.steps[static_cast<std::size_t>(m_step + places)]);
  m_step += places;
  showSteps();
  takeChange();
}

void LessonDialog::takeStep() {
  DraftStep &step = m_draft.steps[static_cast<std::size_t>(m_step)];
  step = m_form->step();
  m_steps->setTitle(m_step, QString::fromStdString(step.title));
  takeChange();
}

void LessonDialog::showSteps() {
  QStringList titles;
  for (const DraftStep &step : m_draft.steps)
    titles << QString::fromStdString(step.title);
  m_steps->show(titles, m_step);
  choose(m_step);
}

void LessonDialog::complain(const QString &sentence) { m_wrong->setText(sentence); }

void LessonDialog::check() {
  const std::vector<DraftProblem> problems = m_check(m_draft);
  m_wrong->setText(problems.empty() ? QString() : sentenceOf(problems.front()));
  m_save->setEnabled(problems.empty());
}

} // namespace halfspace
