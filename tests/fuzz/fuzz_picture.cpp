// Whatever the bytes: the text of a session, which is read as any other, or a problem with a sentence.
#include "lessons/scene/file/session_file.h"
#include "widgets/carriers/carrier.h"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  using namespace halfspace;
  const std::string_view file(reinterpret_cast<const char *>(data), size);
  const Carrier *carrier = carrierOf(file);
  if (!carrier)
    return 0;
  const auto text = carrier->take(file);
  if (!text) {
    if (text.problem().sentence.empty())
      std::abort();
    return 0;
  }
  const auto session = readSession(*text, "fuzz");
  if (!session && session.problem().sentence.empty())
    std::abort();
  (void)carrier->put(std::string(file), *text);
  return 0;
}
