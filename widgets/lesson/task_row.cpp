#include "widgets/lesson/task_row.h"

#include "widgets/colors.h"

#include <QHBoxLayout>
#include <QPainter>

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

void paintVerdict(QPainter &painter, QPointF center, double radius, Verdict verdict, const Theme &theme) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (verdict == Verdict::Open) {
    painter.setPen(QPen(toQColor(theme.mutedInk), 1.4));
    painter.drawEllipse(center, radius, radius);
  } else {
    const bool right = verdict == Verdict::Right;
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQColor(right ? theme.inkOf(Subject::Triangle) : theme.warning));
    painter.drawEllipse(center, radius, radius);
    const auto at = [&](double x, double y) { return center + QPointF(x, y) * radius; };
    painter.setPen(QPen(toQColor(theme.panel), 0.24 * radius, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (right) {
      painter.drawLine(at(-0.45, 0.02), at(-0.12, 0.38));
      painter.drawLine(at(-0.12, 0.38), at(0.46, -0.34));
    } else {
      painter.drawLine(at(-0.36, -0.36), at(0.36, 0.36));
      painter.drawLine(at(-0.36, 0.36), at(0.36, -0.36));
    }
  }
  painter.restore();
}

TaskRow::TaskRow(const Typesetter &typesetter, const QString &instruction, QWidget *parent)
    : QWidget(parent), m_words(new RichLabel(typesetter)), m_theme(themes().front()) {
  auto *layout = new QHBoxLayout(this);
  layout->setContentsMargins(marginsAt(m_theme));
  layout->addWidget(m_words);
  m_words->setMarkdown(instruction);
  tellAccessibly();
}

void TaskRow::setDone(bool done) {
  if (done == m_done)
    return;
  m_done = done;
  m_words->setInk(toQColor(done ? m_theme.mutedInk : m_theme.ink), toQColor(m_theme.warning));
  tellAccessibly();
  update();
}

void TaskRow::setTheme(const Theme &theme) {
  m_theme = theme;
  layout()->setContentsMargins(marginsAt(theme));
  m_words->setInk(toQColor(m_done ? m_theme.mutedInk : m_theme.ink), toQColor(m_theme.warning));
  update();
}

void TaskRow::tellAccessibly() {
  setAccessibleName((m_done ? tr("Done: %1") : tr("To do: %1")).arg(m_words->accessibleName()));
}

void TaskRow::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(toQColor(m_theme.border), 1));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), cornerRadius, cornerRadius);
  const double firstLine = m_words->y() + fontMetrics().ascent() - fontMetrics().capHeight() / 2.0;
  const double radius = markRadius * m_theme.textScale;
  paintVerdict(painter, {layout()->contentsMargins().left() / 2.0, firstLine}, radius, m_done ? Verdict::Right : Verdict::Open, m_theme);
}

} // namespace halfspace
