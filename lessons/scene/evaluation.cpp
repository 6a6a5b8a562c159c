#include "lessons/scene/evaluation.h"

#include "lessons/object/coordinate_limits.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/scene/scene_letters.h"
#include "lessons/scene/scene_looks.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>
#include <unordered_map>

namespace halfspace {
namespace {

using SharedGiven = std::shared_ptr<const Given<Object>>;

template <class T> Lazy<T> nothing() {
  return Lazy<T>([] { return T(); });
}

/// The outcome of an object: itself, its picture, and the values that it has beyond its coordinates.
std::shared_ptr<const Outcome> outcomeOf(const SharedGiven &given, Lazy<std::vector<NamedValue>> values,
                                         std::vector<Reach> reaches) {
  return std::make_shared<const Outcome>(
      Outcome{{{"", given->object}},
              nothing<CaseWords>(),
              std::move(values),
              nothing<Explanation>(),
              Lazy<Figure>([given = given.get(), reaches = std::move(reaches)] {
                return Figure{given->object.kind().draw(*given), reaches};
              }),
              nothing<std::vector<SpecialCase>>(),
              nothing<Crossings>(),
              given});
}

std::shared_ptr<const Outcome> outcomeOfFree(const SharedGiven &given) {
  return outcomeOf(given, nothing<std::vector<NamedValue>>(), {});
}

/// A bound object has a place besides its freedoms, up to which its host is drawn.
std::shared_ptr<const Outcome> outcomeOfBound(const SharedGiven &given, const std::string &host) {
  return outcomeOf(given, Lazy<std::vector<NamedValue>>([given = given.get()] {
                     return std::vector{listed("at", coordinateTerm(*given, 0))};
                   }),
                   {{host, toDouble(given->object[0])}});
}

/// The outcome of what cannot be told now, for a reason.
std::shared_ptr<const Outcome> withoutAnObject(const std::string &reason) {
  return std::make_shared<const Outcome>(Outcome{{},
                                                 Lazy<CaseWords>([reason] {
                                                   return CaseWords{"missing-object", reason, true};
                                                 }),
                                                 nothing<std::vector<NamedValue>>(),
                                                 nothing<Explanation>(),
                                                 nothing<Figure>(),
                                                 nothing<std::vector<SpecialCase>>(),
                                                 nothing<Crossings>(),
                                                 nullptr});
}

bool areSame(const std::vector<SharedGiven> &a, const std::vector<SharedGiven> &b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const SharedGiven &x, const SharedGiven &y) { return x == y || *x == *y; });
}

/// Evaluates one entry after the other.
class Evaluator {
public:
  Evaluator(const Scene &scene, const Evaluation &before) : m_letters(scene) {
    for (const EvaluatedEntry &entry : before.entries)
      m_old.emplace(entry.name, &entry);
    m_found.entries.reserve(scene.entries.size());
  }

  void add(const Entry &entry, const Look &look) {
    const auto *object = std::get_if<Object>(&entry.content);
    if (object && isBound(entry))
      addBound(entry, *object, look);
    else if (object)
      addObject(entry.name, *object, look);
    else
      addUse(entry, std::get<ConstructionUse>(entry.content));
  }

  [[nodiscard]] Evaluation take() { return std::move(m_found); }

private:
  /// What later entries can look at, and why it is not there in the present case; empty where it is.
  struct Visible {
    SharedGiven given;
    std::string whyNot{};
  };

  /// An object in its look.
  static SharedGiven shared(Given<Object> given, const Look &look) {
    given.look = look;
    return std::make_shared<const Given<Object>>(std::move(given));
  }

  void addObject(const std::string &name, const Object &object, const Look &look) {
    const auto given = shared(m_letters.given(name, object), look);
    EvaluatedEntry entry{name, {}, Naming{name}, {given}};
    if (!takeOver(entry))
      entry.outcome = outcomeOfFree(given);
    entry.own = entry.looksAt.front();
    m_visible[name] = {entry.looksAt.front()};
    m_found.entries.push_back(std::move(entry));
  }

  /// A bound object is the point where it lies.
  void addBound(const Entry &entry, const Object &object, const Look &look) {
    const auto host = m_visible.find(entry.on);
    if (host == m_visible.end() || kindOf(host->second.given->object) != object.kind().binding->host)
      return;
    const auto place = placeOn(object, host->second.given->object);
    const auto given = shared(m_letters.bound(entry.name, place.value_or(ExactVec3(0))), look);
    EvaluatedEntry found{entry.name, {}, Naming{entry.name}, {given, host->second.given}};
    found.missing =
        !host->second.whyNot.empty() ? host->second.whyNot
        : place
            ? whyTooLong(*given)
            : words("At the moment {host} has no place for {object}.",
                    {{"host", plainText(host->second.given->symbol)}, {"object", plainText(given->symbol)}});
    if (!takeOver(found))
      found.outcome =
          found.missing.empty() ? outcomeOfBound(given, entry.on) : withoutAnObject(found.missing);
    found.own = std::make_shared<const Given<Object>>(m_letters.freedoms(entry.name, object));
    m_visible[entry.name] = {found.looksAt.front(), found.missing};
    m_found.entries.push_back(std::move(found));
  }

