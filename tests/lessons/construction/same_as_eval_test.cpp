// What `halfspace explain` says of a scene, and what `halfspace eval` answers to the same question: one core,
// the same figures.
#include "tests/lessons/construction/random_objects.h"
#include "tests/test_name.h"

#include "eval/evaluate.h"
#include "lessons/object/flat.h"
#include "lessons/scene/file/explain_formats.h"
#include "tests/effort.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>

namespace halfspace {
namespace {

using namespace test;
using Json = nlohmann::json;

constexpr int scenesPerWriting = isWatched ? 6 : 500;
constexpr std::array writings{Writing::SmallIntegers, Writing::Halves, Writing::Fractions,
                              Writing::LongFractions};

/// The question that a construction answers, and the names of its operands in the order of the roles.
struct Question {
  std::string query;
  std::vector<std::string> operands;
};

/// Those whose objects are a question's own; what the others show is asked in parts below.
const std::map<std::string, Question> &questions() {
  static const std::map<std::string, Question> all{
      {"plane-implicit", {"plane", {"plane"}}},
      {"signed-distance", {"point-plane", {"plane", "point"}}},
      {"ray-plane-dot", {"ray-plane", {"plane", "ray"}}},
      {"ray-plane-picture", {"ray-plane", {"plane", "ray"}}},
      {"ray-triangle-perp", {"ray-triangle", {"triangle", "ray"}}},
      {"ray-triangle-cramer", {"ray-triangle", {"triangle", "ray"}}},
      {"three-methods", {"ray-triangle", {"triangle", "ray"}}},
      {"misprints", {"ray-triangle", {"triangle", "ray"}}},
      {"ray-sphere", {"ray-sphere", {"sphere", "ray"}}},
      {"plane-plane", {"plane-plane", {"plane", "plane2"}}},
      {"line-pluecker", {"line", {"line"}}},
      {"line-line", {"line-line", {"line", "line2"}}},
      {"line-plane", {"line-plane", {"line", "plane"}}},
      {"mirror-point", {"point-plane", {"plane", "point"}}},
      {"mirror-ray", {"ray-plane", {"plane", "ray"}}},
      {"ray-polygon-pluecker", {"ray-polygon", {"polygon", "ray"}}},
      {"ray-solid-pluecker", {"ray-solid", {"solid", "ray"}}},
  };
  return all;
}
/// Those that ask otherwise: each has a test of its own below.
const std::set<std::string> withOtherQuestions{"circumsphere",
                                               "circumsphere-points",
                                               "clipping",
                                               "closest-points",
                                               "barycentric",
                                               "cross-product",
                                               "determinant",
                                               "dot-product-projection",
                                               "half-spaces",
                                               "line-angle",
                                               "line-plane-angle",
                                               "line-ray-segment",
                                               "midpoint",
                                               "plane-angle",
                                               "plane-distance",
                                               "line-sphere",
                                               "plane-parametric",
                                               "plane-sphere",
                                               "parallel-plane",
                                               "perpendicular-bisector",
                                               "perpendicular-plane",
                                               "plane-bisectors",
                                               "plane-through-line",
                                               "point-line",
                                               "point-point",
                                               "ray-plane-substitution",
                                               "ray-box-slabs",
                                               "reflection",
                                               "segment-plane",
                                               "shadow",
                                               "three-planes",
                                               "triangle-degenerate",
                                               "nearest-hit",
                                               "triangle-area",
                                               "polygon-area",
                                               "solid-volume"};
/// Questions know no saucers, no frames and no screens.
const std::set<std::string> withoutQuestions{"torpedo-shot", "torpedo-flight", "camera-ray"};

Json numbersOf(const ExactVec3 &at) { return {toText(at.x), toText(at.y), toText(at.z)}; }

Json coordinateOf(const Object &object, std::size_t index) {
  return numbersIn(coordinatesOf(object)[index].role) == 1 ? Json(toText(object[index].x))
                                                           : numbersOf(object[index]);
}

Json solidOperandOf(const Object &object) {
  const SolidMesh<Rational> mesh = meshOf(object);
  Json solid{{"vertices", Json::array()}, {"faces", mesh.faces}};
  for (const ExactVec3 &corner : mesh.vertices)
    solid["vertices"].push_back(numbersOf(corner));
  return solid;
}

/// An object as an operand: a point as its numbers, corners as a list, else by the words of the eval format.
Json operandOf(const Object &object) {
  static const std::map<std::string_view, std::vector<std::string>> words{{"plane", {"point", "normal"}},
                                                                          {"ray", {"origin", "direction"}},
                                                                          {"line", {"point", "direction"}},
                                                                          {"sphere", {"center", "radius"}}};
  if (object.size() == 1)
    return numbersOf(object[0]);
  if (findSolidKind(kindOf(object)))
    return solidOperandOf(object);
  Json operand;
  if (const auto known = words.find(kindOf(object)); known != words.end())
    for (std::size_t i = 0; i < object.size(); ++i)
      operand[known->second.at(i)] = coordinateOf(object, i);
  else
    for (std::size_t i = 0; i < object.size(); ++i)
      operand.push_back(numbersOf(object[i]));
  return operand;
}

Json answerTo(const Json &asked) {
  std::string answer;
  Evaluator().answer(asked.dump(), answer);
  return Json::parse(answer);
}

Json answerTo(const Question &question, const std::vector<Object> &objects) {
  Json asked{{"query", question.query}};
  for (std::size_t i = 0; i < objects.size(); ++i)
    asked[question.operands.at(i)] = operandOf(objects[i]);
  return answerTo(asked);
}

/// How many figures both have; all of them are the same.
int compare(const Json &explained, const Json &answered, const std::string &group) {
  int compared = 0;
  for (const auto &[name, figure] : explained.items()) {
    if (!answered.contains(name))
      continue;
    const Json &other = answered.at(name);
    if (figure.is_object() && !figure.contains("exact")) {
      compared += compare(figure, other, group + name + ".");
      continue;
    }
    // Lessons have truth values as words.
    EXPECT_EQ(figure, other.is_boolean() ? Json(other.dump()) : other) << group << name;
    ++compared;
  }
  return compared;
}

/// Hands over the objects of many scenes of a construction, and what is explained of them; `compareWith` says
/// how many figures it found the same.
template <class Compare> void compareScenes(std::string_view id, const Compare &compareWith) {
  const Construction &construction = *findConstruction(id);
  int compared = 0;
  for (const Writing writing : writings) {
    RandomObjects random(5 + static_cast<std::uint64_t>(writing));
    for (int i = 0; i < scenesPerWriting && !testing::Test::HasFailure(); ++i) {
      const std::vector<Object> objects = random.objectsFor(construction, writing);
      const Scene scene = sceneOf(construction, objects);
      const Evaluation evaluation = evaluate(scene);
      Json explained = Json::parse(explanationJson("", scene, evaluation));
      explained["degenerate"] = lastOutcome(evaluation).told->degenerate;
      SCOPED_TRACE(explained.dump());
      compared += compareWith(objects, explained);
    }
  }
  EXPECT_GE(compared, scenesPerWriting / 2) << "hardly a figure is the same";
}

class EveryConstructionWithAQuestion : public testing::TestWithParam<std::string> {};

TEST_P(EveryConstructionWithAQuestion, EveryFigureThatBothHave_IsTheSame) {
  const Question &question = questions().at(GetParam());
  compareScenes(GetParam(), [&](const std::vector<Object> &objects, const Json &explained) {
    const Json answered = answerTo(question, objects);
    EXPECT_EQ(answered.at("ok"), !explained.at("degenerate")) << answered;
    if (!answered.at("ok"))
      return 0;
    const Json &result = answered.at("result");
    if (result.contains("case")) {
      EXPECT_EQ(explained.at("case"), result.at("case"));
    }
    return compare(explained.at("values"), result, "");
  });
}

/// No question has several planes, but each of them has one of its own.
TEST(SameAsEval, RayPlaneSubstitution_ForEachPlaneAsItsOwnQuestion) {
  compareScenes("ray-plane-substitution", [](const std::vector<Object> &objects, const Json &explained) {
    int compared = 0;
    for (std::size_t place = 0; place + 1 < objects.size(); ++place) {
      const Json answered = answerTo({"ray-plane", {"plane", "ray"}}, {objects[place], objects.back()});
      const std::string plane = "plane" + std::to_string(place);
      if (answered.at("ok") && explained.at("values").contains(plane))
        compared += compare(explained.at("values").at(plane), answered.at("result"), plane + ".");
    }
    return compared;
  });
}

/// Lessons have meshes and count from 1, questions have triangles and count from 0.
TEST(SameAsEval, NearestHit_AmongTheTrianglesOfAllMeshes) {
  compareScenes("nearest-hit", [](const std::vector<Object> &objects, const Json &explained) {
    Json triangles = Json::array();
    for (std::size_t i = 2; i < objects.size(); ++i) {
      const MeshObject mesh = objectAs<MeshObject>(objects[i]).value();
      for (std::size_t triangle = 0; triangle < mesh.shape->triangleCount(); ++triangle) {
        const auto &[p0, p1, p2] = triangleOf(mesh, triangle);
        triangles.push_back({numbersOf(p0), numbersOf(p1), numbersOf(p2)});
      }
    }
    const Json answered =
        answerTo(Json{{"query", "nearest-hit"}, {"ray", operandOf(objects[0])}, {"triangles", triangles}});
    EXPECT_EQ(answered.at("ok"), !explained.at("degenerate")) << answered;
    if (!answered.at("ok"))
      return 0;
    const Json &values = explained.at("values");
    const Json &result = answered.at("result");
    // To a question a ray within a triangle's plane misses it; a lesson tells that it lies there.
    EXPECT_EQ(explained.at("case") == "in-plane" ? "miss" : explained.at("case"), result.at("case"));
    EXPECT_EQ(values.at("hits"), result.at("order").size());
    if (!result.contains("index"))
      return 0;
    EXPECT_EQ(values.at("nearest"), result.at("index").get<int>() + 1);
    EXPECT_EQ(values.at("lambda"), result.at("t"));
    EXPECT_EQ(values.at("point"), result.at("point"));
    return 1;
  });
}

/// Lessons name where the line goes in and where it comes out, questions have lists of two.
TEST(SameAsEval, RaySolidPluecker_InItsFacesAndPoints) {
  compareScenes("ray-solid-pluecker", [](const std::vector<Object> &objects, const Json &explained) {
    const Json &values = explained.at("values");
    if (!values.contains("entered"))
      return 0;
    const Json answered = answerTo(questions().at("ray-solid-pluecker"), objects).at("result");
    const Json &entered = values.at("entered");
    const Json &left = values.at("left");
    EXPECT_EQ(Json::array({entered.at("face"), left.at("face")}), answered.at("faces"));
    EXPECT_EQ(Json::array({entered.at("point"), left.at("point")}), answered.at("points"));
    return 1;
  });
}

/// Questions have solids: a box is one, where it has an inside.
TEST(SameAsEval, RayBoxSlabs_OfTheBoxAsASolid) {
  compareScenes("ray-box-slabs", [](const std::vector<Object> &objects, const Json &explained) {
    const Json answered = answerTo(questions().at("ray-solid-pluecker"), objects);
    if (!answered.at("ok"))
      return 0;
    const Json &values = explained.at("values");
    EXPECT_EQ(answered.at("result").at("case"), explained.at("case"));
    EXPECT_EQ(answered.at("result").at("origin"), values.at("origin"));
    if (values.contains("entry")) {
      EXPECT_EQ(answered.at("result").at("points"), Json::array({values.at("entry"), values.at("exit")}));
    }
    return 1;
  });
}

TEST(SameAsEval, HalfSpaces_ForEachPointAsItsOwnQuestion) {
  compareScenes("half-spaces", [](const std::vector<Object> &objects, const Json &explained) {
    int compared = 0;
    for (std::size_t i = 1; i < objects.size(); ++i) {
      const Json answered = answerTo({"point-plane", {"plane", "point"}}, {objects[0], objects[i]});
      EXPECT_EQ(answered.at("ok"), explained.at("case") != "zero-normal");
      if (!answered.at("ok"))
        continue;
      const char point = static_cast<char>('A' + static_cast<int>(i) - 1);
      EXPECT_EQ(explained.at("values").at(std::string("f_") + point), answered.at("result").at("f"));
      EXPECT_EQ(explained.at("values").at(std::string("side_") + point), answered.at("result").at("side"));
      ++compared;
    }
    return compared;
  });
}

/// An edge is a ray from a corner to the next, which meets the plane where it is cut.
TEST(SameAsEval, Clipping_OfEachEdgeAsARay) {
  compareScenes("clipping", [](const std::vector<Object> &objects, const Json &explained) {
    int compared = 0;
    for (std::size_t edge = 1; edge <= 3; ++edge) {
      const Object &from = objects[edge];
      const Object &to = objects[edge % 3 + 1];
      const Object ray = RayObject{from[0], to[0] - from[0]};
      const Json answered = answerTo({"ray-plane", {"plane", "ray"}}, {objects[0], ray});
      const std::string number = std::to_string(edge);
      const Json &values = explained.at("values");
      if (!values.contains("t" + number))
        continue;
      EXPECT_EQ(answered.at("result").at("case"), "hit");
      EXPECT_EQ(answered.at("result").at("t"), values.at("t" + number));
      EXPECT_EQ(answered.at("result").at("point"), values.at("cut" + number));
      ++compared;
    }
    return compared;
  });
}

/// The light of the sun is a ray that starts at the corner; that of the lamp is one that goes through it.
TEST(SameAsEval, Shadow_OfEachCornerAsRays) {
  compareScenes("shadow", [](const std::vector<Object> &objects, const Json &explained) {
    int compared = 0;
    const Json &values = explained.at("values");
    const auto compareRay = [&](const RayObject &ray, const std::string &parameter,
                                const std::string &place) {
      const Json answered = answerTo({"ray-plane", {"plane", "ray"}}, {objects[0], Object(ray)});
      if (!values.contains(parameter))
        return;
      EXPECT_EQ(answered.at("result").at("t"), values.at(parameter));
      EXPECT_EQ(answered.at("result").at("point"), values.at(place));
      ++compared;
    };
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::string role(1, static_cast<char>('A' + static_cast<int>(corner)));
      const ExactVec3 at = objects[corner + 2][0];
      const ExactVec3 lamp = objects[1][0];
      compareRay({at, objects[5][1]}, "t_" + role, "S_" + role);
      compareRay({lamp, ExactVec3(at - lamp)}, "k_" + role, "L_" + role);
    }
    return compared;
  });
}

/// Questions tell lines of opposite directions apart, and their point only where they meet.
TEST(SameAsEval, ClosestPoints_InTheirDistance) {
  compareScenes("closest-points", [](const std::vector<Object> &objects, const Json &explained) {
    const Json answered = answerTo(questions().at("line-line"), objects);
    EXPECT_EQ(answered.at("ok"), !explained.at("degenerate"));
    if (!answered.at("ok"))
      return 0;
    const Json &result = answered.at("result");
    const std::string found = result.at("case");
    const std::map<std::string, std::string> cases{{"skew", "skew"},
                                                   {"intersecting", "meet"},
                                                   {"parallel", "parallel"},
                                                   {"same", "coincident"},
                                                   {"opposite", "coincident"}};
    EXPECT_EQ(explained.at("case"), cases.at(found));
    return compare(explained.at("values"), result, "");
  });
}

/// Questions know two planes, and a plane with their line.
TEST(SameAsEval, ThreePlanes_AsThatOfALineOfTwoWithTheThird) {
  compareScenes("three-planes", [](const std::vector<Object> &objects, const Json &explained) {
    const Json pair = answerTo(questions().at("plane-plane"), {objects[0], objects[1]});
    if (!pair.at("ok") || pair.at("result").at("case") != "line")
      return 0;
    const Json line{{"point", pair.at("result").at("point").at("exact")},
                    {"direction", pair.at("result").at("direction").at("exact")}};
    const Json answered =
        answerTo(Json{{"query", "line-plane"}, {"line", line}, {"plane", operandOf(objects[2])}});
    if (!answered.at("ok")) { // of long fractions the line has more digits than a question takes
      EXPECT_TRUE(explained.at("degenerate") || answered.at("error").at("code") == "bad-operand") << answered;
      return 0;
    }
    EXPECT_FALSE(explained.at("degenerate"));
    const Json &result = answered.at("result");
    const auto &found = explained.at("case").get_ref<const std::string &>();
    EXPECT_EQ(found == "point", result.at("case") == "point");
    EXPECT_EQ(found == "line", result.at("case") == "in-plane");
    return compare(explained.at("values"), result, "");
  });
}

/// Questions do not make planes, but tell the equation of each.
int comparePlane(const Json &explained, const Json &plane) {
  const Json answered = answerTo({{"query", "plane"}, {"plane", plane}});
  EXPECT_EQ(answered.at("ok"), !explained.at("degenerate"));
  return answered.at("ok") ? compare(explained.at("values"), answered.at("result"), "") : 0;
}

TEST(SameAsEval, ParallelPlane_AsThePlaneThroughThePoint) {
  compareScenes("parallel-plane", [](const std::vector<Object> &objects, const Json &explained) {
    const int compared = comparePlane(explained, operandOf(PlaneObject{objects[1][0], objects[0][1]}));
    const Json answered = answerTo(questions().at("signed-distance"), objects);
    return answered.at("ok") ? compared + compare(explained.at("values"), answered.at("result"), "") : 0;
  });
}

TEST(SameAsEval, PerpendicularPlane_AsThePlaneThroughThePointWithTheLine) {
  compareScenes("perpendicular-plane", [](const std::vector<Object> &objects, const Json &explained) {
    const PlaneObject plane{objects[1][0], objects[0][1]};
    const int compared = comparePlane(explained, operandOf(plane));
    const Json answered = answerTo(questions().at("line-plane"), {objects[0], plane});
    return answered.at("ok") ? compared + compare(explained.at("values"), answered.at("result"), "") : 0;
  });
}

TEST(SameAsEval, PlaneThroughLine_AsThatOfThreePoints) {
  compareScenes("plane-through-line", [](const std::vector<Object> &objects, const Json &explained) {
    const ExactVec3 start = objects[0][0];
    const Json points{numbersOf(start), numbersOf(start + objects[0][1]), numbersOf(objects[1][0])};
    return comparePlane(explained, {{"points", points}});
  });
}

TEST(SameAsEval, PerpendicularBisector_AsThePlaneThroughTheMiddle) {
  compareScenes("perpendicular-bisector", [](const std::vector<Object> &objects, const Json &explained) {
    const ExactVec3 &from = objects[0][0];
    const ExactVec3 &to = objects[1][0];
    return comparePlane(explained, operandOf(PlaneObject{(from + to) / Rational(2), to - from}));
  });
}

/// Questions have a ray, from one end towards the other.
TEST(SameAsEval, SegmentPlane_AsARay) {
  compareScenes("segment-plane", [](const std::vector<Object> &objects, const Json &explained) {
    const RayObject ray{objects[0][0], objects[0][1] - objects[0][0]};
    const Json answered = answerTo(questions().at("ray-plane-dot"), {objects[1], ray});
    EXPECT_EQ(answered.at("ok"), !explained.at("degenerate"));
    if (!answered.at("ok"))
      return 0;
    EXPECT_EQ(answered.at("result").at("case") == "in-plane", explained.at("case") == "in-plane");
    EXPECT_EQ(answered.at("result").at("case") == "parallel", explained.at("case") == "parallel");
    return compare(explained.at("values"), answered.at("result"), "");
  });
}

/// Questions know the line that the halving planes go through.
TEST(SameAsEval, PlaneBisectors_InThePointOfBothPlanes) {
  compareScenes("plane-bisectors", [](const std::vector<Object> &objects, const Json &explained) {
    const Json answered = answerTo(questions().at("plane-plane"), objects);
    EXPECT_EQ(answered.at("ok"), !explained.at("degenerate"));
    if (!answered.at("ok"))
      return 0;
    const auto &found = explained.at("case").get_ref<const std::string &>();
    const bool isCrossing = found == "crossing" || found == "irrational";
    EXPECT_EQ(answered.at("result").at("case"), isCrossing ? "line" : found);
    return compare(explained.at("values"), answered.at("result"), "");
  });
}

TEST(SameAsEval, DotProductProjection_OfEachVectorOntoTheOther) {
  compareScenes("dot-product-projection", [](const std::vector<Object> &objects, const Json &explained) {
    int compared = 0;
    const std::array names{"onto_v", "onto_w"};
    for (std::size_t onto = 0; onto < names.size(); ++onto) {
      const Json answered = answerTo({{"query", "project-vector"},
                                      {"vector", numbersOf(objects[1 - onto][1])},
                                      {"onto", numbersOf(objects[onto][1])}});
      if (answered.at("ok") && explained.at("values").contains(names.at(onto)))
        compared += compare(explained.at("values").at(names.at(onto)), answered.at("result"), names.at(onto));
    }
    return compared;
  });
}

/// Questions do not reflect, but tell where the ray meets the plane and which part it has along the normal.
TEST(SameAsEval, Reflection_InItsMeetingPointAndParts) {
  compareScenes("reflection", [](const std::vector<Object> &objects, const Json &explained) {
    const Json met = answerTo({"ray-plane", {"plane", "ray"}}, objects);
    EXPECT_EQ(met.at("ok"), !explained.at("degenerate"));
    if (!met.at("ok"))
      return 0;
    EXPECT_EQ(explained.at("case"), met.at("result").at("case"));
    const Json &values = explained.at("values");
    const Json split = answerTo({{"query", "project-vector"},
                                 {"vector", numbersOf(objects[1][1])},
                                 {"onto", numbersOf(objects[0][1])}});
    EXPECT_EQ(values.at("along"), split.at("result").at("projection"));
    EXPECT_EQ(values.at("across"), split.at("result").at("rejection"));
    return compare(values, met.at("result"), "");
  });
}

/// Questions have triangles: that of the start and both tips, with a ray that crosses it.
TEST(SameAsEval, CrossProduct_OfATrianglesSides) {
  compareScenes("cross-product", [](const std::vector<Object> &objects, const Json &explained) {
    const ExactVec3 &start = objects[0][0];
    const ExactVec3 &u = objects[0][1];
    const ExactVec3 &v = objects[1][1];
    const Json corners{numbersOf(start), numbersOf(start + u), numbersOf(start + v)};
    const Json plane = answerTo({{"query", "plane"}, {"plane", {{"points", corners}}}});
    EXPECT_EQ(plane.at("ok"), !explained.at("degenerate"));
    if (!plane.at("ok"))
      return 0;
    const Json &values = explained.at("values");
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_EQ(values.at("cross").at("exact").at(axis),
                plane.at("result").at("coefficients").at("exact").at(axis));
    const RayObject ray{start, cross(u, v)};
    const Json answered =
        answerTo(Json{{"query", "ray-triangle"}, {"triangle", corners}, {"ray", operandOf(ray)}});
    return compare(values, answered.at("result").at("perp"), "");
  });
}

/// Questions have no three vectors: their determinant is what the plane of two of them makes of the tip of
/// the third.
TEST(SameAsEval, Determinant_AsThePlaneOfTheBaseSeesTheTip) {
  compareScenes("determinant", [](const std::vector<Object> &objects, const Json &explained) {
    const PlaneObject base{{0, 0, 0}, cross(objects[0][1], objects[1][1])};
    const Json answered = answerTo({"point-plane", {"plane", "point"}}, {base, PointObject{objects[2][1]}});
    EXPECT_EQ(answered.at("ok"), !isZero(base.normal));
    if (!answered.at("ok"))
      return 0;
    EXPECT_EQ(explained.at("values").at("det"), answered.at("result").at("f"));
    return 1;
  });
}

TEST(SameAsEval, PlaneParametric_AtItsParameters) {
  compareScenes("plane-parametric", [](const std::vector<Object> &objects, const Json &explained) {
    const Json &values = explained.at("values");
    if (explained.at("case") != "in-plane")
      return 0;
    Json answered = answerTo({{"query", "parametric"},
                              {"triangle", operandOf(objects[0])},
                              {"s", values.at("s").at("exact")},
                              {"t", values.at("t").at("exact")}})
                        .at("result");
    answered["in_parallelogram"] = answered.at("in_parallelogram") ? "yes" : "no";
    EXPECT_EQ(values.at("point").at("exact"), numbersOf(objects[1][0]));
    return compare(values, answered, "");
  });
}

/// Questions ask for a ray's hit: that of a ray along the normal through the point.
TEST(SameAsEval, Barycentric_OfARayStraightAtThePoint) {
  compareScenes("barycentric", [](const std::vector<Object> &objects, const Json &explained) {
    const ExactVec3 n = cross(objects[0][1] - objects[0][0], objects[0][2] - objects[0][0]);
    const std::string found = explained.at("case");
    if (isZero(n) || found == "off-plane")
      return 0;
    const Json answered =
        answerTo({"ray-triangle", {"triangle", "ray"}}, {objects[0], RayObject{objects[1][0] - n, n}});
    EXPECT_EQ(answered.at("result").at("location"), found);
    return compare(explained.at("values"), answered.at("result"), "");
  });
}

/// Questions ask for the point of a line that is nearest to the origin: of the line as it is seen from Q.
TEST(SameAsEval, PointLine_FromThePoint) {
  compareScenes("point-line", [](const std::vector<Object> &objects, const Json &explained) {
    const ExactVec3 point = objects[0][0];
    const Json answered = answerTo(
        {{"query", "line"},
         {"line", {{"point", numbersOf(objects[1][0] - point)}, {"direction", numbersOf(objects[1][1])}}}});
    EXPECT_EQ(answered.at("ok"), explained.at("case") != "zero-direction");
    if (!answered.at("ok"))
      return 0;
    const Json nearest = answered.at("result").at("nearest_to_origin").at("exact");
    const Json &foot = explained.at("values").at("foot").at("exact");
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(foot.at(static_cast<std::size_t>(axis)),
                toText(point[axis] +
                       *parseRational(nearest.at(static_cast<std::size_t>(axis)).get<std::string>())));
    EXPECT_EQ(explained.at("case") == "on", answered.at("result").at("through_origin"));
    return 1;
  });
}

/// Questions have no two points: one of them lies in a plane straight across the way to the other.
TEST(SameAsEval, PointPoint_FromThePlaneAcrossTheWay) {
  compareScenes("point-point", [](const std::vector<Object> &objects, const Json &explained) {
    const PlaneObject across{objects[0][0], ExactVec3(objects[1][0] - objects[0][0])};
    const Json answered = answerTo({"point-plane", {"plane", "point"}}, {across, objects[1]});
    EXPECT_EQ(answered.at("ok"), explained.at("case") == "apart");
    if (!answered.at("ok"))
      return 0;
    EXPECT_EQ(explained.at("values").at("distance"), answered.at("result").at("signed_distance"));
    EXPECT_EQ(explained.at("values").at("squared"), answered.at("result").at("f"));
    return 1;
  });
}

/// Halfway along a side of any triangle.
TEST(SameAsEval, Midpoint_OfATrianglesSide) {
  compareScenes("midpoint", [](const std::vector<Object> &objects, const Json &explained) {
    const ExactVec3 side = objects[1][0] - objects[0][0];
    EXPECT_EQ(explained.at("case") == "same", isZero(side));
    if (isZero(side))
      return 0;
    const Json corners{numbersOf(objects[0][0]), numbersOf(objects[1][0]),
                       numbersOf(objects[0][0] + anyPerpendicular(side))};
    const Json answered =
        answerTo({{"query", "parametric"}, {"triangle", corners}, {"s", "1/2"}, {"t", "0"}});
    EXPECT_EQ(explained.at("values").at("point"), answered.at("result").at("point"));
    return 1;
  });
}

/// What a question says of planes with these normals, which are turned until they are at most 90° apart.
Json planesAtMostRight(const PlaneObject &first, PlaneObject second) {
  if (dot(first.normal, second.normal) < 0)
    second.normal = -second.normal;
  return answerTo({"plane-plane", {"plane", "plane2"}}, {first, second});
}

/// Of a construction that has the cosine of such normals among its values.
int compareCosine(const Json &answered, const Json &explained, const char *value) {
  EXPECT_EQ(answered.at("ok"), !explained.at("degenerate"));
  if (!answered.at("ok"))
    return 0;
  EXPECT_EQ(explained.at("values").at(value), answered.at("result").at("cos_angle"));
  return 1;
}

/// Questions tell the angle of the normals, which may be more than 90°.
TEST(SameAsEval, PlaneAngle_OfNormalsAtMostRight) {
  compareScenes("plane-angle", [](const std::vector<Object> &objects, const Json &explained) {
    return compareCosine(planesAtMostRight(objectAs<PlaneObject>(objects[0]).value(),
                                           objectAs<PlaneObject>(objects[1]).value()),
                         explained, "cosine");
  });
}

/// Questions have no angle of lines: that of planes straight across them is the same.
TEST(SameAsEval, LineAngle_OfThePlanesAcross) {
  compareScenes("line-angle", [](const std::vector<Object> &objects, const Json &explained) {
    return compareCosine(planesAtMostRight({objects[0][0], objects[0][1]}, {objects[1][0], objects[1][1]}),
                         explained, "cosine");
  });
}

TEST(SameAsEval, LinePlaneAngle_OfThePlaneAcrossTheLine) {
  compareScenes("line-plane-angle", [](const std::vector<Object> &objects, const Json &explained) {
    return compareCosine(planesAtMostRight({objects[0][0], objects[0][1]}, {objects[1][0], objects[1][1]}),
                         explained, "sine");
  });
}

/// Questions have the distance of a point, with its sign: of a point of the other plane.
TEST(SameAsEval, PlaneDistance_OfAPointOfTheSecond) {
  compareScenes("plane-distance", [](const std::vector<Object> &objects, const Json &explained) {
    const Json planes = answerTo({"plane-plane", {"plane", "plane2"}}, objects);
    EXPECT_EQ(planes.at("ok"), !explained.at("degenerate"));
    if (!planes.at("ok"))
      return 0;
    const std::string found = planes.at("result").at("case");
    EXPECT_EQ(explained.at("case"), found == "line" ? "meet" : found);
    if (found == "line")
      return 0;
    PlaneObject first = objectAs<PlaneObject>(objects[0]).value();
    if (dot(first.normal, ExactVec3(objects[1][0] - first.point)) < 0)
      first.normal = -first.normal;
    const Json answered = answerTo({"point-plane", {"plane", "point"}}, {first, PointObject{objects[1][0]}});
    EXPECT_EQ(explained.at("values").at("distance"), answered.at("result").at("signed_distance"));
    return 1;
  });
}

/// The line that is seen from Q goes through the origin where Q lies on it.
TEST(SameAsEval, LineRaySegment_FromThePointOfWhichItIsAsked) {
  compareScenes("line-ray-segment", [](const std::vector<Object> &objects, const Json &explained) {
    const ExactVec3 point = objects[2][0];
    const Json answered = answerTo(
        {{"query", "line"},
         {"line", {{"point", numbersOf(objects[0][0] - point)}, {"direction", numbersOf(objects[0][1])}}}});
    EXPECT_EQ(answered.at("ok"), explained.at("case") != "zero-direction");
    if (!answered.at("ok"))
      return 0;
    const bool isOn = explained.at("values").at("on") == "yes";
    EXPECT_EQ(answered.at("result").at("through_origin"), isOn);
    EXPECT_EQ(explained.at("case") != "off", isOn);
    return 1;
  });
}

/// Questions have rays: that from the line's point.
TEST(SameAsEval, LineSphere_AsTheRayFromItsPoint) {
  compareScenes("line-sphere", [](const std::vector<Object> &objects, const Json &explained) {
    const Json answered = answerTo({"ray-sphere", {"ray", "sphere"}},
                                   {Object(RayObject{objects[0][0], objects[0][1]}), objects[1]});
    EXPECT_EQ(answered.at("ok"), !explained.at("degenerate")) << answered;
    if (!answered.at("ok"))
      return 0;
    EXPECT_EQ(explained.at("case"), answered.at("result").at("contacts"));
    return compare(explained.at("values"), answered.at("result"), "");
  });
}

/// Questions ask for a point and a plane: the centre of the sphere.
TEST(SameAsEval, PlaneSphere_InTheFootOfTheCentre) {
  compareScenes("plane-sphere", [](const std::vector<Object> &objects, const Json &explained) {
    const Json answered =
        answerTo({"point-plane", {"plane", "point"}}, {objects[0], Object(PointObject{objects[1][0]})});
    if (explained.at("degenerate"))
      return 0;
    const Json &values = explained.at("values");
    EXPECT_EQ(values.at("f"), answered.at("result").at("f"));
    EXPECT_EQ(values.at("center"), answered.at("result").at("foot"));
    EXPECT_EQ(explained.at("case") == "great-circle", answered.at("result").at("side") == "on");
    return 1;
  });
}

/// Questions have planes and points: the centre lies halfway between any two corners, and the fourth lies as
/// far from the plane of three as the determinant says.
void compareCircumspheres(std::string_view id) {
  compareScenes(id, [](const std::vector<Object> &objects, const Json &explained) {
    std::vector<ExactVec3> corners;
    for (const Object &object : objects)
      for (std::size_t i = 0; i < object.size(); ++i)
        corners.push_back(object[i]);
    const auto answerAt = [](const ExactVec3 &point, const ExactVec3 &normal, const Json &at) {
      return answerTo(Json{{"query", "point-plane"},
                           {"plane", {{"point", numbersOf(point)}, {"normal", numbersOf(normal)}}},
                           {"point", at}});
    };
    const ExactVec3 across = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const Json &values = explained.at("values");
    if (!isZero(across)) {
      EXPECT_EQ(values.at("det"), answerAt(corners[0], across, numbersOf(corners[3])).at("result").at("f"));
    }
    if (explained.at("case") != "sphere")
      return 0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Json answered = answerAt((corners[0] + corners[i]) / Rational(2), corners[i] - corners[0],
                                     values.at("center").at("exact"));
      if (!answered.at("ok"))
        return 0; // the numbers of the centre are longer than those of a question may be
      EXPECT_EQ(answered.at("result").at("side"), "on");
    }
    return 1;
  });
}
TEST(SameAsEval, Circumsphere_InThePlanesHalfwayBetween) { compareCircumspheres("circumsphere"); }
TEST(SameAsEval, CircumspherePoints_InThePlanesHalfwayBetween) {
  compareCircumspheres("circumsphere-points");
}

