// What every kind of objects promises, checked for each of the table.
#include "lessons/object/kind.h"

#include "lessons/files/read_file.h"
#include "lessons/lesson/new_numbers/short_numbers.h"
#include "lessons/object/coordinate_limits.h"
#include "lessons/scene/file/scene_reader.h"
#include "lessons/scene/file/scene_writer.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/scene/hand/snap_targets.h"
#include "tests/lessons/objects.h"
#include "tests/lessons/scenes.h"
#include "tests/test_name.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <random>
#include <set>

namespace halfspace {
namespace {

using namespace test;

class EveryKind : public testing::TestWithParam<std::string> {
protected:
  const Kind &kind() const { return *findKind(GetParam()); }

  /// An object with numbers that mean nothing, and as many vertices as are asked for beyond the fewest.
  Object anyObject(std::uint64_t seed, std::size_t moreVertices = 0) const {
    std::mt19937_64 engine(seed);
    const auto number = [&] {
      return Rational(static_cast<int>(engine() % 19) - 9, 1 + static_cast<int>(engine() % 3));
    };
    Object object(kind());
    while (object.size() < kind().fewestCoordinates() + std::min(moreVertices, kind().leavableVertices))
      object.addVertex();
    for (std::size_t i = 0; i < object.size(); ++i)
      for (int axis = 0; axis < numbersIn(coordinatesOf(object)[i].role); ++axis)
        object[i][axis] = number();
    kind().settle(object);
    return object;
  }

  /// A scene with the object `A1`, behind what it lies on.
  Scene sceneWith(const Object &object) const {
    if (!kind().binding)
      return {{{"A1", object}}};
    Object host = *makeObject(kind().binding->host);
    std::mt19937_64 engine(object[0].x == 0 ? 1 : 2);
    for (std::size_t i = 0; i < host.size(); ++i)
      for (int axis = 0; axis < numbersIn(coordinatesOf(host)[i].role); ++axis)
        host[i][axis] = static_cast<int>(engine() % 9) + 1;
    return {{{"H", host}, {"A1", object, "H"}}};
  }