  void addUse(const Entry &entry, const ConstructionUse &use) {
    const Construction *construction = findConstruction(use.id);
    if (!construction)
      return;
    EvaluatedEntry found{entry.name, use.id, m_letters.namingOf(entry), {}};
    for (const ConstructionRole &role : construction->roles) {
      const auto bound = use.roles.find(role.name);
      if (bound == use.roles.end() || !isCountOf(role, bound->second.ids.size()))
        return;
      for (const std::string &id : bound->second.ids) {
        const auto seen = m_visible.find(id);
        if (seen == m_visible.end() || seenKindOf(seen->second.given->object) != role.kind)
          return;
        found.looksAt.push_back(seen->second.given);
        if (found.missing.empty())
          found.missing = seen->second.whyNot;
      }
    }
    if (!takeOver(found))
      found.outcome = found.missing.empty() ? construction->evaluate(found.naming, found.looksAt)
                                            : withoutAnObject(found.missing);
    showMade(*construction, found);
    m_found.entries.push_back(std::move(found));
  }

  /// What the construction makes is there for later entries; what it does not make in its case, with the
  /// reason.
  void showMade(const Construction &construction, const EvaluatedEntry &entry) {
    const Outcome &outcome = *entry.outcome;
    for (const ConstructionRole &made : construction.makes) {
      const auto object = std::find_if(outcome.objects.begin(), outcome.objects.end(),
                                       [&](const MadeObject &each) { return each.name == made.name; });
      const bool isMade = object != outcome.objects.end();
      const auto given = std::make_shared<const Given<Object>>(
          m_letters.made(entry.name, made.name, isMade ? object->object : *makeObject(made.kind)));
      m_visible[entry.name + "." + made.name] = {given,
                                                 isMade ? whyTooLong(*given) : whyNotMade(*given, entry)};
    }
  }

  /// The case of what should have made it tells why it is not there.
  static std::string whyNotMade(const Given<Object> &made, const EvaluatedEntry &maker) {
    if (!maker.missing.empty())
      return maker.missing;
    return words("{why} So there is no {object} to go on with.",
                 {{"why", maker.outcome->told->description}, {"object", plainText(made.symbol)}});
  }

  static std::string whyTooLong(const Given<Object> &made) {
    if (!hasEndlessNumbers(made.object))
      return {};
    return words("The numbers of {object} are too long to go on with.", {{"object", plainText(made.symbol)}});
  }

  /// Takes the outcome over from before, where it was made from the same.
  bool takeOver(EvaluatedEntry &entry) const {
    const auto old = m_old.find(entry.name);
    if (old == m_old.end() || old->second->construction != entry.construction ||
        old->second->missing != entry.missing || !(old->second->naming == entry.naming) ||
        !areSame(old->second->looksAt, entry.looksAt))
      return false;
    entry.looksAt = old->second->looksAt;
    entry.outcome = old->second->outcome;
    return true;
  }

  SceneLetters m_letters;
  std::unordered_map<std::string_view, const EvaluatedEntry *> m_old;
  std::unordered_map<std::string, Visible> m_visible; ///< by id
  Evaluation m_found;
};

} // namespace

Evaluation evaluate(const Scene &scene, const Evaluation &before) {
  Evaluator evaluator(scene, before);
  const std::vector<Look> looks = looksOf(scene);
  for (std::size_t i = 0; i < scene.entries.size(); ++i)
    evaluator.add(scene.entries[i], looks[i]);
  return evaluator.take();
}

const EvaluatedEntry *Evaluation::find(std::string_view name) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const EvaluatedEntry &each) { return each.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

const EvaluatedEntry *Evaluation::lastConstruction() const {
  const auto found = std::find_if(entries.rbegin(), entries.rend(),
                                  [](const EvaluatedEntry &each) { return each.isConstruction(); });
  return found == entries.rend() ? nullptr : &*found;
}

const Crossings &crossingsOf(const Evaluation &evaluation, std::string_view entry) {
  static const Crossings none;
  const EvaluatedEntry *found = evaluation.find(entry);
  return found ? *found->outcome->crossings : none;
}

Figure figureOf(const Evaluation &evaluation) {
  Figure all;
  for (const EvaluatedEntry &entry : evaluation.entries) {
    const Figure &own = *entry.outcome->figure;
    all.marks.insert(all.marks.end(), own.marks.begin(), own.marks.end());
    all.reaches.insert(all.reaches.end(), own.reaches.begin(), own.reaches.end());
  }
  return reaching(std::move(all));
}

WorkingLine lineOf(const EvaluatedEntry &entry, const std::string &id) {
  WorkingLine line = *entry.outcome->explanation->find(id);
  line.id = entry.name + "." + id;
  return line;
}

std::string entryOf(const std::string &lineId) {
  const auto dot = lineId.find('.');
  return dot == std::string::npos ? std::string() : lineId.substr(0, dot);
}

Working workingOf(const Evaluation &evaluation) {
  Working working;
  for (const EvaluatedEntry &entry : evaluation.entries)
    for (const std::string &id : entry.outcome->explanation->ids())
      working.add(lineOf(entry, id));
  return working;
}

} // namespace halfspace
