// Whatever the bytes: a session that can be evaluated and written again as it is, or a problem with a
// sentence.
#include "lessons/scene/evaluation.h"
#include "lessons/scene/file/session_file.h"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  using namespace halfspace;
  const std::string_view text(reinterpret_cast<const char *>(data), size);
  const auto session = readSession(text, "fuzz");
  if (!session) {
    if (session.problem().sentence.empty())
      std::abort();
    return 0;
  }
  const auto again = readSession(writeSession(*session), "fuzz");
  if (!again || !(*again == *session))
    std::abort();
  const Evaluation evaluation = evaluate(session->scene);
  (void)workingOf(evaluation);
  (void)figureOf(evaluation);
  return 0;
}
