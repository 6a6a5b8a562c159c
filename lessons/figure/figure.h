// A figure: a list of marks.
#pragma once

#include "lessons/figure/mark.h"
#include "lessons/shared_list.h"

#include <string_view>

namespace halfspace {

/// A place that the mark with this id is to be drawn up to: that a patch covers, that a ray meets.
struct Reach {
  std::string mark;
  Place at{};
};

/// Copies of a figure share its marks.
struct Figure {
  SharedList<Mark> marks;
  std::vector<Reach> reaches{}; ///< of marks of its own or of other figures that it is put together with

  void add(Mark mark) { marks.push_back(std::move(mark)); }
  /// The patch of a plane is drawn as far as the ray that lies in it, and the ray goes on whatever else it
  /// meets. `along` is the ray's direction, of length 1.
  void reachWithin(const std::string &plane, const std::string &ray, const Place &origin, const Place &along);
};

/// The figure with its marks drawn as far as they are to reach. Where several places are asked of a ray, it
/// meets the farthest.
[[nodiscard]] Figure reaching(Figure figure);

/// The mark with this id, or null.
[[nodiscard]] inline const Mark *findMark(const Figure &figure, std::string_view id) {
  for (const Mark &mark : figure.marks)
    if (baseOf(mark).id == id)
      return &mark;
  return nullptr;
}

/// Leaves the letter alone of a mark's label: `d` of `d = 10`, `E` of `E: x + 2y + 2z − 27 = 0`, and no
/// coordinates to be written behind it.
void clearNumbers(Mark &mark);

/// Writes the coordinates behind the label of a mark that has one, whether others' are written or not.
void writeCoordinates(Mark &mark);

/// The figure with letters alone in its labels.
[[nodiscard]] Figure withoutNumbers(Figure figure);

} // namespace halfspace
