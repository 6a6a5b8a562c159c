#include "widgets/picture/hand/object_tool.h"

#include "lessons/formula/plane_through.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/point.h"
#include "lessons/scene/fresh_names.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace halfspace {
namespace {

/// As few corners as a polygon has, and as many.
constexpr std::size_t fewestCorners = 3;
constexpr std::size_t mostCorners = 8;
/// A new number goes up to so many units at least, in steps of a part of one.
constexpr int usualBound = 10;
const Rational partOfUnit(1, 10);

bool hasCorners(ToolObject object) { return object == ToolObject::Polygon || object == ToolObject::Prism; }

/// How many things a tool takes whose number does not depend on the hand.
std::size_t countFor(ToolObject object) {
  switch (object) {
  case ToolObject::Point:
  case ToolObject::PointOn:
    return 1;
  case ToolObject::PlaneThroughPoints:
  case ToolObject::Triangle:
  case ToolObject::Box:
    return 3;
  case ToolObject::Tetrahedron:
    return 4;
  default:
    return 2;
  }
}

bool isComplete(const ObjectTool &tool) {
  if (!hasCorners(tool.object))
    return tool.picks.size() == countFor(tool.object);
  const std::size_t behind = tool.object == ToolObject::Prism ? 1 : 0;
  return tool.corners > 0 && tool.picks.size() == tool.corners + behind;
}

/// The word of the kind of what is made; empty where the pick itself is all.
std::string_view kindWordOf(ToolObject object) {
  switch (object) {
  case ToolObject::Point:
  case ToolObject::PointOn:
    return {};
  case ToolObject::Segment:
    return "segment";
  case ToolObject::Line:
    return "line";
  case ToolObject::Ray:
    return "ray";
  case ToolObject::Vector:
    return "vector";
  case ToolObject::PlaneThroughPoints:
  case ToolObject::PlaneWithNormal:
    return "plane";
  case ToolObject::Triangle:
    return "triangle";
  case ToolObject::Polygon:
    return "polygon";
  case ToolObject::Sphere:
    return "sphere";
  case ToolObject::Tetrahedron:
    return "tetrahedron";
  case ToolObject::Box:
    return "box";
  case ToolObject::Prism:
    break;
  }
  return "prism";
}

Formula formulaOf(const ToolPick &pick) { return {FormulaKind::Name, {}, pick.name}; }

Formula componentOf(const ToolPick &pick, int axis) {
  return {FormulaKind::Component, axis, {}, {formulaOf(pick)}};
}

Formula difference(Formula to, Formula from) {
  return {FormulaKind::Difference, {}, {}, {std::move(to), std::move(from)}};
}

Formula way(const ToolPick &from, const ToolPick &to) { return wayBetween(formulaOf(from), formulaOf(to)); }

/// The lowest corner and the three lengths of the box whose base goes from one point to another, and whose
/// height goes up to a third: whichever of them is lower in each coordinate as they lie now.
std::vector<Formula> boxBetween(const ToolPick &first, const ToolPick &opposite, const ToolPick &top) {
  std::vector<Formula> lowest;
  std::vector<Formula> lengths;
  bool isFirstLowest = true;
  for (int axis = 0; axis < 3; ++axis) {
    const ToolPick &other = axis == 2 ? top : opposite;
    const bool isLower = first.at[axis] <= other.at[axis];
    isFirstLowest = isFirstLowest && isLower;
    const auto &[low, high] = isLower ? std::tie(first, other) : std::tie(other, first);
    lowest.push_back(componentOf(low, axis));
    lengths.push_back(difference(componentOf(high, axis), componentOf(low, axis)));
  }
  lengths.insert(lengths.begin(),
                 isFirstLowest ? formulaOf(first) : Formula{FormulaKind::Triple, {}, {}, std::move(lowest)});
  return lengths;
}

/// The coordinates of what a tool makes that has all that it wants.
std::vector<Formula> coordinatesOf(const ObjectTool &tool) {
  const std::vector<ToolPick> &picks = tool.picks;
  std::vector<Formula> points(picks.size());
  std::transform(picks.begin(), picks.end(), points.begin(), formulaOf);
  switch (tool.object) {
  case ToolObject::Line:
  case ToolObject::Ray:
  case ToolObject::Vector:
  case ToolObject::PlaneWithNormal:
    return {points[0], way(picks[0], picks[1])};
  case ToolObject::PlaneThroughPoints:
    return planeThrough(points[0], points[1], points[2]);
  case ToolObject::Box:
    return boxBetween(picks[0], picks[1], picks[2]);
  case ToolObject::Prism: // the way to its top stands second
    points.pop_back();
    points.insert(points.begin() + 1, way(picks.front(), picks.back()));
    return points;
  default:
    return points;
  }
}

Scene withEntries(Scene scene, const std::vector<Entry> &entries) {
  for (const Entry &entry : entries)
    scene.entries.push_back(entry);
  return scene;
}

std::vector<Entry> newEntriesOf(const std::vector<ToolPick> &picks) {
  std::vector<Entry> entries;
  for (const ToolPick &pick : picks)
    if (pick.entry)
      entries.push_back(*pick.entry);
  return entries;
}

/// A name that neither the scene has nor what the tool has taken.
std::string nameFor(const Kind &kind, const ObjectTool &tool, const Scene &scene) {
  const Scene grown = withEntries(scene, newEntriesOf(tool.picks));
  return FreshNames(grown).ofKind(kind);
}

ToolPick newPick(Entry entry, const ExactVec3 &at) {
  std::string name = entry.name;
  return {std::move(name), at, std::move(entry)};
}

} // namespace

