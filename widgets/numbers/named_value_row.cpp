#include "widgets/numbers/named_value_row.h"

#include <QEvent>

#include <algorithm>

namespace halfspace {
namespace {

/// Short names stand in a column of this many letters, so that their values are in line.
constexpr int nameLetters = 9;

} // namespace

NamedValueRow::NamedValueRow(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_name(new MathLabel(typesetter, this)), m_value(new MathLabel(typesetter, this)) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

int NamedValueRow::nameColumn() const {
  const int gap = fontMetrics().averageCharWidth();
  return std::max(m_name->sizeHint().width() + gap, nameLetters * gap);
}

bool NamedValueRow::isStacked(int width) const { return nameColumn() + m_value->sizeHint().width() > width; }

int NamedValueRow::heightForWidth(int width) const {
  const int name = m_name->sizeHint().height();
  const int value = m_value->sizeHint().height();
  return isStacked(width) ? name + value : std::max(name, value);
}

QSize NamedValueRow::sizeHint() const {
  const int width = nameColumn() + m_value->sizeHint().width();
  return {width, heightForWidth(width)};
}

QSize NamedValueRow::minimumSizeHint() const {
  return {m_value->minimumSizeHint().width(), m_name->sizeHint().height()};
}

void NamedValueRow::place() {
  const int name = m_name->sizeHint().height();
  if (isStacked(width())) {
    const int indent = 2 * fontMetrics().averageCharWidth();
    m_name->setGeometry(0, 0, width(), name);
    m_value->setGeometry(indent, name, width() - indent, m_value->sizeHint().height());
  } else {
    m_name->setGeometry(0, 0, nameColumn(), height());
    m_value->setGeometry(nameColumn(), 0, width() - nameColumn(), height());
  }
}

bool NamedValueRow::event(QEvent *event) {
  // A formula has another size, or may have got one while nobody saw it, of which nothing is told.
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show) {
    updateGeometry();
    place();
  }
  return QWidget::event(event);
}

void NamedValueRow::resizeEvent(QResizeEvent *) { place(); }

} // namespace halfspace
