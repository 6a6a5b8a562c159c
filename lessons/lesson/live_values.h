// Values among the words of a lesson: `{f}` stands for what f comes to.
#pragma once

#include "lessons/scene/offered_objects.h"
#include "lessons/term/term.h"

#include <functional>
#include <optional>
#include <string>
#include <variant>

namespace halfspace {

/// Whether the learner sees what constructions come to, or is still to find it.
enum class LiveValues { Shown, Hidden };

/// A number or a list as sentences have it. A rounded one is written with ≈ before it.
struct LiveNumber {
  Term term;
  std::optional<Term> size{}; ///< how large a root is, which nobody sees by looking at it: ≈ 7.348

  /// Whether both look the same on the page.
  bool operator==(const LiveNumber &other) const;
};

/// A word stands for what is no number.
using LiveValue = std::variant<std::string, LiveNumber>;

/// What a name stands for: a value, or coordinates of the scene as `Q` and `E.n`; a question mark for a value
/// while those are hidden, and a dash for one that the case does not have.
[[nodiscard]] LiveValue liveValue(const std::string &name, const Scene &scene, const Evaluation &evaluation,
                                  LiveValues values = LiveValues::Shown);

/// The coordinate of an object that a construction makes: `distance.F`, or F where one entry alone makes an
/// F. Nothing for other names, and for what is not there now.
[[nodiscard]] std::optional<CoordinateValue> valueMade(const std::string &name, const Evaluation &evaluation);

/// All names that have a value at present, each once: of the scene's coordinates, of what its entries come
/// to, of the objects that these make.
[[nodiscard]] std::vector<std::string> liveNames(const Evaluation &evaluation);
/// A name with what it stands for: `Q = (1, 2, 3)`, `d ≈ 3.162`.
[[nodiscard]] std::string liveText(const std::string &name, const Evaluation &evaluation);

/// What each name stands for at present.
using LiveValueOf = std::function<LiveValue(const std::string &name)>;

/// 10, or ≈ 3.142, or √2 ≈ 1.414.
[[nodiscard]] std::string plainText(const LiveNumber &number);
[[nodiscard]] std::string latexOf(const LiveNumber &number);

} // namespace halfspace