std::optional<ToolWish> wishOf(const ObjectTool &tool) {
  if (isComplete(tool))
    return {};
  const std::size_t taken = tool.picks.size();
  switch (tool.object) {
  case ToolObject::PointOn:
    return ToolWish{ToolWish::Kind::OnObject};
  case ToolObject::Sphere:
    return taken == 1 ? ToolWish{ToolWish::Kind::Radius, tool.picks[0].at} : ToolWish();
  case ToolObject::PlaneWithNormal:
    return taken == 1 ? ToolWish{ToolWish::Kind::Above, tool.picks[0].at} : ToolWish();
  case ToolObject::Tetrahedron:
    return taken == 3 ? ToolWish{ToolWish::Kind::Above, tool.picks[0].at} : ToolWish();
  case ToolObject::Box:
    return taken == 2 ? ToolWish{ToolWish::Kind::Above, tool.picks[1].at} : ToolWish();
  case ToolObject::Prism:
    return tool.corners > 0 ? ToolWish{ToolWish::Kind::Above, tool.picks[0].at} : ToolWish();
  default:
    return ToolWish();
  }
}

bool canClose(const ObjectTool &tool) {
  return hasCorners(tool.object) && tool.corners == 0 && tool.picks.size() >= fewestCorners;
}

bool canTake(const ObjectTool &tool, const std::string &name) {
  if (canClose(tool) && tool.picks.front().name == name)
    return true;
  return std::none_of(tool.picks.begin(), tool.picks.end(),
                      [&](const ToolPick &pick) { return pick.name == name; });
}

ObjectTool withPick(ObjectTool tool, ToolPick pick) {
  if (canClose(tool) && tool.picks.front().name == pick.name)
    return withClosedCorners(std::move(tool));
  tool.picks.push_back(std::move(pick));
  return canClose(tool) && tool.picks.size() == mostCorners ? withClosedCorners(std::move(tool)) : tool;
}

ObjectTool withoutLastPick(ObjectTool tool) {
  if (tool.corners == tool.picks.size() && tool.corners < mostCorners) {
    tool.corners = 0; // its closing was the last step
    return tool;
  }
  tool.picks.pop_back();
  if (tool.picks.size() < tool.corners)
    tool.corners = 0;
  return tool;
}

ObjectTool withClosedCorners(ObjectTool tool) {
  tool.corners = tool.picks.size();
  return tool;
}

ToolPick newPoint(const ObjectTool &tool, const Scene &scene, const ExactVec3 &at) {
  return newPick({nameFor(*findKind(PointObject::kind), tool, scene), PointObject{at}}, at);
}

ToolPick newRadius(const ObjectTool &tool, const Scene &scene, const Rational &radius, const Rational &unit) {
  const NumberObject number{radius, 0, std::max(radius, Rational(usualBound * unit)), partOfUnit * unit};
  return newPick({nameFor(*findKind(NumberObject::kind), tool, scene), number},
                 tool.picks.front().at + ExactVec3(radius, 0, 0));
}

ToolPick newPointOn(const ObjectTool &tool, const Scene &scene, const std::string &host, const Object &bound,
                    const ExactVec3 &at) {
  return newPick({nameFor(bound.kind(), tool, scene), bound, host}, at);
}

std::vector<Entry> entriesOf(const ObjectTool &tool, const Scene &scene) {
  std::vector<Entry> entries = newEntriesOf(tool.picks);
  const std::string_view word = kindWordOf(tool.object);
  if (word.empty() || !isComplete(tool))
    return entries;
  const Kind &kind = *findKind(word);
  std::string name = nameFor(kind, tool, scene);
  entries.push_back({std::move(name), DerivedObject{&kind, coordinatesOf(tool)}});
  return entries;
}

} // namespace halfspace
