#include "lessons/scene/evaluation.h"

#include "lessons/formula/plane_through.h"
#include "lessons/object/coordinate_limits.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/letters.h"
#include "lessons/scene/formula_names.h"
#include "lessons/scene/object_outcomes.h"
#include "lessons/scene/offered_objects.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Whether a role looks at what the object is, or at what it is seen as: a box, a solid, a point.
bool canStandIn(const ConstructionRole &role, const Object &object) {
  return role.kind == kindOf(object) || role.kind == seenKindOf(object);
}

/// The ids of what a construction makes in an entry.
std::vector<std::string> idsMadeIn(const Construction &construction, const std::string &entry) {
  std::vector<std::string> ids;
  for (const ConstructionRole &made : construction.makes)
    ids.push_back(entry + "." + made.name);
  return ids;
}

bool isOfResult(const MarkBase &mark, const std::vector<std::string> &made) {
  return mark.role == Role::Result || std::any_of(made.begin(), made.end(), [&](const std::string &id) {
           return mark.id == id || mark.id.starts_with(id + "."); // or a coordinate of it
         });
}

/// The outcome with its results in a look.
std::shared_ptr<const Outcome> inLookOf(const Look &look, std::shared_ptr<const Outcome> plain,
                                        std::vector<std::string> made) {
  if (!look.hue && !look.line)
    return plain;
  Outcome outcome = *plain;
  outcome.figure = Lazy<Figure>([look, plain = std::move(plain), made = std::move(made)] {
    Figure figure = *plain->figure;
    for (std::size_t place = 0; place < figure.marks.size(); ++place)
      if (isOfResult(baseOf(figure.marks[place]), made))
        figure.marks.change(place, [&](Mark &mark) {
          Look &own = baseOf(mark).look;
          own.hue = look.hue ? look.hue : own.hue;
          own.line = look.line ? look.line : own.line;
        });
    return figure;
  });
  return std::make_shared<const Outcome>(std::move(outcome));
}

/// With what the labels of its entry are to say.
Figure labelled(Figure figure, LabelText text) {
  for (std::size_t place = 0; place < figure.marks.size(); ++place)
    figure.marks.change(
        place, [&](Mark &mark) { text == LabelText::Name ? clearNumbers(mark) : writeCoordinates(mark); });
  return figure;
}

Figure withoutHiddenLabels(Figure figure, const LabelsByHand &labels) {
  for (std::size_t place = 0; place < figure.marks.size() && !labels.empty(); ++place)
    if (isLabelHidden(labels, baseOf(figure.marks[place]).id))
      figure.marks.change(place, [](Mark &mark) {
        clearNumbers(mark);
        baseOf(mark).label.clear();
      });
  return figure;
}

bool areSame(const std::vector<SharedGiven> &a, const std::vector<SharedGiven> &b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const SharedGiven &x, const SharedGiven &y) { return x == y || *x == *y; });
}

/// Evaluates one entry after the other. Where only numbers of objects have changed since before, the entries
/// that nothing of it concerns are not even looked at.
class Evaluator {
public:
  Evaluator(const Scene &scene, const Evaluation &before) : m_before(before) {
    const bool isPlanKept = before.plan && haveSamePlan(scene, before.scene);
    m_found.scene = scene;
    m_found.plan = isPlanKept ? before.plan : std::make_shared<const ScenePlan>(scene);
    // With a plan that has a place for all of them, each entry stands where it stood.
    m_isInPlace = isPlanKept && before.entries.size() == scene.entries.size();
  }

  [[nodiscard]] Evaluation evaluated() {
    if (m_isInPlace)
      evaluateTouched();
    else
      evaluateAll();
    return std::move(m_found);
  }

private:
  void evaluateAll() {
    for (std::size_t place = 0; place < m_found.scene.entries.size(); ++place)
      if (auto entry = evaluated(place))
        m_found.entries.push_back(std::move(*entry));
  }

  void evaluateTouched() {
    m_found.entries = m_before.entries;
    std::vector<bool> offersOthers(m_found.scene.entries.size());
    for (std::size_t place = 0; place < offersOthers.size(); ++place) {
      const std::vector<std::size_t> &lookedAt = m_found.plan->lookedAt[place];
      const bool isTouched =
          m_found.scene.entries.shared(place) != m_before.scene.entries.shared(place) ||
          std::any_of(lookedAt.begin(), lookedAt.end(), [&](std::size_t at) { return offersOthers[at]; });
      if (!isTouched)
        continue;
      EvaluatedEntry entry = evaluated(place).value();
      offersOthers[place] = !(entry.offers == m_before.entries[place].offers);
      m_found.entries.replace(place, std::move(entry));
    }
  }

