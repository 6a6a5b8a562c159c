#include "app/eval_command.h"

#include "app/descriptor_buffer.h"
#include "app/standard_streams.h"
#include "eval/evaluate.h"
#include "lessons/words.h"

#include <cerrno>
#include <istream>
#include <ostream>
#include <poll.h>
#include <sys/stat.h>

namespace halfspace {
namespace {

constexpr int exitSomeFaults = 1;

/// Whoever opens a pipe waits until somebody opens its other end, perhaps for ever.
constexpr int longestSilence = 1000; // milliseconds

/// Waits for the first bytes of a pipe, or its end; says so where that takes a while.
void awaitPipe(int pipe, const std::string &name) {
  pollfd waiting{pipe, POLLIN, 0};
  if (::poll(&waiting, 1, longestSilence) != 0)
    return;
  printError(
      Problem{words("Nothing has come out of this pipe yet: waiting for whoever writes to it."), name, 0, ""}
          .text());
  while (::poll(&waiting, 1, -1) < 0 && errno == EINTR) {
  }
}

bool isPipe(int descriptor) {
  struct stat found {};
  return ::fstat(descriptor, &found) == 0 && S_ISFIFO(found.st_mode);
}

} // namespace

int runEval(const EvalCommand &command) {
  const std::string name = command.file.value_or("-");
  const bool fromFile = name != "-";
  Descriptor file;
  if (fromFile) {
    file = Descriptor(::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
    if (!file.isOpen())
      return fail({whyNotOpened(errno), name, 0, ""});
    if (isPipe(file.get()))
      awaitPipe(file.get(), name);
  }
  DescriptorBuffer input(fromFile ? file.get() : STDIN_FILENO);
  DescriptorBuffer output(STDOUT_FILENO);
  std::istream questions(&input);
  std::ostream answers(&output);
  switch (evaluateLines(questions, answers)) {
  case StreamOutcome::AllAnswered:
    return 0;
  case StreamOutcome::SomeFaults:
    return exitSomeFaults;
  case StreamOutcome::CannotRead:
    return fail({words("The questions cannot be read."), fromFile ? name : "", 0, ""});
  case StreamOutcome::CannotWrite:
    return fail({words("The answers cannot be written."), "", 0, ""});
  }
  return 0;
}

} // namespace halfspace
