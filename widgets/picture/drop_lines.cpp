#include "widgets/picture/drop_lines.h"

namespace halfspace {

void addDropLines(Figure &figure) {
  const std::size_t count = figure.marks.size();
  for (std::size_t i = 0; i < count; ++i)
    if (const auto *point = std::get_if<PointMark>(&figure.marks[i]);
        point && !point->label.empty() && point->at.z != 0) {
      const MarkBase base{point->id + "/drop", Role::Helper, Subject::Neutral};
      figure.add(SegmentMark{base, point->at, {point->at.x, point->at.y, 0}});
    }
}

} // namespace halfspace
