#include "lessons/scene/provenance.h"

#include "lessons/scene/evaluation.h"

#include <algorithm>
#include <map>
#include <unordered_set>

namespace halfspace {
namespace {

/// Whether a chain says how its first side is calculated, rather than comparing it or only what it comes to.
bool tellsItsFirstSide(const Chain &chain) {
  const TermKind kind = chain.sides().front()->kind;
  const bool isFormula = kind != TermKind::Name && kind != TermKind::Number && kind != TermKind::Unknown;
  return chain.isIdentity() && (isFormula || (kind == TermKind::Name && chain.symbolic() > 1));
}

class Follower {
public:
  explicit Follower(const Working &working) {
    for (const WorkingLine &line : working.lines)
      for (const Chain &chain : line.chains)
        if (tellsItsFirstSide(chain))
          m_told[entryOf(line.id)].push_back({&line, &chain});
  }

  /// Follows a term that stands in a line of an entry.
  void follow(const Term &term, const std::string &entry) {
    if (!m_seen.insert(term.operator->()).second)
      return; // two lines may tell each other
    addMark(term);
    if (term->source)
      return addCoordinate(term);
    if (term->origin)
      follow(*term->origin, entry);
    if (term->kind == TermKind::Number)
      return; // its parts are digits
    followLinesThatTell(term, term->mark.empty() ? entry : entryOf(term->mark));
    for (const Term &part : term->parts)
      follow(part, entry);
  }

  [[nodiscard]] Provenance take() { return std::move(m_found); }

private:
  struct Told {
    const WorkingLine *line;
    const Chain *chain;
  };

  void addMark(const Term &term) {
    if (!term->mark.empty())
      m_found.marks.insert(term->mark);
  }

  void addCoordinate(const Term &term) {
    auto &known = m_found.coordinates;
    if (std::find(known.begin(), known.end(), *term->source) == known.end())
      known.push_back(*term->source);
    if (term->origin) // a number: the name that it was put in for
      addMark(*term->origin);
  }

  void followLinesThatTell(const Term &term, const std::string &entry) {
    for (const Told &told : m_told[entry]) {
      const auto symbols = told.chain->symbols();
      if (!readAlike(symbols.front(), term))
        continue;
      m_found.lines.insert(told.line->id);
      for (const Term &side : symbols)
        follow(side, entry);
    }
  }

  std::map<std::string, std::vector<Told>> m_told; ///< by the entry whose lines they are
  std::unordered_set<const TermNode *> m_seen;
  Provenance m_found;
};

} // namespace

bool isTraceable(const Term &term) {
  return term->kind == TermKind::Number && (term->origin || term->source);
}

Provenance provenanceOf(const Term &number, const std::string &lineId, const Working &working) {
  Follower follower(working);
  follower.follow(number, entryOf(lineId));
  return follower.take();
}

std::optional<CoordinateId> coordinateOf(const Scene &scene, const CoordinateSource &source) {
  const Object *object = findObject(scene, source.object);
  if (!object || source.coordinate >= coordinatesOf(*object).size())
    return {};
  return CoordinateId{source.object, source.coordinate};
}

} // namespace halfspace
