#include "lessons/term/slips.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Something that may stand in a term's place.
struct Replacement {
  Slip slip;
  Term instead;
};

bool isDifference(const Term &term) {
  return term->kind == TermKind::Sum && term->parts.size() == 2 && term->parts[1]->kind == TermKind::Negation;
}

bool isLeaf(const Term &term) { return term->parts.empty() || term->kind == TermKind::Number; }

bool isNegative(const Term &term) {
  const Real *number = numberOf(term);
  return number && sign(*number) == -1;
}

/// v·v
bool isSquare(const Term &term) {
  return term->kind == TermKind::Dot && readAlike(term->parts[0], term->parts[1]);
}

void addOfSum(const Term &term, std::vector<Replacement> &found) {
  if (isDifference(term)) {
    const Term &to = term->parts[0];
    const Term &from = term->parts[1]->parts[0];
    if (!readAlike(from, to)) // v − v is the same reversed
      found.push_back({Slip::ReversedDifference, from - to});
    found.push_back({Slip::AddedInstead, to + from});
  }
  for (std::size_t i = 0; i < term->parts.size(); ++i) {
    if (i > 0 && term->parts[i]->kind != TermKind::Negation) {
      std::vector<Term> parts = term->parts;
      parts[i] = -parts[i];
      found.push_back({Slip::SubtractedInstead, sum(std::move(parts))});
    }
    std::vector<Term> rest = term->parts;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    found.push_back({Slip::DroppedPart, rest.size() == 1 ? rest.front() : sum(std::move(rest))});
  }
}

std::vector<Replacement> replacementsOf(const Term &term) {
  std::vector<Replacement> found;
  switch (term->kind) {
  case TermKind::Sum:
    addOfSum(term, found);
    break;
  case TermKind::Quotient:
    found.push_back({Slip::UpsideDown, term->parts[1] / term->parts[0]});
    found.push_back({Slip::Undivided, term->parts[0]});
    if (isSquare(term->parts[1]))
      found.push_back({Slip::RootOfDivisor, term->parts[0] / root(term->parts[1])});
    break;
  case TermKind::Root:
    found.push_back({Slip::NoRoot, term->parts[0]});
    break;
  case TermKind::Norm:
    found.push_back({Slip::NoRoot, dot(term->parts[0], term->parts[0])});
    break;
  case TermKind::Power:
    found.push_back({Slip::NotSquared, term->parts[0]});
    break;
  case TermKind::Negation:
    found.push_back({Slip::LostSign, term->parts[0]});
    break;
  default:
    if (isLeaf(term) && isNegative(term))
      found.push_back({Slip::LostSign, -term});
    break;
  }
  return found;
}

bool isName(const Term &term) { return term->kind == TermKind::Name || term->kind == TermKind::Applied; }

/// Walks through a term and tries every replacement in every place.
class WrongWayFinder {
public:
  explicit WrongWayFinder(const Term &term) : m_names(namesIn(term)) {}

  /// The wrong ways of a part: `whole` there is the part with the slip.
  [[nodiscard]] std::vector<WrongWay> in(const Term &term) const {
    std::vector<WrongWay> found;
    for (const Replacement &each : replacementsOf(term))
      found.push_back({each.slip, each.instead, term, each.instead});
    if (isName(term))
      addOtherNames(term, found);
    if (term->kind == TermKind::Applied || isLeaf(term))
      return found;
    for (std::size_t i = 0; i < term->parts.size(); ++i)
      for (WrongWay &way : in(term->parts[i])) {
        std::vector<Term> parts = term->parts;
        parts[i] = way.whole;
        way.whole = withParts(term, std::move(parts));
        found.push_back(std::move(way));
      }
    return found;
  }

private:
  void addOtherNames(const Term &term, std::vector<WrongWay> &found) const {
    for (const Term &other : m_names)
      if (other->value && term->value && other->value->isList == term->value->isList &&
          !readAlike(other, term))
        found.push_back({Slip::OtherName, other, term, other});
  }

  std::vector<Term> m_names;
};

} // namespace

std::vector<WrongWay> wrongWays(const Term &term) {
  std::vector<WrongWay> ways = WrongWayFinder(term).in(term);
  std::stable_sort(ways.begin(), ways.end(),
                   [](const WrongWay &a, const WrongWay &b) { return a.slip < b.slip; });
  return ways;
}

} // namespace halfspace
