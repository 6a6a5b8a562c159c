#include "widgets/picture/flat_page.h"

#include "geometry/project_vector.h"
#include "lessons/object/drawing.h"
#include "widgets/picture/camera_views.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>

namespace halfspace {
namespace {

/// What a flat picture takes of the scene's width and height …
constexpr glm::dvec2 shareOfRoom{0.38, 0.34};
/// … but at least so much, and never more, in pixels; and never more than half of the room.
constexpr glm::dvec2 leastSize{210, 150};
constexpr glm::dvec2 mostSize{460, 340};

/// A direction square to another.
ExactVec3 anySquareTo(const ExactVec3 &direction) {
  const ExactVec3 sideways = cross(direction, ExactVec3(0, 0, 1));
  return isZero(sideways) ? ExactVec3(1, 0, 0) : sideways;
}

const ExactVec3 *vectorIn(const Scene &scene, const CoordinateId &id) {
  const Object *object = findObject(scene, id.object);
  if (!object || id.index >= object->size() ||
      coordinatesOf(*object)[id.index].role != CoordinateRole::Direction)
    return nullptr;
  return &coordinate(*object, id.index);
}

/// Turns marks, whose places and directions it turns alike: the origin stays where it is.
class Turn {
public:
  explicit Turn(FlatFrame frame) : m_frame(std::move(frame)) {}

  Mark operator()(PointMark mark) const { return turned(std::move(mark), &PointMark::at); }
  Mark operator()(SegmentMark mark) const {
    return turned(std::move(mark), &SegmentMark::from, &SegmentMark::to);
  }
  Mark operator()(RayMark mark) const {
    if (mark.meets)
      mark.meets = of(*mark.meets);
    return turned(std::move(mark), &RayMark::origin, &RayMark::direction);
  }
  Mark operator()(LineMark mark) const {
    mark.covers = of(std::move(mark.covers));
    return turned(std::move(mark), &LineMark::through, &LineMark::direction);
  }
  Mark operator()(ArrowMark mark) const {
    return turned(std::move(mark), &ArrowMark::from, &ArrowMark::vector);
  }
  Mark operator()(PolygonMark mark) const {
    mark.corners = of(std::move(mark.corners));
    return mark;
  }
  Mark operator()(SphereMark mark) const { return turned(std::move(mark), &SphereMark::center); }
  Mark operator()(MeshMark mark) const {
    mark.place = of(mark.place);
    for (glm::length_t axis = 0; axis < 3; ++axis)
      mark.axes[axis] = of(mark.axes[axis]);
    return mark;
  }
  Mark operator()(ArcMark mark) const {
    return turned(std::move(mark), &ArcMark::center, &ArcMark::from, &ArcMark::to);
  }
  Mark operator()(RightAngleMark mark) const {
    return turned(std::move(mark), &RightAngleMark::at, &RightAngleMark::first, &RightAngleMark::second);
  }
  /// Its sides are level in space, and would not be on the page: what is turned are its corners.
  Mark operator()(const PlanePatchMark &patch) const {
    const MarkBase &base = patch;
    const std::vector<Place> corners = of(cornersOf(patch));
    if (corners.empty())
      return PolygonMark{base, corners};
    const auto byWidth = [](const Place &a, const Place &b) { return a.y < b.y; };
    const auto [left, right] = std::minmax_element(corners.begin(), corners.end(), byWidth);
    const auto byHeight = [](const Place &a, const Place &b) { return a.z < b.z; };
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end(), byHeight);
    if (high->z - low->z <= edgeOnTolerance * (right->y - left->y))
      return SegmentMark{base, *left, *right};
    return PolygonMark{base, corners};
  }

private:
  [[nodiscard]] Place of(const Place &place) const { return onPage(place, m_frame); }
  [[nodiscard]] std::vector<Place> of(std::vector<Place> places) const {
    for (Place &place : places)
      place = of(place);
    return places;
  }
  template <class Kind, class... Members> Kind turned(Kind mark, Members... members) const {
    ((mark.*members = of(mark.*members)), ...);
    return mark;
  }

