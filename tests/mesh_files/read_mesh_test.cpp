#include "widgets/mesh_files/read_mesh.h"

#include "tests/mesh_files/mesh_texts.h"
#include "tests/program_test.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

struct ReadMesh : ProgramTest {
  /// The mesh in a file of this name and content.
  [[nodiscard]] Result<RawMesh> read(const std::string &name, const std::string &content) const {
    write(name, content);
    return readMesh(inFolder(name), [](std::optional<double>) {});
  }

  /// Likewise, its triangles by their places.
  [[nodiscard]] std::vector<StlTriangle> triangles(const std::string &name,
                                                   const std::string &content) const {
    const auto mesh = read(name, content);
    EXPECT_TRUE(mesh) << mesh.problem().text();
    std::vector<StlTriangle> found;
    if (mesh)
      for (const auto &[a, b, c] : mesh->triangles)
        found.push_back({mesh->corners.at(a), mesh->corners.at(b), mesh->corners.at(c)});
    return found;
  }

  void expectRefused(const std::string &name, const std::string &content, const std::string &part) const {
    const auto mesh = read(name, content);
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.problem().sentence.find(part), std::string::npos) << mesh.problem().sentence;
    EXPECT_EQ(mesh.problem().file, inFolder(name).string());
  }
};

using Vec2 = glm::dvec2;

/// Twice the area of triangles in the plane of x and y, each counted positive where it turns left.
double twiceAreaOf(const std::vector<StlTriangle> &triangles) {
  double area = 0;
  for (const auto &[a, b, c] : triangles)
    area += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return area;
}

const std::string tetrahedronObj = "# a tetrahedron\no thing\nv 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\n"
                                   "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::string cornersPly = "0 0 0\n4 0 0\n0 4 0\n0 0 4\n";
const std::string facesPly = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string plyHead(const std::string &format, const std::string &corners, const std::string &faces) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + corners +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class Bytes> std::string binaryTetrahedronPly(const std::string &format, Bytes bytes) {
  std::string ply = plyHead(format, "4", "4");
  for (const float number : {0.0F, 0.0F, 0.0F, 4.0F, 0.0F, 0.0F, 0.0F, 4.0F, 0.0F, 0.0F, 0.0F, 4.0F})
    ply += bytes(number);
  for (const std::array<int, 3> &face : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    ply += '\3';
    for (const int corner : face)
      ply += bytes(corner);
  }
  return ply;
}

TEST_F(ReadMesh, OfEachFormatGivesTheTrianglesOfTheFile) {
  const auto expected = tetrahedronTriangles();
  EXPECT_EQ(triangles("a.stl", binaryStl(expected)), expected);
  EXPECT_EQ(triangles("b.stl", textStl(expected)), expected);
  EXPECT_EQ(triangles("c.obj", tetrahedronObj), expected);
  EXPECT_EQ(triangles("d.ply", plyHead("ascii", "4", "4") + cornersPly + facesPly), expected);
  const auto inOrder = [](const auto &value) { return bytesOf(value); };
  const auto turned = [](const auto &value) { return turnedBytesOf(value); };
  EXPECT_EQ(triangles("e.ply", binaryTetrahedronPly("binary_little_endian", inOrder)), expected);
  EXPECT_EQ(triangles("f.ply", binaryTetrahedronPly("binary_big_endian", turned)), expected);
}

TEST_F(ReadMesh, WithAnotherEndingIsReadAllTheSame) {
  EXPECT_EQ(triangles("a.obj", binaryStl(tetrahedronTriangles())), tetrahedronTriangles());
  EXPECT_EQ(triangles("b.stl", tetrahedronObj), tetrahedronTriangles());
  EXPECT_EQ(triangles("c.txt", textStl(tetrahedronTriangles())), tetrahedronTriangles());
}

TEST_F(ReadMesh, BinaryStlThatBeginsAsTextIsRead) {
  EXPECT_EQ(triangles("a.stl", binaryStl(tetrahedronTriangles(), "solid of a program that writes so")),
            tetrahedronTriangles());
}

