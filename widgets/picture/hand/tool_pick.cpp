#include "widgets/picture/hand/tool_pick.h"

#include "lessons/object/bound_point.h"
#include "lessons/scene/hand/snapping.h"
#include "lessons/scene/offered_objects.h"
#include "widgets/picture/hand/drag.h"
#include "widgets/picture/hand/handle_drag.h"
#include "widgets/picture/hand/mark_picker.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

DragConstraint constraintOf(const ToolRoom &room) {
  const Place up(0, 0, 1);
  return room.isUpright ? alongLine(up) : inPlane(up);
}

/// How a bound object moves on its host; nothing where that is a single place.
std::optional<DragConstraint> constraintOf(const Handle &handle) {
  if (handle.hasAxis())
    return alongLine(toDouble(handle.axis));
  if (!isZero(handle.normal))
    return inPlane(toDouble(handle.normal));
  return handle.center ? std::optional(onSphere(toDouble(*handle.center))) : std::nullopt;
}

/// The place of a bound object that a sight is to start from: on a sphere the one that looks at the eye.
Place startOf(const Handle &handle, const Camera &camera) {
  const Place at = toDouble(handle.at);
  if (!handle.center)
    return at;
  const Place center = toDouble(*handle.center);
  return center - camera.viewDirection() * glm::length(at - center);
}

/// The place under a pixel, within the box that objects are dragged in.
std::optional<Place> boxedPlaceUnder(glm::dvec2 pixel, const DragConstraint &constraint, const View &view,
                                     const Place &at) {
  const auto place = placeUnder(pixel, constraint, view.camera, view.size, at);
  return place ? std::optional(glm::clamp(*place, Place(-dragBox), Place(dragBox))) : std::nullopt;
}

ExactVec3 rounded(const Place &place, const Rational &step) {
  ExactVec3 exact;
  for (int axis = 0; axis < 3; ++axis)
    exact[axis] = roundToMultiple(place[axis], step);
  return exact;
}

/// The place of a room on the grid that is nearest to another one.
ExactVec3 onGrid(const Place &place, const ToolRoom &room, const Rational &step) {
  const ExactVec3 grid = rounded(place, step);
  return room.isUpright ? ExactVec3(room.at.x, room.at.y, grid.z) : ExactVec3(grid.x, grid.y, room.at.z);
}

/// The points that formulas can name: those of the picture, and those that the tool has taken.
Figure pointsSeen(const ObjectTool &tool, const ToolScene &scene) {
  Figure points;
  for (std::size_t place = 0; place < scene.figure.marks.size(); ++place)
    if (const auto *point = std::get_if<PointMark>(&scene.figure.marks[place]);
        point && placeNamed(scene.evaluation, point->id))
      points.marks.push_back(scene.figure.marks.shared(place));
  for (const ToolPick &pick : tool.picks)
    points.add(PointMark{{pick.name}, toDouble(toStage(pick.at, CoordinateRole::Position, scene.stage))});
  return points;
}

/// What goes by the name of a point that is seen.
ToolPick pickNamed(const std::string &seen, const ObjectTool &tool, const Evaluation &evaluation) {
  const std::string source = sourceOf(evaluation.scene, seen);
  const std::string &name = placeNamed(evaluation, source) ? source : seen; // a place may be a vector's, too
  const auto taken = std::find_if(tool.picks.begin(), tool.picks.end(),
                                  [&](const ToolPick &pick) { return pick.name == name; });
  return taken != tool.picks.end() ? *taken : ToolPick{name, placeNamed(evaluation, name).value()};
}

std::optional<ToolPick> ifWanted(const ObjectTool &tool, ToolPick pick) {
  return canTake(tool, pick.name) ? std::optional(std::move(pick)) : std::nullopt;
}

/// The kind of the points that lie on objects of a kind; null where there are none. Of a triangle it is a
/// point within it, not of its plane, as the kinds stand in their table.
const Kind *kindOfPointsOn(const Kind &host) {
  const auto found = std::find_if(kinds().begin(), kinds().end(), [&](const Kind &kind) {
    return kind.binding && kind.binding->host == host.word;
  });
  return found == kinds().end() ? nullptr : &*found;
}

/// What is seen of objects that points can lie on.
Figure hostsSeen(const ToolScene &scene) {
  Figure hosts;
  for (std::size_t place = 0; place < scene.figure.marks.size(); ++place) {
    const std::string_view id = leadingId(baseOf(scene.figure.marks[place]));
    const OfferedObject *object = findOffered(scene.evaluation, id);
    if (object && object->whyNot.empty() && kindOfPointsOn(object->given->object.kind()))
      hosts.marks.push_back(scene.figure.marks.shared(place));
  }
  return hosts;
}

