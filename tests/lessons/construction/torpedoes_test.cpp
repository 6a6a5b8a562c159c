// Torpedoes by the thousand: what each hits, and when, against the loop over all triangles.
#include "tests/effort.h"
#include "tests/lessons/construction/torpedoes.h"

#include "geometry/hit_all.h"
#include "lessons/construction/parts/shots.h"
#include "lessons/lesson/lesson.h"
#include "lessons/object/kinds/mesh.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace halfspace {
namespace {

using namespace test;

INSTANTIATE_TEST_SUITE_P(Plain, TorpedoesAtAMesh, testing::Values(std::pair(plainSearch, 12)));

constexpr int shotsOfASeed = 8;

// --- the shots

std::vector<ExactVec3> firstBarrels(int seed, int count) {
  std::vector<ExactVec3> barrels;
  for (int shot = 0; shot < count; ++shot)
    barrels.push_back(randomBarrel(seed, shotAt(shot * framesPerShot, seed)));
  return barrels;
}

TEST(Shots, OfASeed_AreAlwaysTheSame) {
  EXPECT_EQ(firstBarrels(7, 3), (std::vector<ExactVec3>{{-6, -3, -8}, {0, 5, -8}, {-3, 2, -8}}));
}

TEST(Shots, OfOtherSeeds_AreOthersAndAllPointDownwards) {
  std::set<std::string> all;
  for (int seed = 1; seed <= 200; ++seed) {
    std::string text;
    for (const ExactVec3 &barrel : firstBarrels(seed, 8)) {
      EXPECT_EQ(barrel.z, -8);
      EXPECT_LE(std::max(abs(barrel.x), abs(barrel.y)), 6);
      text += toText(barrel.x) + "," + toText(barrel.y) + ";";
    }
    EXPECT_TRUE(all.insert(text).second) << seed;
  }
}

TEST(Shots, BetweenTwoFrames_TheEarlierStands) {
  const auto shot = [](const Rational &frame) { return shotAt(frame, 7); };
  EXPECT_EQ(shot(149).frame, 0);
  EXPECT_EQ(shot(q(299, 2)).frame, 0);
  EXPECT_EQ(shot(150).frame, 150);
  EXPECT_EQ(shot(q(1501, 10)).number, 1);
  EXPECT_EQ(shot(-1).frame, -150);
  EXPECT_EQ(parameterAt(q(1501, 10), shot(q(1501, 10))), q(1, 500));
}

TEST(Shots, WithoutASeed_ThereIsOne) {
  for (const Rational &frame : {Rational(-20), Rational(0), Rational(1400)})
    EXPECT_EQ(shotAt(frame, 0).frame, 0);
}

// --- what they hit

/// The lesson's scene, with a saucer that crosses the field slowly.
Scene barnScene() {
  const LessonLibrary library = readLessons(LESSON_FOLDER);
  const Lesson *lesson = library.find("photon-torpedo");
  if (!lesson)
    throw std::out_of_range("no lesson photon-torpedo");
  Object saucer = *findObject(lesson->scene, "U");
  saucer[1] = {2, 1, 0};
  return edited(lesson->scene, {ChangeObject{"U", saucer}});
}

Scene atShot(const Scene &scene, int seed, int shot, const Rational &framesLater = 0) {
  const auto with = [&](const std::string &name, const Rational &value) {
    Object number = *findObject(scene, name);
    number[0].x = value;
    return ChangeObject{name, number};
  };
  return edited(scene, {with("seed", seed), with("frame", shot * framesPerShot + framesLater)});
}

Ray<Rational> torpedoOf(const Evaluation &evaluation) {
  const EvaluatedEntry *shot = evaluation.find("shot");
  const auto ray = shot ? objectAs<RayObject>(shot->outcome->objects.front().object) : std::nullopt;
  return ray ? Ray<Rational>{ray->origin, ray->direction} : Ray<Rational>{};
}

/// The triangles of meshes in the scene, in their order.
std::vector<Triangle<Rational>> trianglesIn(const Scene &scene, const std::vector<std::string> &meshes) {
  std::vector<Triangle<Rational>> triangles;
  for (const std::string &name : meshes) {
    const MeshObject mesh = *objectAs<MeshObject>(*findObject(scene, name));
    for (std::size_t i = 0; i < mesh.shape->triangleCount(); ++i)
      triangles.push_back(triangleOf(mesh, i));
  }
  return triangles;
}

TriangleHits<Rational> hitsOf(const Ray<Rational> &ray, const std::vector<Triangle<Rational>> &triangles) {
  return hitAll(ray, std::span<const Triangle<Rational>>(triangles));
}

void expectTheSame(const Crossings &crossings, const TriangleHits<Rational> &all) {
  std::vector<std::pair<std::size_t, Rational>> hits;
  std::vector<std::pair<std::size_t, Rational>> expected;
  for (const Crossing &crossing : crossings.all)
    if (crossing.which == RayTriangleCase::Hit)
      hits.emplace_back(crossing.number, crossing.at->t);
  for (const auto &hit : all.hits)
    expected.emplace_back(hit.index + 1, hit.t);
  EXPECT_EQ(hits, expected);
  ASSERT_EQ(crossings.nearest.has_value(), !all.hits.empty());
  if (crossings.nearest) {
    EXPECT_EQ(*crossings.nearest, all.hits.front().index + 1);
  }
}

void expectSorted(const Crossings &crossings) {
  EXPECT_EQ(crossings.all.size(), crossings.fragments);
  for (std::size_t i = 1; i < crossings.all.size(); ++i) {
    const Crossing &before = crossings.all[i - 1];
    const Crossing &after = crossings.all[i];
    EXPECT_TRUE(before.at || !after.at) << "those without a parameter come last";
    if (before.at && after.at) {
      EXPECT_LE(before.at->t, after.at->t);
    }
    if (before.at.has_value() == after.at.has_value() && (!before.at || before.at->t == after.at->t)) {
      EXPECT_LT(before.number, after.number);
    }
  }
}

/// Whether a ray that comes down goes through the ground within the field of 32 × 24.
bool aimsAtTheField(const Ray<Rational> &ray) {
  const Rational t = -ray.origin.z / ray.direction.z;
  const ExactVec3 ground = ray.origin + ray.direction * t;
  return ground.x >= 0 && ground.x <= 32 && ground.y >= 0 && ground.y <= 24;
}

TEST(Torpedoes, AThousandAtTheBarn_HitWhatTheLoopOverAllTrianglesSays) {
  const Scene barn = barnScene();
  const auto triangles = trianglesIn(barn, {"field", "barn", "roof", "wall"});
  std::set<std::size_t> hit;
  int atTheField = 0;
  for (int seed = 1; seed <= effort(125); ++seed)
    for (int shot = 0; shot < shotsOfASeed; ++shot) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", shot " + std::to_string(shot));
      const Evaluation evaluation = evaluate(atShot(barn, seed, shot));
      const Ray<Rational> torpedo = torpedoOf(evaluation);
      const Crossings &crossings = *evaluation.find("nearest")->outcome->crossings;
      ASSERT_NO_FATAL_FAILURE(expectTheSame(crossings, hitsOf(torpedo, triangles)));
      expectSorted(crossings);
      if (aimsAtTheField(torpedo)) {
        EXPECT_TRUE(crossings.nearest) << "none slips through";
        ++atTheField;
      }
      if (crossings.nearest)
        hit.insert(*crossings.nearest);
    }
  EXPECT_GT(atTheField, effort(500));
  EXPECT_GE(hit.size(), static_cast<std::size_t>(atLeast(7))) << "of the field, the barn and its roof";
}