TEST_F(ReadMesh, BinaryStlWithTooSmallACountIsReadToItsEnd) {
  std::string stl = binaryStl(tetrahedronTriangles()) + "the end"; // less than a triangle
  stl[80] = 1;
  EXPECT_EQ(triangles("a.stl", stl), tetrahedronTriangles());
}

TEST_F(ReadMesh, TextStlWhoseNameIsInOtherLettersIsReadAsText) {
  std::string name;
  for (int i = 0; i < 200; ++i)
    name += "Ж";
  EXPECT_EQ(triangles("a.stl", "solid " + name + textStl(tetrahedronTriangles()).substr(5)),
            tetrahedronTriangles());
}

TEST_F(ReadMesh, TextStlHoweverItIsWrittenIsRead) {
  const std::string facet = "color 1 0 0\r\n\tFACET normal 0 0 1\r\n\r\nouter loop\r\nvertex 0 0 0\r\n"
                            "VERTEX +4.0 0e0 .0\r\n  vertex\t0 4 0\r\nendloop\r\nendfacet\r\n";
  const StlTriangle triangle{Vec3<float>(0, 0, 0), Vec3<float>(4, 0, 0), Vec3<float>(0, 4, 0)};
  EXPECT_EQ(triangles("a.stl", "Solid one\r\n" + facet + "endsolid one\r\nsolid\r\n" + facet + "endsolid"),
            (std::vector{triangle, triangle}));
}

TEST_F(ReadMesh, TextStlThatDoesNotGoOnAsItBeginsIsRefused) {
  const std::string text = textStl(tetrahedronTriangles());
  const auto with = [&](std::string_view part, std::string_view other) {
    std::string changed = text;
    return changed.replace(changed.find(part), part.size(), other);
  };
  expectRefused("a.stl", with("endsolid test", ""), "cut off");
  expectRefused("b.stl", with("outer loop", ""), "damaged");
  expectRefused("c.stl", with("endloop", "vertex 1 2 3"), "damaged");
  expectRefused("d.stl", with("vertex 4.000000", "vertex four"), "damaged");
  expectRefused("e.stl", with("0.000000\n", "\n"), "damaged"); // two numbers
  expectRefused("f.stl", text + "facet normal 0 0 0\n", "damaged");
}

TEST_F(ReadMesh, FacesOfMoreCornersAreCutIntoTriangles) {
  const std::string corners = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\n";
  const auto quad = triangles("a.obj", corners + "f 1 2 3 4\n");
  EXPECT_EQ(quad.size(), 2U);
  EXPECT_EQ(twiceAreaOf(quad), 32);
  const auto ply = triangles("b.ply", plyHead("ascii", "4", "1") + "0 0 0\n4 0 0\n4 4 0\n0 4 0\n4 0 1 2 3\n");
  EXPECT_EQ(ply.size(), 2U);
  EXPECT_EQ(twiceAreaOf(ply), 32);
}

TEST_F(ReadMesh, AFaceWithACornerThatPointsInwardsStaysWhatItIs) {
  // An arrow head: cut from its first corner, a triangle would lie outside.
  const auto arrow = triangles("a.obj", "v 4 0 0\nv 8 8 0\nv 4 2 0\nv 0 8 0\nf 2 3 4 1\n");
  ASSERT_EQ(arrow.size(), 2U);
  for (const StlTriangle &triangle : arrow)
    EXPECT_GT(twiceAreaOf({triangle}) * twiceAreaOf(arrow), 0);
  EXPECT_EQ(std::abs(twiceAreaOf(arrow)), 16);
}

