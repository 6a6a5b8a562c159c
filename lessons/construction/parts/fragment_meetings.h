// How a ray meets the triangles of several meshes.
#pragma once

#include "lessons/construction/parts/fragments.h"

namespace halfspace {

/// Nobody reads a longer list: of meshes with more triangles, what is hit first and what is looked at are
/// told.
inline constexpr std::size_t mostListedFragments = 128;

/// Where all meshes stand: that takes a root for each of them.
using Placements = std::vector<MeshPlacement>;
[[nodiscard]] Placements placementsOf(const GivenMeshes &meshes);

/// A triangle, and how the ray meets it.
struct Meeting {
  Fragment fragment;
  std::size_t number = 0;
  Triangle<Rational> triangle;
  RayTriangle<Rational> meet;

  [[nodiscard]] bool isHit() const { return meet.which == RayTriangleCase::Hit; }
  [[nodiscard]] bool isBehind() const { return meet.which == RayTriangleCase::Behind; }
  [[nodiscard]] bool isTriangle() const { return meet.perps.denominator != 0; }
};

/// With the triangle of a number from 1 to the count.
[[nodiscard]] Meeting meetingWith(const RayObject &ray, const GivenMeshes &meshes,
                                  const Placements &placements, std::size_t number);

/// Earlier hits come first, and of those with the same λ the one with the lower number.
[[nodiscard]] bool isNearer(const Meeting &a, const Meeting &b);

/// Those that are listed, by number: all of meshes with few triangles, and those that are needed.
[[nodiscard]] std::vector<Meeting> listedMeetings(const RayObject &ray, const GivenMeshes &meshes,
                                                  const Placements &placements,
                                                  const std::vector<std::optional<Meeting>> &needed);

/// What a ray and a triangle in whose plane it lies have in common, by the ray's λ.
struct Passage {
  Rational begin;
  Rational end;
  Fragment fragment{};
};

/// The first along the ray of those in whose planes it lies; nothing where it touches none of them.
[[nodiscard]] std::optional<Passage> firstAlong(const RayObject &ray, const std::vector<Meeting> &meetings);

} // namespace halfspace
