#include <geometry/intersect_ray_plane.h>

#include <iostream>

int main() {
  using namespace halfspace;
  const auto plane = planeThrough<Rational>({5, 4, 7}, {1, 2, 2});
  const Ray<Rational> ray{{11, 15, 8}, {-1, 3, 2}};
  const auto meet = intersectRayPlane(ray, plane);
  std::cout << (meet.which == RayPlaneCase::Behind ? "behind, t = " : "t = ") << meet.t << "\n";
}
