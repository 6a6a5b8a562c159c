#include "widgets/working/working_practice.h"

#include "widgets/flow_layout.h"
#include "widgets/keep_room.h"

#include <QActionGroup>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

QToolButton *tool(const QString &explanation) {
  auto *button = new QToolButton;
  button->setToolTip(explanation);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

bool hasNumbersToFind(const Working &working) {
  const auto isAsked = [](const WorkingLine &line) { return line.asked != Asked::Nothing; };
  return std::any_of(working.lines.begin(), working.lines.end(), isAsked) ||
         !fade(working, Fading::Gaps, {}).gaps.empty();
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
    if (choice->data().toInt() == static_cast<int>(fading())) {
      choice->setChecked(true);
      // Who sees all lines learns here that they can be practised.
      m_chooser->setText(fading() == Fading::None ? tr("Practise") : choice->text());
    }
}

void WorkingPractice::setStep(const std::string &lesson, int step, std::optional<Fading> asked) {
  if (m_step != std::pair(lesson, step)) {
    m_blocks.forgetAnswers(); // what was typed elsewhere does not come along
    m_blocks.endTrace();
  }
  m_step = {lesson, step};
  m_asked = asked;
}

void WorkingPractice::setWorking(const Working &working, const std::vector<std::size_t> &linesIn,
                                 bool hidden) {
  m_working = working;
  m_linesIn = linesIn;
  m_hidden = hidden;
  refresh();
}

Fading WorkingPractice::fading() const {
  const auto here = m_practice.find(m_step);
  if (here != m_practice.end() && here->second.fading)
    return *here->second.fading;
  const auto chosen = m_chosen.find(m_step.first);
  return m_asked.value_or(chosen == m_chosen.end() ? Fading::None : chosen->second);
}

void WorkingPractice::refresh() {
  if (!m_hidden) // else these may not be the numbers of the scene
    endRecordsOfOtherNumbers();
  const bool isWorkedOut = hasNumbersToFind(m_working);
  m_chooser->setEnabled(!m_hidden && isWorkedOut);
  m_chooser->setToolTip(isWorkedOut ? tr("How much of the lines you work out yourself")
                                    : tr("No number is worked out here now."));
  m_newNumbers->setEnabled(!m_hidden);
  showChoice();
  m_fade = m_hidden ? withheld(m_working) : fade(m_working, fading(), openedLines());
  m_blocks.setWorking(m_working, m_linesIn, m_fade,
                      m_hidden ? std::map<std::string, LineRemark>() : remarks());
  showScore();
}

void WorkingPractice::endRecordsOfOtherNumbers() {
  for (auto &[line, record] : practice().lines) {
    if (textOf(line) == record.text)
      continue;
    LineRemark said = std::move(record.remark);
    said.isOfNow = false;
    record = {textOf(line), false, std::move(said)};
  }
}

void WorkingPractice::count(LineRecord &record, bool right) {
  if (std::exchange(record.isCounted, true))
    return;
  Score &score = practice().score;
  ++score.tried;
  score.right += right ? 1 : 0;
}

void WorkingPractice::showScore() {
  const Score score = practice().score;
  m_score->setText(
      tr("First try %1/%2", "blanks filled in right, of those tried").arg(score.right).arg(score.tried));
  m_score->setVisible(score.tried > 0 && !m_hidden);
  keepRoom(*m_score, fading() != Fading::None); // the first answer moves nothing
}

std::map<std::string, LineRemark> WorkingPractice::remarks() {
  std::map<std::string, LineRemark> remarks;
  for (const auto &[line, record] : practice().lines)
    if (!record.remark.text.isEmpty())
      remarks[line] = record.remark;
  return remarks;
}

std::set<std::string> WorkingPractice::openedLines() {
  std::set<std::string> lines;
  for (const auto &[line, record] : practice().lines)
    if (record.isOpen)
      lines.insert(line);
  return lines;
}

WorkingPractice::LineRecord &WorkingPractice::recordOf(const std::string &lineId) {
  LineRecord &record = practice().lines[lineId];
  record.text = textOf(lineId);
  return record;
}

std::string WorkingPractice::textOf(const std::string &lineId) const {
  const WorkingLine *line = findLine(m_working, lineId);
  return line ? plainText(*line) : std::string();
}

void WorkingPractice::choose(Fading fading) {
  m_chosen[m_step.first] = fading;
  practice() = {fading, {}, {}};
  m_blocks.forgetAnswers(); // they were to other questions
  refresh();
  m_blocks.focusField();
  emit blanksChanged();
}

void WorkingPractice::renewNumbers() {
  practice().lines.clear();
  m_blocks.forgetAnswers(); // they were about the other numbers
  emit newNumbersRequested();
  refresh();
  if (hasBlanks())
    m_blocks.focusField();
}

void WorkingPractice::answer(const QString &lineId, const QString &text) {
  const std::string line = lineId.toStdString();
  const WorkingLine *asking = findLine(m_working, line);
  const auto gap = m_fade.gaps.find(line);
  if (!asking || gap == m_fade.gaps.end())
    return;
  const char decimalMark = QString(locale().decimalPoint()).at(0).toLatin1();
  const Judgement judgement = judge(*asking, gap->second, text.toStdString(), decimalMark);
  LineRecord &record = recordOf(line);
  record.remark = {QString::fromStdString(judgement.sentence), judgement.right};
  record.isOpen = judgement.right;
  if (judgement.isAnswer)
    count(record, judgement.right);
  refresh();
  emit blanksChanged();
}

void WorkingPractice::open(const QString &lineId) {
  const std::string line = lineId.toStdString();
  LineRecord &record = recordOf(line);
  record.isOpen = true;
  record.remark = {};
  count(record, false);
  refresh();
  emit blanksChanged();
}

} // namespace halfspace