  /// Nothing for an entry that is left out.
  [[nodiscard]] std::optional<EvaluatedEntry> evaluated(std::size_t place) const {
    const Entry &entry = m_found.scene.entries[place];
    const Look &look = m_found.plan->looks[place];
    if (const auto *use = std::get_if<ConstructionUse>(&entry.content))
      return evaluatedUse(entry, *use, look);
    if (const auto *derived = std::get_if<DerivedObject>(&entry.content))
      return evaluatedDerived(entry.name, *derived, look);
    const auto *object = std::get_if<Object>(&entry.content);
    return isBound(entry) ? evaluatedBound(entry, *object, look)
                          : std::optional(evaluatedObject(entry.name, *object, look));
  }

  [[nodiscard]] const SceneLetters &letters() const { return m_found.plan->letters; }

  /// An object in its look.
  static SharedGiven shared(Given<Object> given, const Look &look) {
    given.look = look;
    return std::make_shared<const Given<Object>>(std::move(given));
  }

  [[nodiscard]] EvaluatedEntry evaluatedObject(const std::string &name, const Object &object,
                                               const Look &look) const {
    const auto given = shared(letters().given(name, object), look);
    EvaluatedEntry entry{name, {}, Naming{name}, {given}};
    if (!takeOver(entry))
      entry.outcome = outcomeOfFree(given);
    entry.own = entry.looksAt.front();
    entry.offers = {{"", entry.looksAt.front()}};
    return entry;
  }

  /// An object whose coordinates follow others is what they come to.
  [[nodiscard]] std::optional<EvaluatedEntry>
  evaluatedDerived(const std::string &name, const DerivedObject &derived, const Look &look) const {
    Object object(*derived.kind);
    std::string missing; ///< why something that it follows is not there
    std::string fault;
    for (std::size_t index = 0; index < derived.coordinates.size(); ++index) {
      if (index == object.size())
        object.addVertex();
      auto value =
          valueOf(derived.coordinates[index], [&](std::string_view id) { return valueNamed(id, missing); });
      if (const auto *without = std::get_if<FormulaFault>(&value))
        fault = without->sentence;
      else
        setCoordinate(object, index, std::get<FormulaValue>(value));
    }
    Given<Object> made = letters().derived(name, withoutBounds(std::move(object)));
    takeLetters(derived, made);
    const auto given = shared(std::move(made), look);
    EvaluatedEntry found{name, {}, Naming{name}, {given}};
    found.missing = missing.empty() ? whyNotThere(*given, fault) : missing;
    if (found.missing.empty())
      found.along = placesAlong(derived);
    if (!takeOver(found))
      found.outcome = found.missing.empty() ? outcomeOfDerived(given, derived, found.along)
                                            : withoutAnObject(found.missing);
    found.offers = {{"", found.looksAt.front(), found.missing}};
    return found;
  }

  /// The points that a plane was laid through: it is drawn as far as them.
  [[nodiscard]] std::vector<Place> placesAlong(const DerivedObject &derived) const {
    std::vector<Place> places;
    const auto points =
        derived.kind->word == PlaneObject::kind ? pointsOfPlane(derived.coordinates) : std::nullopt;
    std::string missing;
    if (points)
      for (const Formula &point : *points)
        places.push_back(toDouble(std::get<ExactVec3>(std::get<FormulaValue>(
            valueOf(point, [&](std::string_view id) { return valueNamed(id, missing); })))));
    return places;
  }

  /// A coordinate that is another object's, or one of its coordinates, has that one's letter.
  void takeLetters(const DerivedObject &derived, Given<Object> &made) const {
    for (std::size_t i = 0; i < derived.coordinates.size(); ++i) {
      const Formula &formula = derived.coordinates[i];
      if (formula.kind != FormulaKind::Name || coordinatesOf(made.object)[i].goesByObject())
        continue;
      const auto place =
          coordinateNamed(formula.name, [&](std::string_view id) { return kindOfOffered(id); });
      if (place)
        made.letters[i] = findOffered(m_found, place->object)->given->letters[place->index];
    }
  }

