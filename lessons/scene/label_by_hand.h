// Labels that somebody has moved or hidden, instead of leaving them to whoever draws the picture.
#pragma once

#include "lessons/result.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

/// Where a label stands beside its mark: the same in pictures of every size, as it is measured in the size of
/// the label's type.
struct LabelSpot {
  /// The part of the label that the offset leads to, at half of its height. A label that grows, as its
  /// numbers change, grows away from there.
  enum class Side : std::uint8_t { Left, Middle, Right };

  glm::dvec2 offset{}; ///< from the mark's own anchor, to the right and downwards, in em
  Side side = Side::Middle;
  bool operator==(const LabelSpot &) const = default;
};

/// A label is at most so many em away from its mark, each way.
inline constexpr double mostLabelOffset = 100;

/// The spot as sessions keep it: to a hundredth of an em, which nobody sees, and within `mostLabelOffset`. An
/// offset that is no number is 0.
[[nodiscard]] LabelSpot settled(LabelSpot spot);

/// What somebody has done to the label of a mark.
struct LabelByHand {
  std::optional<LabelSpot> spot{}; ///< nothing: it is placed as all others are
  bool isHidden = false;
  bool operator==(const LabelByHand &) const = default;
};

/// By the ids of their marks; none that nothing was done to.
using LabelsByHand = std::map<std::string, LabelByHand, std::less<>>;

/// A scene has at most so many: more than labels are drawn, and no more than a map of a file may have fields.
inline constexpr std::size_t mostLabelsByHand = 200;
/// In bytes; those of our figures are shorter by far.
inline constexpr std::size_t longestMarkId = 200;

/// The name of the entry that a mark belongs to: `distance` for `distance.F/angle`.
[[nodiscard]] std::string_view entryOfMark(std::string_view mark);

/// Whether somebody has hidden the label of a mark.
[[nodiscard]] bool isLabelHidden(const LabelsByHand &labels, std::string_view mark);

/// Whether one more label could be kept, for a mark of this id; if not, why.
[[nodiscard]] std::optional<Problem> refuseLabel(const LabelsByHand &labels, std::string_view mark);

/// The labels, where an entry has got another name.
[[nodiscard]] LabelsByHand withEntryRenamed(const LabelsByHand &labels, std::string_view entry,
                                            std::string_view newName);

} // namespace halfspace
