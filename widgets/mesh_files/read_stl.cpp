#include "widgets/mesh_files/read_stl.h"

#include "widgets/mesh_files/check_mesh_file.h"
#include "widgets/mesh_files/small_letters.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <fstream>
#include <string_view>

namespace halfspace {
namespace {

/// Triangles of a binary file that are read at once.
constexpr std::size_t trianglesAtOnce = 5000;
/// In a binary triangle, behind its normal.
constexpr std::size_t cornersAt = 3 * sizeof(float);
/// Lines of a text after which it is told how far reading is.
constexpr std::size_t linesBetweenNews = 50'000;

constexpr std::string_view blanks = " \t\r\v\f";

/// The lines of a facet in a text, by their first words.
constexpr std::array<std::string_view, 7> facetLines{"facet",  "outer",   "vertex",  "vertex",
                                                     "vertex", "endloop", "endfacet"};

std::uintmax_t sizeOf(const std::filesystem::path &file) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  return error ? 0 : bytes;
}

/// No more than are read, though the file may have grown since it was checked.
std::size_t roomForTriangles(const std::filesystem::path &file) {
  const std::uintmax_t bytes = std::max<std::uintmax_t>(sizeOf(file), stlBegin);
  return std::min<std::uintmax_t>((bytes - stlBegin) / stlTriangle, mostMeshTriangles);
}

/// Of the last three corners.
void addTriangle(RawMesh &mesh) {
  const auto end = static_cast<std::uint32_t>(mesh.corners.size());
  mesh.triangles.push_back({end - 3, end - 2, end - 1});
}

void addBinary(const char *triangle, RawMesh &mesh) {
  for (int corner = 0; corner < 3; ++corner) {
    const char *bytes = triangle + cornersAt + static_cast<std::size_t>(corner) * 3 * sizeof(float);
    const auto coordinate = [bytes](std::size_t axis) {
      return std::bit_cast<float>(stlNumber(bytes + axis * sizeof(float)));
    };
    mesh.corners.emplace_back(coordinate(0), coordinate(1), coordinate(2));
  }
  addTriangle(mesh);
}

/// A text, taken line by line.
class StlText {
public:
  /// False where the line is none that may follow.
  bool take(const std::string &line) {
    const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    const std::string word = inSmallLetters(std::string_view(line).substr(begin, end - begin));
    return word.empty() || (m_isInSolid ? takeInSolid(word, line.c_str() + end) : takeSolid(word));
  }

  [[nodiscard]] bool isWhole() const { return !m_isInSolid; }
  [[nodiscard]] RawMesh &mesh() { return m_mesh; }

private:
  bool takeSolid(const std::string &word) {
    m_isInSolid = word == "solid";
    return m_isInSolid;
  }

  bool takeInSolid(const std::string &word, const char *rest) {
    const bool isBetweenFacets = m_facetLine == 0;
    if (isBetweenFacets && (word == "color" || word == "endsolid")) {
      m_isInSolid = word == "color";
      return true;
    }
    if (word != facetLines[m_facetLine] || (word == "vertex" && !takeCorner(rest)))
      return false;
    m_facetLine = (m_facetLine + 1) % facetLines.size();
    if (m_facetLine == 0)
      addTriangle(m_mesh);
    return true;
  }

  bool takeCorner(const char *numbers) {
    Vec3<float> corner;
    for (int axis = 0; axis < 3; ++axis) {
      char *end = nullptr;
      corner[axis] = std::strtof(numbers, &end);
      if (end == numbers)
        return false;
      numbers = end;
    }
    m_mesh.corners.push_back(corner);
    return true;
  }

  RawMesh m_mesh;
  bool m_isInSolid = false;
  std::size_t m_facetLine = 0; ///< the one that comes next
};

} // namespace

std::uint32_t stlNumber(const char *bytes) {
  std::uint32_t number = 0;
  for (unsigned byte = 0; byte < sizeof number; ++byte)
    number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[byte])) << (8 * byte);
  return number;
}

Result<RawMesh> readBinaryStl(const std::filesystem::path &file, const PartDone &partDone) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(stlBegin);
  const std::size_t count = roomForTriangles(file);
  RawMesh mesh;
  mesh.corners.reserve(3 * count);
  mesh.triangles.reserve(count);
  std::vector<char> bytes(trianglesAtOnce * stlTriangle);
  while (mesh.triangles.size() < count) {
    const std::size_t next = std::min(trianglesAtOnce, count - mesh.triangles.size());
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(next * stlTriangle)))
      return Problem{sentenceForDamage(), file.string(), 0, ""};
    for (std::size_t i = 0; i < next; ++i)
      addBinary(bytes.data() + i * stlTriangle, mesh);
    partDone(static_cast<double>(mesh.triangles.size()) / static_cast<double>(count));
  }
  if (mesh.triangles.empty())
    return Problem{sentenceForNoTriangles(), file.string(), 0, ""};
  return mesh;
}

Result<RawMesh> readTextStl(const std::filesystem::path &file, const PartDone &partDone) {
  const auto problem = [&](std::string sentence) {
    return Problem{std::move(sentence), file.string(), 0, ""};
  };
  const auto bytes = static_cast<double>(sizeOf(file));
  std::ifstream stream(file);
  StlText text;
  double bytesDone = 0;
  std::size_t lines = 0;
  for (std::string line; std::getline(stream, line);) {
    if (!text.take(line))
      return problem(sentenceForDamage());
    if (text.mesh().triangles.size() > mostMeshTriangles)
      return problem(sentenceForTooManyTriangles());
    bytesDone += static_cast<double>(line.size() + 1);
    if (++lines % linesBetweenNews == 0)
      partDone(std::min(bytesDone / bytes, 1.0));
  }
  if (!text.isWhole())
    return problem(sentenceForDamage());
  if (text.mesh().triangles.empty())
    return problem(sentenceForNoTriangles());
  return std::move(text.mesh());
}

} // namespace halfspace
