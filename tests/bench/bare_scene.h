// The yardstick: a picture drawn the usual VTK way, an actor with a source of its own for each thing. Knows
// nothing of the rest of this program.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

class vtkRenderer;

namespace halfspace::bench {

using Path = std::vector<glm::dvec3>;

/// Tubes around open paths, as one actor: an outline, or the dashes of a line.
struct BareTubes {
  std::vector<Path> paths;
  double radius = 0;
  glm::dvec3 color{};
  bool operator==(const BareTubes &) const = default;
};

struct BareArrow {
  glm::dvec3 from{};
  glm::dvec3 vector{};
  double radius = 0;
  glm::dvec3 color{};
  bool operator==(const BareArrow &) const = default;
};

struct BareBall {
  glm::dvec3 at{};
  double radius = 0;
  glm::dvec3 color{};
  bool operator==(const BareBall &) const = default;
};

struct BareFace {
  Path corners;
  glm::dvec3 color{};
  double opacity = 1;
  bool operator==(const BareFace &) const = default;
};

/// Lines one pixel wide on the ground.
struct BareGrid {
  std::vector<Path> lines;
  glm::dvec3 color{};
  bool operator==(const BareGrid &) const = default;
};

/// A surface of very many triangles; its corners are put into the scene by a matrix.
struct BareMesh {
  std::shared_ptr<const std::vector<glm::dvec3>> corners;
  std::shared_ptr<const std::vector<glm::uvec3>> triangles;
  glm::dmat4 placement{1};
  glm::dvec3 color{};
  bool operator==(const BareMesh &) const = default;
};

using BareThing = std::variant<BareGrid, BareTubes, BareArrow, BareBall, BareFace, BareMesh>;

/// Rows from top to bottom, four bytes a pixel.
struct BareImage {
  int width = 0;
  int height = 0;
  const std::uint8_t *rgba = nullptr;
  std::shared_ptr<const void> owner; ///< keeps the bytes
};

/// An image with its lower left corner at a pixel counted from the lower left of the view.
struct BareLabel {
  BareImage image;
  glm::dvec2 pixel{};
};

struct BarePicture {
  std::map<std::string, BareThing> things; ///< by name: what has the same name is the same actor
  std::vector<BareLabel> labels;
};

struct BareCamera {
  glm::dvec3 eye{};
  glm::dvec3 target{};
  double viewAngle = 0; ///< vertical, in radians
};

/// Plain passes and no sorting, as the program has them: so the difference is how the picture is kept up to
/// date.
class BareScene {
public:
  BareScene();
  ~BareScene();
  BareScene(const BareScene &) = delete;
  BareScene &operator=(const BareScene &) = delete;

  [[nodiscard]] vtkRenderer *renderer() const;
  void setCamera(const BareCamera &camera);
  /// Changes the sources of the things that differ from what was shown before.
  void show(const BarePicture &picture);
  /// To be called when the first picture is shown.
  void fitClippingRange();

private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

/// A picture much like a lesson's, with these labels: a plane with its normal, points, a ray, the grid and
/// the axes.
[[nodiscard]] BarePicture samplePicture(const std::vector<BareImage> &labels);

} // namespace halfspace::bench
