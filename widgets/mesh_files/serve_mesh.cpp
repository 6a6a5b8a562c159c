#include "widgets/mesh_files/serve_mesh.h"

#include "lessons/files/descriptor.h"
#include "widgets/mesh_files/mesh_wire.h"
#include "widgets/mesh_files/read_mesh.h"

namespace halfspace {
namespace {

constexpr int exitNotServed = 1;
/// A part is told when it grew by so much.
constexpr double partStep = 0.01;

} // namespace

int serveMesh(const std::filesystem::path &file, int descriptor) {
  const ByteSink sink = [descriptor](std::string_view bytes) { return writeAll(descriptor, bytes) == 0; };
  if (!sendBeginning(sink))
    return exitNotServed;
  double told = -1;
  const auto mesh = readMesh(file, [&](std::optional<double> part) {
    if (!part || *part < told + partStep)
      return;
    told = *part;
    (void)sendPart(part, sink);
  });
  if (!mesh) {
    (void)sendProblem(mesh.problem(), sink);
    return exitNotServed;
  }
  return sendMesh(*mesh, sink) ? 0 : exitNotServed;
}

} // namespace halfspace
