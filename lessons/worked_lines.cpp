#include "lessons/worked_lines.h"

#include "lessons/words.h"

namespace halfspace {
namespace {

WorkingLine lineOf(LineWords &&line, std::string numbers, std::string result) {
  return {std::move(line.id), std::move(line.symbols), std::move(numbers), std::move(result),
          std::move(line.sentence)};
}

} // namespace

WorkingLine differenceLine(LineWords line, const ExactVec3 &to, const ExactVec3 &from,
                           const ExactVec3 &difference) {
  Formula f;
  std::string inserted = f.equals(f(to) + " - " + f(from));
  return lineOf(std::move(line), std::move(inserted), equalTo(difference));
}

WorkingLine dotLine(LineWords line, const ExactVec3 &a, const ExactVec3 &b, const Rational &product) {
  Formula f;
  std::string inserted = f.equals(f.products(a, b));
  WorkingLine worked = lineOf(std::move(line), std::move(inserted), equalTo(product));
  worked.blank = Blank{product};
  return worked;
}

WorkingLine shortDotLine(LineWords line, const ExactVec3 &a, const ExactVec3 &b, const Rational &product) {
  Formula f;
  std::string inserted = f.equals(f(a) + "\\cdot " + f(b));
  WorkingLine worked = lineOf(std::move(line), std::move(inserted), equalTo(product));
  worked.blank = Blank{product};
  return worked;
}

WorkingLine parameterLine(LineWords line, const Rational &numerator, const Rational &denominator,
                          const Rational &parameter) {
  Formula f;
  std::string inserted = f.equals(f.quotient(numerator, denominator));
  WorkingLine worked = lineOf(std::move(line), std::move(inserted), equalTo(parameter));
  worked.blank = fractionBlank(numerator, denominator);
  worked.blank->mistakes.push_back(
      {Rational(-parameter),
       parameter < 0 ? words("{answer} has lost its sign: numerator and denominator have different signs.")
                     : words("{answer} has the wrong sign: the numerator goes from the start to the plane, "
                             "P₀ minus the start.")});
  return worked;
}

WorkingLine pointLine(LineWords line, const ExactVec3 &start, const Rational &parameter,
                      const ExactVec3 &direction, const ExactVec3 &point) {
  Formula f;
  std::string inserted = f.equals(f(start) + " + " + f.factor(parameter) + f(direction));
  return lineOf(std::move(line), std::move(inserted), equalTo(point));
}

} // namespace halfspace
