#include "widgets/carriers/qr/photograph.h"

#include "lessons/files/run_apart.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/words.h"
#include "widgets/carriers/qr/qr_text.h"
#include "widgets/carriers/qr/read_codes.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

Problem foreignCode() {
  return {words("The QR code in this picture holds no scene of Halfspace."), "", 0, ""};
}

Problem unreadableCode() {
  return {words("There is a QR code in this picture, but it is blurred or covered. Photograph it again: from "
                "straight above, in even light, and so near that it fills half of the picture."),
          "", 0, ""};
}

Problem severalCodes(std::size_t count) {
  return {words("{count} QR codes in this picture hold scenes. Photograph one of them alone, or cut it out.",
                {{"count", std::to_string(count)}}),
          "", 0, ""};
}

Problem searchedTooLong() {
  return {words("This picture could not be searched for a QR code: it takes too much time or memory. Cut the "
                "code out of it."),
          "", 0, ""};
}

/// What the codes of a picture come to.
std::optional<Result<std::string>> sessionIn(std::vector<ReadCode> codes) {
  if (codes.empty())
    return {};
  std::erase_if(codes, [](const ReadCode &code) { return !code.isWhole; });
  if (codes.empty())
    return unreadableCode();
  std::erase_if(codes, [](const ReadCode &code) { return !isQrText(code.text); });
  if (codes.empty())
    return foreignCode();
  if (codes.size() > 1)
    return severalCodes(codes.size());
  return sessionInQrText(codes.front().text);
}

std::optional<Result<std::string>> search(std::string_view picture) {
  const auto image = greyImageOf(picture);
  if (!image)
    return image.problem();
  return sessionIn(readCodes(*image));
}

// How the process that searches tells what it found, in front of the text or the sentence.
constexpr char tellsNothing = '-';
constexpr char tellsSession = 's';
constexpr char tellsProblem = 'p';

std::string told(const std::optional<Result<std::string>> &found) {
  if (!found)
    return {tellsNothing};
  return *found ? tellsSession + **found : tellsProblem + found->problem().sentence;
}

/// Out of what was told, which is not empty.
std::optional<Result<std::string>> heard(std::string telling) {
  const char what = telling.front();
  if (what == tellsNothing)
    return {};
  telling.erase(0, 1);
  if (what == tellsSession)
    return telling;
  return Problem{std::move(telling), "", 0, ""};
}

} // namespace

std::optional<Result<std::string>> sessionInPhotograph(std::string_view picture, unsigned mostSeconds) {
  auto telling =
      runApart([&] { return told(search(picture)); }, ProcessBounds{{}, mostSeconds}, maxSessionBytes + 1);
  if (!telling || telling->empty())
    return searchedTooLong();
  return heard(std::move(*telling));
}

Problem noCode() {
  return {
      words("No QR code is found in this picture. Photograph it from straight above, in even light, and so "
            "near that it fills half of the picture."),
      "", 0, ""};
}

} // namespace halfspace
