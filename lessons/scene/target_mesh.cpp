#include "lessons/scene/target_mesh.h"

#include "geometry/decide.h"
#include "lessons/construction/construction.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/mesh.h"
#include "lessons/reading/typed_number.h"
#include "lessons/scene/fresh_names.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace halfspace {
namespace {

/// The longest side of a mesh is made about so long, in scene units.
constexpr double wantedSide = 8;
/// Where it stands at first: on the field of a scene of usual size, beside the middle.
const ExactVec3 firstPlace(9, 16, 0);
/// A copy of a mesh stands so far beside it.
const Rational gapBeside = 3;

/// 1, 2 or 5 times a power of ten, not much above the factor.
Rational roundFactor(double factor) {
  const int exponent = static_cast<int>(std::floor(std::log10(factor)));
  const double leading = factor / std::pow(10.0, exponent);
  constexpr double slack = 1.3;
  const int digit = leading * slack >= 10 ? 10 : leading * slack >= 5 ? 5 : leading * slack >= 2 ? 2 : 1;
  return Rational(digit) * powerOfTen(exponent);
}

Rational scaleOf(const MeshShape &shape) {
  const double longest = shape.box().longestSide();
  return longest > 0 ? std::clamp(roundFactor(wantedSide / longest), smallestScale, coordinateLimit)
                     : Rational(1);
}

/// The meshes that a construction looks at in a role of its own for many of them.
struct MeshList {
  std::string entry;
  const ConstructionRole *role;
  std::vector<std::string> ids;
};

/// The lists of all constructions of a scene that have one.
std::vector<MeshList> meshListsIn(const Scene &scene) {
  std::vector<MeshList> lists;
  for (const Entry &entry : scene.entries)
    if (const auto *use = std::get_if<ConstructionUse>(&entry.content))
      for (const ConstructionRole &role : findConstruction(use->id)->roles)
        if (role.isList && role.kind == MeshObject::kind)
          lists.push_back({entry.name, &role, use->roles.at(role.name).ids});
  return lists;
}

/// Puts a mesh before all constructions, and into those lists that have room for it.
std::vector<Edit> editsToAdd(const Scene &scene, const std::string &name, const MeshObject &mesh,
                             const std::vector<MeshList> &lists) {
  const auto firstUse = std::find_if(scene.entries.begin(), scene.entries.end(), [](const Entry &entry) {
    return std::holds_alternative<ConstructionUse>(entry.content);
  });
  std::vector<Edit> edits{
      AddEntry{static_cast<std::size_t>(firstUse - scene.entries.begin()), {name, Object(mesh)}}};
  for (const MeshList &list : lists) {
    std::vector<std::string> ids = list.ids;
    ids.push_back(name);
    if (isCountOf(*list.role, ids.size()))
      edits.emplace_back(RebindRole{list.entry, list.role->name, std::move(ids)});
  }
  return edits;
}

/// wallB for wall, and for wallB as well; or wallC where there is one already. Numbers are those of
/// triangles.
std::string nextName(const Scene &scene, std::string name) {
  if (name.size() > 1 && std::isupper(static_cast<unsigned char>(name.back())))
    name.pop_back();
  char letter = 'B';
  while (
      scene.entries.find(name + letter)) // no list has so many that it would come to the end of the letters
    ++letter;
  return name + letter;
}

/// The way beside a mesh, across its heading but along an axis, by its width and a gap.
ExactVec3 wayBeside(const MeshObject &mesh) {
  const BoundingBox &box = mesh.shape->box();
  const Rational width = (exactly(box.high).y - exactly(box.low).y) * mesh.scale;
  const Rational way = roundUpToMultiple(width + gapBeside, 1);
  return abs(mesh.heading.x) >= abs(mesh.heading.y) ? ExactVec3(0, way, 0) : ExactVec3(-way, 0, 0);
}

} // namespace

bool takesMeshes(const Scene &scene) { return !meshListsIn(scene).empty(); }

std::vector<Edit> editsForMesh(const Scene &scene, std::shared_ptr<const MeshShape> shape) {
  const MeshObject mesh{ExactVec3(0), {1, 0, 0}, scaleOf(*shape), std::move(shape)};
  const std::string name = FreshNames(scene).ofKind(*findKind(MeshObject::kind));
  return {AddEntry{scene.entries.size(), {name, Object(mesh)}}};
}

std::vector<Edit> editsForTarget(const Scene &scene, std::shared_ptr<const MeshShape> shape) {
  MeshObject mesh{firstPlace, {1, 0, 0}, scaleOf(*shape), std::move(shape)};
  if (const Object *before = findObject(scene, targetName))
    if (const auto old = objectAs<MeshObject>(*before)) {
      mesh.place = old->place;
      mesh.heading = old->heading;
      return {ChangeObject{targetName, mesh}};
    }
  return editsToAdd(scene, targetName, mesh, meshListsIn(scene));
}

std::optional<MeshCopy> copyOfMesh(const Scene &scene, const std::string &name) {
  const Object *original = findObject(scene, name);
  auto mesh = original ? objectAs<MeshObject>(*original) : std::nullopt;
  if (!mesh)
    return {};
  std::vector<MeshList> lists = meshListsIn(scene);
  std::erase_if(lists, [&name](const MeshList &list) {
    return std::find(list.ids.begin(), list.ids.end(), name) == list.ids.end() ||
           !isCountOf(*list.role, list.ids.size() + 1);
  });
  if (lists.empty())
    return {};
  mesh->place += wayBeside(*mesh);
  MeshCopy copy{nextName(scene, name), {}};
  copy.edits = editsToAdd(scene, copy.name, *mesh, lists);
  return copy;
}

std::vector<Edit> editsToRemoveMesh(const Scene &scene, const std::string &name) {
  std::vector<Edit> edits = editsToUnlist(scene, name);
  edits.emplace_back(RemoveEntry{name});
  return edits;
}

} // namespace halfspace
