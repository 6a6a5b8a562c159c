// The program that reads meshes, and what it may become in the hands of a file: the file's name says what.
#include "widgets/mesh_files/mesh_wire.h"
#include "widgets/mesh_files/serve_mesh.h"

#include <csignal>
#include <cstdlib>
#include <string>
#include <unistd.h>

namespace {

using namespace halfspace;

bool print(std::string_view bytes) {
  return ::write(STDOUT_FILENO, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
}

/// A mesh of which half is sent.
bool printHalf() {
  std::string bytes;
  const ByteSink sink = [&](std::string_view more) {
    bytes += more;
    return true;
  };
  return sendBeginning(sink) && sendMesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, sink) &&
         print(std::string_view(bytes).substr(0, bytes.size() / 2));
}

} // namespace

int main(int count, char **arguments) {
  if (count != 3 || std::string(arguments[1]) != readMeshCommand)
    return EXIT_FAILURE;
  const std::string file = arguments[2];
  const auto is = [&](const char *name) { return file.find(name) != std::string::npos; };
  if (is("crash"))
    return std::raise(SIGKILL);
  if (is("rubbish"))
    return print("Segmentation fault\n") ? EXIT_SUCCESS : EXIT_FAILURE;
  if (is("silent"))
    return EXIT_SUCCESS;
  if (is("half"))
    return printHalf() ? EXIT_SUCCESS : EXIT_FAILURE;
  while (is("hang"))
    ::pause();
  return serveMesh(file, STDOUT_FILENO);
}
