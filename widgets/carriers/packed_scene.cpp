#include "widgets/carriers/packed_scene.h"

#include "lessons/scene/file/session_file.h"
#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/carriers/deflate.h"

#include <utility>

namespace halfspace {

Problem noScene() { return {words("This picture holds no scene of Halfspace."), "", 0, ""}; }

Problem damagedScene() {
  return {words("The scene in this picture is damaged, and cannot be read any more."), "", 0, ""};
}

Problem damagedPicture() {
  return {words("This picture is damaged or cut off, and no scene of Halfspace is found in it."), "", 0, ""};
}

Result<std::string> unpackedScene(std::string_view packed) {
  Inflated scene = inflated(packed, maxSessionBytes);
  if (scene.content.size() > maxSessionBytes)
    return Problem{words("The scene in this picture is too large: at most {limit} MiB are read.",
                         {{"limit", std::to_string(maxSessionBytes >> 20U)}}),
                   "", 0, ""};
  if (!scene.isWhole)
    return damagedScene();
  return std::move(scene.content);
}

bool beginsAsSession(std::string_view text) {
  return text.starts_with('{') && trimmed(text.substr(1)).starts_with("\"format\": \"halfspace\"");
}

} // namespace halfspace
