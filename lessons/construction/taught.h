// What a file of taught/ is written with, and how it describes its construction: tables of what it makes, of
// its values and of its worked lines, each row with its name, the cases in which it stands, and what it is.
// The names of all that the construction can come to follow from the tables, and so does what each case has
// of them.
#pragma once

#include "lessons/construction/construction.h"
#include "lessons/construction/parts/name_rows.h"
#include "lessons/construction/parts/own_names.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/construction/parts/zero_vectors.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/letters.h"
#include "lessons/sentence.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <utility>

namespace halfspace {

/// In which cases something stands.
template <class Out> using When = std::function<bool(const Out &)>;
inline constexpr auto always = [](const auto & /*at*/) { return true; };

/// An object that later entries can look at.
template <class Out> struct MadeRow {
  MadeRow(std::string object, std::string_view of, When<Out> when, std::function<Object(const Out &)> making)
      : name(std::move(object)), kind(of), stands(std::move(when)), make(std::move(making)) {}
  /// A point, by its letter.
  MadeRow(std::string object, When<Out> when, Term Out::*point)
      : MadeRow(std::move(object), PointObject::kind, std::move(when),
                [point](const Out &at) { return PointObject{vectorOf(at.*point)}; }) {}

  std::string name;
  std::string_view kind;
  When<Out> stands;
  std::function<Object(const Out &)> make;
};

/// A value in a case, with how a learner reads its name.
struct ToldValue {
  /// What stands in the worked lines goes by its term.
  ToldValue(const Term &term) : label(term), value(listed({}, term).value) {}
  /// What is for programs only has no label.
  ToldValue(Value unlabelled) : value(std::move(unlabelled)) {}
  ToldValue(std::variant<std::monostate, Term, std::string> read, Value shown)
      : label(std::move(read)), value(std::move(shown)) {}

