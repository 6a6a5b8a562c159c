#include "lessons/scene/label_by_hand.h"

#include "lessons/words.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// Offsets are kept in this part of an em.
constexpr double perEm = 100;

double settledOffset(double offset) {
  return std::isfinite(offset)
             ? std::round(std::clamp(offset, -mostLabelOffset, mostLabelOffset) * perEm) / perEm
             : 0;
}

} // namespace

LabelSpot settled(LabelSpot spot) {
  spot.offset = {settledOffset(spot.offset.x), settledOffset(spot.offset.y)};
  return spot;
}

std::string_view entryOfMark(std::string_view mark) { return mark.substr(0, mark.find_first_of("./")); }

bool isLabelHidden(const LabelsByHand &labels, std::string_view mark) {
  const auto label = labels.find(mark);
  return label != labels.end() && label->second.isHidden;
}

std::optional<Problem> refuseLabel(const LabelsByHand &labels, std::string_view mark) {
  const auto refused = [](std::string sentence) { return Problem{std::move(sentence), "", 0, ""}; };
  if (mark.size() > longestMarkId)
    return refused(words("This is the name of no mark: they have at most {limit} bytes.",
                         {{"limit", std::to_string(longestMarkId)}}));
  if (labels.size() >= mostLabelsByHand && !labels.contains(mark))
    return refused(words("At most {limit} labels can be moved or hidden.",
                         {{"limit", std::to_string(mostLabelsByHand)}}));
  return {};
}

LabelsByHand withEntryRenamed(const LabelsByHand &labels, std::string_view entry, std::string_view newName) {
  LabelsByHand renamed;
  for (const auto &[mark, label] : labels) {
    const bool isOfEntry = entryOfMark(mark) == entry;
    renamed.emplace(isOfEntry ? std::string(newName) + mark.substr(entry.size()) : mark, label);
  }
  return renamed;
}

} // namespace halfspace
