#include "widgets/mesh_files/read_mesh.h"

#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/mesh_files/check_mesh_file.h"
#include "widgets/mesh_files/read_stl.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <new>
#include <optional>
#include <string_view>

namespace halfspace {
namespace {

/// Faces with more corners are cut from their first corner: to cut them well takes a time that grows with the
/// square.
constexpr vtkIdType mostCornersOfFaceCutWell = 1000;

/// Calls `told` whenever the reader says that it went on.
template <class Told> class Listening {
public:
  Listening(vtkObject &reader, Told told) : m_reader(reader), m_told(std::move(told)) {
    m_command->SetClientData(&m_told);
    m_command->SetCallback(
        [](vtkObject *, unsigned long, void *data, void *) { (*static_cast<Told *>(data))(); });
    m_reader.AddObserver(vtkCommand::ProgressEvent, m_command);
  }
  Listening(const Listening &) = delete;
  Listening &operator=(const Listening &) = delete;
  ~Listening() { m_reader.RemoveObserver(m_command); }

private:
  vtkObject &m_reader;
  Told m_told;
  vtkNew<vtkCallbackCommand> m_command;
};

template <class Reader>
vtkSmartPointer<vtkPolyData> readBy(const std::filesystem::path &file, const PartDone &partDone) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  const Listening listening(*reader, [&] { partDone(reader->GetProgress()); });
  reader->Update();
  return reader->GetErrorCode() == 0 ? reader->GetOutput() : nullptr;
}

/// A line of an OBJ file with those in which it goes on, behind backslashes.
class ObjLines {
public:
  explicit ObjLines(const std::filesystem::path &path) : m_file(path) {}

  bool next() {
    m_number += m_goesOn;
    m_line.clear();
    m_goesOn = 0;
    for (std::string more; std::getline(m_file, more);) {
      ++m_goesOn;
      const std::string_view part = trimmed(more);
      if (!part.ends_with('\\')) {
        m_line += part;
        return true;
      }
      m_line += part.substr(0, part.size() - 1);
      m_line += ' ';
    }
    return m_goesOn > 0;
  }
  [[nodiscard]] const std::string &line() const { return m_line; }
  /// Where it begins.
  [[nodiscard]] int number() const { return m_number; }

private:
  std::ifstream m_file;
  std::string m_line;
  int m_number = 1;
  int m_goesOn = 0; ///< over so many lines of the file
};

/// Whether a line's first word is this letter.
bool isOf(const std::string &line, char kind) {
  return line.starts_with(kind) && (line.size() == 1 || line[1] == ' ' || line[1] == '\t');
}

bool hasThreeNumbers(const char *at) {
  for (int axis = 0; axis < 3; ++axis) {
    char *end = nullptr;
    const double value = std::strtod(at, &end);
    const bool endsThere = *end == '\0' || *end == ' ' || *end == '\t';
    if (end == at || !endsThere || !std::isfinite(value))
      return false;
    at = end;
  }
  return true;
}

/// Behind the one that tells the kind.
bool hasThreeWords(std::string_view line) {
  constexpr std::string_view blanks = " \t";
  for (int word = 0; word < 3; ++word) {
    line.remove_prefix(std::min(line.find_first_of(blanks), line.size()));
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  }
  return !line.empty();
}

/// What is wrong with the first broken line of an OBJ file. VTK's reader goes on behind a broken corner as if
/// it were one, and reads nothing of a file with a broken face.
std::optional<Problem> brokenLineOf(const std::filesystem::path &path) {
  for (ObjLines lines(path); lines.next();) {
    const bool isBrokenCorner = isOf(lines.line(), 'v') && !hasThreeNumbers(lines.line().c_str() + 1);
    const bool isBrokenFace = isOf(lines.line(), 'f') && !hasThreeWords(lines.line());
    if (!isBrokenCorner && !isBrokenFace)
      continue;
    const WordValues where{{"line", std::to_string(lines.number())}};
    return Problem{
        isBrokenCorner
            ? words("Line {line} should be a corner, and is not three numbers.", where)
            : words("Line {line} should be a face, and has not three corners. Is the file cut off?", where),
        path.string(), lines.number(), ""};
  }
  return {};
}

/// Turns the faces of VTK's data into triangles.
class Triangles {
public:
  Triangles(vtkPoints &points, std::vector<std::array<std::uint32_t, 3>> &triangles)
      : m_points(points), m_cornerCount(points.GetNumberOfPoints()), m_triangles(triangles) {}

