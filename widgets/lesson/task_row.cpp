#include "widgets/lesson/task_row.h"

#include "widgets/colors.h"
#include "widgets/verdict.h"

#include <QPainter>
#include <QVBoxLayout>

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

TaskRow::TaskRow(const Typesetter &typesetter, const QString &instruction, QWidget *parent)
    : QWidget(parent), m_words(new RichLabel(typesetter)), m_holdsAlready(new RichLabel(typesetter)),
      m_theme(themes().front()) {
  auto *layout = new QVBoxLayout(this);
  layout->addWidget(m_words);
  layout->addWidget(m_holdsAlready);
  m_holdsAlready->setMarkdown(tr("It is so already. Change that, then bring it about again."));
  m_holdsAlready->hide();
  setTheme(m_theme);
  setWords(instruction);
}

void TaskRow::setWords(const QString &markdown) {
  m_words->setMarkdown(markdown);
  tellAccessibly();
}

void TaskRow::setState(TaskState state) {
  if (state == m_state)
    return;
  m_state = state;
  m_holdsAlready->setVisible(state == TaskState::HoldsAlready);
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
  m_holdsAlready->setInk(m_theme.mutedInk, m_theme);
}

void TaskRow::tellAccessibly() {
  const QString instruction = m_words->accessibleName();
  setAccessibleName((m_state == TaskState::Done ? tr("Done: %1") : tr("To do: %1")).arg(instruction));
  setAccessibleDescription(m_state == TaskState::HoldsAlready ? m_holdsAlready->accessibleName()
                           : m_state == TaskState::Waiting    ? tr("after those above")
                                                              : QString());
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
