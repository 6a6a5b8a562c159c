// The program itself, timed as whoever starts it meets it.
#pragma once

#include "tests/bench/durations.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace halfspace::bench {

/// A folder for files of its own, which is removed with them.
class BenchFolder {
public:
  explicit BenchFolder(const std::string &name)
      : m_path(std::filesystem::temp_directory_path() / ("halfspace-bench-" + name)) {
    std::filesystem::remove_all(m_path);
    std::filesystem::create_directories(m_path);
  }
  ~BenchFolder() { std::filesystem::remove_all(m_path); }
  BenchFolder(const BenchFolder &) = delete;
  BenchFolder &operator=(const BenchFolder &) = delete;

  [[nodiscard]] const std::filesystem::path &path() const { return m_path; }

private:
  std::filesystem::path m_path;
};

/// How long the program runs with these arguments, as a shell reads them, in a folder; in milliseconds, from
/// its start to its end. Nothing where it fails.
[[nodiscard]] inline std::optional<double> timeOfCommand(const std::string &arguments,
                                                         const std::filesystem::path &folder) {
  const auto start = Clock::now();
  const std::string command = "cd '" + folder.string() + "' && exec '" HALFSPACE_PROGRAM "' " + arguments;
  if (std::system(command.c_str()) != 0) // NOLINT(concurrency-mt-unsafe): nothing else is running
    return {};
  return millisecondsSince(start);
}

} // namespace halfspace::bench
