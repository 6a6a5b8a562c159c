#include "lessons/figure/extents.h"
#include "tests/animation/animated_lessons.h"
#include "widgets/animation/film.h"
#include "widgets/flight/scene_flight.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/lesson_picture.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {
namespace {

using test::animated;
using test::motionOf;

void expectSame(const Figure &figure, const Figure &other) {
  ASSERT_EQ(figure.marks.size(), other.marks.size());
  for (std::size_t i = 0; i < figure.marks.size(); ++i)
    EXPECT_EQ(figure.marks[i], other.marks[i]) << baseOf(figure.marks[i]).id;
  EXPECT_EQ(extentsOf(figure), extentsOf(other));
}

/// What a picture shows of a scene by one of its lesson's steps; null: of the whole of it.
SceneContent contentBy(const AnimatedScene &scene, const LessonStep *step) {
  const Evaluation evaluation = evaluate(scene.scene);
  return contentOf(scene.lesson.get(), step, evaluation,
                   stageOf(scene.scene, boundObjectsOf(scene.scene, evaluation)));
}

/// The scene with another value of one of its numbers.
Scene withNumber(Scene scene, const std::string &name, int value) {
  NumberObject number = *objectAs<NumberObject>(*findObject(scene, name));
  number.value = value;
  setObject(scene, name, number);
  return scene;
}

TEST(FlightMotion, AtItsOwnSpeed_ShowsOneFrameAfterTheOther) {
  const AnimatedScene scene = animated("photon-torpedo");
  const auto motion = motionOf("flight", scene);
  ASSERT_TRUE(motion);
  const LessonStep *step = nullptr;
  for (const LessonStep &each : scene.lesson->steps)
    if (flightOf(each))
      step = &each;
  const std::vector<double> moments = momentsOf(*motion, framesPerSecond);
  const auto flight = flightIn(scene.scene, *flightOf(*step));
  const Rational last(static_cast<int>(moments.size()) - 1);
  EXPECT_GE(last, flight->lastFrame(evaluate(scene.scene)));
  EXPECT_LT(last - 1, flight->lastFrame(evaluate(scene.scene)));
  for (const std::size_t frame : {std::size_t{0}, std::size_t{1}, std::size_t{38}, moments.size() - 1}) {
    SCOPED_TRACE(frame);
    AnimatedScene there = scene;
    there.scene = withNumber(scene.scene, flightOf(*step)->frame, static_cast<int>(frame));
    const Moment moment = motion->at(moments[frame]);
    expectSame(moment.content.figure, contentBy(there, step).figure);
    EXPECT_TRUE(moment.labelledLike);
  }
}

TEST(FlightMotion, ThatFiresByItself_GoesOnToTheLastFrame) {
  AnimatedScene scene = animated("photon-torpedo");
  scene.scene = withNumber(scene.scene, "seed", 7);
  const auto frame = *objectAs<NumberObject>(*findObject(scene.scene, "frame"));
  EXPECT_DOUBLE_EQ(motionOf("flight", scene)->seconds(), toDouble(frame.to) / framesPerSecond);
  EXPECT_DOUBLE_EQ(motionOf("flight", scene, 3)->seconds(), 3);
}

TEST(FlightMotion, OfALessonWithoutOne_IsRefused) {
  EXPECT_FALSE(findMotionKind("flight")->make(animated("signed-distance"), {}));
  AnimatedScene none = animated("photon-torpedo");
  none.lesson = nullptr;
  EXPECT_FALSE(findMotionKind("flight")->make(none, {}));
}

TEST(StepsMotion, BeginsWithTheFirstStepAndEndsWithTheLast) {
  const AnimatedScene scene = animated("signed-distance");
  const auto motion = motionOf("steps", scene);
  ASSERT_TRUE(motion);
  const auto &steps = scene.lesson->steps;
  const double length = motion->seconds() / static_cast<double>(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    SCOPED_TRACE(steps[i].title);
    const Moment rest = motion->at(length * (static_cast<double>(i) + 0.9));
    expectSame(rest.content.figure, contentBy(scene, &steps[i]).figure);
    EXPECT_TRUE(rest.content.arrival.marks.empty());
  }
  expectSame(motion->at(0).content.figure, contentBy(scene, &steps.front()).figure);
  expectSame(motion->at(motion->seconds()).content.figure, contentBy(scene, &steps.back()).figure);
}

TEST(StepsMotion, FromStepToStep_NewMarksFadeIn_AndLabelsStayWhereTheyAre) {
  const AnimatedScene scene = animated("signed-distance");
  const auto motion = motionOf("steps", scene);
  const auto &steps = scene.lesson->steps;
  const double length = motion->seconds() / static_cast<double>(steps.size());
  std::size_t faded = 0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const Moment early = motion->at(length * static_cast<double>(i) + 0.05);
    const Moment later = motion->at(length * static_cast<double>(i) + 0.2);
    faded += early.content.arrival.marks.size();
    if (!early.content.arrival.marks.empty()) {
      EXPECT_LT(early.content.arrival.presence, later.content.arrival.presence);
      EXPECT_LT(later.content.arrival.presence, 1);
    }
    for (const Mark &mark : later.content.figure.marks)
      EXPECT_NE(findMark(later.labelledLike->figure, baseOf(mark).id), nullptr) << baseOf(mark).id;
    EXPECT_EQ(early.camera, later.camera);
  }
  EXPECT_GT(faded, 0U);
}

