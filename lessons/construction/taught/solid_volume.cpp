// The volume of a solid: that of the tetrahedra from one corner to all triangles of its faces.
#include "geometry/polygon_area.h"
#include "lessons/construction/taught.h"
#include "lessons/object/solid.h"

#include <algorithm>
#include <numeric>

namespace halfspace {
namespace {

// Of a prism over eight corners: six triangles of its top, and two of each of its six sides away from the
// first corner.
constexpr std::size_t mostTetrahedra = 18;

struct In : Naming {
  Given<SolidObject> K;
};

/// Of the first corner and these three, which are counterclockwise seen from outside.
struct Tetrahedron {
  std::array<std::uint32_t, 3> corners;
  Rational determinant; ///< six times the volume; negative where it is turned inside out
  Term D;
};

std::vector<Tetrahedron> tetrahedraOf(const In &in) {
  std::vector<Tetrahedron> all;
  const auto &[vertices, faces] = in.K.object.mesh;
  const auto way = [&vertices = vertices](std::uint32_t corner) {
    return ExactVec3(vertices[corner] - vertices[0]);
  };
  for (const auto &face : faces) {
    if (std::find(face.begin(), face.end(), 0U) != face.end())
      continue; // flat tetrahedra
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Rational value = dot(way(face[0]), cross(way(face[i]), way(face[i + 1])));
      all.push_back({{face[0], face[i], face[i + 1]},
                     value,
                     ownName(in, letter("D", std::to_string(all.size() + 1)), value)});
    }
  }
  return all;
}

enum class VolumeCase { Solid, Flat, SelfMeeting, NotPlanar };

VolumeCase caseOf(const SolidMesh<Rational> &mesh) {
  if (isFlat(mesh))
    return VolumeCase::Flat;
  VolumeCase found = VolumeCase::Solid;
  for (const auto &face : mesh.faces) {
    Polygon<Rational> corners;
    for (const std::uint32_t corner : face)
      corners.push_back(mesh.vertices[corner]);
    const PolygonAreaCase area = polygonArea(corners).which;
    if (area == PolygonAreaCase::NotPlanar)
      return VolumeCase::NotPlanar;
    if (area == PolygonAreaCase::SelfMeeting)
      found = VolumeCase::SelfMeeting;
  }
  return found;
}

Rational volumeOf(const std::vector<Tetrahedron> &tetrahedra) {
  return std::accumulate(
             tetrahedra.begin(), tetrahedra.end(), Rational(0),
             [](const Rational &sum, const Tetrahedron &each) { return Rational(sum + each.determinant); }) /
         6;
}

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  VolumeCase which = caseOf(in.K.object.mesh);
  bool hasVolume = which != VolumeCase::NotPlanar;

  std::vector<Tetrahedron> tetrahedra = tetrahedraOf(in);
  Term V = ownName(letter("V"), volumeOf(tetrahedra));

  [[nodiscard]] Term wayTo(std::uint32_t corner) const {
    return cornerTerm(in.K, corner) - cornerTerm(in.K, 0);
  }
};

CaseWords tell(const Out &at) {
  switch (at.which) {
  case VolumeCase::Solid:
    return {"solid", words("The volume of the solid is {V}.", {{"V", equation(at.V)}})};
  case VolumeCase::Flat:
    return {"flat", words("All corners lie in one plane: the solid is flat and has no volume."), true};
  case VolumeCase::SelfMeeting:
    return {"self-meeting",
            words("The boundary of the base meets itself: {V} counts each part as often as the boundary goes "
                  "round it, and negative where it goes the other way round.",
                  {{"V", equation(at.V)}}),
            true};
  case VolumeCase::NotPlanar:
    break;
  }
  return {"not-planar",
          words("The corners of the base do not lie in one plane: it is no face, and there is no "
                "solid that has a volume."),
          true};
}

std::string signWords(const Rational &determinant) {
  if (determinant > 0)
    return words("Six times the volume of a tetrahedron: from the first corner to three of a face.");
  return determinant < 0
             ? words(
                   "Negative: seen from the first corner this part of a face is turned the other way round, "
                   "and its tetrahedron is taken away.")
             : words("0: the first corner and these three lie in one plane.");
}

WorkingLine determinantLine(const Out &at, std::size_t index) {
  const auto &[corners, value, D] = at.tetrahedra[index];
  const Term whole = determinant(3, {at.wayTo(corners[0]), at.wayTo(corners[1]), at.wayTo(corners[2])});
  return asked((D == whole).then(columnsPutIn(whole)).then(calculated(whole)), signWords(value),
               {{-D, words("{answer} has the wrong sign.")}});
}

WorkingLine volumeLine(const Out &at) {
  std::vector<Term> parts;
  for (const Tetrahedron &each : at.tetrahedra)
    parts.push_back(each.D);
  const Term all = sum(std::move(parts));
  return asked(
      withNumbers(at.V == all / 6),
      at.which == VolumeCase::Flat
          ? words("0: a flat solid has no volume.")
          : words("Each determinant is six times the volume of its tetrahedron, with its sign."),
      {{all, words("{answer} is the sum of the determinants: divide by 6.")},
       {all / 3, words("{answer} is divided by 3: the base of a tetrahedron is half a parallelogram, so "
                       "divide by 6.")}});
}

LineTable<Out> lines() {
  return joined<LineRow<Out>>(
      {linesOfEach<Out>(
           mostTetrahedra,
           [](const Out &at, std::size_t index) { return at.hasVolume && index < at.tetrahedra.size(); },
           {{"det", determinantLine}}, 1),
       {{"volume", &Out::hasVolume, volumeLine}}});
}

/// The edges of the tetrahedra that are none of the solid.
Figure draw(const Out &at) {
  Figure figure;
  const auto &[vertices, faces] = at.in.K.object.mesh;
  const auto sides = edgesByEnds(faces);
  for (std::uint32_t corner = 1; corner < vertices.size(); ++corner) {
    const bool isEdge = std::any_of(sides.begin(), sides.end(), [corner](const FaceEdge &side) {
      return side.ends() == std::pair<std::uint32_t, std::uint32_t>(0, corner);
    });
    if (!isEdge && vertices[corner] != vertices[0])
      figure.add(SegmentMark{{partOf(at.mark("ways"), corner), Role::Helper, Subject::Measure},
                             place(vertices[0]),
                             place(vertices[corner])});
  }
  return figure;
}

} // namespace

Construction solid_volume() {
  std::vector<std::string> letters{"V"};
  for (std::size_t i = 1; i <= mostTetrahedra; ++i)
    letters.push_back("D" + std::to_string(i));
  return taught<Out, SolidObject>({.id = "solid-volume",
                                   .word = "volume",
                                   .title = [] { return words("volume"); },
                                   .roles = {"K"},
                                   .letters = std::move(letters),
                                   .cases = {"solid", "flat", "self-meeting", "not-planar"},
                                   .values = {{named::number("volume"), &Out::hasVolume, &Out::V}},
                                   .lines = lines(),
                                   .marks = {"ways"},
                                   .tell = tell,
                                   .draw = draw});
}

} // namespace halfspace
