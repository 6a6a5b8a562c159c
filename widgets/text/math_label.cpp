#include "widgets/text/math_label.h"

#include "widgets/text/indices.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfspace {
namespace {

constexpr int margin = 2;
/// The type's size, as part of the height of the widget's.
constexpr double typeSize = 0.82;
/// What is too wide on lines of its own is drawn smaller, but not below this part of its size.
constexpr double smallestScale = 0.5;
/// Narrower, in em, than any formula can be broken to.
constexpr double narrowestLine = 1;

} // namespace

MathLabel::MathLabel(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void MathLabel::setFormula(const math::Row &formula, const QString &plainText) {
  setAccessibleName(plainText);
  const auto before = std::exchange(m_picture, m_typesetter.picture(formula));
  if (!before || before->box() != m_picture->box())
    updateGeometry();
  update();
}

void MathLabel::setInkOf(MathPicture::InkOf inkOf) {
  m_inkOf = std::move(inkOf);
  update();
}

double MathLabel::emPixels() const { return QFontMetricsF(font()).height() * typeSize; }

double MathLabel::roomIn(int width) const { return std::max(width - 2 * margin, 1) / emPixels(); }

int MathLabel::heightOf(const MathPicture &picture) const {
  return std::max(fontMetrics().height(), static_cast<int>(std::ceil(picture.height() * emPixels()))) +
         2 * margin;
}

QSize MathLabel::sizeHint() const {
  if (!m_picture)
    return {0, fontMetrics().height() + 2 * margin};
  return {static_cast<int>(std::ceil(m_picture->width() * emPixels())) + 2 * margin, heightOf(*m_picture)};
}

QSize MathLabel::minimumSizeHint() const {
  const QSize size = sizeHint();
  return {static_cast<int>(size.width() * smallestScale), size.height()};
}

int MathLabel::heightForWidth(int width) const {
  const bool fits = !m_picture || width >= sizeHint().width();
  return fits ? sizeHint().height() : heightOf(m_picture->brokenTo(roomIn(width)));
}

int MathLabel::narrowestWidth() const {
  const double width = m_picture ? m_picture->brokenTo(narrowestLine).width() : 0;
  return static_cast<int>(std::ceil(smallestScale * width * emPixels())) + 2 * margin;
}

bool MathLabel::event(QEvent *event) {
  if (event->type() == QEvent::ToolTip)
    setToolTip(width() < sizeHint().width() ? richTextOf(accessibleName()) : QString());
  return QWidget::event(event);
}

void MathLabel::paintEvent(QPaintEvent *) {
  if (!m_picture)
    return;
  QPainter painter(this);
  const double room = roomIn(width());
  const bool isBroken = m_picture->width() > room && heightForWidth(width()) <= height();
  const MathPicture &shown = isBroken ? m_picture->brokenTo(room) : *m_picture;
  const double em = emPixels() * std::clamp(room / std::max(shown.width(), room), smallestScale, 1.0);
  const double baseline = height() / 2.0 + (shown.ascent() - shown.depth()) * em / 2;
  shown.paint(
      painter, {double(margin), baseline}, em,
      m_inkOf ? m_inkOf : [this](const QString &) { return palette().color(QPalette::WindowText); });
}

} // namespace halfspace
