#include "widgets/working/working_practice.h"

#include "widgets/flow_layout.h"

#include <QButtonGroup>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {
namespace {

constexpr QMargins barMargins(12, 0, 12, 4);
constexpr QMargins scoreMargins(8, 0, 8, 0); // as the text of a button

QToolButton *barButton(const QString &text, const QString &explanation) {
  auto *button = new QToolButton;
  button->setText(text);
  button->setToolTip(explanation);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

} // namespace

WorkingPractice::WorkingPractice(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_panel(new WorkingPanel(typesetter)), m_choices(new QButtonGroup(this)),
      m_newNumbers(
          barButton(tr("New numbers"), tr("Work with other short numbers; the case stays the same."))),
      m_score(new QLabel) {
  auto *bar = new FlowLayout;
  createBar(*bar);
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(bar);
  layout->addWidget(m_panel, 1);
  connect(m_choices, &QButtonGroup::idClicked, this, [this](int id) { choose(static_cast<Fading>(id)); });
  connect(m_panel, &WorkingPanel::answered, this, &WorkingPractice::answer);
  connect(m_panel, &WorkingPanel::showRequested, this, &WorkingPractice::open);
}

void WorkingPractice::createBar(QLayout &bar) {
  bar.setContentsMargins(barMargins);
  bar.setSpacing(2);
  addChoice(bar, Fading::None, tr("All lines"), tr("Show every line with its numbers."));
  addChoice(bar, Fading::Gaps, tr("Gaps"), tr("Find one number of every line."));
  addChoice(bar, Fading::Last, tr("Last blank"), tr("Work out the last result yourself."));
  addChoice(bar, Fading::All, tr("All blank"), tr("Work out every line yourself."));
  bar.addWidget(m_newNumbers);
  connect(m_newNumbers, &QToolButton::clicked, this, &WorkingPractice::renewNumbers);
  m_score->setObjectName("score");
  m_score->setForegroundRole(QPalette::PlaceholderText);
  m_score->setContentsMargins(scoreMargins);
  m_score->setToolTip(tr("What you filled in right at the first try. A line that was shown does not count."));
  m_score->hide();
  bar.addWidget(m_score);
}

void WorkingPractice::addChoice(QLayout &bar, Fading fading, const QString &text,
                                const QString &explanation) {
  QToolButton *button = barButton(text, explanation);
  button->setCheckable(true);
  button->setChecked(fading == m_usual);
  m_choices->addButton(button, static_cast<int>(fading));
  bar.addWidget(button);
}

void WorkingPractice::setUsual(Fading fading) {
  m_usual = fading;
  refresh();
}

void WorkingPractice::setStep(const std::string &lesson, int step, std::optional<Fading> asked) {
  if (m_step != std::pair(lesson, step)) {
    m_panel->forgetAnswers(); // what was typed elsewhere does not come along
    m_panel->endTrace();
  }
  m_step = {lesson, step};
  m_asked = asked;
}

void WorkingPractice::setWorking(const Working &working, bool hidden) {
  m_working = working;
  m_hidden = hidden;
  refresh();
}

Fading WorkingPractice::fading() const {
  const auto here = m_practice.find(m_step);
  if (here != m_practice.end() && here->second.fading)
    return *here->second.fading;
  return m_asked.value_or(m_usual);
}

void WorkingPractice::refresh() {
  // What was done with other numbers is of no use for these.
  std::erase_if(practice().lines,
                [this](const auto &each) { return textOf(each.first) != each.second.text; });
  for (QAbstractButton *button : m_choices->buttons())
    button->setEnabled(!m_hidden);
  m_newNumbers->setEnabled(!m_hidden);
  m_choices->button(static_cast<int>(fading()))->setChecked(true);
  m_fade = m_hidden ? Fade() : fade(m_working, fading(), openedLines());
  if (m_hidden)
    m_panel->setWorkingWithoutNumbers(m_working);
  else
    m_panel->setWorking(m_working, m_fade, remarks());
  showScore();
}

void WorkingPractice::showScore() {
  const Fade all = fade(m_working, fading(), {});
  const auto asked = static_cast<int>(all.gaps.size());
  int right = 0;
  for (const auto &[line, gap] : all.gaps) {
    const auto record = practice().lines.find(line);
    right += record != practice().lines.end() && record->second.wasRight == true ? 1 : 0;
  }
  constexpr QChar figureSpace(0x2007); // as wide as a digit: nothing moves from 9 to 10
  const int digits = static_cast<int>(QString::number(asked).size());
  m_score->setText(
      tr("%1 of %n right", "lines that were filled in", asked).arg(right, digits, 10, figureSpace));
  m_score->setAccessibleName(
      tr("%1 of %n right at the first try", "lines that were filled in", asked).arg(right));
  m_score->setVisible(asked > 0 && !m_hidden);
}

std::map<std::string, LineRemark> WorkingPractice::remarks() {
  std::map<std::string, LineRemark> remarks;
  for (const auto &[line, record] : practice().lines)
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
  m_usual = fading;
  practice() = {fading, {}};
  m_panel->forgetAnswers(); // they were to other questions
  refresh();
  m_panel->focusField();
  emit blanksChanged();
}

void WorkingPractice::renewNumbers() {
  practice().lines.clear();
  m_panel->forgetAnswers(); // they were about the other numbers
  emit newNumbersRequested();
  refresh();
  if (hasBlanks())
    m_panel->focusField();
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
  if (judgement.isAnswer && !record.wasRight)
    record.wasRight = judgement.right;
  refresh();
  emit blanksChanged();
}

void WorkingPractice::open(const QString &lineId) {
  const std::string line = lineId.toStdString();
  LineRecord &record = recordOf(line);
  record.isOpen = true;
  record.remark = {};
  record.wasRight = record.wasRight.value_or(false);
  refresh();
  emit blanksChanged();
}

} // namespace halfspace
