// What an entry of a scene comes to: objects, values, worked lines, figure, and the case in plain words.
#pragma once

#include "geometry/surd.h"
#include "lessons/construction/crossings.h"
#include "lessons/construction/explanation.h"
#include "lessons/construction/special_case.h"
#include "lessons/figure/figure.h"
#include "lessons/lazy.h"
#include "lessons/object/object.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace halfspace {

struct NamedValue;

struct Word {
  std::string name; ///< for programs, as in the eval format: in-plane
  std::string read; ///< as learners read it: “in the plane”, in their language
};

/// A value by its shape: a number, a list of numbers (a vector too), a word, an index, or a group of named
/// values.
using Value = std::variant<Surd, std::vector<Surd>, Word, int, std::vector<NamedValue>>;

struct NamedValue {
  std::string name; ///< as in the eval format: signed_distance, foot, t, perp …
  /// How a learner reads the name: a term of the worked lines, or words; nothing for what is for programs
  /// only.
  std::variant<std::monostate, Term, std::string> label;
  Value value;
};

/// The name of a value as a learner reads it, in plain text; empty for what is for programs only.
[[nodiscard]] std::string readName(const NamedValue &value);

/// A number or a list of numbers as a term; nothing for words and groups.
[[nodiscard]] std::optional<Term> termOf(const Value &value);

/// A value that stands in the worked lines: what the term comes to, an exact number or a list of them.
[[nodiscard]] NamedValue listed(std::string name, const Term &term);

/// The case of an outcome.
struct CaseWords {
  std::string name;          ///< hit, behind, parallel … : a word for programs; empty for a sound object
  std::string description{}; ///< the case in plain words
  bool degenerate = false;   ///< the input has no answer of the usual kind: the description is a warning
};

/// An object that an entry has for the entries below it.
struct MadeObject {
  std::string name; ///< its own within the entry: F; empty for the object that the entry itself is
  Object object;
};

/// What one entry comes to. Only the objects are there at once; all else is made when it is looked at.
struct Outcome {
  std::vector<MadeObject> objects; ///< those that are there in the case
  Lazy<CaseWords> told;
  Lazy<std::vector<NamedValue>> values;  ///< those that have a meaning in the case
  Lazy<Explanation> explanation;         ///< empty for an object
  Lazy<Figure> figure;                   ///< the entry's own marks
  Lazy<std::vector<SpecialCase>> nearby; ///< the special cases near the present input
  Lazy<Crossings> crossings; ///< of a ray with many triangles; none where it is about something else
  std::shared_ptr<const void> computed; ///< what the others are made from
};

} // namespace halfspace
