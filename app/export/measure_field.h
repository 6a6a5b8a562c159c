// A field for a length.
#pragma once

#include <QDoubleSpinBox>

namespace halfspace {

/// Shows its number as short as it is, with the decimal mark of the user's language; a point and a comma are
/// both read as one. For numbers below a thousand.
class MeasureField : public QDoubleSpinBox {
  Q_OBJECT
public:
  MeasureField(const QString &unit, double least, double most, double step);

  [[nodiscard]] QString textFromValue(double value) const override;
  [[nodiscard]] double valueFromText(const QString &text) const override;
  [[nodiscard]] QValidator::State validate(QString &text, int &place) const override;

private:
  /// What is typed, without the unit.
  [[nodiscard]] QString numberIn(const QString &text) const;
};

} // namespace halfspace
