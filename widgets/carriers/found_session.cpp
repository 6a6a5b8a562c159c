#include "widgets/carriers/found_session.h"

#include "lessons/files/read_file.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/words.h"
#include "widgets/carriers/carrier.h"
#include "widgets/carriers/qr/grey_image.h"
#include "widgets/carriers/qr/photograph.h"

#include <utility>

namespace halfspace {
namespace {

/// What a picture of a format with room for a session has in that, and otherwise its QR code.
Result<std::string> sessionInPicture(const std::string &picture) {
  const Carrier *carrier = carrierOf(picture);
  auto carried = carrier ? carrier->take(picture) : noCode();
  if (carried || !isPixelPicture(picture))
    return carried;
  auto photographed = sessionInPhotograph(picture);
  return photographed ? std::move(*photographed) : std::move(carried);
}

} // namespace

Result<FoundSession> findSession(const std::filesystem::path &file) {
  auto content = readFile(file, mostPictureBytes);
  if (!content)
    return content.problem();
  return findSessionIn(std::move(*content), file.string());
}

Result<FoundSession> findSessionIn(std::string content, const std::string &file) {
  if (content.size() > mostPictureBytes)
    return Problem{words("This is too large to be searched for a scene."), file, 0, ""};
  const bool isPicture = carrierOf(content) || isPixelPicture(content);
  auto text = isPicture ? sessionInPicture(content) : std::move(content);
  if (!text)
    return Problem{text.problem().sentence, file, 0, ""};
  auto session = readSession(*text, file);
  if (!session)
    return session.problem();
  return FoundSession{std::move(*session), std::move(*text), isPicture};
}

} // namespace halfspace
