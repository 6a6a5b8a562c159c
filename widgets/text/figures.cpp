#include "widgets/text/figures.h"

#include "lessons/language.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfspace {
namespace {

constexpr int mostDigitsBehind = 9;

/// A number as English has it, with the marks of the user's language: 1.234,5 for 1,234.5.
QString inUsersMarks(QString number) {
  if (language().decimalMark == ',')
    std::transform(number.begin(), number.end(), number.begin(), [](QChar each) {
      return each == ',' ? QChar('.') : each == '.' ? QChar(',') : each;
    });
  return number;
}

QString englishText(double value, int digits) {
  const int before = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
  const double unit = std::pow(10.0, before - digits);
  const double rounded = before > digits ? std::round(value / unit) * unit : value;
  QString text =
      QLocale(QLocale::English).toString(rounded, 'f', std::clamp(digits - before, 0, mostDigitsBehind));
  while (text.contains('.') && (text.endsWith('0') || text.endsWith('.')))
    text.chop(1);
  return text;
}

} // namespace

QString counted(std::size_t count) {
  return inUsersMarks(QLocale(QLocale::English).toString(static_cast<qulonglong>(count)));
}

int formOf(std::size_t count) {
  return static_cast<int>(std::min<std::size_t>(count, std::numeric_limits<int>::max()));
}

QString trianglesInWords(std::size_t count) {
  return count == 1 ? QCoreApplication::translate("figures", "1 triangle")
                    : QCoreApplication::translate("figures", "%1 triangles", nullptr, formOf(count))
                          .arg(counted(count));
}

QString roundedText(double value, int digits) { return inUsersMarks(englishText(value, digits)); }

QString measuredText(double value, int digits) {
  const QString text = englishText(value, digits);
  return (QLocale(QLocale::English).toDouble(text) == value ? "" : "≈ ") + inUsersMarks(text);
}

} // namespace halfspace
