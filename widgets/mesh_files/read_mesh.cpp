#include "widgets/mesh_files/read_mesh.h"

#include "lessons/words.h"
#include "widgets/mesh_files/check_mesh_file.h"
#include "widgets/mesh_files/read_obj.h"
#include "widgets/mesh_files/read_ply.h"
#include "widgets/mesh_files/read_stl.h"

#include <new>

namespace halfspace {
namespace {

Result<RawMesh> readAs(MeshFormat format, const std::filesystem::path &file, const PartDone &partDone) {
  switch (format) {
  case MeshFormat::BinaryStl:
    return readBinaryStl(file, partDone);
  case MeshFormat::TextStl:
    return readTextStl(file, partDone);
  case MeshFormat::Obj:
    return readObj(file, partDone);
  case MeshFormat::Ply:
    break;
  }
  return readPly(file, partDone);
}

} // namespace

Result<RawMesh> readMesh(const std::filesystem::path &file, const PartDone &partDone) {
  const auto format = checkMeshFile(file);
  if (!format)
    return format.problem();
  try {
    return readAs(*format, file, partDone);
  } catch (const std::bad_alloc &) {
    return Problem{words("The mesh is too large for the memory that may be used to read it."), file.string(),
                   0, ""};
  }
}

} // namespace halfspace
