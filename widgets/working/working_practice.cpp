#include "widgets/working/working_practice.h"

#include "widgets/flow_layout.h"
#include "widgets/keep_room.h"

#include <QActionGroup>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

namespace halfspace {
namespace {

QToolButton *tool(const QString &explanation) {
  auto *button = new QToolButton;
  button->setToolTip(explanation);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

LineRemarks shown(const std::map<std::string, AnswerRemark> &remarks) {
  LineRemarks shown;
  for (const auto &[line, remark] : remarks)
    shown[line] = {QString::fromStdString(remark.text), remark.right, remark.isOfNow};
  return shown;
}

} // namespace

WorkingPractice::WorkingPractice(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_blocks(typesetter), m_chooser(tool({})), m_choices(new QActionGroup(this)),
      m_newNumbers(tool(tr("Work with other short numbers."))), m_score(new QLabel) {
  auto *menu = new QMenu(m_chooser);
  menu->setToolTipsVisible(true);
  addChoice(*menu, Fading::None, tr("All lines"), tr("Show every line with its numbers."));
  addChoice(*menu, Fading::Gaps, tr("Gaps"), tr("Find one number of every line."));
  addChoice(*menu, Fading::Last, tr("Last blank"), tr("Work out the last result yourself."));
  addChoice(*menu, Fading::All, tr("All blank"), tr("Work out every line yourself."));
  m_chooser->setObjectName("fading");
  m_chooser->setMenu(menu);
  m_chooser->setPopupMode(QToolButton::InstantPopup);
  m_newNumbers->setObjectName("newNumbers");
  m_newNumbers->setText(tr("New numbers"));
  m_score->setObjectName("score");
  m_score->setForegroundRole(QPalette::PlaceholderText);
  m_score->setToolTip(
      tr("How many of the blanks that you tried you filled in right at the first try. One that was shown "
         "counts as tried."));
  m_score->hide();
  auto *row = new FlowLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  // The score comes and goes: the others stay where they are.
  for (QWidget *widget : {static_cast<QWidget *>(m_chooser), static_cast<QWidget *>(m_newNumbers),
                          static_cast<QWidget *>(m_score)})
    row->addWidget(widget);
  connect(m_choices, &QActionGroup::triggered, this,
          [this](const QAction *choice) { choose(static_cast<Fading>(choice->data().toInt())); });
  connect(m_newNumbers, &QToolButton::clicked, this, &WorkingPractice::renewNumbers);
  connect(&m_blocks, &StepWorking::answered, this, &WorkingPractice::answer);
  connect(&m_blocks, &StepWorking::showRequested, this, &WorkingPractice::open);
  showChoice();
}

void WorkingPractice::addChoice(QMenu &menu, Fading fading, const QString &text, const QString &explanation) {
  QAction *choice = menu.addAction(text);
  choice->setToolTip(explanation);
  choice->setCheckable(true);
  choice->setData(static_cast<int>(fading));
  m_choices->addAction(choice);
}

void WorkingPractice::showChoice() {
  for (QAction *choice : m_choices->actions())
    if (choice->data().toInt() == static_cast<int>(m_practice.fading())) {
      choice->setChecked(true);
      // Who sees all lines learns here that they can be practised.
      m_chooser->setText(m_practice.fading() == Fading::None ? tr("Practise") : choice->text());
    }
}

void WorkingPractice::setStep(const std::string &lesson, int step, std::optional<Fading> asked) {
  if (!m_practice.setStep(lesson, step, asked))
    return;
  m_blocks.forgetAnswers(); // what was typed elsewhere does not come along
  m_blocks.endTrace();
}

void WorkingPractice::setWorking(const Working &working, const std::vector<std::size_t> &linesIn,
                                 bool hidden) {
  m_linesIn = linesIn;
  m_practice.setWorking(working, hidden);
  refresh();
}

void WorkingPractice::refresh() {
  const bool isWorkedOut = m_practice.hasNumbersToFind();
  m_chooser->setEnabled(!m_practice.isHidden() && isWorkedOut);
  m_chooser->setToolTip(isWorkedOut ? tr("How much of the lines you work out yourself")
                                    : tr("No number is worked out here now."));
  m_newNumbers->setEnabled(!m_practice.isHidden());
  m_chooser->setVisible(!m_practice.working().lines.empty());
  showChoice();
  m_blocks.setWorking(m_practice.working(), m_linesIn, m_practice.fade(), shown(m_practice.remarks()));
  showScore();
}

void WorkingPractice::showScore() {
  const LinePractice::Score score = m_practice.score();
  m_score->setText(
      tr("Right %1/%2", "blanks filled in right, of those tried").arg(score.right).arg(score.tried));
  m_score->setVisible(score.tried > 0 && !m_practice.isHidden());
  keepRoom(*m_score, m_practice.fading() != Fading::None); // the first answer moves nothing
}

void WorkingPractice::choose(Fading fading) {
  m_practice.choose(fading);
  m_blocks.forgetAnswers(); // they were to other questions
  refresh();
  m_blocks.focusField();
  emit blanksChanged();
}

void WorkingPractice::offerNewNumbers(bool offered) { m_newNumbers->setVisible(offered); }

void WorkingPractice::renewNumbers() {
  m_practice.forgetLines();
  m_blocks.forgetAnswers(); // they were about the other numbers
  emit newNumbersRequested();
  refresh();
  if (hasBlanks())
    m_blocks.focusField();
}

void WorkingPractice::answer(const QString &line, const QString &text) {
  if (!m_practice.answer(line.toStdString(), text.toStdString()))
    return;
  refresh();
  emit blanksChanged();
}

void WorkingPractice::open(const QString &line) {
  m_practice.open(line.toStdString());
  refresh();
  emit blanksChanged();
}

} // namespace halfspace