  [[nodiscard]] const Kind *kindOfOffered(std::string_view id) const {
    const OfferedObject *object = findOffered(m_found, id);
    return object ? &object->given->object.kind() : nullptr;
  }

  /// What a name in a formula stands for; and why it is not there now, where it is not.
  [[nodiscard]] std::optional<FormulaValue> valueNamed(std::string_view name, std::string &whyNot) const {
    const auto place = coordinateNamed(name, [&](std::string_view id) { return kindOfOffered(id); });
    if (!place)
      return {};
    const OfferedObject *object = findOffered(m_found, place->object);
    if (!object->whyNot.empty()) {
      whyNot = object->whyNot;
      return {};
    }
    const ExactVec3 &value = object->given->object[place->index];
    return numbersIn(place->role) == 1 ? FormulaValue(value.x) : FormulaValue(value);
  }

  static void setCoordinate(Object &object, std::size_t index, const FormulaValue &value) {
    if (const auto *number = std::get_if<Rational>(&value))
      object[index].x = *number;
    else
      object[index] = std::get<ExactVec3>(value);
  }

  /// A number that follows others is what it is.
  static Object withoutBounds(Object object) {
    if (auto number = objectAs<NumberObject>(object)) {
      number->from = number->to = number->value;
      return *number;
    }
    return object;
  }

  /// `fault`: what keeps a formula from having a value; empty where all have one.
  static std::string whyNotThere(const Given<Object> &derived, std::string fault) {
    if (std::string tooLong = whyTooLong(derived); fault.empty() && !tooLong.empty())
      return tooLong;
    if (const auto unfitting = refuseUnfitting(derived.object); fault.empty() && unfitting)
      fault = unfitting->sentence;
    if (fault.empty())
      return {};
    return words("{object} is not there now. {why}", {{"object", plainText(derived.symbol)}, {"why", fault}});
  }

  /// A bound object is the point where it lies.
  [[nodiscard]] std::optional<EvaluatedEntry> evaluatedBound(const Entry &entry, const Object &object,
                                                             const Look &look) const {
    const OfferedObject *host = findOffered(m_found, entry.on);
    if (!host || kindOf(host->given->object) != object.kind().binding->host)
      return {};
    const auto place = placeOn(object, host->given->object);
    const auto given = shared(letters().bound(entry.name, place.value_or(ExactVec3(0))), look);
    EvaluatedEntry found{entry.name, {}, Naming{entry.name}, {given, host->given}};
    found.missing =
        !host->whyNot.empty() ? host->whyNot
        : place               ? whyTooLong(*given)
                              : words("At the moment {host} has no place for {object}.",
                                      {{"host", plainText(host->given->symbol)}, {"object", plainText(given->symbol)}});
    if (!takeOver(found))
      found.outcome =
          found.missing.empty() ? outcomeOfBound(given, entry.on) : withoutAnObject(found.missing);
    found.own = std::make_shared<const Given<Object>>(letters().freedoms(entry.name, object));
    found.offers = {{"", found.looksAt.front(), found.missing}};
    return found;
  }

  [[nodiscard]] std::optional<EvaluatedEntry> evaluatedUse(const Entry &entry, const ConstructionUse &use,
                                                           const Look &look) const {
    const Construction *construction = findConstruction(use.id);
    if (!construction)
      return {};
    EvaluatedEntry found{entry.name, use.id, letters().namingOf(entry), {}};
    found.look = look;
    for (const ConstructionRole &role : construction->roles) {
      const auto bound = use.roles.find(role.name);
      if (bound == use.roles.end() || !isCountOf(role, bound->second.ids.size()))
        return {};
      for (const std::string &id : bound->second.ids) {
        const OfferedObject *seen = findOffered(m_found, id);
        if (!seen || !canStandIn(role, seen->given->object))
          return {};
        found.looksAt.push_back(seen->given);
        if (found.missing.empty())
          found.missing = seen->whyNot;
      }
    }
    if (!takeOver(found)) {
      found.outcome = found.missing.empty()
                          ? inLookOf(look, construction->evaluate(found.naming, found.looksAt),
                                     idsMadeIn(*construction, entry.name))
                          : withoutAnObject(found.missing);
      found.offers = offersOf(*construction, found);
    }
    return found;
  }

