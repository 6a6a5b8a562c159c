// How every step of every lesson begins: nothing lies over anything, and everything can be read and grabbed.
#include "lessons/lesson/lesson.h"
#include "lessons/lesson/shown.h"
#include "lessons/scene/hand/handles.h"
#include "tests/effort.h"
#include "tests/picture/labels/vectors_only.h"
#include "tests/test_name.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/flat_picture.h"
#include "widgets/picture/hand/handle_drag.h"
#include "widgets/picture/labels/label_page.h"
#include "widgets/picture/screen_shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {
namespace {

const LessonLibrary &library() {
  static const LessonLibrary lessons = readLessons(LESSON_FOLDER);
  return lessons;
}

/// Two handles nearer than this, in design pixels, are grabbed one for the other …
constexpr double leastHandleDistance = 22;
/// … but for an arrow's tip and its start: the arrow shows which is which.
constexpr double leastArrowLength = 11;
/// Lines that meet at a smaller angle than this on the screen look like one, in radians; axes, like none that
/// are square to each other.
constexpr double leastAngle = 0.12;
constexpr double leastAxesAngle = 0.3;
/// An arrow no end of which is farther away from an axis, in design pixels, is taken for a part of it.
constexpr double leastAxisDistance = 6;

/// A step's picture as it is seen when the lesson begins there.
struct Page {
  const Theme &theme;
  View view{};
  SceneContent content{};
  std::vector<Handle> handles{};
  LabelPage placer{};
  std::vector<LabelOnPage> labels{};
  std::vector<Place> places{}; ///< that belong into the view

