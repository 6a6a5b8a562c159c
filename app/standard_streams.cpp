#include "app/standard_streams.h"

#include "lessons/files/descriptor.h"
#include "lessons/text.h"
#include "lessons/words.h"

namespace halfspace {

void holdStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) // opened the wrong way round; the lowest free number is this one
      static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

int printOut(std::string_view text) {
  const int error = writeAll(STDOUT_FILENO, text);
  if (error == 0)
    return 0;
  return fail(
      {words("Standard output cannot be written: {reason}.", {{"reason", reasonOf(error)}}), "", 0, ""});
}

void printError(std::string_view sentence) {
  // Where standard error is closed there is nobody to tell.
  static_cast<void>(writeAll(STDERR_FILENO, "halfspace: " + printable(sentence) + "\n"));
}

int fail(const Problem &problem) {
  printError(problem.text());
  return exitRefused;
}

} // namespace halfspace
