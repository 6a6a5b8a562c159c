#include "widgets/mesh_files/check_mesh_file.h"

#include "tests/mesh_files/mesh_texts.h"
#include "tests/program_test.h"
#include "widgets/mesh_files/raw_mesh.h"

#include <sys/stat.h>

namespace halfspace {
namespace {

/// Of a file that is as long as its beginning.
Result<MeshFormat> check(const std::string &content, std::string_view ending) {
  return checkMeshHead(content, content.size(), ending);
}

void expectFormat(const Result<MeshFormat> &format, MeshFormat expected) {
  ASSERT_TRUE(format) << format.problem().text();
  EXPECT_EQ(*format, expected);
}

void expectRefused(const Result<MeshFormat> &format, const std::string &part) {
  ASSERT_FALSE(format);
  EXPECT_NE(format.problem().sentence.find(part), std::string::npos) << format.problem().sentence;
}

const std::string obj = "# a triangle\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string ply = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0.5\n";

TEST(CheckMeshFile, TellsTheFormatByTheContentWhateverTheName) {
  for (const char *ending : {".stl", ".STL", ".obj", ".ply", ".txt", ""}) {
    SCOPED_TRACE(ending);
    expectFormat(check(binaryStl(tetrahedronTriangles()), ending), MeshFormat::BinaryStl);
    expectFormat(check(textStl(tetrahedronTriangles()), ending), MeshFormat::TextStl);
    expectFormat(check(obj, ending), MeshFormat::Obj);
    expectFormat(check(ply, ending), MeshFormat::Ply);
  }
}

TEST(CheckMeshFile, BinaryStlThatBeginsAsTextIsToldByItsLength) {
  expectFormat(check(binaryStl(tetrahedronTriangles(), "solid made by a test"), ".stl"),
               MeshFormat::BinaryStl);
}

TEST(CheckMeshFile, BinaryStlWithTooSmallACountIsReadToItsEnd) {
  std::string stl = binaryStl(tetrahedronTriangles());
  stl[80] = 0;
  expectFormat(check(stl, ".stl"), MeshFormat::BinaryStl);
}

TEST(CheckMeshFile, BinaryStlThatIsCutOffIsRefusedWithBothCounts) {
  const std::string stl = binaryStl(tetrahedronTriangles());
  expectRefused(check(stl.substr(0, stl.size() - 1), ".stl"), "has 4 triangles, and 3 are there");
  expectRefused(check(stl.substr(0, 100), ".stl"), "has 4 triangles, and 0 are there");
  expectRefused(check(std::string(50, '\1') + '\0', ".stl"), "cut off");
  expectRefused(check(binaryStlHead(0), ".stl"), "no triangles");
  expectRefused(check(binaryStlHead(0xFFFFFFFF), ".stl"), "cut off");
}

TEST(CheckMeshFile, WithTooManyTrianglesIsRefused) {
  const std::uint32_t count = mostMeshTriangles + 1;
  const std::string head = binaryStlHead(count);
  expectRefused(checkMeshHead(head, head.size() + 50ULL * count, ".stl"), "at most 5000000 triangles");
  const std::string large = "ply\nformat binary_big_endian 1.0\nelement face 5000001\n"
                            "property list uchar int vertex_indices\nend_header\n";
  expectRefused(checkMeshHead(large, 100'000'000, ".ply"), "at most 5000000 triangles");
}

TEST(CheckMeshFile, PlyThatAnnouncesMoreThanIsThereIsRefused) {
  const std::string head =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  expectRefused(check(head + std::string(100, '\0'), ".ply"), "cut off");
}

TEST(CheckMeshFile, OfAnotherKindIsRefused) {
  expectRefused(check("", ".stl"), "empty");
  expectRefused(check("Dear diary,\ntoday I learned nothing.\n", ".stl"), "no mesh");
  expectRefused(check("Dear diary,\ntoday I learned nothing.\n", ".ply"), "no mesh");
  expectRefused(check(std::string("\x89PNG\r\n\x1a\n\0\0\0", 11), ".obj"), "no mesh");
}

struct CheckMeshFileOnDisk : ProgramTest {};

TEST_F(CheckMeshFileOnDisk, ThatIsNoUsualFileIsRefusedAndNotWaitedFor) {
  ASSERT_EQ(::mkfifo(inFolder("pipe.stl").c_str(), S_IRUSR | S_IWUSR), 0);
  expectRefused(checkMeshFile(inFolder("pipe.stl")), "pipe");
  expectRefused(checkMeshFile(folder()), "folder");
  expectRefused(checkMeshFile("/dev/zero"), "device");
  EXPECT_FALSE(checkMeshFile(inFolder("none.stl")));
}

TEST_F(CheckMeshFileOnDisk, ThatIsTooLargeIsRefusedUnread) {
  write("large.stl", "solid");
  std::filesystem::resize_file(inFolder("large.stl"), mostMeshFileBytes + 1);
  expectRefused(checkMeshFile(inFolder("large.stl")), "2047 MiB");
}

TEST_F(CheckMeshFileOnDisk, NamesTheFileInItsProblem) {
  write("empty.obj", "");
  EXPECT_EQ(checkMeshFile(inFolder("empty.obj")).problem().file, inFolder("empty.obj").string());
}

} // namespace
} // namespace halfspace
