#include "widgets/mesh_files/read_ply.h"

#include "lessons/words.h"
#include "widgets/mesh_files/check_mesh_file.h"
#include "widgets/mesh_files/file_bytes.h"
#include "widgets/mesh_files/mesh_builder.h"
#include "widgets/mesh_files/ply_header.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string_view>
#include <utility>

namespace halfspace {
namespace {

/// No number that a program writes is longer.
constexpr std::size_t longestWord = 400;
/// Elements after which it is told how far reading is.
constexpr std::uint64_t elementsBetweenNews = 50'000;

constexpr std::string_view axes = "xyz";
constexpr std::size_t largestNumber = sizeof(double);
constexpr std::size_t bitsOfByte = 8;

bool isBlank(unsigned char byte) { return byte == ' ' || (byte >= '\t' && byte <= '\r'); }

double signedNumber(std::uint64_t bits, std::size_t bytes) {
  const auto shift = bitsOfByte * (largestNumber - bytes);
  return static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift);
}

double floatingNumber(std::uint64_t bits, std::size_t bytes) {
  return bytes == sizeof(float) ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                                : std::bit_cast<double>(bits);
}

/// The numbers behind the header.
class PlyContent {
public:
  PlyContent(const std::filesystem::path &file, const PlyHeader &header)
      : m_bytes(file, header.bytes), m_form(header.form) {}

  /// Nothing where the file ends, or goes on with something else.
  std::optional<double> next(const PlyNumber &number) {
    return m_form == PlyForm::Text ? nextWord() : nextBytes(number);
  }
  [[nodiscard]] double part() const { return m_bytes.part(); }

private:
  std::optional<double> nextWord() {
    auto byte = m_bytes.next();
    while (byte && isBlank(*byte))
      byte = m_bytes.next();
    m_word.clear();
    for (; byte && !isBlank(*byte); byte = m_bytes.next()) {
      if (m_word.size() == longestWord)
        return {};
      m_word += static_cast<char>(*byte);
    }
    return numberIn(m_word);
  }

  std::optional<double> nextBytes(const PlyNumber &number) {
    std::array<char, largestNumber> bytes{};
    if (!m_bytes.take(bytes.data(), number.bytes))
      return {};
    if (m_form == PlyForm::LowestByteFirst)
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(number.bytes));
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < number.bytes; ++i)
      bits = bits << bitsOfByte | static_cast<unsigned char>(bytes[i]);
    switch (number.kind) {
    case PlyNumber::Kind::Signed:
      return signedNumber(bits, number.bytes);
    case PlyNumber::Kind::Unsigned:
      return static_cast<double>(bits);
    case PlyNumber::Kind::Floating:
      break;
    }
    return floatingNumber(bits, number.bytes);
  }

  FileBytes m_bytes;
  PlyForm m_form;
  std::string m_word;
};

/// The number of a corner; `noCorner` for what is none.
std::uint32_t cornerOf(double number) {
  const bool isOne = number >= 0 && number < noCorner && number == std::floor(number);
  return isOne ? static_cast<std::uint32_t>(number) : noCorner;
}

/// Reads the elements of a file, one after the other. Each step returns false where the file does not go on
/// as its header says, or has too much.
class PlyReader {
public:
  PlyReader(const std::filesystem::path &file, const PlyHeader &header, const PartDone &partDone)
      : m_header(header), m_content(file, header), m_partDone(partDone) {}

  bool read() {
    return std::all_of(m_header.elements.begin(), m_header.elements.end(),
                       [this](const PlyElement &element) { return readAll(element); });
  }
  [[nodiscard]] MeshBuilder &mesh() { return m_mesh; }

private:
  bool readAll(const PlyElement &element) {
    if (element.properties.empty())
      return true; // however many there are: nothing stands for them
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (i % elementsBetweenNews == 0)
        m_partDone(m_content.part());
      if (!readOne(element) || m_mesh.isTooLarge())
        return false;
    }
    return true;
  }

  bool readOne(const PlyElement &element) {
    Vec3<float> corner(0.0F);
    for (const PlyProperty &property : element.properties)
      if (property.count ? !readList(property) : !readNumber(property, corner))
        return false;
      else if (element.name == plyFace && isListOfCorners(property))
        m_mesh.addFace(m_list);
    if (element.name == plyCorner)
      m_mesh.addCorner(corner);
    return true;
  }

  bool readNumber(const PlyProperty &property, Vec3<float> &corner) {
    const auto number = m_content.next(property.number);
    if (number && property.name.size() == 1 && axes.find(property.name) != std::string_view::npos)
      corner[static_cast<int>(axes.find(property.name))] = static_cast<float>(*number);
    return number.has_value();
  }

  /// Keeps no more of it than a face may have.
  bool readList(const PlyProperty &property) {
    m_list.clear();
    const auto count = m_content.next(*property.count);
    if (!count || !(*count >= 0))
      return false;
    for (double i = 0; i < *count; ++i) {
      const auto number = m_content.next(property.number);
      if (!number || m_list.size() > mostMeshCorners)
        return false;
      m_list.push_back(cornerOf(*number));
    }
    return true;
  }

  const PlyHeader &m_header;
  PlyContent m_content;
  const PartDone &m_partDone;
  MeshBuilder m_mesh;
  std::vector<std::uint32_t> m_list; ///< the last one that was read
};

/// Whether each corner has all three coordinates.
bool hasPlaces(const PlyElement &corner) {
  return std::all_of(axes.begin(), axes.end(), [&](char axis) {
    return std::any_of(corner.properties.begin(), corner.properties.end(),
                       [axis](const PlyProperty &property) {
                         return !property.count && property.name == std::string(1, axis);
                       });
  });
}

Result<PlyHeader> headerOf(const std::filesystem::path &file) {
  FileBytes bytes(file);
  std::string head;
  for (auto byte = bytes.next(); byte && head.size() < meshFileHead; byte = bytes.next())
    head += static_cast<char>(*byte);
  return readPlyHeader(head);
}

} // namespace

Result<RawMesh> readPly(const std::filesystem::path &file, const PartDone &partDone) {
  const auto problem = [&](std::string sentence) {
    return Problem{std::move(sentence), file.string(), 0, ""};
  };
  const auto header = headerOf(file);
  if (!header)
    return problem(header.problem().sentence);
  for (const PlyElement &element : header->elements)
    if (element.name == plyCorner && !hasPlaces(element))
      return problem(words("The corners of this PLY file have no places: x, y or z is missing."));
  PlyReader reader(file, *header, partDone);
  if (!reader.read())
    return problem(reader.mesh().isTooLarge() ? sentenceForTooManyTriangles() : sentenceForDamage());
  RawMesh mesh = reader.mesh().take();
  if (mesh.triangles.empty() || mesh.corners.empty())
    return problem(sentenceForNoTriangles());
  return mesh;
}

} // namespace halfspace
