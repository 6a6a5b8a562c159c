#include "lessons/term/term_shape.h"

#include <algorithm>
#include <string>

namespace halfspace {

const Term &shown(const Term &term) { return term->kind == TermKind::Number ? term->parts[0] : term; }

bool isCompound(const Term &term) {
  const Term &looked = shown(term);
  if (looked->kind == TermKind::Negation)
    return isCompound(looked->parts[0]);
  return looked->kind != TermKind::Digits && looked->kind != TermKind::Name &&
         looked->kind != TermKind::Unknown;
}

bool isTall(const Term &term) {
  const Term &looked = shown(term);
  switch (looked->kind) {
  case TermKind::Quotient:
  case TermKind::List:
  case TermKind::Root:
  case TermKind::Matrix:
  case TermKind::Determinant:
    return true;
  default:
    return std::any_of(looked->parts.begin(), looked->parts.end(), isTall);
  }
}

bool isAsHighAsNumbers(const Term &term) {
  const Term &looked = shown(term);
  if (!isTall(looked) || isWrittenInDigits(looked))
    return true;
  switch (looked->kind) {
  case TermKind::Negation:
  case TermKind::Sum:
  case TermKind::Product:
  case TermKind::Dot:
  case TermKind::Cross:
    return std::all_of(looked->parts.begin(), looked->parts.end(), isAsHighAsNumbers);
  default:
    return false;
  }
}

bool isWrittenInDigits(const Term &term) {
  const Term &bare = shown(term)->kind == TermKind::Negation ? shown(term)->parts[0] : term;
  const auto isDigits = [](const Term &each) { return shown(each)->kind == TermKind::Digits; };
  return isDigits(bare) || (shown(bare)->kind == TermKind::Quotient &&
                            std::all_of(shown(bare)->parts.begin(), shown(bare)->parts.end(), isDigits));
}

bool isNumeral(const Term &term) { return term->kind == TermKind::Number || term->kind == TermKind::Digits; }

bool isInteger(const Term &number) {
  const Term &looked = shown(number);
  return looked->kind == TermKind::Digits && looked->digits.find('.') == std::string::npos;
}

bool isNumeric(const Term &term) {
  switch (term->kind) {
  case TermKind::Number:
    return true;
  case TermKind::Power:
  case TermKind::Quotient:
    return std::all_of(term->parts.begin(), term->parts.end(), isNumeric);
  default:
    return false;
  }
}

bool isRoundedOne(const Term &factor) {
  const Term &looked = shown(factor);
  return looked->kind == TermKind::Digits && looked->digits == "1" && factor->isRounded;
}

bool isOfRoots(const Term &term) {
  const Term &looked = shown(term);
  const auto isDigitsOrRoot = [](const Term &each) {
    return shown(each)->kind == TermKind::Digits || shown(each)->kind == TermKind::Root;
  };
  return looked->kind == TermKind::Root ||
         (looked->kind == TermKind::Product &&
          std::all_of(looked->parts.begin(), looked->parts.end(), isDigitsOrRoot));
}

bool isWordBeforeName(const Term &term) {
  return term->symbol.isWord && term->parts[0]->kind == TermKind::Name;
}

bool isOfList(const Term &application) { return application->parts[0]->kind == TermKind::List; }

bool hasUnknown(const std::vector<Term> &summands) {
  return std::any_of(summands.begin(), summands.end(), [](const Term &summand) {
    const Term &looked = shown(summand);
    const Term &bare = looked->kind == TermKind::Negation ? shown(looked->parts[0]) : looked;
    const Term &last = bare->kind == TermKind::Product ? bare->parts.back() : bare;
    return last->kind == TermKind::Unknown;
  });
}

bool standDotted(const Term &left, const Term &right) {
  const bool powerOfTen = left->kind == TermKind::Digits && right->kind == TermKind::Power;
  return powerOfTen || (isNumeric(left) && isNumeric(right));
}

} // namespace halfspace
