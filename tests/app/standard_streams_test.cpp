#include "app/standard_streams.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace halfspace {
namespace {

/// Whether a program that is started without standard streams gives their numbers to no file that it opens,
/// and still cannot read or write them.
bool keepsNumbersFree() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    close(stream);
  holdStandardStreams();
  char byte = 0;
  return open("/dev/null", O_RDWR | O_CLOEXEC) > STDERR_FILENO && read(STDIN_FILENO, &byte, 1) < 0 &&
         write(STDOUT_FILENO, &byte, 1) < 0 && write(STDERR_FILENO, &byte, 1) < 0;
}

TEST(StandardStreams, ThatAreClosed_GiveTheirNumbersToNoOtherFile) {
  const pid_t child = fork();
  if (child == 0)
    _exit(keepsNumbersFree() ? 0 : 1);
  int ended = -1;
  ASSERT_EQ(waitpid(child, &ended, 0), child);
  EXPECT_EQ(ended, 0);
}

} // namespace
} // namespace halfspace
