// Marks made in one line.
#pragma once

#include "lessons/figure/figure.h"

namespace halfspace {

template <class MarkKind>
MarkKind withId(MarkKind mark, const std::string &id, Subject subject = Subject::Neutral) {
  mark.id = id;
  mark.subject = subject;
  return mark;
}

inline PointMark pointAt(Place at) {
  PointMark mark;
  mark.at = at;
  return mark;
}

inline SegmentMark segmentBetween(Place from, Place to) {
  SegmentMark mark;
  mark.from = from;
  mark.to = to;
  return mark;
}

inline PolygonMark polygonOf(std::vector<Place> corners) {
  PolygonMark mark;
  mark.corners = std::move(corners);
  return mark;
}

inline PlanePatchMark patchAt(Place center, Place normal, std::vector<Place> covers = {}) {
  PlanePatchMark mark;
  mark.center = center;
  mark.normal = normal;
  mark.covers = std::move(covers);
  return mark;
}

} // namespace halfspace