/// Questions have the plane of three points: its normal is twice as long as the area.
TEST(SameAsEval, TriangleArea_InTheNormalOfItsPlane) {
  compareScenes("triangle-area", [](const std::vector<Object> &objects, const Json &explained) {
    const Json answered = answerTo({{"query", "plane"}, {"plane", {{"points", operandOf(objects[0])}}}});
    EXPECT_EQ(answered.at("ok"), explained.at("case") == "proper");
    if (!answered.at("ok"))
      return 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_EQ(explained.at("values").at("normal").at("exact").at(axis),
                answered.at("result").at("coefficients").at("exact").at(axis));
    return 1;
  });
}

/// Questions have no areas, but refuse polygons that are not flat; those that they take do not meet
/// themselves.
TEST(SameAsEval, PolygonArea_InWhatIsFlat) {
  compareScenes("polygon-area", [](const std::vector<Object> &objects, const Json &explained) {
    const Json answered = answerTo({"ray-polygon", {"polygon", "ray"}},
                                   {objects[0], RayObject{objects[0][0], ExactVec3(1, 2, 3)}});
    const bool isRefused = !answered.at("ok") && answered.at("error").at("code") == "not-planar";
    EXPECT_EQ(explained.at("case") == "not-planar", isRefused) << answered;
    if (answered.at("ok")) {
      EXPECT_EQ(explained.at("case"), "simple");
    }
    return 1;
  });
}