TEST(Torpedoes, OnTheirWay_ExplodeWhereTheyHitAndNotBefore) {
  const Scene barn = barnScene();
  const auto triangles = trianglesIn(barn, {"field", "barn", "roof", "wall"});
  int exploded = 0;
  for (int seed = 1; seed <= 40; ++seed) {
    const auto all = hitsOf(torpedoOf(evaluate(atShot(barn, seed, 3))), triangles);
    if (all.hits.empty()) // it leaves the field
      continue;
    ++exploded;
    const auto flightAfter = [&](const Rational &lambda) {
      const Evaluation evaluation = evaluate(atShot(barn, seed, 3, lambda * framesPerLambda));
      const EvaluatedEntry *flight = evaluation.find("flight");
      return flight ? flight->outcome : nullptr;
    };
    const Rational t = all.hits.front().t;
    ASSERT_LT(t, 2) << "before the next shot";
    EXPECT_EQ(flightAfter(t * q(99, 100))->told->name, "flying");
    EXPECT_EQ(flightAfter(t)->told->name, "exploded");
    EXPECT_EQ(std::get<Surd>(flightAfter(2)->values->front().value), Surd(t)) << "it stays there";
  }
  EXPECT_GT(exploded, 20);
}

/// Hills over a field of 32 × 32 cells, two triangles each.
TriangleMesh hills() {
  constexpr std::uint32_t n = 32;
  std::mt19937 engine(1);
  TriangleMesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      mesh.corners.emplace_back(x, y, static_cast<double>(engine() % 16) / 8);
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t i = y * (n + 1) + x;
      mesh.triangles.push_back({i, i + 1, i + n + 1});
      mesh.triangles.push_back({i + n + 2, i + n + 1, i + 1});
    }
  return mesh;
}

TEST_P(TorpedoesAtAMesh, ManyTorpedoes_HitWhatTheLoopOverAllTrianglesSays) {
  const auto &[search, seeds] = GetParam();
  Scene scene = barnScene();
  Object field = *findObject(scene, "field");
  field.setShape(std::make_shared<const MeshShape>(hills(), search.make(hills())));
  field[0] = {q(1, 3), q(-1, 2), -1};
  field[1] = {4, q(1, 4), 0};
  field[2].x = q(10, 9);
  scene = edited(scene, {ChangeObject{"field", field}, RemoveEntry{"flight"}});
  Object chosen = *findObject(scene, "i");
  chosen[0].x = 0; // none
  scene = edited(scene, {ChangeObject{"i", chosen}});
  const auto triangles = trianglesIn(scene, {"field", "barn", "roof", "wall"});
  const std::size_t inField = hills().triangles.size();
  const std::size_t ofFewMeshes = triangles.size() - inField;
  int atTheField = 0;
  for (int seed = 1; seed <= seeds; ++seed)
    for (int shot = 0; shot < shotsOfASeed; ++shot) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", shot " + std::to_string(shot));
      const Evaluation evaluation = evaluate(atShot(scene, seed, shot));
      const Crossings &crossings = *evaluation.find("nearest")->outcome->crossings;
      const Ray<Rational> torpedo = torpedoOf(evaluation);
      const auto all = hitsOf(torpedo, triangles);
      ASSERT_EQ(crossings.nearest.has_value(), !all.hits.empty());
      if (!crossings.nearest)
        continue;
      EXPECT_EQ(*crossings.nearest, all.hits.front().index + 1);
      EXPECT_EQ(nearestOf(crossings)->at->t, all.hits.front().t);
      const bool isInField = *crossings.nearest <= inField;
      EXPECT_EQ(crossings.all.size(), ofFewMeshes + (isInField ? 1 : 0))
          << "of very many the nearest one alone";
      atTheField += aimsAtTheField(torpedo) ? 1 : 0;
    }
  EXPECT_GT(atTheField, seeds * 3);
}

} // namespace
} // namespace halfspace
