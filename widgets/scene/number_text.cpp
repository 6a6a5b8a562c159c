#include "widgets/scene/number_text.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace halfspace {

std::string numberText(double number) {
  const double rounded = std::round(number * 1000) / 1000;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed;
  text.precision(3);
  text << (rounded == 0 ? 0.0 : rounded);
  std::string digits = text.str();
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.')
    digits.pop_back();
  return digits;
}

} // namespace halfspace