std::optional<ToolPick> pickOnObject(glm::dvec2 pixel, const ObjectTool &tool, const ToolScene &scene,
                                     const View &view) {
  const std::string mark = markUnder(pixel, hostsSeen(scene), view.camera, view.size, view.pixelRatio);
  if (mark.empty())
    return {};
  const std::string id = mark.substr(0, mark.find('/'));
  const Object host = toStage(findOffered(scene.evaluation, id)->given->object, scene.stage);
  const Object bound(*kindOfPointsOn(host.kind()));
  const auto start = placeOn(bound, host);
  if (!start)
    return {};
  const Handle handle = boundHandle(id, bound, host, *start);
  const auto constraint = constraintOf(handle);
  const auto place = constraint ? boxedPlaceUnder(pixel, *constraint, view, startOf(handle, view.camera))
                                : std::optional(toDouble(*start));
  if (!place)
    return {};
  const Object moved = movedToGrid(bound, handle, rounded(*place, finestStep), scene.step);
  const ExactVec3 at = placeOn(moved, host).value();
  return newPointOn(tool, scene.evaluation.scene, id, fromStage(moved, scene.stage),
                    fromStage(at, CoordinateRole::Position, scene.stage));
}

ToolPick radiusUpTo(const Place &place, const ObjectTool &tool, const ToolScene &scene) {
  const ExactVec3 center = toStage(tool.picks.front().at, CoordinateRole::Position, scene.stage);
  const Rational radius =
      std::max(scene.step, roundToMultiple(glm::distance(place, toDouble(center)), scene.step));
  const Rational unit = scene.stage.unit();
  return newRadius(tool, scene.evaluation.scene, radius * unit, unit);
}

} // namespace

ToolRoom roomFor(const ToolWish &wish, const Stage &stage) {
  if (wish.kind == ToolWish::Kind::Point || wish.kind == ToolWish::Kind::OnObject)
    return {};
  return {toStage(wish.from, CoordinateRole::Position, stage), wish.kind == ToolWish::Kind::Above};
}

bool canPlace(const ToolRoom &room, const Camera &camera) {
  return isGrabbable(constraintOf(room), camera, toDouble(room.at));
}

std::optional<ToolPick> pickUnder(glm::dvec2 pixel, const ObjectTool &tool, const ToolScene &scene,
                                  const ToolRoom &room, const View &view) {
  const auto wish = wishOf(tool);
  if (!wish)
    return {};
  if (wish->kind == ToolWish::Kind::OnObject)
    return pickOnObject(pixel, tool, scene, view);
  const bool isRadius = wish->kind == ToolWish::Kind::Radius;
  const std::string point =
      isRadius ? std::string()
               : markUnder(pixel, pointsSeen(tool, scene), view.camera, view.size, view.pixelRatio);
  if (!point.empty())
    return ifWanted(tool, pickNamed(point, tool, scene.evaluation));
  if (!canPlace(room, view.camera))
    return {};
  const auto place = boxedPlaceUnder(pixel, constraintOf(room), view, toDouble(room.at));
  if (!place)
    return {};
  return isRadius ? radiusUpTo(*place, tool, scene) : pickAt(onGrid(*place, room, scene.step), tool, scene);
}

std::optional<ToolPick> pickAt(const ExactVec3 &place, const ObjectTool &tool, const ToolScene &scene) {
  const auto wish = wishOf(tool);
  if (!wish || wish->kind == ToolWish::Kind::OnObject)
    return {};
  if (wish->kind == ToolWish::Kind::Radius)
    return radiusUpTo(toDouble(place), tool, scene);
  const ExactVec3 at = fromStage(place, CoordinateRole::Position, scene.stage);
  for (const Mark &mark : pointsSeen(tool, scene).marks)
    if (ToolPick there = pickNamed(baseOf(mark).id, tool, scene.evaluation); there.at == at)
      return ifWanted(tool, std::move(there));
  return newPoint(tool, scene.evaluation.scene, at);
}

std::optional<ObjectTool> followed(ObjectTool tool, const Evaluation &evaluation) {
  for (ToolPick &pick : tool.picks) {
    if (pick.entry ? evaluation.scene.entries.find(pick.name) != nullptr
                   : !placeNamed(evaluation, pick.name).has_value())
      return {};
    if (!pick.entry)
      pick.at = *placeNamed(evaluation, pick.name);
  }
  return tool;
}

} // namespace halfspace
