// What `halfspace explain` says of a scene, and what `halfspace eval` answers to the same question: one core,
// the same figures.
#include "tests/lessons/construction/random_objects.h"

#include "eval/evaluate.h"
#include "lessons/scene/explain_formats.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace halfspace {
namespace {

using namespace test;
using Json = nlohmann::json;

constexpr int scenesPerWriting = 500;

/// The question that a construction answers, and the names of its operands in the order of the roles.
struct Question {
  std::string query;
  std::vector<std::string> operands;
};

/// Those whose figures have a question; the others have none in the eval format.
const std::map<std::string, Question> &questions() {
  static const std::map<std::string, Question> all{
      {"plane-implicit", {"plane", {"plane"}}},
      {"signed-distance", {"point-plane", {"plane", "point"}}},
      {"ray-plane-dot", {"ray-plane", {"plane", "ray"}}},
      {"ray-triangle-perp", {"ray-triangle", {"triangle", "ray"}}},
      {"ray-triangle-cramer", {"ray-triangle", {"triangle", "ray"}}},
      {"three-methods", {"ray-triangle", {"triangle", "ray"}}},
      {"misprints", {"ray-triangle", {"triangle", "ray"}}},
      {"ray-sphere", {"ray-sphere", {"sphere", "ray"}}},
      {"plane-plane", {"plane-plane", {"plane", "plane2"}}},
      {"line-pluecker", {"line", {"line"}}},
      {"line-line", {"line-line", {"line", "line2"}}},
      {"line-plane", {"line-plane", {"line", "plane"}}},
      {"ray-polygon-pluecker", {"ray-polygon", {"polygon", "ray"}}},
      {"ray-solid-pluecker", {"ray-solid", {"solid", "ray"}}},
  };
  return all;
}
const std::set<std::string> withoutQuestion{"point-line",
                                            "half-spaces",
                                            "barycentric",
                                            "dot-product-projection",
                                            "ray-plane-substitution",
                                            "plane-parametric",
                                            "ray-plane-picture",
                                            "triangle-degenerate"};

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

Json answerTo(const Question &question, const std::vector<Object> &objects) {
  Json asked{{"query", question.query}};
  for (std::size_t i = 0; i < objects.size(); ++i)
    asked[question.operands.at(i)] = operandOf(objects[i]);
  std::string answer;
  Evaluator().answer(asked.dump(), answer);
  return Json::parse(answer);
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

class SameAsEval : public testing::TestWithParam<std::string> {};

TEST_P(SameAsEval, EveryFigureThatBothHave_IsTheSame) {
  const Construction &construction = *findConstruction(GetParam());
  const Question &question = questions().at(GetParam());
  int compared = 0;
  for (const Writing writing :
       {Writing::SmallIntegers, Writing::Halves, Writing::Fractions, Writing::LongFractions}) {
    RandomObjects random(11 + static_cast<std::uint64_t>(writing));
    for (int i = 0; i < scenesPerWriting && !HasFailure(); ++i) {
      const std::vector<Object> objects = random.objectsFor(construction, writing);
      const Scene scene = sceneOf(construction, objects);
      const Evaluation evaluation = evaluate(scene);
      const Json explained = Json::parse(explanationJson("", scene, evaluation));
      const Json answered = answerTo(question, objects);
      SCOPED_TRACE(answered.dump());
      ASSERT_EQ(answered.at("ok"), !lastOutcome(evaluation).told->degenerate);
      if (!answered.at("ok"))
        continue;
      if (answered.at("result").contains("case")) {
        EXPECT_EQ(explained.at("case"), answered.at("result").at("case"));
      }
      compared += compare(explained.at("values"), answered.at("result"), "");
    }
  }
  EXPECT_GT(compared, scenesPerWriting) << "hardly a name is the same";
}

/// No question has several planes, but each of them has one of its own.
TEST(RayPlaneSubstitution, ComesToTheSameForEachPlaneAsItsOwnQuestion) {
  const Question question{"ray-plane", {"plane", "ray"}};
  int compared = 0;
  RandomObjects random(5);
  for (int i = 0; i < scenesPerWriting && !HasFailure(); ++i) {
    const std::vector<Object> objects =
        random.objectsFor(*findConstruction("ray-plane-substitution"), Writing::Fractions);
    const Scene scene = sceneOf(*findConstruction("ray-plane-substitution"), objects);
    const Evaluation evaluation = evaluate(scene);
    if (lastOutcome(evaluation).told->degenerate)
      continue;
    const Json explained = Json::parse(explanationJson("", scene, evaluation));
    for (std::size_t place = 0; place + 1 < objects.size(); ++place) {
      const Json answered = answerTo(question, {objects[place], objects.back()});
      SCOPED_TRACE(answered.dump());
      compared +=
          compare(explained.at("values").at("plane" + std::to_string(place)), answered.at("result"), "");
    }
  }
  EXPECT_GT(compared, scenesPerWriting);
}

/// Lessons name where the line goes in and where it comes out, questions have lists of two.
TEST(RaySolidPluecker, ComesToTheFacesAndThePointsOfItsQuestion) {
  const Construction &construction = *findConstruction("ray-solid-pluecker");
  int compared = 0;
  RandomObjects random(6);
  for (int i = 0; i < scenesPerWriting && !HasFailure(); ++i) {
    const std::vector<Object> objects = random.objectsFor(construction, Writing::Fractions);
    const Scene scene = sceneOf(construction, objects);
    const Evaluation evaluation = evaluate(scene);
    const Json values = Json::parse(explanationJson("", scene, evaluation)).at("values");
    if (!values.contains("entered"))
      continue;
    const Json answered = answerTo(questions().at("ray-solid-pluecker"), objects).at("result");
    const Json &entered = values.at("entered");
    const Json &left = values.at("left");
    EXPECT_EQ(Json::array({entered.at("face"), left.at("face")}), answered.at("faces"));
    EXPECT_EQ(Json::array({entered.at("point"), left.at("point")}), answered.at("points"));
    ++compared;
  }
  EXPECT_GT(compared, scenesPerWriting / 4);
}

INSTANTIATE_TEST_SUITE_P(Constructions, SameAsEval, testing::ValuesIn([] {
                           std::vector<std::string> ids;
                           for (const Construction &construction : constructions())
                             if (std::string id(construction.id); !withoutQuestion.contains(id))
                               ids.push_back(std::move(id));
                           return ids;
                         }()),
                         [](const auto &each) {
                           std::string name = each.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

} // namespace
} // namespace halfspace