TEST_F(ReadMesh, AFaceLikeACombIsCutIntoItsOwnArea_WhereverItIsSeenFrom) {
  // Teeth of width 1 and height 3 on a bar of height 1, in each of the three planes and turned either way.
  std::vector<Vec2> comb{{0, 0}, {9, 0}};
  for (int x = 9; x > 0; --x)
    comb.insert(comb.end(), {{static_cast<double>(x), x % 2 == 1 ? 4.0 : 1.0},
                             {static_cast<double>(x - 1), x % 2 == 1 ? 4.0 : 1.0}});
  for (int along = 0; along < 3; ++along)
    for (const bool turned : {false, true}) {
      std::string obj;
      std::string face = "f";
      for (std::size_t i = 0; i < comb.size(); ++i) {
        Vec3<double> corner(0.0);
        corner[(along + 1) % 3] = comb[i].x;
        corner[(along + 2) % 3] = comb[i].y;
        obj += "v " + std::to_string(corner.x) + " " + std::to_string(corner.y) + " " +
               std::to_string(corner.z) + "\n";
        face += " " + std::to_string(turned ? comb.size() - i : i + 1);
      }
      double area = 0;
      for (const auto &[a, b, c] : triangles("comb.obj", obj + face + "\n")) {
        const Vec3<float> normal = glm::cross(b - a, c - a);
        EXPECT_TRUE(turned ? normal[along] <= 0 : normal[along] >= 0);
        area += std::abs(normal[along]) / 2;
      }
      EXPECT_EQ(area, 9 + 5 * 3) << along << turned;
    }
}

TEST_F(ReadMesh, AFaceThatCrossesItselfOrHasNoAreaIsCutAllTheSame) {
  const std::string corners = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 4 4 0\n";
  EXPECT_EQ(triangles("bow.obj", corners + "f 1 2 3 4\n").size(), 2U);
  EXPECT_EQ(triangles("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n").size(), 2U);
  EXPECT_EQ(triangles("point.obj", corners + "f 1 1 1 1 1\n").size(), 3U);
}

TEST_F(ReadMesh, PlyWithOtherPropertiesAndElementsInAnyOrderIsRead) {
  const std::string head = "ply\nformat ascii 1.0\nelement strange 2\nproperty list uchar float many\n"
                           "element nothing 4000000000\nelement face 1\nproperty uchar red\n"
                           "property list uchar uint vertex_index\nproperty list uchar float texcoord\n"
                           "element vertex 3\nproperty float nx\nproperty double z\nproperty double y\n"
                           "property short x\nend_header\n";
  EXPECT_EQ(triangles("a.ply", head + "3 1 2 3\n0\n255 3 2 0 1 2 .5 .5\n9 3 2 +1\r\n9 6 5 4 9 1e0 8 7"),
            (std::vector<StlTriangle>{{Vec3<float>(7, 8, 1), Vec3<float>(1, 2, 3), Vec3<float>(4, 5, 6)}}));
}

TEST_F(ReadMesh, BinaryPlyWithNumbersOfAllSizesIsRead) {
  const auto file = [](const std::string &form, auto bytes) {
    std::string ply =
        "ply\nformat " + form +
        " 1.0\nelement vertex 3\nproperty double x\nproperty short y\n"
        "property int8 z\nelement face 1\nproperty list ushort uint16 vertex_indices\nend_header\n";
    for (int corner = 0; corner < 3; ++corner)
      ply += bytes(0.25 * corner) + bytes(static_cast<std::int16_t>(-300 * corner)) +
             bytes(static_cast<std::int8_t>(corner - 2));
    for (const int number : {3, 2, 0, 1})
      ply += bytes(static_cast<std::uint16_t>(number));
    return ply;
  };
  const std::vector<StlTriangle> expected{
      {Vec3<float>(0.5F, -600, 0), Vec3<float>(0, 0, -2), Vec3<float>(0.25F, -300, -1)}};
  const auto inOrder = [](const auto &value) { return bytesOf(value); };
  const auto turned = [](const auto &value) { return turnedBytesOf(value); };
  EXPECT_EQ(triangles("a.ply", file("binary_little_endian", inOrder)), expected);
  EXPECT_EQ(triangles("b.ply", file("binary_big_endian", turned)), expected);
}

