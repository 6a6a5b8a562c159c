#include "lessons/files/descriptor.h"

#include "lessons/words.h"

#include <cerrno>
#include <poll.h>
#include <system_error>

namespace halfspace {
namespace {

bool wouldWait(int error) { return error == EAGAIN || error == EWOULDBLOCK; }

/// Waits for a descriptor that was opened not to wait. 0, or the number of the error.
int waitFor(int descriptor, short event) {
  pollfd waiting{descriptor, event, 0};
  while (::poll(&waiting, 1, -1) < 0)
    if (errno != EINTR)
      return errno;
  return 0;
}

} // namespace

int Descriptor::close() {
  const int closing = std::exchange(m_descriptor, none);
  // Linux has closed it also where it was interrupted.
  return closing == none || ::close(closing) == 0 || errno == EINTR ? 0 : errno;
}

int writeAll(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0)
      text.remove_prefix(static_cast<std::size_t>(written));
    else if (wouldWait(errno)) {
      if (const int error = waitFor(descriptor, POLLOUT))
        return error;
    } else if (errno != EINTR)
      return errno;
  }
  return 0;
}

ReadPart readSome(int descriptor, char *into, std::size_t most) {
  for (;;) {
    const ssize_t count = ::read(descriptor, into, most);
    if (count >= 0)
      return {static_cast<std::size_t>(count), 0};
    if (wouldWait(errno)) {
      if (const int error = waitFor(descriptor, POLLIN))
        return {0, error};
    } else if (errno != EINTR)
      return {0, errno};
  }
}

int syncToDisk(int descriptor) {
  while (::fsync(descriptor) != 0) {
    if (errno == EINVAL || errno == ENOSYS || errno == ENOTSUP)
      return 0;
    if (errno != EINTR)
      return errno;
  }
  return 0;
}

std::string reasonOf(int error) {
  switch (error) {
  case EBADF:
    return words("it is closed");
  case ENOSPC:
    return words("there is no room left on the disk");
  case EDQUOT:
    return words("your share of the disk is full");
  case EFBIG:
    return words("the file would be larger than it may be");
  case EACCES:
  case EPERM:
    return words("you may not do that there");
  case EROFS:
    return words("the disk is read-only");
  case ENOENT:
    return words("there is no such folder");
  case EEXIST:
    return words("something else stands there");
  case ENOTDIR:
    return words("a part of its path is no folder");
  case ENAMETOOLONG:
    return words("its name is too long");
  case ELOOP:
    return words("its links lead in a circle");
  case ENXIO:
    return words("nobody reads from it");
  case EPIPE:
    return words("nobody reads it any more");
  default:
    return std::error_code(error, std::generic_category()).message();
  }
}

std::string whyNotOpened(int error) {
  switch (error) {
  case ENOENT:
  case ENOTDIR:
    return words("There is no such file.");
  case EACCES:
  case EPERM:
    return words("You may not read this file.");
  default:
    return words("The file cannot be opened: {reason}.", {{"reason", reasonOf(error)}});
  }
}

} // namespace halfspace
