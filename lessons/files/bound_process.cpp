#include "lessons/files/bound_process.h"

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

/// Never above what is allowed already.
void bound(__rlimit_resource resource, rlim_t most) {
  rlimit limit{};
  if (::getrlimit(resource, &limit) != 0)
    return;
  limit.rlim_cur = limit.rlim_max = std::min(limit.rlim_max, most);
  ::setrlimit(resource, &limit);
}

} // namespace

void boundThisProcess(const ProcessBounds &bounds) {
  if (memoryCanBeBounded && bounds.memory)
    bound(RLIMIT_AS, *bounds.memory);
  bound(RLIMIT_CPU, bounds.seconds);
  bound(RLIMIT_CORE, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL); // nobody waits for what it does any more
}

} // namespace halfspace
