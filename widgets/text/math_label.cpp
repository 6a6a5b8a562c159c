#include "widgets/text/math_label.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfspace {
namespace {

constexpr int margin = 2;
/// The type's size, as part of the height of the widget's.
constexpr double typeSize = 0.82;
/// A formula that is too wide is drawn smaller, but not below this part of its size.
constexpr double smallestScale = 0.5;

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

QSize MathLabel::sizeHint() const {
  if (!m_picture)
    return {0, fontMetrics().height() + 2 * margin};
  const double em = emPixels();
  return {static_cast<int>(std::ceil(m_picture->width() * em)) + 2 * margin,
          std::max(fontMetrics().height(), static_cast<int>(std::ceil(m_picture->height() * em))) +
              2 * margin};
}

QSize MathLabel::minimumSizeHint() const {
  const QSize size = sizeHint();
  return {static_cast<int>(size.width() * smallestScale), size.height()};
}

void MathLabel::paintEvent(QPaintEvent *) {
  if (!m_picture)
    return;
  QPainter painter(this);
  const double wanted = m_picture->width() * emPixels();
  const double room = width() - 2 * margin;
  const double em = emPixels() * (wanted > room ? std::max(smallestScale, room / wanted) : 1);
  const double baseline = height() / 2.0 + (m_picture->ascent() - m_picture->depth()) * em / 2;
  m_picture->paint(
      painter, {double(margin), baseline}, em,
      m_inkOf ? m_inkOf : [this](const QString &) { return palette().color(QPalette::WindowText); });
}

} // namespace halfspace
