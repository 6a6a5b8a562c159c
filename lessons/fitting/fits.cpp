#include "lessons/fitting/fits.h"

#include "lessons/construction/construction.h"
#include "lessons/fitting/objects_between.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/polygon.h"
#include "lessons/object/kinds/segment.h"
#include "lessons/object/kinds/tetrahedron.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/solid.h"
#include "lessons/scene/fresh_names.h"
#include "lessons/scene/offered_objects.h"
#include "lessons/scene/scene_checker.h"

#include <algorithm>
#include <array>
#include <set>

namespace halfspace {
namespace {

/// A construction with selected objects in its roles.
struct FilledUse {
  ConstructionUse use;
  std::vector<const ConstructionRole *> open{}; ///< roles in which nothing stands
  std::size_t count = 0;                        ///< of the objects that stand in one
};

/// Finds what fits one selection.
class Fitter {
public:
  Fitter(const Scene &scene, const std::vector<std::string> &selected) : m_scene(scene), m_names(scene) {
    m_selected.resize(selected.size());
    std::vector<SeenObject> seen = seenObjectsOf(scene);
    std::vector<std::string> meant;
    meant.reserve(selected.size());
    for (const std::string &id : selected)
      meant.push_back(meantBy(id, seen));
    for (SeenObject &object : seen) {
      const auto place = std::find(meant.begin(), meant.end(), object.id);
      if (place == meant.end())
        m_otherKinds.insert(object.kind);
      else
        m_selected[static_cast<std::size_t>(place - meant.begin())] = std::move(object);
    }
    std::erase_if(m_selected, [](const SeenObject &object) { return object.id.empty(); });
  }

  [[nodiscard]] std::vector<Fit> fits() const {
    std::vector<Fit> found;
    if (m_selected.empty())
      return found;
    std::vector<Fit> wanting;
    for (const Construction &construction : constructions()) {
      FilledUse filled = filledUse(construction);
      if (filled.count < m_selected.size() || filled.open.size() > 1)
        continue;
      Fit fit{{m_names.ofUse(construction), std::move(filled.use)}};
      if (filled.open.empty()) {
        found.push_back(std::move(fit));
      } else if (const ConstructionRole &open = *filled.open.front(); isAnotherOf(open.kind)) {
        fit.wanted = WantedObject{open.name, open.kind};
        wanting.push_back(std::move(fit));
      }
    }
    for (DerivedObject &derived : objectsBetween(m_selected)) {
      std::string name = m_names.ofKind(*derived.kind);
      found.push_back({{std::move(name), std::move(derived)}});
    }
    if (m_selected.size() == 1)
      addOfOne(m_selected.front(), found);
    found.insert(found.end(), std::make_move_iterator(wanting.begin()),
                 std::make_move_iterator(wanting.end()));
    return found;
  }

private:
  /// The one object that a construction makes is meant by the construction, too.
  static std::string meantBy(const std::string &id, const std::vector<SeenObject> &seen) {
    const auto isMade = [&](const SeenObject &object) { return object.id != id && ownerOf(object.id) == id; };
    const auto made = std::find_if(seen.begin(), seen.end(), isMade);
    return made != seen.end() && std::count_if(seen.begin(), seen.end(), isMade) == 1 ? made->id : id;
  }

  void addOfOne(const SeenObject &object, std::vector<Fit> &found) const {
    addPointsOn(object, found);
    const std::vector<std::string> corners = cornersOf(object);
    if (object.kind == SegmentObject::kind)
      addOfEnds(corners, found);
    else
      addFaces(object.kind, corners, found);
  }

  /// The names of the places that an object of straight sides is told by.
  [[nodiscard]] std::vector<std::string> cornersOf(const SeenObject &seen) const {
    const Entry *entry = m_scene.entries.find(seen.id);
    const Kind *kind = entry ? kindOf(*entry) : nullptr;
    constexpr std::array straight{SegmentObject::kind, TriangleObject::kind, PolygonObject::kind,
                                  TetrahedronObject::kind};
    if (!kind || std::find(straight.begin(), straight.end(), kind->word) == straight.end())
      return {};
    const auto *derived = std::get_if<DerivedObject>(&entry->content);
    const std::size_t count = derived ? derived->coordinates.size() : std::get<Object>(entry->content).size();
    std::vector<std::string> corners;
    for (std::size_t i = 0; i < count; ++i)
      corners.push_back(sourceOf(m_scene, coordinateId(seen.id, kind->coordinates[i])));
    return corners;
  }

  /// Of ends that are objects themselves.
  void addOfEnds(const std::vector<std::string> &ends, std::vector<Fit> &found) const {
    const Fitter ofEnds(m_scene, ends);
    if (ofEnds.m_selected.size() < ends.size())
      return;
    for (Fit &fit : ofEnds.fits())
      if (!fit.wanted && !kindOf(fit.entry))
        found.push_back(std::move(fit));
  }

  void addFaces(std::string_view kind, const std::vector<std::string> &corners,
                std::vector<Fit> &found) const {
    using Face = std::array<std::size_t, 3>;
    const std::vector<Face> faces = kind == TetrahedronObject::kind
                                        ? std::vector<Face>{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}
                                        : std::vector<Face>{{0, 1, 2}};
    const std::string name = m_names.ofKind(*findKind(PlaneObject::kind));
    for (const auto &[a, b, c] : faces)
      if (c < corners.size())
        found.push_back({{name, planeThrough({corners[a], corners[b], corners[c]})}});
  }

  /// The points that can lie on an object, where their kinds begin.
  void addPointsOn(const SeenObject &host, std::vector<Fit> &found) const {
    for (const Kind &kind : kinds()) {
      if (!kind.binding || kind.binding->host != host.kind)
        continue;
      Object point(kind);
      kind.settle(point);
      found.push_back({{m_names.ofKind(kind), std::move(point), host.id}});
    }
  }

  [[nodiscard]] FilledUse filledUse(const Construction &construction) const {
    FilledUse filled{{std::string(construction.id), {}}};
    std::vector<SeenObject> left = m_selected;
    for (const bool isList : {false, true})
      for (const ConstructionRole &role : construction.roles)
        if (role.isList == isList)
          fill(role, left, filled);
    return filled;
  }

  static void fill(const ConstructionRole &role, std::vector<SeenObject> &left, FilledUse &filled) {
    const std::size_t most = role.isList ? maxListedObjects : 1;
    RoleObjects objects;
    std::erase_if(left, [&](const SeenObject &object) {
      if (objects.ids.size() == most || !canStandFor(role.kind, object.kind))
        return false;
      objects.ids.push_back(object.id);
      return true;
    });
    filled.count += objects.ids.size();
    if (objects.ids.empty())
      filled.open.push_back(&role);
    else
      filled.use.roles.emplace(role.name, std::move(objects));
  }

  [[nodiscard]] bool isAnotherOf(std::string_view needed) const {
    return std::any_of(m_otherKinds.begin(), m_otherKinds.end(),
                       [&](std::string_view kind) { return canStandFor(needed, kind); });
  }

  const Scene &m_scene;
  FreshNames m_names;
  std::vector<SeenObject> m_selected;
  std::set<std::string_view> m_otherKinds; ///< of what is not selected
};

} // namespace

std::vector<Fit> fitsFor(const Scene &scene, const std::vector<std::string> &selected) {
  if (scene.entries.size() >= maxSceneEntries)
    return {};
  return Fitter(scene, selected).fits();
}

} // namespace halfspace
