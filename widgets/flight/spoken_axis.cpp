#include "widgets/flight/spoken_axis.h"

namespace halfspace {

QString SpokenAxis::text(QAccessible::Text text) const {
  if (text == QAccessible::Value)
    return m_axis.readout();
  return text == QAccessible::Description ? m_axis.spokenCrossings().join("; ")
                                          : QAccessibleWidget::text(text);
}

void *SpokenAxis::interface_cast(QAccessible::InterfaceType type) {
  if (type == QAccessible::ValueInterface)
    return static_cast<QAccessibleValueInterface *>(this);
  return QAccessibleWidget::interface_cast(type);
}

} // namespace halfspace
