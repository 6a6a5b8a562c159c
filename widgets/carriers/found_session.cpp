#include "widgets/carriers/found_session.h"

#include "lessons/files/read_file.h"
#include "lessons/scene/file/session_file.h"
#include "widgets/carriers/carrier.h"

#include <utility>

namespace halfspace {

Result<FoundSession> findSession(const std::filesystem::path &file) {
  auto content = readFile(file, mostPictureBytes);
  if (!content)
    return content.problem();
  const Carrier *carrier = carrierOf(*content);
  auto text = carrier ? carrier->take(*content) : std::move(content);
  if (!text)
    return Problem{text.problem().sentence, file.string(), 0, ""};
  auto session = readSession(*text, file.string());
  if (!session)
    return session.problem();
  return FoundSession{std::move(*session), std::move(*text), carrier != nullptr};
}

} // namespace halfspace
