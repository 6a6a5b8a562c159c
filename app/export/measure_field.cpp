#include "app/export/measure_field.h"

#include "widgets/text/figures.h"

namespace halfspace {
namespace {

constexpr int digitsBehind = 2;
constexpr int mostDigits = 3 + digitsBehind;

} // namespace

MeasureField::MeasureField(const QString &unit, double least, double most, double step) {
  setDecimals(digitsBehind);
  setRange(least, most);
  setSingleStep(step);
  setSuffix(unit);
}

QString MeasureField::textFromValue(double value) const { return roundedText(value, mostDigits); }

double MeasureField::valueFromText(const QString &text) const { return numberIn(text).toDouble(); }

QValidator::State MeasureField::validate(QString &text, int & /*place*/) const {
  bool isNumber = false;
  const double value = numberIn(text).toDouble(&isNumber);
  if (!isNumber)
    return numberIn(text).isEmpty() ? QValidator::Intermediate : QValidator::Invalid;
  return value >= minimum() && value <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

QString MeasureField::numberIn(const QString &text) const {
  QString number = text;
  if (number.endsWith(suffix()))
    number.chop(suffix().size());
  return number.trimmed().replace(',', '.');
}

} // namespace halfspace
