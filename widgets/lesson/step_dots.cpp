#include "widgets/lesson/step_dots.h"

#include "widgets/colors.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace halfspace {

namespace {

// At a text scale of 1.
constexpr double usualSpacing = 16;
constexpr double leastSpacing = 9;
constexpr double usualRadius = 3.5;
constexpr double usualCurrentRadius = 5;
constexpr double usualHeight = 22;

} // namespace

StepDots::StepDots(QWidget *parent) : QWidget(parent), m_theme(themes().front()) {
  setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
}

void StepDots::setSteps(const QStringList &titles) {
  m_titles = titles;
  tellAccessibly();
  updateGeometry();
  update();
}

void StepDots::setCurrent(int step) {
  m_current = step;
  tellAccessibly();
  update();
}

void StepDots::setTheme(const Theme &theme) {
  m_theme = theme;
  updateGeometry();
  update();
}

void StepDots::tellAccessibly() {
  setAccessibleName(tr("Step %1 of %2").arg(m_current + 1).arg(m_titles.size()));
}

double StepDots::spacing() const {
  return std::min(usualSpacing * m_theme.textScale, width() / std::max(1.0, double(m_titles.size())));
}

QSize StepDots::sizeHint() const { return sizeWith(usualSpacing); }

QSize StepDots::minimumSizeHint() const { return sizeWith(leastSpacing); }

QSize StepDots::sizeWith(double spacing) const {
  const double scale = m_theme.textScale;
  return {static_cast<int>(std::ceil(spacing * scale * m_titles.size())),
          static_cast<int>(std::ceil(usualHeight * scale))};
}

QPointF StepDots::center(int step) const { return {spacing() * (step + 0.5), height() / 2.0}; }

int StepDots::stepAt(QPoint position) const {
  return std::clamp(static_cast<int>(position.x() / spacing()), 0, static_cast<int>(m_titles.size()) - 1);
}

void StepDots::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const int count = static_cast<int>(m_titles.size());
  for (int step = 0; step < count; ++step) {
    const bool current = step == m_current;
    painter.setBrush(toQColor(current            ? m_theme.accent
                              : step < m_current ? mix(m_theme.panel, m_theme.accent, 0.5)
                                                 : mix(m_theme.panel, m_theme.mutedInk, 0.4)));
    const double radius = (current ? usualCurrentRadius : usualRadius) * m_theme.textScale;
    painter.drawEllipse(center(step), radius, radius);
  }
}

void StepDots::mousePressEvent(QMouseEvent *event) {
  if (!m_titles.isEmpty())
    emit clicked(stepAt(event->pos()));
}

bool StepDots::event(QEvent *event) {
  if (event->type() != QEvent::ToolTip || m_titles.isEmpty())
    return QWidget::event(event);
  const auto *help = static_cast<QHelpEvent *>(event);
  QToolTip::showText(help->globalPos(), m_titles[stepAt(help->pos())], this);
  return true;
}

} // namespace halfspace
