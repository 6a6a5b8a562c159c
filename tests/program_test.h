// The program as a shell meets it: run in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>

namespace halfspace {

struct Ran {
  int status = -1; ///< −1: ended by a signal
  std::string out;
  std::string err;
};

inline std::string contentOf(const std::filesystem::path &file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Each test finds its folder empty.
class ProgramTest : public testing::Test {
protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "halfspace-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    m_folder = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(m_folder); }

  [[nodiscard]] const std::filesystem::path &folder() const { return m_folder; }
  [[nodiscard]] std::filesystem::path inFolder(const std::string &name) const { return m_folder / name; }

  [[nodiscard]] std::string file(const std::string &name) const { return contentOf(inFolder(name)); }
  void write(const std::string &name, const std::string &text) const {
    std::ofstream(inFolder(name), std::ios::binary) << text;
  }

  /// A command as a shell reads it, which writes into .out and .err; no core file should it crash.
  [[nodiscard]] Ran shell(const std::string &command) const {
    const std::string there = "cd '" + m_folder.string() + "' && ulimit -c 0 && " + command;
    const int ended = std::system(there.c_str()); // NOLINT(concurrency-mt-unsafe): a test is one thread
    return {WIFEXITED(ended) ? WEXITSTATUS(ended) : -1, contentOf(inFolder(".out")),
            contentOf(inFolder(".err"))};
  }

  /// Whether programs are installed; their names stand side by side.
  [[nodiscard]] bool has(const std::string &programs) const {
    return shell("for each in " + programs + "; do command -v $each || exit 1; done >.out 2>.err").status ==
           0;
  }

private:
  std::filesystem::path m_folder;
};

} // namespace halfspace
