#include "widgets/picture/shapes/shape_mesh.h"

#include "tests/picture/shapes/mesh_of.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

const Color red{200, 0, 0};
const Color white{255, 255, 255};

Mesh meshOfForm(ShapeForm form) { return meshOf({{"", red, std::move(form)}}); }

bool isCovered(const Mesh &mesh, const Place &place) {
  return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                     [&](const glm::vec3 &at) { return glm::distance(Place(at), place) < 0.3; });
}

TEST(ShapeMesh, OfAnOpenLine_GoesAlongItsPath_AndOfAClosedOneBackToItsStart) {
  const std::vector<Place> path{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}};
  EXPECT_TRUE(isCovered(meshOfForm(LineShape{path, 0.1}), {4, 4, 0}));
  const auto middle = [&](bool isClosed) { // whole lines have corners at their ends alone
    return isCovered(meshOfForm(LineShape{path, 0.1, {0.4, 0.3}, isClosed}), {2, 2, 0});
  };
  EXPECT_FALSE(middle(false));
  EXPECT_TRUE(middle(true));
}

TEST(ShapeMesh, OfALineThatFades_IsInItsOwnColourUntilThere) {
  for (const Rhythm &rhythm : {Rhythm(), Rhythm{0.4, 0.3}})
    for (const bool atBothEnds : {false, true}) {
      const Mesh mesh =
          meshOfForm(LineShape{{{0, 0, 0}, {10, 0, 0}}, 0.1, rhythm, false, LineFade{white, 2, atBothEnds}});
      ASSERT_FALSE(mesh.positions.empty());
      for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double way = mesh.positions[i].x;
        const bool isEnd = way > 9.99 || (atBothEnds && way < 0.01);
        const bool isBetween = way < 7.999 && (way > 2.001 || !atBothEnds);
        if (isEnd || isBetween) {
          EXPECT_EQ(mesh.colors[i], isEnd ? mix(white, red, fadedStrength) : red);
        }
      }
    }
}

TEST(ShapeMesh, OfOneBallOfMany_HasFewerTriangles) {
  EXPECT_LT(meshOfForm(BallShape{{0, 0, 0}, 1, true}).triangles.size(),
            meshOfForm(BallShape{{0, 0, 0}, 1}).triangles.size());
}

TEST(ShapeMesh, OfShapes_HasThemInTheirOrderAndColours) {
  const Color blue{0, 0, 200};
  const Mesh mesh = meshOf({{"", red, FaceShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}},
                            {"", blue, ArrowShape{{0, 0, 0}, {0, 0, 5}, 0.1}}});
  EXPECT_EQ(mesh.colors.front(), red);
  EXPECT_EQ(mesh.colors.back(), blue);
}

bool areSame(const Mesh &a, const Mesh &b) {
  return a.positions == b.positions && a.normals == b.normals && a.colors == b.colors &&
         a.triangles == b.triangles;
}

TEST(MeshSequence, OfListsThatFollowOneAnother_HasTheMeshOfEach) {
  const Shape ball{"A", red, BallShape{{0, 0, 0}, 1}};
  const Shape line{"B", red, LineShape{{{0, 0, 0}, {4, 0, 0}}, 0.1}};
  const Shape longerLine{"B", red, LineShape{{{0, 0, 0}, {4, 0, 0}, {9, 9, 0}}, 0.1}};
  const Shape arrow{"C", white, ArrowShape{{0, 0, 0}, {0, 0, 5}, 0.1}};
  MeshSequence meshes;
  const std::vector<std::vector<Shape>> lists{
      {ball, line, arrow}, {ball, longerLine, arrow}, {longerLine, arrow}, {longerLine, arrow, ball}, {},
      {line, ball}};
  for (const std::vector<Shape> &list : lists)
    EXPECT_TRUE(areSame(meshes.meshOf(std::make_shared<const std::vector<Shape>>(list)), meshOf(list)));
}

TEST(ShapeMesh, OfWhatIsNoSolid_IsEmpty) {
  EXPECT_TRUE(meshOfForm(LineShape{}).positions.empty());
  EXPECT_TRUE(meshOfForm(HairlineShape{{{0, 0, 0}, {1, 0, 0}}, {1, 1}}).positions.empty());
  EXPECT_TRUE(meshOfForm(LeaderShape{{0, 0}, {9, 9}}).positions.empty());
}

} // namespace
} // namespace halfspace
