// What moves in an animation: the picture of each of its moments.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/result.h"
#include "widgets/picture/scene_content.h"

#include <functional>
#include <memory>

namespace halfspace {

/// A scene that is to be shown in motion. A plain value, which a thread of its own may have.
struct AnimatedScene {
  std::shared_ptr<const Lesson> lesson; ///< that it belongs to; null: none
  Scene scene;
  PixelSize size;          ///< of the pictures
  std::optional<int> step; ///< that is shown, from 0; nothing: as suits the motion
  /// On the scene's stage, for pictures of this size. Nothing: as the lesson begins.
  std::optional<Camera> camera;
  /// In the place of what a step shows, where the motion chooses none.
  std::optional<SceneContent> shown;
};

/// What a picture shows at a moment, and from where.
struct Moment {
  SceneContent content;
  /// As in `PictureRequest`; nothing: labels go on from the moment before.
  std::optional<SceneContent> labelledLike;
  Camera camera;
};

class Motion {
public:
  Motion() = default;
  virtual ~Motion() = default;
  Motion(const Motion &) = delete;
  Motion &operator=(const Motion &) = delete;

  /// How long it takes, in seconds: more than 0.
  [[nodiscard]] virtual double seconds() const = 0;
  /// Whether its end is its beginning: shown again and again it goes on without a break.
  [[nodiscard]] virtual bool isLoop() const { return false; }
  /// What is seen so many seconds after its beginning, from 0 to seconds().
  [[nodiscard]] virtual Moment at(double time) = 0;
};

/// One file in motions/, and a word in this room's CMakeLists.txt.
struct MotionKind {
  std::string name;  ///< as it is asked for: flight
  std::string title; ///< for people, in their language
  bool choosesSteps; ///< it shows steps of its own choice where none is asked for, not the one that is shown
                     ///< now
  /// The motion of a scene, in so many seconds or in as many as it takes by itself; or a sentence where the
  /// scene has no such motion.
  std::function<Result<std::unique_ptr<Motion>>(const AnimatedScene &scene, std::optional<double> seconds)>
      make;
};

[[nodiscard]] const std::vector<MotionKind> &motionKinds();

/// The one of this name, or null.
[[nodiscard]] const MotionKind *findMotionKind(std::string_view name);

} // namespace halfspace
