#include "lessons/files/read_file.h"

#include "lessons/words.h"

#include <algorithm>
#include <cerrno>
#include <sys/stat.h>

namespace halfspace {
namespace {

constexpr std::size_t partSize = 1U << 16U;

std::string whyNoFile(mode_t mode) {
  return S_ISDIR(mode) ? words("This is a folder, not a file.")
                       : words("This is a device, a pipe or a socket, not a file.");
}

std::string inWords(std::size_t bytes) {
  return bytes >= 1U << 20U ? std::to_string(bytes >> 20U) + " MiB" : std::to_string(bytes >> 10U) + " KiB";
}

} // namespace

Result<OpenedFile> openFile(const std::filesystem::path &file) {
  const auto problem = [&](std::string sentence) {
    return Problem{std::move(sentence), file.string(), 0, ""};
  };
  // Looked at before it is opened: to open a device or a pipe may do something to it.
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0)
    return problem(whyNotOpened(errno));
  if (!S_ISREG(found.st_mode))
    return problem(whyNoFile(found.st_mode));
  OpenedFile opened{Descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)),
                    static_cast<std::uint64_t>(found.st_size)};
  if (!opened.descriptor.isOpen())
    return problem(whyNotOpened(errno));
  return opened;
}

Result<std::string> readFile(const std::filesystem::path &file, std::size_t mostBytes) {
  const auto problem = [&](std::string sentence) {
    return Problem{std::move(sentence), file.string(), 0, ""};
  };
  const auto opened = openFile(file);
  if (!opened)
    return opened.problem();

  std::string text;
  for (;;) {
    const std::size_t begun = text.size();
    text.resize(begun + partSize);
    const ReadPart part = readSome(opened->descriptor.get(), text.data() + begun, partSize);
    text.resize(begun + part.count);
    if (part.error != 0)
      return problem(words("The file cannot be read: {reason}.", {{"reason", reasonOf(part.error)}}));
    if (text.size() > mostBytes)
      return problem(
          words("The file is too large: at most {limit} are read.", {{"limit", inWords(mostBytes)}}));
    if (part.count == 0)
      return text;
  }
}

} // namespace halfspace
