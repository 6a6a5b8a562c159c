// Whatever the file: the process that reads it sends a mesh that can be asked for hits, or a sentence, and
// ends by itself.
#include "tests/fuzz/arrived_mesh.h"
#include "widgets/mesh_files/serve_mesh.h"

#include <cstdint>
#include <cstdio>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace halfspace;

constexpr std::size_t memory = 1ULL << 30U;
constexpr unsigned seconds = 10;

/// A file that is gone with the test.
class KeptFile {
public:
  KeptFile() { require(::mkdtemp(m_folder.data()) != nullptr); }
  KeptFile(const KeptFile &) = delete;
  KeptFile &operator=(const KeptFile &) = delete;
  ~KeptFile() { std::filesystem::remove_all(m_folder); }

  std::filesystem::path holding(std::string_view bytes) {
    std::filesystem::path file = m_folder + "/mesh" + endingOf(bytes);
    std::FILE *stream = std::fopen(file.c_str(), "wbe");
    require(stream != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size());
    require(std::fclose(stream) == 0);
    return file;
  }

private:
  /// The one that its bytes were most likely meant to have.
  static const char *endingOf(std::string_view bytes) {
    return bytes.find('\0') != std::string_view::npos ? ".stl" : ".obj";
  }

  std::string m_folder = (std::filesystem::temp_directory_path() / "halfspace-XXXXXX").string();
};

/// All that a process of its own writes about the file.
std::string served(const std::filesystem::path &file) {
  std::array<int, 2> ends{};
  require(::pipe(ends.data()) == 0);
  const pid_t process = ::fork();
  require(process >= 0);
  if (process == 0) {
    ::close(ends[0]);
    boundThisProcess({memory, seconds});
    ::_exit(serveMesh(file, ends[1]));
  }
  ::close(ends[1]);
  std::string bytes;
  std::array<char, 1 << 16> part{};
  for (ssize_t count = 0; (count = ::read(ends[0], part.data(), part.size())) > 0;)
    bytes.append(part.data(), static_cast<std::size_t>(count));
  ::close(ends[0]);
  int status = 0;
  require(::waitpid(process, &status, 0) == process && WIFEXITED(status));
  return bytes;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  static KeptFile kept;
  const std::string bytes = served(kept.holding({reinterpret_cast<const char *>(data), size}));
  requireMeshOrSentence(bytes, bytes.size() + 1);
  return 0;
}
