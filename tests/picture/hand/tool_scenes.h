// Scenes for tools that make objects, told by the lines that one would type.
#pragma once

#include "lessons/typed/read_line.h"
#include "lessons/typed/write_line.h"
#include "widgets/picture/hand/object_tool.h"

#include <stdexcept>

namespace halfspace::test {

/// The scene after these lines; the test fails where one cannot be read.
inline Scene typedBelow(Scene scene, const std::vector<std::string> &lines) {
  for (const std::string &line : lines) {
    auto entry = readLine(line, scene);
    if (const auto *fault = std::get_if<TypedFault>(&entry))
      throw std::invalid_argument(line + ": " + fault->sentence);
    scene.entries.push_back(std::get<Entry>(std::move(entry)));
  }
  return scene;
}
inline Scene typedScene(const std::vector<std::string> &lines) { return typedBelow({}, lines); }

/// As they would be typed.
inline std::vector<std::string> linesOf(const std::vector<Entry> &entries) {
  std::vector<std::string> lines;
  for (const Entry &entry : entries)
    lines.push_back(lineFor(entry));
  return lines;
}

/// The tool after new points at these places.
inline ObjectTool withNewPoints(ObjectTool tool, const Scene &scene, const std::vector<ExactVec3> &places) {
  for (const ExactVec3 &place : places) {
    ToolPick point = newPoint(tool, scene, place);
    tool = withPick(std::move(tool), std::move(point));
  }
  return tool;
}

} // namespace halfspace::test
