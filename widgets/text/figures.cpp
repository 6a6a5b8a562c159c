#include "widgets/text/figures.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

constexpr int mostDigitsBehind = 9;

} // namespace

QString counted(std::size_t count) {
  return QLocale(QLocale::English).toString(static_cast<qulonglong>(count));
}

QString trianglesInWords(std::size_t count) {
  return count == 1 ? QCoreApplication::translate("figures", "1 triangle")
                    : QCoreApplication::translate("figures", "%1 triangles").arg(counted(count));
}

QString roundedText(double value, int digits) {
  const int before = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
  const double unit = std::pow(10.0, before - digits);
  const double rounded = before > digits ? std::round(value / unit) * unit : value;
  QString text =
      QLocale(QLocale::English).toString(rounded, 'f', std::clamp(digits - before, 0, mostDigitsBehind));
  while (text.contains('.') && (text.endsWith('0') || text.endsWith('.')))
    text.chop(1);
  return text;
}

} // namespace halfspace