  FlatFrame m_frame;
};

/// Whether it is a plane seen edge-on, which goes on as far as there is room.
bool runsOn(const Mark &mark) {
  const auto *line = std::get_if<SegmentMark>(&mark);
  return line && line->subject == Subject::Plane && line->role == Role::Given;
}

/// What the picture is about: without planes that go on and on, and what lies far away from all that is
/// given.
std::vector<Place> placesIn(const Figure &flat) {
  Figure near;
  std::vector<Place> given;
  for (const Mark &mark : flat.marks) {
    if (!runsOn(mark))
      near.add(mark);
    if (const auto *point = std::get_if<PointMark>(&mark); point && point->role == Role::Given)
      given.push_back(point->at);
  }
  std::vector<Place> places = placesOf(near);
  std::erase_if(places, [&](const Place &place) {
    return std::none_of(given.begin(), given.end(),
                        [&](const Place &at) { return glm::distance(at, place) <= maximumPatchReach; });
  });
  return places;
}

} // namespace

Place onPage(const Place &place, const FlatFrame &frame) {
  return {glm::dot(place, frame.toEye), glm::dot(place, frame.right), glm::dot(place, frame.up)};
}

std::optional<FlatFrame> flatFrame(const ExactVec3 &up, const ExactVec3 &right) {
  if (isZero(up))
    return {};
  const ExactVec3 part = projectVector(right, up).rejection;
  const ExactVec3 level = isZero(part) ? anySquareTo(up) : part;
  FlatFrame frame;
  frame.up = unitOf(up);
  frame.right = unitOf(level);
  frame.toEye = glm::cross(frame.right, frame.up);
  frame.normal = cross(level, up);
  return frame;
}

std::optional<FlatFrame> flatFrame(const std::optional<FlatPage> &page, const Scene &scene) {
  if (!page)
    return {};
  const ExactVec3 *up = vectorIn(scene, page->up);
  const ExactVec3 *right = vectorIn(scene, page->right);
  return up && right ? flatFrame(*up, *right) : std::nullopt;
}

std::optional<glm::dvec2> flatSizeIn(glm::dvec2 room, double sizeScale) {
  if (glm::any(glm::lessThan(room / 2.0, leastSize)))
    return {};
  return glm::min(glm::clamp(room * shareOfRoom, leastSize, mostSize * sizeScale), room / 2.0);
}

Figure laidFlat(const Figure &figure, const FlatFrame &frame) {
  Figure flat;
  for (const Mark &mark : withoutNumbers(figure).marks)
    flat.add(std::visit(Turn(frame), mark));
  return flat;
}

Camera flatCamera(const Figure &flat, View view) {
  view.camera = {};
  view.camera.azimuth = 0;
  view.camera.elevation = 0;
  view.camera.orthographic = true;
  return fitted(view, placesIn(flat));
}

bool showsAll(const Figure &flat, const View &view) {
  const std::vector<Place> places = placesIn(flat);
  return std::all_of(places.begin(), places.end(), [&](const Place &place) {
    const auto pixel = view.camera.project(place, view.size);
    return pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x <= view.size.width &&
           pixel->y <= view.size.height;
  });
}

Figure clippedTo(const View &view, Figure flat) {
  const double half = view.camera.height / 2 * view.size.width / view.size.height;
  const double middle = view.camera.target.y;
  for (std::size_t place = 0; place < flat.marks.size(); ++place)
    if (runsOn(flat.marks[place])) {
      auto line = std::get<SegmentMark>(flat.marks[place]);
      const Place from = line.from;
      const Place way = line.to - from; // it is not upright: a patch is wider than high
      const auto at = [&](double y) { return from + way * std::clamp((y - from.y) / way.y, 0.0, 1.0); };
      line.from = at(middle - half);
      line.to = at(middle + half);
      flat.marks.replace(place, std::move(line));
    }
  return flat;
}

} // namespace halfspace
