// Whatever the bytes that come from the process that reads: a mesh that can be asked for hits, or a sentence.
#include "tests/fuzz/arrived_mesh.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char *>(data), size);
  halfspace::requireMeshOrSentence(bytes, 1 + size % 50);
  return 0;
}
