#include "widgets/mesh_files/read_obj.h"

#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/mesh_files/check_mesh_file.h"
#include "widgets/mesh_files/file_bytes.h"
#include "widgets/mesh_files/mesh_builder.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace halfspace {
namespace {

/// Of a line with those in which it goes on, in bytes: a face with a million corners is shorter.
constexpr std::size_t longestLine = 1U << 24U;
/// Lines after which it is told how far reading is.
constexpr std::size_t linesBetweenNews = 50'000;

constexpr std::string_view blanks = " \t";

/// A line of an OBJ file with those in which it goes on, behind backslashes.
class ObjLines {
public:
  explicit ObjLines(const std::filesystem::path &file) : m_file(file) {}

  /// False at the end of the file, and where a line is too long.
  bool next() {
    m_number += m_goesOn;
    m_goesOn = 0;
    m_line.clear();
    while (takePart()) {
      ++m_goesOn;
      if (!trimmed(m_part).ends_with('\\')) {
        m_line += trimmed(m_part);
        return true;
      }
      m_line += trimmed(m_part).substr(0, trimmed(m_part).size() - 1);
      m_line += ' ';
    }
    return m_goesOn > 0 && !m_isTooLong;
  }

  [[nodiscard]] const std::string &line() const { return m_line; }
  /// Where it begins.
  [[nodiscard]] int number() const { return m_number; }
  [[nodiscard]] bool isTooLong() const { return m_isTooLong; }
  [[nodiscard]] double partDone() const { return m_file.part(); }

private:
  /// One line of the file.
  bool takePart() {
    m_part.clear();
    auto byte = m_file.next();
    if (!byte)
      return false;
    for (; byte && *byte != '\n'; byte = m_file.next()) {
      m_isTooLong = m_line.size() + m_part.size() >= longestLine;
      if (m_isTooLong)
        return false;
      m_part += static_cast<char>(*byte);
    }
    return true;
  }

  FileBytes m_file;
  std::string m_line;
  std::string m_part;
  int m_number = 1;
  int m_goesOn = 0; ///< over so many lines of the file
  bool m_isTooLong = false;
};

/// Takes the first word off a line; empty at its end.
std::string_view takeWord(std::string_view &line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

/// Takes line after line.
class ObjReader {
public:
  /// Why a line that begins at this number is broken; empty where it is not.
  std::string take(std::string_view line, int number) {
    const std::string_view word = takeWord(line);
    const WordValues where{{"line", std::to_string(number)}};
    if (word == "v" && !takeCorner(line))
      return words("Line {line} should be a corner, and is not three numbers.", where);
    if (word != "f")
      return {};
    if (const std::string_view wrong = takeCorners(line); !wrong.empty())
      return words("Line {line} should be a face, and “{word}” is not the number of a corner.",
                   {{"line", std::to_string(number)}, {"word", shortened(wrong)}});
    if (m_face.size() < 3)
      return words("Line {line} should be a face, and has not three corners. Is the file cut off?", where);
    m_mesh.addFace(m_face);
    return {};
  }

  [[nodiscard]] MeshBuilder &mesh() { return m_mesh; }

private:
  /// What stands behind the three numbers (a weight, a colour) does not count.
  bool takeCorner(std::string_view line) {
    Vec3<float> corner;
    for (int axis = 0; axis < 3; ++axis) {
      const auto number = numberIn(takeWord(line));
      if (!number || !std::isfinite(*number))
        return false;
      corner[axis] = static_cast<float>(*number);
    }
    m_mesh.addCorner(corner);
    return true;
  }

  /// The corners of a face; the first word that is none, or nothing.
  std::string_view takeCorners(std::string_view line) {
    m_face.clear();
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
      // Those of textures and normals follow behind a slash.
      const std::string_view text = word.substr(0, word.find('/'));
      long long number = 0;
      const char *const last = text.data() + text.size();
      const auto [end, error] = std::from_chars(text.data(), last, number);
      if (error == std::errc::invalid_argument || end != last)
        return word;
      m_face.push_back(cornerOf(error == std::errc{} ? number : 0));
    }
    return {};
  }

  /// Counted from 1, or backwards from the last corner that was told; `noCorner` for what is none.
  [[nodiscard]] std::uint32_t cornerOf(long long number) const {
    const auto there = static_cast<long long>(m_mesh.cornerCount());
    const long long corner = number < 0 ? there + number : number - 1;
    return corner >= 0 && corner < noCorner ? static_cast<std::uint32_t>(corner) : noCorner;
  }

  MeshBuilder m_mesh;
  std::vector<std::uint32_t> m_face;
};

} // namespace

Result<RawMesh> readObj(const std::filesystem::path &file, const PartDone &partDone) {
  const auto problem = [&](std::string sentence, int line = 0) {
    return Problem{std::move(sentence), file.string(), line, ""};
  };
  ObjLines lines(file);
  ObjReader reader;
  for (std::size_t count = 0; lines.next(); ++count) {
    if (count % linesBetweenNews == 0)
      partDone(lines.partDone());
    if (std::string wrong = reader.take(lines.line(), lines.number()); !wrong.empty())
      return problem(std::move(wrong), lines.number());
    if (reader.mesh().isTooLarge())
      return problem(sentenceForTooManyTriangles());
  }
  if (lines.isTooLong())
    return problem(words("Line {line} is too long.", {{"line", std::to_string(lines.number())}}),
                   lines.number());
  RawMesh mesh = reader.mesh().take();
  if (mesh.triangles.empty() || mesh.corners.empty())
    return problem(sentenceForNoTriangles());
  return mesh;
}

} // namespace halfspace
