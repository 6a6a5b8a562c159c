// One save through the program's own functions: save_something KIND FILE (old|new)
// Prints why not, and ends with 1, when it is told that the save failed.
#include "app/settings.h"
#include "app/work/recovery.h"
#include "lessons/files/write_file.h"
#include "lessons/object/kinds/point.h"
#include "lessons/scene/file/session_file.h"
#include "widgets/scene/png.h"

#include <QFile>
#include <QFileInfo>

#include <dlfcn.h>
#include <functional>
#include <iostream>
#include <random>

namespace halfspace {
namespace {

/// A save with all that it needs made ready before.
using Save = std::function<std::optional<Problem>()>;

/// Larger than a page, so that a disk can become full in the middle of it.
Session sessionAt(int x) {
  Session session{"signed-distance", 2, {}};
  for (int i = 0; i < 200; ++i)
    session.scene.entries.push_back(
        {"Q" + std::to_string(i), PointObject{ExactVec3(x, Rational(-10, 3), i)}});
  return session;
}

Save savingSession(const std::string &file, int x) {
  return [file, session = sessionAt(x)] { return writeFile(file, writeSession(session)); };
}

/// A file that is there is taken up first, as the program does with work that was left behind.
Save keepingUnsaved(const std::string &file, int x) {
  const QString path = QString::fromStdString(file);
  const auto recovery = std::make_shared<Recovery>(QFileInfo(path).path());
  if (QFile::exists(path) && !recovery->adopt(path))
    return [] { return Problem{"Another program has the file.", "", 0, ""}; };
  return [recovery, work = UnsavedWork{sessionAt(x), {}, {}}] { return recovery->keep(work); };
}

Save savingSettings(const std::string &file, int x) {
  Settings settings;
  settings.window = QByteArray(6000, static_cast<char>(x));
  return [path = QString::fromStdString(file), settings] { return writeSettings(settings, path); };
}

/// Noise, which PNG cannot make small.
Save savingPicture(const std::string &file, unsigned seed) {
  constexpr int side = 64;
  RgbaImage picture{side, side, std::vector<std::uint8_t>(std::size_t{4} * side * side)};
  std::mt19937 noise(seed);
  for (std::uint8_t &byte : picture.rgba)
    byte = static_cast<std::uint8_t>(noise());
  return [file, picture] { return writePng(picture, file); };
}

Save prepared(const std::string &kind, const std::string &file, int content) {
  if (kind == "session")
    return savingSession(file, content);
  if (kind == "recovery")
    return keepingUnsaved(file, content);
  if (kind == "settings")
    return savingSettings(file, content);
  if (kind == "picture")
    return savingPicture(file, static_cast<unsigned>(content));
  return [kind] { return Problem{"There is nothing called " + kind + ".", "", 0, ""}; };
}

/// Tells the library that makes calls fail, if it is there, from where on they count.
void countCalls(bool on) {
  if (void *tell = dlsym(RTLD_DEFAULT, "countCalls"))
    reinterpret_cast<void (*)(bool)>(tell)(on);
}

int run(const std::string &kind, const std::string &file, bool isNew) {
  const Save save = prepared(kind, file, isNew ? 2 : 1);
  countCalls(true);
  const auto problem = save();
  countCalls(false);
  if (problem)
    std::cout << problem->text() << "\n";
  return problem ? 1 : 0;
}

} // namespace
} // namespace halfspace

int main(int argc, char **argv) {
  return argc == 4 ? halfspace::run(argv[1], argv[2], std::string_view(argv[3]) == "new") : 2;
}
