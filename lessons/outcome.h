// What a scene comes to: values, worked lines, figure, and the case in plain words.
#pragma once

#include "geometry/surd.h"
#include "lessons/figure.h"
#include "lessons/working.h"

#include <string>
#include <variant>
#include <vector>

namespace halfspace {

struct NamedValue;

/// A value by its shape: a number, a list of numbers (a vector too), a word, an index, or a group of named
/// values.
using Value = std::variant<Surd, std::vector<Surd>, std::string, int, std::vector<NamedValue>>;

struct NamedValue {
  std::string name; ///< as in the eval format: signed_distance, foot, t, perp …
  std::string
      latex; ///< how a learner reads the name, `\mark{…}{…}` included; empty: not shown in the inspector
  Value value;
};

/// A value that stands in the worked lines: what the term comes to, an exact number or a list of them.
[[nodiscard]] NamedValue listed(std::string name, const Term &term);

struct Outcome {
  std::string caseName;           ///< hit, behind, parallel … : a word for programs
  std::vector<NamedValue> values; ///< those that have a meaning in the case
  Working working;
  Figure figure;
  std::string description; ///< the case in plain words
  bool degenerate = false; ///< the input has no answer of the usual kind: the description is a warning
};

} // namespace halfspace