  std::variant<std::monostate, Term, std::string> label;
  Value value;
};

/// A value, by the name that the eval format has for it.
template <class Out> struct ValueRow {
  ValueName name;
  When<Out> stands;
  std::function<ToldValue(const Out &)> tell;
};
template <class Out> using ValueTable = std::vector<ValueRow<Out>>;

/// The names of all that a table can come to, and those values that a case has.
template <class Out> [[nodiscard]] std::vector<ValueName> valueNames(const ValueTable<Out> &table) {
  std::vector<ValueName> names;
  for (const ValueRow<Out> &row : table)
    names.push_back(row.name);
  return names;
}
template <class Out>
[[nodiscard]] std::vector<NamedValue> valuesIn(const ValueTable<Out> &table, const Out &at) {
  std::vector<NamedValue> values;
  for (const ValueRow<Out> &row : table)
    if (row.stands(at)) {
      ToldValue told = row.tell(at);
      values.push_back({row.name.name, std::move(told.label), std::move(told.value)});
    }
  return values;
}

/// Values under one name, which is for programs only.
template <class Out>
[[nodiscard]] ValueRow<Out> valueGroup(const std::string &name, When<Out> stands, ValueTable<Out> members) {
  return {named::group(name, valueNames(members)), std::move(stands),
          [members](const Out &at) { return ToldValue(Value(valuesIn(members, at))); }};
}

/// A worked line.
template <class Out> struct LineRow {
  LineRow(std::string line, When<Out> when, std::function<WorkingLine(const Out &)> making)
      : id(std::move(line)), stands(std::move(when)), make(std::move(making)) {}
  /// A formula whose result a learner is to find, with its sentence: one, which has the letters of the
  /// construction, or one of several.
  LineRow(std::string line, When<Out> when, std::function<Chain(const Out &)> formula, Sentence sentence)
      : LineRow(std::move(line), std::move(when), std::move(formula),
                [sentence](const Out &at) { return words(sentence.english, at.letters); }) {}
  LineRow(std::string line, When<Out> when, std::function<Chain(const Out &)> formula,
          std::function<std::string(const Out &)> sentence)
      : LineRow(std::move(line), std::move(when),
                [formula = std::move(formula), sentence = std::move(sentence)](const Out &at) {
                  return asked(formula(at), sentence(at));
                }) {}

  std::string id;
  When<Out> stands;
  std::function<WorkingLine(const Out &)> make;
};
template <class Out> using LineTable = std::vector<LineRow<Out>>;

/// Whether a case has the thing with this place among several.
template <class Out> using HasPlace = std::function<bool(const Out &, std::size_t)>;

/// A worked line of each of several things, whose number follows the word.
template <class Out> struct NumberedLine {
  std::string word;
  std::function<WorkingLine(const Out &, std::size_t)> make;
  HasPlace<Out> stands{}; ///< where not everything that is there has the line
};

/// The lines of things counted from `first`, one thing after the other: of those that a case has.
template <class Out>
[[nodiscard]] LineTable<Out> linesOfEach(std::size_t most, const HasPlace<Out> &has,
                                         const std::vector<NumberedLine<Out>> &lines, std::size_t first = 0) {
  LineTable<Out> table;
  for (std::size_t i = 0; i < most; ++i)
    for (const NumberedLine<Out> &line : lines)
      table.push_back({line.word + std::to_string(first + i),
                       [stands = line.stands ? line.stands : has, i](const Out &at) { return stands(at, i); },
                       [make = line.make, i](const Out &at) { return make(at, i); }});
  return table;
}

/// A construction as its file describes it. Everything but Out and what it makes is asked for only when
/// somebody looks at it.
template <class Out> struct Teaching {
  std::string_view id;
  std::string_view
      word{}; ///< by which it is asked for, where it is one of several for that; empty: its id alone
  std::string (*title)();         ///< what comes of it, in few words
  std::vector<std::string> roles; ///< in the order of In
  std::vector<MadeRow<Out>> makes{};
  std::vector<std::string> letters{}; ///< its own
  std::vector<std::string> cases;
  ValueTable<Out> values;
  LineTable<Out> lines;
  std::vector<std::string> marks; ///< its own, without those that accompany another
  std::function<CaseWords(const Out &)> tell;
  std::function<Figure(const Out &)> draw;
  /// The nearest special cases, one change of one object each; none that holds already.
  std::function<std::vector<SpecialCase>(const Out &)> nearby{};
  /// Of a construction that looks at a ray and many triangles.
  std::function<Crossings(const Out &)> cross{};
};

namespace detail {

/// How the objects of a role are taken from the front of those that are left; `listed` are in a list.
template <class Kind> struct RoleOf {
  static constexpr std::string_view kind = Kind::kind;
  static constexpr bool isList = false;
  static Given<Kind> take(GivenObjects &left, std::size_t /*listed*/) {
    const auto &first = *left.front();
    left = left.subspan(1);
    return as<Kind>(first);
  }
};
template <class Kind> struct RoleOf<Several<Kind>> {
  static constexpr std::string_view kind = Kind::kind;
  static constexpr bool isList = true;
  static std::vector<Given<Kind>> take(GivenObjects &left, std::size_t listed) {
    std::vector<Given<Kind>> all;
    for (const auto &object : left.first(listed))
      all.push_back(as<Kind>(*object));
    left = left.subspan(listed);
    return all;
  }
};

template <class Out>
[[nodiscard]] std::vector<MadeObject> madeIn(const Teaching<Out> &teaching, const Out &at) {
  std::vector<MadeObject> made;
  for (const MadeRow<Out> &row : teaching.makes)
    if (row.stands(at))
      made.push_back({row.name, row.make(at)});
  return made;
}

template <class Out> [[nodiscard]] Explanation explained(const Teaching<Out> &teaching, const Out &at) {
  Explanation lines;
  for (const LineRow<Out> &row : teaching.lines)
    if (row.stands(at))
      lines.add(row.id, [make = row.make, &at] { return make(at); });
  return lines;
}

template <class Out> [[nodiscard]] ConstructionNames namesOf(const Teaching<Out> &teaching) {
  ConstructionNames names{teaching.cases, valueNames(teaching.values), {}, teaching.marks};
  for (const LineRow<Out> &row : teaching.lines)
    names.lines.push_back(row.id);
  return names;
}

} // namespace detail

/// The construction that a file teaches. Kinds are those of the roles, in their order.
template <class Out, class... Kinds> [[nodiscard]] Construction taught(Teaching<Out> described) {
  using In = std::remove_cvref_t<decltype(std::declval<Out &>().in)>;
  struct Both {
    explicit Both(In objects) : in(std::move(objects)), out(in) {}
    In in;
    Out out; // refers to the objects beside it
  };
  const auto teaching = std::make_shared<const Teaching<Out>>(std::move(described));
  Construction construction{teaching->id,
                            teaching->word,
                            teaching->title,
                            {},
                            {},
                            teaching->letters,
                            detail::namesOf(*teaching),
                            static_cast<bool>(teaching->cross),
                            {}};
  std::size_t next = 0;
  (construction.roles.push_back(
       {teaching->roles.at(next++), detail::RoleOf<Kinds>::kind, detail::RoleOf<Kinds>::isList}),
   ...);
  for (const MadeRow<Out> &row : teaching->makes)
    construction.makes.push_back({row.name, row.kind});
  construction.evaluate = [teaching, roles = construction.roles](Naming naming, GivenObjects objects) {
    GivenObjects left = objects;
    const std::size_t listed = objects.size() + 1 - sizeof...(Kinds);
    const auto both = std::make_shared<const Both>(
        In{withLetters(std::move(naming), roles, objects), detail::RoleOf<Kinds>::take(left, listed)...});
    // What is made later may refer to both: the outcome holds them.
    const auto later = [&](auto make) {
      return [teaching, &at = both->out, make] { return make(*teaching, at); };
    };
    using Described = const Teaching<Out> &;
    return std::make_shared<const Outcome>(Outcome{
        detail::madeIn(*teaching, both->out),
        Lazy<CaseWords>(later([](Described by, const Out &at) { return by.tell(at); })),
        Lazy<std::vector<NamedValue>>(
            later([](Described by, const Out &at) { return valuesIn(by.values, at); })),
        Lazy<Explanation>(later([](Described by, const Out &at) { return detail::explained(by, at); })),
        Lazy<Figure>(later([](Described by, const Out &at) { return by.draw(at); })),
        Lazy<std::vector<SpecialCase>>(later([](Described by, const Out &at) {
          return by.nearby ? by.nearby(at) : std::vector<SpecialCase>();
        })),
        Lazy<Crossings>(
            later([](Described by, const Out &at) { return by.cross ? by.cross(at) : Crossings(); })),
        both});
  };
  return construction;
}

} // namespace halfspace