/// Questions have no volumes, but take convex solids alone, which have one.
TEST(SameAsEval, SolidVolume_OfWhatIsConvex) {
  compareScenes("solid-volume", [](const std::vector<Object> &objects, const Json &explained) {
    const RayObject ray{objects[0][0], ExactVec3(1, 2, 3)};
    const Json answered = answerTo({"ray-solid", {"solid", "ray"}}, {objects[0], ray});
    if (!answered.at("ok"))
      return 0;
    EXPECT_EQ(explained.at("case"), "solid");
    return 1;
  });
}

TEST(SameAsEval, TriangleDegenerate_WhereThereIsNoPlane) {
  compareScenes("triangle-degenerate", [](const std::vector<Object> &objects, const Json &explained) {
    const ExactVec3 &corner = objects[0][0];
    const Json plane = answerTo({{"query", "plane"}, {"plane", {{"points", operandOf(objects[0])}}}});
    EXPECT_EQ(plane.at("ok"), explained.at("case") == "proper");
    const Json answered =
        answerTo({"ray-triangle", {"triangle", "ray"}}, {objects[0], RayObject{corner, ExactVec3(1, 2, 3)}});
    if (!plane.at("ok")) {
      EXPECT_EQ(answered.at("error").at("code"), "degenerate-triangle");
      return 1;
    }
    return answered.at("result").contains("perp")
               ? compare(explained.at("values"), answered.at("result").at("perp"), "")
               : 0;
  });
}

INSTANTIATE_TEST_SUITE_P(SameAsEval, EveryConstructionWithAQuestion, testing::ValuesIn([] {
                           std::vector<std::string> ids;
                           for (const Construction &construction : constructions())
                             if (std::string id(construction.id);
                                 !withOtherQuestions.contains(id) && !withoutQuestions.contains(id))
                               ids.push_back(std::move(id));
                           return ids;
                         }()),
                         test::testName);

} // namespace
} // namespace halfspace