  [[nodiscard]] glm::dvec2 pixelOf(const Place &place) const {
    return glm::dvec2(view.camera.project(place, view.size).value());
  }
};

void placeLabels(Page &page, const std::optional<AxesReach> &axes) {
  const double scale = designScale(page.view.camera, page.view.size, page.view.pixelRatio);
  const auto ofAxes = axes ? axisLabels(*axes, page.view.camera, 0, scale) : std::vector<AxisLabel>();
  page.labels =
      page.placer.place(writtenLabels(page.content, ofAxes, page.theme, page.view),
                        obstaclesOf(page.content, axes, page.theme, page.view), vectorsOnly(), page.view);
}

Page pageOf(const Lesson &lesson, const LessonStep &step, const Theme &theme, PixelSize size, double ratio,
            const std::vector<PixelBox> &covered) {
  const Evaluation evaluation = evaluate(lesson.scene);
  const Figure whole = figureOf(evaluation);
  Page page{theme};
  page.content.figure = shownIn(step, evaluation, whole).figure;
  page.handles = handlesOf({lesson.scene, evaluation});
  page.places = placesOf(whole);
  for (const Handle &handle : page.handles) {
    page.places.push_back(shownPlace(handle));
    if (const auto knob = knobOf(handle, false))
      page.content.knobs.push_back(*knob);
  }
  const std::vector<Place> tips = axisTips(whole);
  page.places.insert(page.places.end(), tips.begin(), tips.end());
  page.view = {Camera(lesson.camera), size, ratio, covered};
  page.view.camera = fitted(page.view, page.places);
  placeLabels(page, axesAround(page.content.figure));
  return page;
}

PixelBox boxOf(const LabelOnPage &label) {
  return {label.place.topLeft, label.place.topLeft + label.place.extent};
}

/// A straight thing, in space and on the screen.
struct Stroke {
  std::string name;
  Place along{};
  glm::dvec2 from{};
  glm::dvec2 to{};
};

Stroke strokeOf(const Page &page, const std::string &name, const Place &from, const Place &to) {
  return {name, to - from, page.pixelOf(from), page.pixelOf(to)};
}

std::vector<Stroke> axesOf(const Page &page) {
  static const std::array<std::string, 3> names{"x", "y", "z"};
  std::vector<Stroke> strokes;
  const auto ends = axisEnds(axesAround(page.content.figure));
  for (std::size_t i = 0; i < ends.size(); ++i)
    strokes.push_back(strokeOf(page, names[i], ends[i].low, ends[i].high));
  return strokes;
}

std::vector<Stroke> arrowsOf(const Page &page) {
  std::vector<Stroke> strokes;
  for (const Mark &mark : page.content.figure.marks)
    if (const auto *arrow = std::get_if<ArrowMark>(&mark))
      strokes.push_back(strokeOf(page, arrow->id, arrow->from, arrow->from + shownVector(*arrow)));
  return strokes;
}

/// The sides of polygons, each from both of its ends.
std::vector<Stroke> sidesOf(const Page &page) {
  std::vector<Stroke> strokes;
  for (const Mark &mark : page.content.figure.marks)
    if (const auto *polygon = std::get_if<PolygonMark>(&mark))
      for (std::size_t i = 0; i < polygon->corners.size(); ++i) {
        const Place &from = polygon->corners[i];
        const Place &to = polygon->corners[(i + 1) % polygon->corners.size()];
        strokes.push_back(strokeOf(page, "a side of " + polygon->id, from, to));
        strokes.push_back(strokeOf(page, "a side of " + polygon->id, to, from));
      }
  return strokes;
}

std::vector<Stroke> ticksOf(const Page &page) {
  const double scale = designScale(page.view.camera, page.view.size, page.view.pixelRatio);
  std::vector<Stroke> strokes;
  for (const auto &[low, high] : axisTicks(axesAround(page.content.figure), page.view.camera, scale))
    strokes.push_back(strokeOf(page, "a tick", low, high));
  return strokes;
}

/// What is wrong with a page, a sentence each.
std::vector<std::string> coveredLabels(const Page &page) {
  std::vector<std::string> wrong;
  std::vector<Stroke> strokes = axesOf(page);
  for (Stroke &arrow : arrowsOf(page))
    strokes.push_back(std::move(arrow));
  const std::vector<Stroke> ticks = ticksOf(page);
  for (const LabelOnPage &label : page.labels) {
    const PixelBox box = boxOf(label);
    for (const LabelOnPage &other : page.labels)
      if (label.text.id < other.text.id && overlapArea(box, boxOf(other)) > 0)
        wrong.push_back(label.text.id + " and " + other.text.id + " lie over each other");
    for (const Stroke &stroke : strokes)
      if (lengthInside(box, stroke.from, stroke.to) > 0)
        wrong.push_back(label.text.id + " is struck through by " + stroke.name);
    const bool isOfAxes = label.text.stand == LabelStand::Pinned || label.text.id.starts_with("axis ");
    for (const Stroke &tick : ticks)
      if (!isOfAxes && lengthInside(box, tick.from, tick.to) > 0)
        wrong.push_back(label.text.id + " lies on a tick");
    for (const Handle &handle : page.handles)
      if (distanceTo(box, page.pixelOf(shownPlace(handle))) < 4 * page.view.pixelRatio)
        wrong.push_back(label.text.id + " lies on the handle " + handle.id);
    for (const PixelBox &covered : page.view.covered)
      if (overlapArea(box, covered) > 0)
        wrong.push_back(label.text.id + " is covered");
    if (overlapArea(box, page.view.box()) < box.extent().x * box.extent().y)
      wrong.push_back(label.text.id + " leaves the view");
  }
  return wrong;
}

/// Labels of points that stand nearer to another point with a label, without a leader that tells whose they
/// are.
std::vector<std::string> mistakenLabels(const Page &page) {
  std::vector<std::string> wrong;
  for (const LabelOnPage &label : page.labels)
    for (const Mark &mark : page.content.figure.marks) {
      const auto *own = std::get_if<PointMark>(findMark(page.content.figure, label.text.id));
      const auto *other = std::get_if<PointMark>(&mark);
      if (!own || !other || other->label.empty() || label.place.needsLeader)
        continue;
      const double reach = distanceTo(boxOf(label), page.pixelOf(own->at));
      if (reach > distanceTo(boxOf(label), page.pixelOf(other->at)) + page.view.pixelRatio)
        wrong.push_back(label.text.id + " seems to be the name of " + other->id);
    }
  return wrong;
}

std::vector<std::string> missingLabels(const Page &page) {
  std::vector<std::string> wrong;
  for (const Mark &mark : page.content.figure.marks) {
    const MarkBase &base = baseOf(mark);
    const auto isIts = [&](const LabelOnPage &label) { return label.text.id == base.id; };
    if (!base.label.empty() && std::none_of(page.labels.begin(), page.labels.end(), isIts))
      wrong.push_back(base.id + " has no label");
  }
  return wrong;
}

/// What moves when a handle is selected: its gizmo comes, and the line down to the ground.
std::vector<std::string> labelsThatMove(const Page &page) {
  std::vector<std::string> wrong;
  for (const Handle &handle : page.handles) {
    Page selected = page;
    selected.content.gizmo.emplace();
    selected.content.gizmo->at = shownPlace(handle);
    selected.content.gizmo->note = "\\text{$\\displaystyle z = 2$ fixed}";
    selected.content.dropLine = DropLine{toDouble(handle.at)};
    placeLabels(selected, axesAround(selected.content.figure));
    for (const LabelOnPage &label : page.labels)
      for (const LabelOnPage &after : selected.labels)
        if (label.text.id == after.text.id && label.place.topLeft != after.place.topLeft)
          wrong.push_back(label.text.id + " moves for " + handle.id);
    for (const std::string &sentence : coveredLabels(selected))
      if (sentence.find("note") != std::string::npos || sentence.find("drop") != std::string::npos)
        wrong.push_back(sentence + ", for " + handle.id);
  }
  return wrong;
}

std::vector<std::string> placesOutOfView(const Page &page) {
  std::vector<std::string> wrong;
  for (const Place &place : page.places) {
    const glm::dvec2 pixel = page.pixelOf(place);
    if (distanceTo(page.view.box(), pixel) > 0)
      wrong.emplace_back("a place is out of view");
    for (const PixelBox &covered : page.view.covered)
      if (distanceTo(covered, pixel) == 0)
        wrong.emplace_back("a place is covered");
  }
  return wrong;
}

/// How near two handles may be on the screen, in design pixels. Arrows may start in one point, but the handle
/// of a whole sits on no other.
double leastDistance(const Handle &a, const Handle &b) {
  if (a.motion == Handle::Motion::Whole || b.motion == Handle::Motion::Whole)
    return leastHandleDistance;
  if (shownPlace(a) == shownPlace(b))
    return 0;
  const bool isArrow = a.base == b.at || b.base == a.at;
  return isArrow ? leastArrowLength : leastHandleDistance;
}

std::vector<std::string> handlesInTheWay(const Page &page) {
  std::vector<std::string> wrong;
  for (const Handle &handle : page.handles)
    for (const Handle &other : page.handles) {
      const double distance =
          glm::distance(page.pixelOf(shownPlace(handle)), page.pixelOf(shownPlace(other)));
      if (handle.id < other.id && distance < leastDistance(handle, other) * page.view.pixelRatio)
        wrong.push_back(handle.id + " and " + other.id + " are " + std::to_string(distance) + " apart");
    }
  return wrong;
}

/// What a plain drag does not move along the grid, because what it would move on is seen edge-on.
std::vector<std::string> handlesSeenEdgeOn(const Page &page) {
  std::vector<std::string> wrong;
  for (const Handle &handle : page.handles) {
    const auto mode = grabMode(handle, false, page.view.camera);
    if (!mode)
      wrong.push_back(handle.id + " cannot be grabbed");
    else if (movesFreely(handle) && *mode != DragMode::Horizontal)
      wrong.push_back(handle.id + " can be dragged up and down only");
  }
  return wrong;
}

/// The sine of the angle between two strokes on the screen.
double angleBetween(const Stroke &a, const Stroke &b) {
  const glm::dvec2 first = glm::normalize(a.to - a.from);
  const glm::dvec2 second = glm::normalize(b.to - b.from);
  return std::abs(first.x * second.y - first.y * second.x);
}

bool areParallel(const Stroke &a, const Stroke &b) {
  constexpr double rounding = 1e-9;
  return glm::length(glm::cross(glm::normalize(a.along), glm::normalize(b.along))) < rounding;
}

/// Whether both are sides of one body, or of it and a piece of it, which may lie behind one another as the
/// body is turned.
bool areOfOneBody(const Stroke &a, const Stroke &b) {
  const auto bodyOf = [](const Stroke &stroke) { return stroke.name.substr(0, stroke.name.find('/')); };
  return bodyOf(a) == bodyOf(b) && (bodyOf(a) != a.name || bodyOf(b) != b.name);
}

/// What meets and is seen as one line although it is none.
std::vector<std::string> falseLines(const Page &page) {
  std::vector<std::string> wrong;
  const auto compare = [&](const std::vector<Stroke> &strokes, double least) {
    for (std::size_t i = 0; i < strokes.size(); ++i)
      for (std::size_t j = i + 1; j < strokes.size(); ++j)
        if (strokes[i].from == strokes[j].from && !areOfOneBody(strokes[i], strokes[j]) &&
            !areParallel(strokes[i], strokes[j]) && angleBetween(strokes[i], strokes[j]) < least)
          wrong.push_back(strokes[i].name + " and " + strokes[j].name + " look like one line");
  };
  compare(axesOf(page), leastAxesAngle);
  std::vector<Stroke> figure = arrowsOf(page);
  for (Stroke &side : sidesOf(page))
    figure.push_back(std::move(side));
  compare(figure, leastAngle);
  return wrong;
}

/// Whether an arrow lies in an axis: then it is seen around that, as it is thicker.
bool liesIn(const Stroke &arrow, const Stroke &axis) {
  return areParallel(arrow, axis) && distanceToSegment(arrow.from, axis.from, axis.to) < 1;
}

/// Arrows that are seen along an axis in which they do not lie.
std::vector<std::string> arrowsOnAxes(const Page &page) {
  std::vector<std::string> wrong;
  for (const Stroke &axis : axesOf(page))
    for (const Stroke &arrow : arrowsOf(page)) {
      const double distance = std::max(distanceToSegment(arrow.from, axis.from, axis.to),
                                       distanceToSegment(arrow.to, axis.from, axis.to));
      if (distance < leastAxisDistance * page.view.pixelRatio && !liesIn(arrow, axis))
        wrong.push_back(arrow.name + " is " + std::to_string(distance) + " from the axis " + axis.name);
    }
  return wrong;
}

/// A picture on a screen.
struct Screen {
  PixelSize size;
  double ratio;
};

bool fitsAnyScreen(const Lesson &, const Theme &, const Screen &) { return true; }

/// The equations of three planes have no room in so small a picture, in the projector's large type.
bool fitsItsLabels(const Lesson &lesson, const Theme &theme, const Screen &screen) {
  const auto planes =
      std::count_if(lesson.scene.entries.begin(), lesson.scene.entries.end(), [](const Entry &entry) {
        const auto *object = std::get_if<Object>(&entry.content);
        return object && kindOf(*object) == "plane";
      });
  return planes < 3 || theme.name != "projector" || screen.size.width / screen.ratio > 400;
}

class StartView : public testing::TestWithParam<std::string> {
protected:
  /// Looks at all steps of the lesson, in all themes, at several sizes, where the lesson fits these.
  template <class Look, class Fits = decltype(&fitsAnyScreen)>
  void expectNothing(const Look &look, const Fits &fits = fitsAnyScreen) {
    const Lesson &lesson = *library().find(GetParam());
    const std::vector<LessonStep> noSteps;
    for (const Theme &theme : themes())
      for (const PixelSize size : {PixelSize{840, 725}, PixelSize{600, 480}, PixelSize{1100, 940}})
        for (const double ratio : {1.0, 1.5})
          for (const LessonStep &step : fits(lesson, theme, Screen{size, ratio}) ? lesson.steps : noSteps)
            for (const std::string &sentence :
                 look(pageOf(lesson, step, theme, size, ratio, coveredIn(lesson, size, ratio))))
              ADD_FAILURE() << theme.name << ", " << size.width << " wide, at " << ratio << ", " << step.title
                            << ": " << sentence;
  }