TEST(StepsMotion, OfNoLessonOrOfAChosenStep_IsRefused) {
  AnimatedScene scene = animated("signed-distance");
  scene.step = 1;
  EXPECT_FALSE(findMotionKind("steps")->make(scene, {}));
  scene.step = {};
  scene.lesson = nullptr;
  EXPECT_FALSE(findMotionKind("steps")->make(scene, {}));
}

TEST(TurnMotion, EndsWhereItBegins_AndIsHalfwayRoundInBetween) {
  const auto motion = motionOf("turn", animated("ray-triangle-perp"));
  ASSERT_TRUE(motion->isLoop());
  const Camera begin = motion->at(0).camera;
  const Camera half = motion->at(motion->seconds() / 2).camera;
  const Camera end = motion->at(motion->seconds()).camera;
  EXPECT_LT(glm::distance(begin.eye(), end.eye()), 1e-9);
  EXPECT_LT(glm::distance(begin.viewDirection(), end.viewDirection()), 1e-9);
  EXPECT_NEAR(half.viewDirection().x, -begin.viewDirection().x, 1e-9);
  EXPECT_NEAR(half.viewDirection().y, -begin.viewDirection().y, 1e-9);
  EXPECT_NEAR(half.viewDirection().z, begin.viewDirection().z, 1e-9);
}

TEST(TurnMotion, OfALessonAsItBegins_KeepsAllOfItInView) {
  for (const std::string lesson : {"ray-triangle-perp", "signed-distance", "plane-plane", "photon-torpedo"}) {
    SCOPED_TRACE(lesson);
    const AnimatedScene scene = animated(lesson);
    const auto motion = motionOf("turn", scene);
    const std::vector<Place> places = placesNearGiven(contentBy(scene, nullptr).figure, true);
    for (const double time : momentsOf(*motion, 7)) {
      const Camera camera = motion->at(time).camera;
      for (const Place &place : places) {
        const auto pixel = camera.project(place, scene.size);
        ASSERT_TRUE(pixel);
        EXPECT_TRUE(pixel->x > 0 && pixel->y > 0 && pixel->x < scene.size.width &&
                    pixel->y < scene.size.height)
            << pixel->x << " " << pixel->y;
      }
    }
  }
}

TEST(TurnMotion, FromAChosenView_BeginsWithThat_AndShowsTheStepThatIsAskedFor) {
  AnimatedScene scene = animated("signed-distance");
  Camera chosen;
  chosen.azimuth = 1;
  chosen.height = 7;
  scene.camera = chosen;
  scene.step = 0;
  const auto motion = motionOf("turn", scene, 2);
  EXPECT_EQ(motion->at(0).camera, chosen);
  EXPECT_DOUBLE_EQ(motion->seconds(), 2);
  expectSame(motion->at(1).content.figure, contentBy(scene, &scene.lesson->steps.front()).figure);
}

TEST(MotionKinds, HaveNamesThatStandOnce) {
  std::set<std::string> names;
  for (const MotionKind &kind : motionKinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_EQ(findMotionKind(kind.name), &kind);
    EXPECT_FALSE(kind.title.empty());
  }
  EXPECT_EQ(findMotionKind("dance"), nullptr);
}

} // namespace
} // namespace halfspace