TEST_F(ReadMesh, PlyThatDoesNotGoOnAsItsHeaderSaysIsRefused) {
  const std::string head = plyHead("ascii", "4", "4") + cornersPly;
  expectRefused("a.ply", head + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 two 3\n", "damaged");
  expectRefused("b.ply", head + "3 0 2 1\n3 0 1 3\n3 0 3 2\n-1 1 2 3\n", "damaged");
  expectRefused("c.ply", head + "4000000000 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", "damaged");
  expectRefused("d.ply", head + std::string(100'000, '1') + facesPly, "damaged");
  expectRefused("e.ply",
                plyHead("ascii", "4", "4").replace(plyHead("ascii", "4", "4").find(" z"), 2, " w") +
                    cornersPly + facesPly,
                "x, y or z is missing");
}

TEST_F(ReadMesh, ObjFaceWithAWordThatIsNoCornerIsToldWithItsLine) {
  for (const std::string word : {"two", "/2", "2x/1", "1.5"})
    expectRefused("a.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 " + word + " 3\n",
                  "Line 4 should be a face, and “" + word + "” is not the number of a corner.");
}

TEST_F(ReadMesh, ObjLineWithoutAnEndIsRefused) {
  expectRefused("a.obj", "v 0 0 0\nf" + std::string(20'000'000, ' ') + "1 1 1\n", "Line 2 is too long.");
  std::string goesOn = "v 0 0 0\nf";
  for (int i = 0; i < 4'000'000; ++i)
    goesOn += " 1111\\\n";
  expectRefused("b.obj", goesOn, "Line 2 is too long.");
}

TEST_F(ReadMesh, ObjCountsNegativeNumbersFromTheLastCorner) {
  EXPECT_EQ(triangles("a.obj", "v 9 9 9\nv 0 0 0\nv 4 0 0\nv 0 4 0\nf -3 -2 -1\n"),
            (std::vector<StlTriangle>{{Vec3<float>(0, 0, 0), Vec3<float>(4, 0, 0), Vec3<float>(0, 4, 0)}}));
}

TEST_F(ReadMesh, ObjWithTexturesAndNormalsIsRead) {
  EXPECT_EQ(triangles("a.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n").size(),
            1U);
  EXPECT_EQ(triangles("b.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nvn 0 0 1\nf 1//1 2//1 3//1\n").size(), 1U);
}

TEST_F(ReadMesh, NumbersOfCornersThatAreNotThereLeadNowhere) {
  const auto obj = read("a.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\nf 1 2 4\nf 1 2 3 900000000\n");
  ASSERT_TRUE(obj) << obj.problem().text();
  EXPECT_EQ(std::count_if(obj->triangles.begin(), obj->triangles.end(),
                          [](const auto &t) { return std::count(t.begin(), t.end(), noCorner) > 0; }),
            2);
  const auto ply = read("b.ply", plyHead("ascii", "4", "2") + cornersPly + "3 0 1 2\n3 0 1 -7\n");
  ASSERT_TRUE(ply) << ply.problem().text();
  EXPECT_EQ(ply->triangles, (decltype(ply->triangles){{0, 1, 2}, {0, 1, noCorner}}));
}

TEST_F(ReadMesh, ObjCornerThatIsNoThreeNumbers_IsToldWithItsLine) {
  for (const std::string corner : {"nan 1 1", "1 inf 1", "1 2", "1 two 3", ""}) {
    const auto mesh = read("a.obj", "v 0 0 0\nv 4 0 0\nv " + corner + "\nv 0 4 0\nf 1 2 4\n");
    ASSERT_FALSE(mesh) << corner;
    EXPECT_EQ(mesh.problem().sentence, "Line 3 should be a corner, and is not three numbers.");
  }
}

TEST_F(ReadMesh, ObjCornerHoweverItIsWritten_IsReadOrToldWithItsLine) {
  for (const std::string corner : {"  v two 1 1", "\tv 7 nan 3", "v 0 0 5abc", "v 1 2 \\\nthree"}) {
    const auto mesh = read("a.obj", "v 0 0 0\nv 4 0 0\n" + corner + "\nv 0 4 0\nf 1 2 4\n");
    ASSERT_FALSE(mesh) << corner;
    EXPECT_EQ(mesh.problem().sentence, "Line 3 should be a corner, and is not three numbers.");
  }
  for (const std::string corner :
       {"  v 0 4 0", "v 0 4 0 1", "v 0 4 \\\n  0", "v 0.0 4. 0e0\r", "v\t0 4\t0"}) {
    const auto mesh = read("b.obj", "v 0 0 0\nv 4 0 0\n" + corner + "\nf 1 2 3\n");
    ASSERT_TRUE(mesh) << corner << ": " << mesh.problem().text();
    EXPECT_EQ(mesh->corners.at(2), Vec3<float>(0, 4, 0)) << corner;
  }
}

TEST_F(ReadMesh, ObjFaceThatIsCutOff_IsToldWithItsLine_ThoughOthersAreWhole) {
  for (const std::string face : {"f 1 2", "f 3", "f"}) {
    const auto mesh = read("a.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n" + face);
    ASSERT_FALSE(mesh) << face;
    EXPECT_EQ(mesh.problem().sentence,
              "Line 5 should be a face, and has not three corners. Is the file cut off?");
  }
}

TEST_F(ReadMesh, NoNumbersStayNoNumbers) {
  const auto mesh = read("a.stl", binaryStl({{Vec3<float>(NAN, 0, 0), {1, 0, 0}, {0, INFINITY, 0}}}));
  ASSERT_TRUE(mesh) << mesh.problem().text();
  EXPECT_TRUE(std::isnan(mesh->corners.at(0).x));
  EXPECT_TRUE(std::isinf(mesh->corners.at(2).y));
}

TEST_F(ReadMesh, WithoutTrianglesIsRefused) {
  expectRefused("a.obj", "v 0 0 0\nv 1 1 1\n", "no triangles");
  expectRefused("b.obj", "f 1 2 3\n", "no triangles");
  expectRefused("c.stl", "solid nothing\nendsolid nothing\n", "no triangles");
  expectRefused("d.ply", plyHead("ascii", "4", "0") + cornersPly, "no triangles");
  expectRefused("e.obj", "nothing\n", "no triangles");
}

TEST_F(ReadMesh, ThatIsCutOffIsRefused) {
  const std::string text = textStl(tetrahedronTriangles());
  expectRefused("a.stl", text.substr(0, text.size() / 2), "cut off");
  const std::string binary = binaryStl(tetrahedronTriangles());
  expectRefused("b.stl", binary.substr(0, binary.size() / 2), "cut off");
  const std::string ply =
      binaryTetrahedronPly("binary_little_endian", [](auto value) { return bytesOf(value); });
  expectRefused("c.ply", ply.substr(0, ply.size() - 1 - 13), "cut off");
}

TEST_F(ReadMesh, OfEachFormatTellsHowFarItIs) {
  constexpr int count = 400'000;
  const std::vector<StlTriangle> many(100'000, tetrahedronTriangles().front());
  std::string obj = "v 0 0 0\nv 4 0 0\nv 0 4 0\n";
  std::string ply = plyHead("ascii", "4", std::to_string(count)) + cornersPly;
  for (int i = 0; i < count; ++i) {
    obj += "f 1 2 3\n";
    ply += "3 0 1 2\n";
  }
  for (const std::string &content : {binaryStl(many), textStl(many), obj, ply}) {
    write("a.stl", content);
    std::vector<double> parts;
    ASSERT_TRUE(readMesh(inFolder("a.stl"), [&](std::optional<double> part) {
      if (part)
        parts.push_back(*part);
    }));
    ASSERT_GE(parts.size(), 5U);
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
    EXPECT_GT(parts.back(), 0.8);
    EXPECT_LE(parts.back(), 1);
  }
}

TEST_F(ReadMesh, WithTooManyTrianglesIsRefusedAlsoWhereOnlyTheWholeTellsSo) {
  std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (std::size_t i = 0; i <= mostMeshTriangles; ++i)
    obj += "f 1 2 3\n";
  expectRefused("a.obj", obj, "at most 5000000 triangles");
}

} // namespace
} // namespace halfspace