  /// Buttons in the upper right corner, a card in the lower left one, a flat picture in the lower right one.
  static std::vector<PixelBox> coveredIn(const Lesson &lesson, PixelSize size, double ratio) {
    const double width = size.width;
    const double height = size.height;
    const glm::dvec2 corner(width, height);
    std::vector<PixelBox> covered{{{width - 44 * ratio, 0}, {width, 160 * ratio}}};
    if (const auto flat = flatSizeIn(corner / ratio, 1); flat && lesson.flat)
      covered.push_back({corner - *flat * ratio, corner});
    const double cardEnd = std::min(430 * ratio, covered.size() > 1 ? covered.back().low.x : width);
    covered.push_back({{0, height - 56 * ratio}, {cardEnd, height}});
    return covered;
  }
};

TEST_P(StartView, NoLabelIsCovered) { expectNothing(coveredLabels, fitsItsLabels); }
TEST_P(StartView, EveryMarkHasItsLabel) { expectNothing(missingLabels); }
TEST_P(StartView, NoLabelSeemsToBeAnotherPoints) { expectNothing(mistakenLabels); }
TEST_P(StartView, NoLabelMovesWhenAHandleIsSelected) { expectNothing(labelsThatMove, fitsItsLabels); }
TEST_P(StartView, AllIsInView) { expectNothing(placesOutOfView); }
TEST_P(StartView, HandlesCanBeToldApart) { expectNothing(handlesInTheWay); }
TEST_P(StartView, NoHandleIsSeenEdgeOn) { expectNothing(handlesSeenEdgeOn); }
TEST_P(StartView, NoArrowLooksLikeAPartOfAnAxis) { expectNothing(arrowsOnAxes); }
TEST_P(StartView, NothingLooksLikeALineThatIsNone) { expectNothing(falseLines); }

/// A lesson in which one corner of a triangle was dragged to the middle of the two others, or to the first of
/// them.
Lesson withDegenerateTriangle(Lesson lesson, const std::string &triangle, std::size_t corner, bool toMiddle) {
  Object object = *findObject(lesson.scene, triangle);
  const ExactVec3 &first = object[corner == 0 ? 1 : 0];
  const ExactVec3 &second = object[corner == 2 ? 1 : 2];
  object[corner] = toMiddle ? (first + second) / Rational(2) : first;
  setObject(lesson.scene, triangle, std::move(object));
  return lesson;
}

TEST(DegenerateTriangles, HaveTheHandleOfTheWholeBesideTheirCorners) {
  int looks = 0;
  for (const Lesson &lesson : library().lessons)
    for (const Entry &entry : lesson.scene.entries)
      if (const Object *object = findObject(lesson.scene, entry.name);
          object && kindOf(*object) == "triangle")
        for (std::size_t corner = 0; corner < 3; ++corner)
          for (const bool toMiddle : {true, false}) {
            const Lesson degenerate = withDegenerateTriangle(lesson, entry.name, corner, toMiddle);
            Page page = pageOf(degenerate, degenerate.steps.front(), themes().front(), {840, 725}, 1, {});
            std::vector<Handle> &handles = page.handles;
            handles.erase(std::remove_if(handles.begin(), handles.end(),
                                         [&](const Handle &handle) { return handle.object != entry.name; }),
                          handles.end());
            for (const std::string &sentence : handlesInTheWay(page))
              ADD_FAILURE() << lesson.id << ", corner " << corner << ": " << sentence;
            ++looks;
          }
  EXPECT_GT(looks, 20);
}

/// The flat picture of a step in a room that it has beside the scene.
Page flatPageOf(const Lesson &lesson, const LessonStep &step, const Theme &theme, glm::dvec2 size,
                double ratio) {
  const Evaluation evaluation = evaluate(lesson.scene);
  const Figure whole = figureOf(evaluation);
  const FlatPicture flat(flatFrame(lesson.flat, lesson.scene).value(), {}, whole,
                         shownIn(step, evaluation, whole).figure);
  Page page{theme};
  page.view = flat.fitted({{}, {static_cast<int>(size.x), static_cast<int>(size.y)}, ratio});
  page.content = flat.seenFrom(page.view);
  placeLabels(page, std::nullopt);
  return page;
}

/// The scenes of a lesson's flat picture: as it begins, and with its point and its ray dragged elsewhere.
std::vector<Lesson> flatLessons() {
  std::vector<Lesson> lessons;
  for (const Lesson &lesson : library().lessons)
    if (lesson.flat)
      for (int x = -2; x <= 2; ++x)
        for (int z = -2; z <= 2; ++z) {
          lessons.push_back(lesson);
          Scene &scene = lessons.back().scene;
          Object ray = *findObject(scene, lesson.flat->right.object);
          ray[0] += ExactVec3(x, 0, z);
          ray[1] += ExactVec3(0, z, x);
          setObject(scene, lesson.flat->right.object, std::move(ray));
        }
  return lessons;
}

TEST(FlatPictures, HaveNoLabelThatSeemsToBeAnotherPoints) {
  int looks = 0;
  for (const Lesson &lesson : flatLessons())
    for (const Theme &theme : test::fewer(themes()))
      for (const glm::dvec2 room : {glm::dvec2(840, 725), glm::dvec2(600, 480), glm::dvec2(1100, 940)})
        for (const double ratio : {0.64, 0.8})
          for (const LessonStep &step : lesson.steps) {
            const Page page = flatPageOf(lesson, step, theme, flatSizeIn(room, 1).value(), ratio);
            for (const std::string &sentence : mistakenLabels(page))
              ADD_FAILURE() << theme.name << ", " << room.x << " wide, at " << ratio << ", " << step.title
                            << ": " << sentence;
            ++looks;
          }
  EXPECT_GE(looks, test::atLeast(101));
}

/// The first step of a lesson, looked at from another direction.
Page pageFrom(const glm::dvec3 &direction, const std::string &id) {
  Lesson lesson = *library().find(id);
  lesson.camera.from = direction;
  return pageOf(lesson, lesson.steps.front(), themes().front(), {840, 725}, 1, {});
}

TEST(HandlesSeenEdgeOn, FromTooLow_AreThoseThatMoveHorizontally) {
  const double elevation = leastPlaneGrabAngle / 2;
  const std::vector<std::string> wrong =
      handlesSeenEdgeOn(pageFrom({std::cos(elevation), 0, std::sin(elevation)}, "signed-distance"));
  EXPECT_EQ(std::count(wrong.begin(), wrong.end(), "E.P0 can be dragged up and down only"), 1);
  EXPECT_EQ(std::count(wrong.begin(), wrong.end(), "E.offset cannot be grabbed"), 0);
}

TEST(HandlesSeenEdgeOn, AlongTheNormal_AreThoseThatMoveAlongIt) {
  const glm::dvec3 normal(1, 2, 2); // of the lesson's plane
  const std::vector<std::string> wrong = handlesSeenEdgeOn(pageFrom(normal, "signed-distance"));
  EXPECT_EQ(wrong, std::vector<std::string>{"E.offset cannot be grabbed"});
}

std::vector<std::string> lessonNames() {
  std::vector<std::string> names;
  for (const Lesson &lesson : library().lessons)
    names.push_back(lesson.id);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Lessons, StartView, testing::ValuesIn(test::fewer(lessonNames())), test::testName);

} // namespace
} // namespace halfspace