  /// Objects of all sorts, the one without any extent among them.
  std::vector<Object> objects() const {
    std::vector<Object> all{Object(kind())};
    kind().settle(all.front());
    for (std::uint64_t seed = 0; seed < 60; ++seed)
      all.push_back(anyObject(seed, seed % 6));
    return all;
  }
};

TEST_P(EveryKind, IsDescribedAndFoundByItsWord) {
  EXPECT_FALSE(kind().meaning.empty());
  EXPECT_EQ(&Object(kind()).kind(), &kind());
  ASSERT_FALSE(kind().coordinates.empty());
  ASSERT_LT(kind().leavableVertices, kind().coordinates.size());
  std::set<std::string_view> names;
  for (const CoordinateSpec &spec : kind().coordinates) {
    EXPECT_TRUE(names.insert(spec.name).second) << spec.name << " stands twice";
    EXPECT_TRUE(!spec.name.empty() || kind().coordinates.size() == 1) << "only a single one has no name";
    if (spec.role == CoordinateRole::Direction) {
      EXPECT_EQ(kind().coordinates.front().role, CoordinateRole::Position) << "it is drawn from there";
    }
  }
  for (std::size_t i = kind().fewestCoordinates(); i < kind().coordinates.size(); ++i)
    EXPECT_EQ(kind().coordinates[i].role, CoordinateRole::Position) << "only vertices can be missing";
}

TEST_P(EveryKind, IsWrittenAndReadAsItIs) {
  for (const Object &object : objects()) {
    const Session session{"x", 0, sceneWith(object)};
    const auto again = readSession(writeSession(session), "x");
    ASSERT_TRUE(again) << again.problem().text();
    EXPECT_EQ(*again, session);
  }
}

TEST_P(EveryKind, IsDrawnWithFinitePlacesAndMarksOfItsOwn) {
  for (const Object &object : objects()) {
    const Evaluation evaluation = evaluate(sceneWith(object));
    std::set<std::string> ids;
    for (const Mark &mark : evaluation.find("A1")->outcome->figure->marks) {
      EXPECT_TRUE(ids.insert(baseOf(mark).id).second) << baseOf(mark).id << " stands twice";
      EXPECT_TRUE(baseOf(mark).id.starts_with("A1")) << baseOf(mark).id;
      EXPECT_EQ(baseOf(mark).role, Role::Given);
    }
    if (kind().binding) {
      EXPECT_TRUE(ids.contains("A1")) << "it is a point";
      continue;
    }
    for (std::size_t i = 0; i < object.size(); ++i)
      if (coordinatesOf(object)[i].role == CoordinateRole::Position) {
        EXPECT_TRUE(ids.contains(coordinateId("A1", coordinatesOf(object)[i]))) << "what is grabbed is seen";
      }
  }
}

TEST_P(EveryKind, HasHandlesThatMoveWhatTheySay) {
  for (const Object &object : objects()) {
    const Scene scene = sceneWith(object);
    std::set<std::string> ids;
    for (const Handle &handle : handlesOf(scene)) {
      if (handle.object == "H")
        continue;
      EXPECT_TRUE(ids.insert(handle.id).second) << handle.id << " stands twice";
      EXPECT_EQ(handle.object, "A1");
      if (handle.host) { // how it keeps to its host is tested for each
        EXPECT_EQ(placeOn(movedTo(object, handle, handle.at), *handle.host), handle.at);
        continue;
      }
      EXPECT_EQ(movedTo(object, handle, handle.at), object) << handle.id << " moves what stays where it is";
      const ExactVec3 way = handle.hasAxis() ? handle.axis : ExactVec3(1, -2, 3);
      const Object moved = movedTo(object, handle, handle.at + way);
      EXPECT_FALSE(moved == object) << handle.id;
      const Handle after = test::handle({{{"A1", moved}}}, handle.id);
      EXPECT_EQ(after.at, handle.at + way) << handle.id << " follows the hand";
    }
  }
}

TEST_P(EveryKind, CatchesAndOffersPlacesThatFit) {
  const Entry corner{"T", TriangleObject{{9, 9, 0}, {1, 9, 4}, {5, 2, 9}}};
  for (const Object &object : objects()) {
    Scene scene = sceneWith(object);
    for (const Entry &other : {planeE(), pointQ(), corner})
      scene.entries.push_back(other);
    for (const Handle &handle : handlesOf(scene))
      for (const SnapTarget &target : snapTargets(scene, handle)) {
        EXPECT_FALSE(target.name.empty());
        EXPECT_LE(target.places.dimension(), 2U) << target.name;
      }
  }
}

TEST_P(EveryKind, GetsShortNumbers) {
  const Scene scene = sceneWith(anyObject(5));
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene renewed = withShortNumbers(scene, seed);
    EXPECT_FALSE(refusedCoordinateOf(*findObject(renewed, "A1")));
    EXPECT_EQ(kindOf(*findObject(renewed, "A1")), kind().word);
  }
}

TEST_P(EveryKind, IsSettledOnce) {
  for (Object object : objects()) {
    const Object before = object;
    kind().settle(object);
    EXPECT_EQ(object, before);
  }
}

/// As files have it: plane: {P0: [x, y, z], n: [x, y, z]}
std::string spelled(const Kind &kind) {
  std::string coordinates = kind.binding ? "on: name" : "";
  const Object object(kind);
  for (const CoordinateSpec &spec : coordinatesOf(object))
    coordinates += (coordinates.empty() ? "" : ", ") + std::string(spec.name) +
                   (spec.name.empty() ? "" : ": ") + (numbersIn(spec.role) == 3 ? "[x, y, z]" : "x");
  if (kind.shape)
    coordinates += ", corners: x y z …, faces: 0 1 2 …";
  const bool isNameless = kind.coordinates.front().name.empty();
  return std::string(kind.word) + ": " + (isNameless ? coordinates : "{" + coordinates + "}");
}

TEST_P(EveryKind, HasItsRowInTheDocumentation) {
  const std::string text = *readFile(DOCUMENTATION_FOLDER "/writing-a-lesson.md", 1 << 20);
  const std::string row = "| " + std::string(kind().meaning) + " | `" + spelled(kind()) + "` |";
  EXPECT_NE(text.find(row), std::string::npos) << row;
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryKind, testing::ValuesIn([] {
                           std::vector<std::string> words;
                           for (const Kind &kind : kinds())
                             words.emplace_back(kind.word);
                           return words;
                         }()),
                         test::testName);

bool isFilled(const Object &polygon) {
  return findMark(figureOf(evaluate({{{"A1", polygon}}})), "A1") != nullptr;
}

TEST(Polygon, FlatAndConvex_IsFilledAndOthersAreOutlined) {
  EXPECT_TRUE(isFilled(polygonOf({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}})));
  EXPECT_TRUE(isFilled(polygonOf({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}})))
      << "a straight corner";
  EXPECT_FALSE(isFilled(polygonOf({{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}}))) << "bent";
  EXPECT_FALSE(isFilled(polygonOf({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}))) << "with a dent";
  EXPECT_FALSE(isFilled(polygonOf({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}}))) << "crossing itself";
  EXPECT_FALSE(isFilled(polygonOf({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}})));
  const Figure star = figureOf(evaluate({{{"A1", polygonOf({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}})}}}));
  EXPECT_NE(findMark(star, "A1/side3"), nullptr) << "its last side";
}

TEST(Number, ChangedBeyondItsBounds_StaysWithinThem) {
  Scene scene{{{"k", *makeObject("number")}}};
  Object number = *findObject(scene, "k");
  number[1].x = -2;
  number[2].x = 3;
  number[0].x = 7;
  scene = edited(scene, {ChangeObject{"k", number}});
  EXPECT_EQ((*findObject(scene, "k"))[0].x, 3);
  EXPECT_EQ((*findObject(withValue({"x", 0, scene}, "k=-1")->scene, "k"))[0].x, -1);
  EXPECT_EQ(withValue({"x", 0, scene}, "k=-9").problem().sentence,
            "“value” cannot be -9 here: -2 is the nearest that fits.");
  EXPECT_FALSE(withValue({"x", 0, scene}, "k=1,2,3"));
}

TEST(Number, BeyondItsBoundsInAFile_IsRefused) {
  const auto read = [](const std::string &number) {
    return readSession(
        R"({"format":"halfspace","version":2,"lesson":"x","step":0,"scene":[{"name":"k","number":)" + number +
            "}]}",
        "x");
  };
  EXPECT_TRUE(read(R"({"value":"1","from":"0","to":"2","step":"1/2"})"));
  EXPECT_FALSE(read(R"({"value":"3","from":"0","to":"2","step":"1/2"})"));
  EXPECT_FALSE(read(R"({"value":["3"],"from":"0","to":"2","step":"1/2"})"));
}

} // namespace
} // namespace halfspace
