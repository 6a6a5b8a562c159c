#include "widgets/mesh_files/check_mesh_file.h"

#include "lessons/files/read_file.h"
#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/mesh_files/ply_header.h"
#include "widgets/mesh_files/raw_mesh.h"
#include "widgets/mesh_files/read_stl.h"
#include "widgets/mesh_files/small_letters.h"

#include <algorithm>
#include <optional>

namespace halfspace {
namespace {

Problem problemOf(std::string sentence) { return {std::move(sentence), "", 0, ""}; }

Problem cutOff() { return problemOf(words("The file is cut off: it says that more follows than is there.")); }

bool isText(std::string_view head) { return head.find('\0') == std::string_view::npos; }

bool beginsAsPly(std::string_view head) { return head.starts_with("ply\n") || head.starts_with("ply\r"); }

bool beginsAsTextStl(std::string_view head) {
  constexpr std::string_view word = "solid";
  const std::string_view text = trimmed(head);
  return isText(head) && inSmallLetters(text.substr(0, word.size())) == word;
}

/// Whether a line gives a corner, as OBJ files do.
bool hasObjCorner(std::string_view head) {
  if (!isText(head))
    return false;
  for (;;) {
    const std::string_view line = trimmed(head.substr(0, head.find('\n')));
    if (line.starts_with("v ") || line.starts_with("v\t"))
      return true;
    if (head.find('\n') == std::string_view::npos)
      return false;
    head.remove_prefix(head.find('\n') + 1);
  }
}

/// How many triangles a binary STL file announces; nothing for a file that is too short.
std::optional<std::uint64_t> stlCount(std::string_view head) {
  if (head.size() < stlBegin)
    return {};
  return stlNumber(head.data() + stlCountAt);
}

bool fillsExactly(std::optional<std::uint64_t> count, std::uint64_t bytes) {
  return count && *count > 0 && bytes == stlBegin + *count * stlTriangle;
}

/// Files whose count is too small, as some programs write it, are read to their end.
Result<MeshFormat> checkBinaryStl(std::optional<std::uint64_t> count, std::uint64_t bytes) {
  if (!count)
    return cutOff();
  const std::uint64_t there = (bytes - stlBegin) / stlTriangle;
  if (std::max(*count, there) > mostMeshTriangles)
    return *count > there && bytes < stlBegin + mostMeshTriangles * stlTriangle
               ? cutOff()
               : problemOf(sentenceForTooManyTriangles());
  if (*count > there)
    return problemOf(
        words("The file is cut off: it says that it has {count} triangles, and {there} are there.",
              {{"count", std::to_string(*count)}, {"there", std::to_string(there)}}));
  if (there == 0)
    return problemOf(sentenceForNoTriangles());
  return MeshFormat::BinaryStl;
}

Result<MeshFormat> checkPly(std::string_view head, std::uint64_t bytes) {
  const auto header = readPlyHeader(head);
  if (!header)
    return header.problem();
  // The end of the last line may be missing.
  if (header->leastContent > bytes - header->bytes + 1)
    return cutOff();
  if (header->countOf(plyFace) > mostMeshTriangles || header->countOf(plyCorner) > mostMeshCorners)
    return problemOf(sentenceForTooManyTriangles());
  return MeshFormat::Ply;
}

} // namespace

std::string sentenceForTooManyTriangles() {
  return words("The mesh is too large: at most {limit} triangles are read.",
               {{"limit", std::to_string(mostMeshTriangles)}});
}

std::string sentenceForNoTriangles() { return words("The file has no triangles."); }

std::string sentenceForDamage() {
  return words("The file is damaged or cut off: it does not go on as its beginning says.");
}

Result<MeshFormat> checkMeshHead(std::string_view head, std::uint64_t bytes, std::string_view ending) {
  const std::string small = inSmallLetters(ending);
  const auto count = stlCount(head);
  if (head.empty())
    return problemOf(words("The file is empty."));
  if (beginsAsPly(head))
    return checkPly(head, bytes);
  if (fillsExactly(count, bytes))
    return checkBinaryStl(count, bytes);
  if (beginsAsTextStl(head))
    return MeshFormat::TextStl;
  if (hasObjCorner(head) || (small == ".obj" && isText(head)))
    return MeshFormat::Obj;
  if (small == ".stl" && !isText(head))
    return checkBinaryStl(count, bytes);
  return problemOf(words("This is no mesh that can be read: STL, OBJ and PLY files are."));
}

Result<MeshFormat> checkMeshFile(const std::filesystem::path &file) {
  const auto problem = [&](std::string sentence) {
    return Problem{std::move(sentence), file.string(), 0, ""};
  };
  const auto opened = openFile(file);
  if (!opened)
    return opened.problem();
  if (opened->bytes > mostMeshFileBytes)
    return problem(words("The file is too large: at most {limit} MiB are read.",
                         {{"limit", std::to_string(mostMeshFileBytes >> 20U)}}));
  std::string head(meshFileHead, '\0');
  std::size_t filled = 0;
  for (;;) {
    const ReadPart part = readSome(opened->descriptor.get(), head.data() + filled, head.size() - filled);
    if (part.error != 0)
      return problem(words("The file cannot be read: {reason}.", {{"reason", reasonOf(part.error)}}));
    filled += part.count;
    if (part.count == 0 || filled == head.size())
      break;
  }
  head.resize(filled);
  auto format =
      checkMeshHead(head, std::max<std::uint64_t>(opened->bytes, filled), file.extension().string());
  if (!format)
    return Problem{format.problem().sentence, file.string(), format.problem().line, ""};
  return format;
}

} // namespace halfspace
