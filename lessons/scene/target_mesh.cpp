#include "lessons/scene/target_mesh.h"

#include "lessons/construction/construction.h"
#include "lessons/object/coordinate_limits.h"
#include "lessons/object/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {
namespace {

/// The longest side of a mesh is made about so long, in scene units.
constexpr double wantedSide = 8;
/// Where it stands at first: on the field of a scene of usual size, beside the middle.
const ExactVec3 firstPlace(9, 16, 0);

/// 1, 2 or 5 times a power of ten, not much above the factor.
Rational roundFactor(double factor) {
  const int exponent = static_cast<int>(std::floor(std::log10(factor)));
  const double leading = factor / std::pow(10.0, exponent);
  constexpr double slack = 1.3;
  const int digit = leading * slack >= 10 ? 10 : leading * slack >= 5 ? 5 : leading * slack >= 2 ? 2 : 1;
  return Rational(digit) * powerOfTen(exponent);
}

Rational scaleOf(const MeshShape &shape) {
  const Vec3<double> size = shape.box().high - shape.box().low;
  const double longest = std::max({size.x, size.y, size.z});
  return longest > 0 ? std::clamp(roundFactor(wantedSide / longest), smallestScale, coordinateLimit)
                     : Rational(1);
}

/// The role in which a construction looks at a list of meshes; null where it has none.
const ConstructionRole *meshRole(const ConstructionUse &use) {
  const Construction &construction = *findConstruction(use.id);
  const auto found =
      std::find_if(construction.roles.begin(), construction.roles.end(),
                   [](const ConstructionRole &role) { return role.isList && role.kind == MeshObject::kind; });
  return found == construction.roles.end() ? nullptr : &*found;
}

} // namespace

bool takesMeshes(const Scene &scene) {
  return std::any_of(scene.entries.begin(), scene.entries.end(), [](const Entry &entry) {
    const auto *use = std::get_if<ConstructionUse>(&entry.content);
    return use && meshRole(*use);
  });
}

std::vector<Edit> editsForTarget(const Scene &scene, std::shared_ptr<const MeshShape> shape) {
  MeshObject mesh{firstPlace, {1, 0, 0}, scaleOf(*shape), std::move(shape)};
  if (const Object *before = findObject(scene, targetName))
    if (const auto old = objectAs<MeshObject>(*before)) {
      mesh.place = old->place;
      mesh.heading = old->heading;
      return {ChangeObject{targetName, mesh}};
    }
  const auto firstUse = std::find_if(scene.entries.begin(), scene.entries.end(), [](const Entry &entry) {
    return std::holds_alternative<ConstructionUse>(entry.content);
  });
  std::vector<Edit> edits{
      AddEntry{static_cast<std::size_t>(firstUse - scene.entries.begin()), {targetName, Object(mesh)}}};
  for (const Entry &entry : scene.entries) {
    const auto *use = std::get_if<ConstructionUse>(&entry.content);
    const ConstructionRole *role = use ? meshRole(*use) : nullptr;
    if (!role)
      continue;
    RoleObjects objects = use->roles.at(role->name);
    objects.ids.emplace_back(targetName);
    if (isCountOf(*role, objects.ids.size()))
      edits.emplace_back(RebindRole{entry.name, role->name, std::move(objects)});
  }
  return edits;
}

} // namespace halfspace
