#include "lessons/construction/parts/fragments.h"

#include "lessons/term/plain_text.h"

#include <cassert>

namespace halfspace {

std::size_t fragmentCount(const GivenMeshes &meshes) {
  std::size_t count = 0;
  for (const auto &mesh : meshes)
    count += mesh.object.shape->triangleCount();
  return count;
}

std::size_t numberOf(const GivenMeshes &meshes, const Fragment &fragment) {
  std::size_t before = 0;
  for (std::size_t i = 0; i < fragment.mesh; ++i)
    before += meshes[i].object.shape->triangleCount();
  return before + fragment.index + 1;
}

Fragment fragmentOf(const GivenMeshes &meshes, std::size_t number) {
  assert(number >= 1 && number <= fragmentCount(meshes));
  Fragment fragment{0, number - 1};
  while (fragment.index >= meshes[fragment.mesh].object.shape->triangleCount()) {
    fragment.index -= meshes[fragment.mesh].object.shape->triangleCount();
    ++fragment.mesh;
  }
  return fragment;
}

Triangle<Rational> triangleOf(const GivenMeshes &meshes, const Fragment &fragment) {
  return triangleOf(meshes[fragment.mesh].object, fragment.index);
}

std::string nameOf(const GivenMeshes &meshes, const Fragment &fragment) {
  return plainText(meshes[fragment.mesh].symbol) + " " + std::to_string(fragment.index + 1);
}

Term crossingTerm(const RayTerms &ray, const Triangle<Rational> &triangle) {
  const auto listOf = [](const ExactVec3 &vector) { return list({vector.x, vector.y, vector.z}); };
  const Term n = listOf(perpsOf(triangle).normal);
  return dot(listOf(triangle.p0) - ray.Q, n) / dot(ray.r, n);
}

FirstHits firstHits(const RayObject &ray, const GivenMeshes &meshes) {
  FirstHits first;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const MeshObject &mesh = meshes[i].object;
    const Ray<Rational> own = MeshPlacement(mesh).toMesh({ray.origin, ray.direction});
    const auto hit = mesh.shape->search()->search(own).nearest;
    if (!hit)
      continue;
    if (!first.fragments.empty() && hit->t < first.t)
      first.fragments.clear();
    if (first.fragments.empty() || hit->t == first.t) {
      first.t = hit->t;
      first.fragments.push_back({i, hit->index});
    }
  }
  return first;
}

} // namespace halfspace
