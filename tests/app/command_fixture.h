// The program without a display, and what it answers.
#pragma once

#include "tests/program_test.h"

#include <nlohmann/json.hpp>

#include <QImage>

#include <algorithm>

namespace halfspace {

/// The program without a display and a home.
class Program : public ProgramTest {
protected:
  QImage picture(const std::string &name) const {
    return QImage(QString::fromStdString(inFolder(name).string()));
  }

  /// `arguments` as a shell reads them; `environment`: NAME=value in front. No display and no home.
  Ran run(const std::string &arguments, const std::string &environment = "") const {
    return runWith(">.out 2>.err </dev/null", arguments, environment);
  }
  /// Likewise, with other standard streams.
  Ran runWith(const std::string &streams, const std::string &arguments,
              const std::string &environment = "") const {
    std::filesystem::remove(inFolder(".out"));
    std::filesystem::remove(inFolder(".err"));
    return shell("exec " + command(arguments, environment) + " " + streams);
  }
  /// Tells it to end as soon as a condition of the shell holds, or after a minute, and says how it ended.
  Ran runUntil(const std::string &condition, const std::string &arguments) const {
    return shell("{ exec " + command(arguments) +
                 " >.out 2>.err </dev/null & } ; for wait in $(seq 3000); do { " + condition +
                 "; } 2>/dev/null && break; sleep 0.02; done; kill -TERM $!; wait $!");
  }

  /// From now on it is a copy of the program that runs, which has one of our lessons, and this one.
  void addLesson(const std::string &text) {
    const std::filesystem::path own = inFolder("own");
    const std::filesystem::path lessons = "share/halfspace/lessons";
    if (!std::filesystem::exists(own)) {
      const std::filesystem::path program = m_program;
      std::filesystem::create_directories(own / "bin");
      std::filesystem::create_directories(own / lessons);
      m_program = (own / "bin/halfspace").string();
      std::filesystem::copy_file(program, m_program);
      std::filesystem::copy(program.parent_path().parent_path() / lessons / "signed-distance.md",
                            own / lessons);
    }
    write("own/share/halfspace/lessons/added.md", text);
  }

  nlohmann::json explained(const std::string &arguments) const {
    const Ran ran = run("explain --format json " + arguments);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    return nlohmann::json::parse(ran.out);
  }

  /// Refused: status 2, nothing printed, and one sentence that says why.
  void expectRefused(const std::string &arguments, const std::string &reason,
                     const std::string &environment = "") const {
    SCOPED_TRACE(environment + " halfspace " + arguments);
    const Ran ran = run(arguments, environment);
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_TRUE(ran.err.starts_with("halfspace: ") && (ran.err.ends_with(".\n") || ran.err.ends_with("?\n")))
        << ran.err;
    EXPECT_NE(ran.err.find(reason), std::string::npos) << ran.err;
  }

private:
  [[nodiscard]] std::string command(const std::string &arguments, const std::string &environment = "") const {
    return "env -u DISPLAY -u WAYLAND_DISPLAY -u XDG_RUNTIME_DIR -u QT_QPA_PLATFORM HOME='" +
           folder().string() + "' " + environment + " '" + m_program + "' " + arguments;
  }

  std::string m_program = HALFSPACE_PROGRAM;
};

} // namespace halfspace
