#include "widgets/lesson/task_row.h"

#include "widgets/colors.h"
#include "widgets/speak_by.h"
#include "widgets/verdict.h"

#include <QAccessibleWidget>
#include <QPainter>
#include <QVBoxLayout>

#include <utility>

namespace halfspace {

namespace {

// At a text scale of 1.
constexpr double markRoom = 34;
constexpr double markRadius = 7.5;
constexpr double edgeMargin = 7;
constexpr double cornerRadius = 6;

QMargins marginsAt(const Theme &theme) {
  return QMarginsF(markRoom, edgeMargin, edgeMargin, edgeMargin).toMargins() * theme.textScale;
}

FilledMarkdown noWords() { return {}; }

/// Tells a screen reader of the task.
class SpokenTask : public QAccessibleWidget {
public:
  explicit SpokenTask(TaskRow &row) : QAccessibleWidget(&row), m_row(row) {}

  [[nodiscard]] QString text(QAccessible::Text text) const override {
    return text == QAccessible::Name          ? m_row.spokenName()
           : text == QAccessible::Description ? m_row.spokenDescription()
                                              : QAccessibleWidget::text(text);
  }

private:
  const TaskRow &m_row;
};

} // namespace

TaskRow::TaskRow(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_words(new RichLabel(typesetter)), m_remark(new RichLabel(typesetter)),
      m_hints(new HintColumn(typesetter)), m_now(noWords), m_answer(noWords),
      m_holdsAlready(withNames(
          MarkdownText(tr("It is so already. Change that, then bring it about again.").toStdString())
              .markdown())),
      m_theme(themes().front()) {
  speakBy<TaskRow, SpokenTask>();
  auto *layout = new QVBoxLayout(this);
  layout->addWidget(m_words);
  layout->addWidget(m_remark);
  layout->addWidget(m_hints);
  m_remark->hide();
  m_hints->hide();
  connect(m_hints, &HintColumn::told, this, &TaskRow::hintTold);
  setTheme(m_theme);
}

void TaskRow::setWords(FilledMarkdown instruction, Lazy<FilledMarkdown> now, Lazy<FilledMarkdown> answer) {
  const bool isOther = m_words->setWords(std::move(instruction));
  m_now = std::move(now);
  m_answer = std::move(answer);
  if (showRemark() || isOther)
    tellScreenReader();
}

void TaskRow::setHints(std::vector<Lazy<FilledMarkdown>> hints) {
  m_hints->setHints(std::move(hints));
  showHints();
}

void TaskRow::setHeld(bool held) {
  m_words->setHeld(held);
  m_hints->setHeld(held);
  m_remark->setHeld(held);
}

bool TaskRow::showRemark() {
  const FilledMarkdown &remark = m_state == TaskState::Done           ? *m_answer
                                 : m_state == TaskState::HoldsAlready ? m_holdsAlready
                                                                      : *m_now;
  m_remark->setVisible(!remark.blocks.empty());
  return m_remark->setWords(remark);
}

void TaskRow::setState(TaskState state) {
  if (state == m_state)
    return;
  m_state = state;
  showRemark();
  showHints();
  setInks();
  setToolTip(m_state == TaskState::Waiting ? tr("Do those above first.") : QString());
  tellScreenReader();
  update();
}

void TaskRow::setTheme(const Theme &theme) {
  m_theme = theme;
  m_hints->setTheme(theme);
  layout()->setContentsMargins(marginsAt(theme));
  setInks();
  update();
}

void TaskRow::showHints() { m_hints->setVisible(isDue() && !m_hints->isEmpty()); }

bool TaskRow::isDue() const { return m_state == TaskState::Open || m_state == TaskState::HoldsAlready; }

void TaskRow::setInks() {
  m_words->setInk(isDue() ? m_theme.ink : m_theme.mutedInk, m_theme);
  m_remark->setInk(m_state == TaskState::Done ? m_theme.ink : m_theme.mutedInk, m_theme);
}

QString TaskRow::spokenName() const {
  return (m_state == TaskState::Done ? tr("Done: %1") : tr("To do: %1")).arg(m_words->plain());
}

QString TaskRow::spokenDescription() const {
  return m_state == TaskState::Waiting ? tr("after those above") : m_remark->plain();
}

void TaskRow::tellScreenReader() {
  tellSpoken(*this, QAccessible::NameChanged);
  tellSpoken(*this, QAccessible::DescriptionChanged);
}

void TaskRow::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(toQColor(m_theme.border), 1));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), cornerRadius, cornerRadius);
  const double firstLine = m_words->y() + fontMetrics().ascent() - fontMetrics().capHeight() / 2.0;
  const double radius = markRadius * m_theme.textScale;
  paintVerdict(painter, {layout()->contentsMargins().left() / 2.0, firstLine}, radius,
               m_state == TaskState::Done ? Verdict::Right : Verdict::Open, m_theme);
}

} // namespace halfspace
