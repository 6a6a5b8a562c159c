#include "lessons/language.h"

#include <algorithm>

namespace halfspace {
namespace {

Language &current() {
  static Language language;
  return language;
}

} // namespace

void setLanguage(Language language) { current() = std::move(language); }

const Language &language() { return current(); }

std::string withDecimalMark(std::string decimal) {
  std::replace(decimal.begin(), decimal.end(), '.', language().decimalMark);
  return decimal;
}

char listSeparator() { return language().decimalMark == ',' ? ';' : ','; }

} // namespace halfspace