  /// What the construction makes is there for later entries; what it does not make in its case, with the
  /// reason.
  [[nodiscard]] std::vector<OfferedObject> offersOf(const Construction &construction,
                                                    const EvaluatedEntry &entry) const {
    std::vector<OfferedObject> offers;
    const Outcome &outcome = *entry.outcome;
    for (const ConstructionRole &made : construction.makes) {
      const auto object = std::find_if(outcome.objects.begin(), outcome.objects.end(),
                                       [&](const MadeObject &each) { return each.name == made.name; });
      const bool isMade = object != outcome.objects.end();
      const auto given =
          shared(letters().made(entry.name, made.name, isMade ? object->object : *makeObject(made.kind)),
                 entry.look);
      std::string whyNot = isMade ? whyTooLong(*given) : whyNotMade(*given, entry);
      offers.push_back({made.name, given, std::move(whyNot)});
    }
    return offers;
  }

  /// The case of what should have made it tells why it is not there.
  static std::string whyNotMade(const Given<Object> &made, const EvaluatedEntry &maker) {
    if (!maker.missing.empty())
      return maker.missing;
    if (!maker.outcome->told->degenerate && findMark(*maker.outcome->figure, made.id))
      return words("The numbers of {object} are no fractions: nothing can be made of it.",
                   {{"object", plainText(made.symbol)}});
    return words("{why} So there is no {object} to go on with.",
                 {{"why", maker.outcome->told->description}, {"object", plainText(made.symbol)}});
  }

  static std::string whyTooLong(const Given<Object> &made) {
    if (!hasEndlessNumbers(made.object))
      return {};
    return words("The numbers of {object} are too long to go on with.", {{"object", plainText(made.symbol)}});
  }

  /// Takes over what was made of the same before.
  bool takeOver(EvaluatedEntry &entry) const {
    const EvaluatedEntry *old = m_before.find(entry.name);
    if (!old || old->construction != entry.construction || old->missing != entry.missing ||
        !(old->naming == entry.naming) || old->look != entry.look || old->along != entry.along ||
        !areSame(old->looksAt, entry.looksAt))
      return false;
    entry.looksAt = old->looksAt;
    entry.outcome = old->outcome;
    entry.offers = old->offers;
    return true;
  }

  const Evaluation &m_before;
  Evaluation m_found;
  bool m_isInPlace = false;
};

} // namespace

bool isOfResult(const MarkBase &mark, const EvaluatedEntry &entry) {
  const Construction *construction = findConstruction(entry.construction);
  return construction && isOfResult(mark, idsMadeIn(*construction, entry.name));
}

Evaluation evaluate(const Scene &scene, const Evaluation &before) {
  return Evaluator(scene, before).evaluated();
}

const EvaluatedEntry *Evaluation::find(std::string_view name) const { return entries.find(name); }

const EvaluatedEntry *Evaluation::lastConstruction() const {
  for (std::size_t place = entries.size(); place-- > 0;)
    if (entries[place].isConstruction())
      return &entries[place];
  return nullptr;
}

const Crossings &crossingsOf(const Evaluation &evaluation, std::string_view entry) {
  static const Crossings none;
  const EvaluatedEntry *found = evaluation.find(entry);
  return found ? *found->outcome->crossings : none;
}

Figure figureOf(const Evaluation &evaluation) {
  Figure all;
  for (const EvaluatedEntry &entry : evaluation.entries) {
    const Entry &said = *evaluation.scene.entries.find(entry.name);
    if (said.isHidden)
      continue;
    const Figure &own = *entry.outcome->figure;
    all.marks.append(said.label ? labelled(own, *said.label).marks : own.marks);
    all.reaches.insert(all.reaches.end(), own.reaches.begin(), own.reaches.end());
  }
  return withoutHiddenLabels(reaching(std::move(all)), evaluation.scene.labels);
}

WorkingLine lineOf(const EvaluatedEntry &entry, const std::string &id) {
  WorkingLine line = *entry.outcome->explanation->find(id);
  line.id = entry.name + "." + id;
  return line;
}

std::string entryOf(const std::string &lineId) { return std::string(qualified(lineId).entry); }

Working workingOf(const Evaluation &evaluation) {
  Working working;
  for (const EvaluatedEntry &entry : evaluation.entries)
    for (const std::string &id : entry.outcome->explanation->ids())
      working.add(lineOf(entry, id));
  return working;
}

} // namespace halfspace
