// The camera once around the scene.
#include "lessons/words.h"
#include "widgets/animation/staged_scene.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/design_scale.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace halfspace {
namespace {

constexpr double usualSeconds = 8;

/// The figure is kept in view in so many directions; between them nearly all of it is.
constexpr int directions = 24;

constexpr double fullTurn = 2 * std::numbers::pi;

/// A place carried around the upright axis through a pivot.
Place turned(const Place &place, const Place &pivot, double angle) {
  const Place away = place - pivot;
  return pivot + Place(away.x * std::cos(angle) - away.y * std::sin(angle),
                       away.x * std::sin(angle) + away.y * std::cos(angle), away.z);
}

/// All that comes by when places are carried around.
std::vector<Place> sweptBy(const std::vector<Place> &places, const Place &pivot) {
  std::vector<Place> swept;
  for (int i = 0; i < directions; ++i)
    for (const Place &place : places)
      swept.push_back(turned(place, pivot, fullTurn * i / directions));
  return swept;
}

class Turn : public Motion {
public:
  Turn(const StagedScene &staged, double seconds)
      : m_content(staged.shown(staged.step())), m_camera(staged.camera()), m_seconds(seconds) {
    const SceneContent whole = staged.shown(nullptr);
    const std::vector<Place> places = placesNearGiven(whole.figure, whole.stage.hasAxes());
    const PixelSize size = staged.animated.size;
    const View view{m_camera, size, ownPixelRatio(size)};
    m_pivot = middleInView(view, places);
    if (!staged.animated.camera)
      m_camera = fitted(view, sweptBy(places, m_pivot));
  }

  [[nodiscard]] double seconds() const override { return m_seconds; }
  [[nodiscard]] bool isLoop() const override { return true; }

  [[nodiscard]] Moment at(double time) override {
    Camera camera = m_camera;
    camera.turnAbout(m_pivot, fullTurn * time / m_seconds, 0);
    return {m_content, {}, camera};
  }

private:
  SceneContent m_content;
  Camera m_camera;
  Place m_pivot{};
  double m_seconds;
};

Result<std::unique_ptr<Motion>> makeTurn(const AnimatedScene &scene, std::optional<double> seconds) {
  return std::unique_ptr<Motion>(std::make_unique<Turn>(StagedScene(scene), seconds.value_or(usualSeconds)));
}

} // namespace

MotionKind turn() { return {"turn", words("A turn around the scene"), false, makeTurn}; }

} // namespace halfspace
