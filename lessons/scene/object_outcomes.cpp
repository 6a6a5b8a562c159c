#include "lessons/scene/object_outcomes.h"

#include "lessons/object/degenerate.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/scene/formula_names.h"

#include <set>
#include <utility>

namespace halfspace {
namespace {

template <class T> Lazy<T> nothing() {
  return Lazy<T>([] { return T(); });
}

/// The outcome of an object: itself, what is wrong with it, its picture, and the values that it has beyond
/// its coordinates.
std::shared_ptr<const Outcome> outcomeOf(const SharedGiven &given, Lazy<std::vector<NamedValue>> values,
                                         std::vector<Reach> reaches) {
  Lazy<CaseWords> told([given = given.get()] {
    std::string why = whyDegenerate(*given);
    return why.empty() ? CaseWords() : CaseWords{"degenerate", std::move(why), true};
  });
  return std::make_shared<const Outcome>(
      Outcome{{{"", given->object}},
              std::move(told),
              std::move(values),
              nothing<Explanation>(),
              Lazy<Figure>([given = given.get(), reaches = std::move(reaches)] {
                return Figure{given->object.kind().draw(*given), reaches};
              }),
              nothing<std::vector<SpecialCase>>(),
              nothing<Crossings>(),
              given});
}

/// The ids of the marks of an object's coordinates that are other objects: these have the letter beside them
/// already.
std::set<std::string> marksOfOthers(const Given<Object> &given, const DerivedObject &derived) {
  std::set<std::string> marks;
  const auto &specs = coordinatesOf(given.object);
  for (std::size_t i = 0; i < derived.coordinates.size(); ++i)
    if (derived.coordinates[i].kind == FormulaKind::Name && !specs[i].goesByObject())
      marks.insert(coordinateId(given.id, specs[i]));
  return marks;
}

} // namespace

std::shared_ptr<const Outcome> outcomeOfFree(const SharedGiven &given) {
  return outcomeOf(given, nothing<std::vector<NamedValue>>(), {});
}

std::shared_ptr<const Outcome> outcomeOfDerived(const SharedGiven &given, const DerivedObject &derived,
                                                const std::vector<Place> &places) {
  std::vector<Reach> reaches;
  reaches.reserve(places.size());
  for (const Place &place : places)
    reaches.push_back({given->id, place});
  Outcome outcome =
      *outcomeOf(given, Lazy<std::vector<NamedValue>>([given = given.get()] {
                   std::vector<NamedValue> values;
                   for (std::size_t i = 0; i < given->object.size(); ++i)
                     if (const std::string name = valueNameOf(given->object.kind(), i); !name.empty())
                       values.push_back(listed(name, coordinateTerm(*given, i)));
                   return values;
                 }),
                 {});
  outcome.figure = Lazy<Figure>(
      [given = given.get(), others = marksOfOthers(*given, derived), reaches = std::move(reaches)] {
        Figure figure{given->object.kind().draw(*given), reaches};
        for (std::size_t place = 0; place < figure.marks.size(); ++place)
          if (others.contains(baseOf(figure.marks[place]).id))
            figure.marks.change(place, [](Mark &mark) { baseOf(mark).label.clear(); });
        return figure;
      });
  return std::make_shared<const Outcome>(std::move(outcome));
}

std::shared_ptr<const Outcome> outcomeOfBound(const SharedGiven &given, const std::string &host) {
  return outcomeOf(given, Lazy<std::vector<NamedValue>>([given = given.get()] {
                     return std::vector{listed("at", coordinateTerm(*given, 0))};
                   }),
                   {{host, toDouble(given->object[0])}});
}

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

} // namespace halfspace
