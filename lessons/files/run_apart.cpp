#include "lessons/files/run_apart.h"

#include "lessons/files/descriptor.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <sys/wait.h>

namespace halfspace {
namespace {

/// Both ends of a pipe that programs started meanwhile do not get; not open where there can be none.
struct Pipe {
  Descriptor read;
  Descriptor write;
};

Pipe makePipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    return {};
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// What ends this process ends the copy at once: it has nothing to keep.
void endBySignals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGALRM})
    std::signal(number, SIG_DFL);
}

/// A copy that has waited so many times as long as it may work is ended too.
constexpr unsigned mostWaiting = 6;

/// The life of the copy. Nothing of what this process has open is closed or written by its end.
[[noreturn]] void live(const std::function<std::string()> &work, const ProcessBounds &bounds, int into) {
  endBySignals();
  boundThisProcess(bounds);
  ::alarm(mostWaiting * bounds.seconds);
  int status = EXIT_FAILURE;
  try {
    if (writeAll(into, work()) == 0)
      status = EXIT_SUCCESS;
  } catch (const std::exception &) {
    status = EXIT_FAILURE;
  }
  ::_exit(status);
}

/// Stops soon after so many bytes.
std::string readUpTo(std::size_t mostBytes, const Descriptor &descriptor) {
  constexpr std::size_t partSize = 1U << 16U;
  std::string text;
  std::array<char, partSize> part{};
  ReadPart read{part.size()};
  while (read.count > 0 && text.size() <= mostBytes) {
    read = readSome(descriptor.get(), part.data(), part.size());
    text.append(part.data(), read.count);
  }
  return text;
}

bool endsWell(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR)
      return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

} // namespace

std::optional<std::string> runApart(const std::function<std::string()> &work, const ProcessBounds &bounds,
                                    std::size_t mostBytes) {
  Pipe pipe = makePipe();
  const pid_t process = pipe.read.isOpen() ? ::fork() : -1;
  if (process == 0) {
    pipe.read.close(); // so that nobody is left who could read, once the other has stopped
    live(work, bounds, pipe.write.get());
  }
  pipe.write.close();
  if (process < 0)
    return {};
  std::string result = readUpTo(mostBytes, pipe.read);
  pipe.read.close(); // whoever writes more ends by that
  return endsWell(process) && result.size() <= mostBytes ? std::optional(std::move(result)) : std::nullopt;
}

} // namespace halfspace
