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
  QSizePolicy policy(QSizePolicy::Preferred,
                     QSizePolicy::Preferred); // a fixed height would be that of one line
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

int NamedValueRow::nameColumn() const {
  const int gap = fontMetrics().averageCharWidth();
  return std::max(m_name->sizeHint().width() + gap, nameLetters * gap);
}

bool NamedValueRow::isStacked(int width) const { return nameColumn() + m_value->sizeHint().width() > width; }

int NamedValueRow::indent() const { return 2 * fontMetrics().averageCharWidth(); }

int NamedValueRow::heightForWidth(int width) const {
  if (isStacked(width))
    return m_name->heightForWidth(width) + m_value->heightForWidth(width - indent());
  return std::max(m_name->sizeHint().height(), m_value->sizeHint().height());
}

QSize NamedValueRow::sizeHint() const {
  const int width = nameColumn() + m_value->sizeHint().width();
  return {width, heightForWidth(width)};
}

QSize NamedValueRow::minimumSizeHint() const {
  return {std::max(m_name->narrowestWidth(), indent() + m_value->narrowestWidth()),
          m_name->sizeHint().height()};
}

void NamedValueRow::place() {
  if (isStacked(width())) {
    const int name = m_name->heightForWidth(width());
    const int valueWidth = width() - indent();
    m_name->setGeometry(0, 0, width(), name);
    m_value->setGeometry(indent(), name, valueWidth, m_value->heightForWidth(valueWidth));
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
