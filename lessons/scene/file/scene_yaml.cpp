#include "lessons/scene/file/scene_yaml.h"

#include "lessons/reading/yaml_text.h"
#include "lessons/scene/file/scene_writer.h"

#include <nlohmann/json.hpp>

namespace halfspace {
namespace {

using Json = nlohmann::ordered_json;

/// On one line, in brackets and braces.
std::string flowOf(const Json &json) {
  if (json.is_string())
    return yamlText(json.get<std::string>());
  if (!json.is_structured())
    return json.dump();
  std::string parts;
  for (const auto &[key, value] : json.items())
    parts += (parts.empty() ? "" : ", ") + (json.is_object() ? key + ": " : "") + flowOf(value);
  return json.is_object() ? "{" + parts + "}" : "[" + parts + "]";
}

} // namespace

std::string yamlOf(const Scene &scene) {
  std::string lines;
  for (const Json &entry : jsonOf(scene))
    lines += "  - " + flowOf(entry) + "\n";
  return lines;
}

} // namespace halfspace
