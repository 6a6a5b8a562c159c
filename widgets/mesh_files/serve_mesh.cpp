#include "widgets/mesh_files/serve_mesh.h"

#include "lessons/files/descriptor.h"
#include "widgets/mesh_files/mesh_wire.h"
#include "widgets/mesh_files/read_mesh.h"

#include <algorithm>
#include <csignal>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace halfspace {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool memoryCanBeBounded = false; // it maps terabytes for itself
#else
constexpr bool memoryCanBeBounded = true;
#endif

constexpr int exitNotServed = 1;
/// A part is told when it grew by so much.
constexpr double partStep = 0.01;

/// Never above what is allowed already.
void bound(__rlimit_resource resource, rlim_t most) {
  rlimit limit{};
  if (::getrlimit(resource, &limit) != 0)
    return;
  limit.rlim_cur = limit.rlim_max = std::min(limit.rlim_max, most);
  ::setrlimit(resource, &limit);
}

} // namespace

void boundThisProcess(std::size_t memory, unsigned seconds) {
  if (memoryCanBeBounded)
    bound(RLIMIT_AS, memory);
  bound(RLIMIT_CPU, seconds);
  bound(RLIMIT_CORE, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL); // nobody waits for the mesh any more
}

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
