// What it costs to find the nearest hit among ever more triangles.
#include "widgets/cost_plot/measure_cost.h"

#include "geometry/decide.h"
#include "geometry/search/hit_finder.h"
#include "geometry/search/rounded_ray.h"

#include <QtTest>

#include <cmath>

using namespace halfspace;

namespace {

using ExactRay = Ray<Rational>;

const ExactRay steep{{6, 7, 14}, {Rational(40, 3), Rational(20, 3), Rational(-40, 3)}};

/// A square floor of two triangles, turned and moved so that its middle is (6, 7, 3).
MeshObject floorMesh() {
  const std::vector<Vec3<double>> corners{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
  return {{6, 7, 3},
          {0, 2, 0},
          2,
          std::make_shared<const MeshShape>(corners, std::vector<MeshFace>{{0, 1, 2, 3}})};
}

std::vector<CostPoint> costsOf(const ExactRay &ray, std::size_t most,
                               const std::vector<MeshObject> &meshes = {}) {
  const std::atomic<bool> cancelled{false};
  std::vector<CostPoint> points;
  measureCost(
      {ray, meshes}, cancelled, [&](const CostPoint &point) { points.push_back(point); }, most);
  return points;
}

} // namespace

class MeasureCostTest : public QObject {
  Q_OBJECT

private slots:
  void field_ofAnyNumber_hasSoManyTriangles_andIsAlwaysTheSame() {
    for (const std::size_t triangles :
         {std::size_t(1), std::size_t(2), std::size_t(3), fewestMeasured, std::size_t(1001)}) {
      const TriangleMesh field = bumpyField(triangles);
      QCOMPARE(field.triangles.size(), triangles);
      QVERIFY(field == bumpyField(triangles));
    }
  }

  void shotFromAbove_meetsTheField_whicheverWayItIsLookedFor() {
    for (const std::size_t triangles : {fewestMeasured, std::size_t(1000), std::size_t(10000)}) {
      const TriangleMesh field = bumpyField(triangles);
      const SearchResult plain = PlainHitSearch(field).search(shotAtField(steep));
      QVERIFY(plain.nearest.has_value());
      QVERIFY(plain.nearest == HitFinder(trianglesOf(field)).search(shotAtField(steep)).nearest);
    }
  }

  void shot_isThatOfTheRay_movedAboveTheOrigin() {
    const ExactRay shot = shotAtField(steep);
    QVERIFY(shot.origin.z == 14);
    QVERIFY(shot.direction == Vec3<Rational>(1, Rational(1, 2), -1));
    const ExactRay upwards = shotAtField({{5, 6, 7}, {0, 0, 2}});
    QVERIFY(upwards.origin == Vec3<Rational>(0, 0, 7));
  }

  void shot_ofNumbersBeyondDoubles_isFinite() {
    Rational huge = 10;
    for (int i = 0; i < 9; ++i)
      huge = huge * huge; // 10^512
    for (const ExactRay &ray : {ExactRay{{huge, 0, huge}, {1, 0, -1}}, ExactRay{{0, 0, 1}, {huge, 0, -1}},
                                ExactRay{{0, 0, 1}, {0, 0, Rational(-1) / huge}}}) {
      const ExactRay shot = shotAtField(ray);
      QVERIFY(RoundedRay(shot).isExact);
      QVERIFY(!isZero(shot.direction));
      QCOMPARE(costsOf(ray, fewestMeasured).size(), std::size_t(1));
    }
  }

  void costs_ofEachSize_areMeasured_andTheTreeLooksAtFew() {
    const std::vector<CostPoint> points = costsOf(steep, 10000);
    QCOMPARE(points.size(), std::size_t(3));
    for (const CostPoint &point : points) {
      QCOMPARE(point.plain.triangles, point.triangles);
      QCOMPARE(point.plain.boxes, std::size_t(0));
      QVERIFY(std::isfinite(point.plainMicroseconds) && point.plainMicroseconds > 0);
      QVERIFY(std::isfinite(point.treeMicroseconds) && point.treeMicroseconds > 0);
    }
    QCOMPARE(points.back().triangles, std::size_t(10000));
    QVERIFY(points.back().tree.boxes + points.back().tree.triangles < 1000);
  }

  void meshesOfTheScene_areOneMesh_asTheyStand() {
    const MeshObject floor = floorMesh();
    const TriangleMesh mesh = oneMeshOf({floor, floor});
    QCOMPARE(mesh.triangles.size(), std::size_t(4));
    for (std::size_t i = 0; i < 4; ++i)
      QVERIFY(exactly(mesh.triangle(i)).p1 == triangleOf(floor, i % 2).p1);
  }

  void costInTheScene_isMeasuredFirst_atItsOwnTriangles() {
    const std::vector<CostPoint> points = costsOf(steep, 1000, {floorMesh(), floorMesh()});
    QCOMPARE(points.size(), std::size_t(3));
    QVERIFY(points[0].inScene && !points[1].inScene);
    QCOMPARE(points[0].triangles, std::size_t(4));
    QCOMPARE(points[0].plain.triangles, std::size_t(4));
    QVERIFY(points[0].tree.triangles > 0);
  }

  void cancelled_tellsNoMore() {
    std::atomic<bool> cancelled{false};
    int told = 0;
    measureCost(
        {steep, {}}, cancelled,
        [&](const CostPoint &) {
          ++told;
          cancelled = true;
        },
        10000);
    QCOMPARE(told, 1);
  }
};

QTEST_APPLESS_MAIN(MeasureCostTest)
#include "measure_cost_test.moc"
