#include "widgets/lesson/task_row.h"

#include "widgets/colors.h"
#include "widgets/verdict.h"

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

} // namespace

TaskRow::TaskRow(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_words(new RichLabel(typesetter)), m_remark(new RichLabel(typesetter)),
      m_holdsAlready(withNames(
          readWords(tr("It is so already. Change that, then bring it about again.").toStdString()))),
      m_theme(themes().front()) {
  auto *layout = new QVBoxLayout(this);
  layout->addWidget(m_words);
  layout->addWidget(m_remark);
  m_remark->hide();
  setTheme(m_theme);
}

void TaskRow::setWords(FilledMarkdown instruction, FilledMarkdown now, FilledMarkdown answer) {
  m_words->setWords(std::move(instruction));
  m_now = std::move(now);
  m_answer = std::move(answer);
  showRemark();
  tellAccessibly();
}

void TaskRow::setHeld(bool held) {
  m_words->setHeld(held);
  m_remark->setHeld(held);
}

void TaskRow::showRemark() {
  const FilledMarkdown &remark = m_state == TaskState::Done           ? m_answer
                                 : m_state == TaskState::HoldsAlready ? m_holdsAlready
                                                                      : m_now;
  m_remark->setWords(remark);
  m_remark->setVisible(!remark.blocks.empty());
}

void TaskRow::setState(TaskState state) {
  if (state == m_state)
    return;
  m_state = state;
  showRemark();
  setInks();
  tellAccessibly();
  update();
}

void TaskRow::setTheme(const Theme &theme) {
  m_theme = theme;
  layout()->setContentsMargins(marginsAt(theme));
  setInks();
  update();
}

void TaskRow::setInks() {
  const bool isDue = m_state == TaskState::Open || m_state == TaskState::HoldsAlready;
  m_words->setInk(isDue ? m_theme.ink : m_theme.mutedInk, m_theme);
  m_remark->setInk(m_state == TaskState::Done ? m_theme.ink : m_theme.mutedInk, m_theme);
}

void TaskRow::tellAccessibly() {
  const QString instruction = m_words->accessibleName();
  setAccessibleName((m_state == TaskState::Done ? tr("Done: %1") : tr("To do: %1")).arg(instruction));
  setAccessibleDescription(m_state == TaskState::Waiting ? tr("after those above")
                                                         : m_remark->accessibleName());
  setToolTip(m_state == TaskState::Waiting ? tr("Do those above first.") : QString());
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
