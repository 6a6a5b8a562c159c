// What a screen reader is told of a flight's axis.
#pragma once

#include "widgets/flight/flight_axis.h"

#include <QAccessibleWidget>

namespace halfspace {

/// A slider whose value is where the torpedo is, described by what the ray crosses. Made when it is asked
/// for.
class SpokenAxis : public QAccessibleWidget, public QAccessibleValueInterface {
public:
  explicit SpokenAxis(FlightAxis &axis) : QAccessibleWidget(&axis, QAccessible::Slider), m_axis(axis) {}

  [[nodiscard]] QString text(QAccessible::Text text) const override;
  void *interface_cast(QAccessible::InterfaceType type) override;

  [[nodiscard]] QVariant currentValue() const override { return m_axis.placed().time(); }
  void setCurrentValue(const QVariant &value) override { m_axis.moveTo(value.toDouble()); }
  [[nodiscard]] QVariant minimumValue() const override { return m_axis.placed().scale().range.low; }
  [[nodiscard]] QVariant maximumValue() const override { return m_axis.placed().scale().range.high; }
  [[nodiscard]] QVariant minimumStepSize() const override { return {}; }

private:
  FlightAxis &m_axis;
};

} // namespace halfspace