  void add(vtkIdType count, const vtkIdType *corners) {
    if (count == 3)
      add(corners[0], corners[1], corners[2]);
    else if (count < 3 || count > mostCornersOfFaceCutWell || !areThere(count, corners) ||
             !addCutWell(count, corners))
      addFromFirst(count, corners);
  }

private:
  [[nodiscard]] std::uint32_t numberOf(vtkIdType corner) const {
    return corner >= 0 && corner < m_cornerCount ? static_cast<std::uint32_t>(corner) : noCorner;
  }
  void add(vtkIdType a, vtkIdType b, vtkIdType c) {
    m_triangles.push_back({numberOf(a), numberOf(b), numberOf(c)});
  }
  void addFromFirst(vtkIdType count, const vtkIdType *corners) {
    for (vtkIdType i = 1; i + 1 < count; ++i)
      add(corners[0], corners[i], corners[i + 1]);
  }
  bool areThere(vtkIdType count, const vtkIdType *corners) const {
    return std::all_of(corners, corners + count,
                       [&](vtkIdType corner) { return numberOf(corner) != noCorner; });
  }
  /// So that faces with corners that point inwards stay what they are.
  bool addCutWell(vtkIdType count, const vtkIdType *corners) {
    m_face->Initialize(static_cast<int>(count), corners, &m_points);
    if (m_face->EarCutTriangulation(m_cut) == 0)
      return false;
    for (vtkIdType i = 0; i + 2 < m_cut->GetNumberOfIds(); i += 3)
      add(corners[m_cut->GetId(i)], corners[m_cut->GetId(i + 1)], corners[m_cut->GetId(i + 2)]);
    return true;
  }

  vtkPoints &m_points;
  vtkIdType m_cornerCount;
  std::vector<std::array<std::uint32_t, 3>> &m_triangles;
  vtkNew<vtkPolygon> m_face;
  vtkNew<vtkIdList> m_cut;
};

/// Of what a reader has read; it gives nothing where it gave up.
Result<RawMesh> rawMeshOf(const vtkSmartPointer<vtkPolyData> &read, const std::filesystem::path &file) {
  const auto problem = [&](std::string sentence) {
    return Problem{std::move(sentence), file.string(), 0, ""};
  };
  if (!read)
    return problem(sentenceForDamage());
  vtkPolyData &data = *read;
  vtkPoints *points = data.GetPoints();
  if (points == nullptr || points->GetNumberOfPoints() == 0 || data.GetNumberOfPolys() == 0)
    return problem(sentenceForNoTriangles());
  const auto cornerCount = static_cast<std::size_t>(points->GetNumberOfPoints());
  if (cornerCount > mostMeshCorners || static_cast<std::size_t>(data.GetNumberOfPolys()) > mostMeshTriangles)
    return problem(sentenceForTooManyTriangles());
  RawMesh mesh;
  mesh.triangles.reserve(static_cast<std::size_t>(data.GetNumberOfPolys()));
  Triangles triangles(*points, mesh.triangles);
  const auto faces = vtkSmartPointer<vtkCellArrayIterator>::Take(data.GetPolys()->NewIterator());
  for (faces->GoToFirstCell(); !faces->IsDoneWithTraversal(); faces->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType *corners = nullptr;
    faces->GetCurrentCell(count, corners);
    triangles.add(count, corners);
    if (mesh.triangles.size() > mostMeshTriangles)
      return problem(sentenceForTooManyTriangles());
  }
  if (mesh.triangles.empty())
    return problem(sentenceForNoTriangles());
  mesh.corners.reserve(cornerCount);
  for (std::size_t i = 0; i < cornerCount; ++i) {
    Vec3<double> corner;
    points->GetPoint(static_cast<vtkIdType>(i), &corner.x);
    mesh.corners.emplace_back(corner);
  }
  return mesh;
}

Result<RawMesh> readAs(MeshFormat format, const std::filesystem::path &file, const PartDone &partDone) {
  switch (format) {
  case MeshFormat::BinaryStl:
    return readBinaryStl(file, partDone);
  case MeshFormat::TextStl:
    return readTextStl(file, partDone);
  case MeshFormat::Obj:
    if (const auto broken = brokenLineOf(file))
      return *broken;
    return rawMeshOf(readBy<vtkOBJReader>(file, partDone), file);
  case MeshFormat::Ply:
    break;
  }
  return rawMeshOf(readBy<vtkPLYReader>(file, partDone), file);
}

} // namespace

Result<RawMesh> readMesh(const std::filesystem::path &file, const PartDone &partDone) {
  const auto format = checkMeshFile(file);
  if (!format)
    return format.problem();
  vtkObject::GlobalWarningDisplayOff(); // what is wrong is told by sentences
  try {
    return readAs(*format, file, partDone);
  } catch (const std::bad_alloc &) {
    return Problem{words("The mesh is too large for the memory that may be used to read it."), file.string(),
                   0, ""};
  }
}

} // namespace halfspace
