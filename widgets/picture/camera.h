// The turntable camera, as plain maths: no VTK, so that dragging and picking can be tested without a screen.
#pragma once

#include "lessons/figure/mark.h"
#include "lessons/scene/camera_view.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace halfspace {

/// A size in device pixels.
struct PixelSize {
  int width = 1;
  int height = 1;
  bool operator==(const PixelSize &) const = default;
};

/// An upright rectangle of a view, in device pixels from the view's top left corner.
struct PixelBox {
  glm::dvec2 low{};
  glm::dvec2 high{};
  bool operator==(const PixelBox &) const = default;

  [[nodiscard]] glm::dvec2 extent() const { return high - low; }
};

/// A half-line of sight: where the eye looks through a pixel. The direction is unit.
struct SightLine {
  Place origin{};
  Place direction{};
};

/// A camera that turns about `target` with z up and cannot end upside down. Angles are in radians.
class Camera {
public:
  Camera() = default;
  explicit Camera(const CameraView &view);

  Place target{};
  double azimuth = 0;     ///< of the eye as seen from the target, from +x towards +y
  double elevation = 0.4; ///< of the eye above the horizontal; within ±maxElevation
  double height = 21;     ///< scene units from the bottom to the top of the view, at the target
  bool orthographic = false;

  /// Just short of straight up, where the horizon would lose its direction.
  static constexpr double maxElevation = 1.5690;
  static constexpr double minHeight = 0.05;
  static constexpr double maxHeight = 2000;
  /// The target stays within so many units of the origin, in each coordinate: farther away nothing is drawn.
  static constexpr double farthestTarget = 1000;
  /// The vertical angle of view of the perspective camera: 28°.
  static constexpr double viewAngle = 0.4886921905584123;

  [[nodiscard]] Place eye() const;
  /// From the eye to the target.
  [[nodiscard]] double distance() const;
  /// Unit, from the eye towards the target.
  [[nodiscard]] Place viewDirection() const;
  [[nodiscard]] Place right() const;
  [[nodiscard]] Place up() const;

  void turn(double azimuthChange, double elevationChange);
  /// Likewise, but about another place: it stays where it is on the screen.
  void turnAbout(Place pivot, double azimuthChange, double elevationChange);
  /// Moves the target in the plane of the screen, so that the picture there follows a pointer that moved by
  /// so many pixels (x right, y down).
  void pan(glm::dvec2 pixels, PixelSize size);
  /// Scales the view by a factor (< 1 comes nearer), keeping the point under the pixel (at the target's
  /// depth) where it is. `height` stays between minHeight and maxHeight.
  void zoom(double factor, glm::dvec2 pixel, PixelSize size);

  /// Pixel (x right, y down, from the top left corner of the view) and depth (0 at the eye, 1/2 at the
  /// target's depth, towards 1 far away) of a place; nothing for a place behind the eye or not finite.
  [[nodiscard]] std::optional<glm::dvec3> project(Place place, PixelSize size) const;
  [[nodiscard]] SightLine sightThrough(glm::dvec2 pixel, PixelSize size) const;
  /// The scene units that one pixel spans at a place; 0 behind the eye.
  [[nodiscard]] double unitsPerPixel(Place at, PixelSize size) const;

  bool operator==(const Camera &) const = default;
};

/// The camera looking the same way that shows all places as large as they fit into a part of the view; the
/// same camera for no places.
[[nodiscard]] Camera fitted(Camera camera, const std::vector<Place> &places, PixelSize size,
                            const PixelBox &room);

/// The camera for a view that had another size: whatever was between the left and the right side still is.
[[nodiscard]] Camera keptBetweenSides(Camera camera, PixelSize before, PixelSize now);

} // namespace halfspace
