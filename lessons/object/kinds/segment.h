// Segments: what lies between two points.
#pragma once

#include "lessons/object/given.h"

namespace halfspace {

/// A segment by its ends, which may be one point: then it has no length.
struct SegmentObject {
  static constexpr std::string_view kind = "segment";
  static auto coordinatesOf(auto &self) { return std::tie(self.from, self.to); }

  ExactVec3 from{};
  ExactVec3 to{};
  bool operator==(const SegmentObject &) const = default;
};

/// The letters of the ends, with their values.
struct SegmentTerms {
  Term A;
  Term B;
};

[[nodiscard]] SegmentTerms termsOf(const Given<SegmentObject> &segment);

} // namespace halfspace
