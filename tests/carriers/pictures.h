// Small pictures of each format that carries sessions, and texts to be put into them.
#pragma once

#include "tests/formula/laid_out.h"
#include "widgets/carriers/base64.h"
#include "widgets/carriers/carrier.h"
#include "widgets/exports/format.h"

#include <string>

namespace halfspace::test {

/// 8 by 8 pixels.
inline std::string pngPicture() {
  return *fromBase64(
      "iVBORw0KGgoAAAANSUhEUgAAAAgAAAAICAIAAABLbSncAAAAzElEQVR42mNgUPXKn7LzHrOGb9H0PQ/ZtANKZ+1/wqkX"
      "zMBtEFo1/8hLPuOI2kXH3wiaRTcsPfVexDKOQcw6oXXV+S+Sdskday99l3FM695w9Ze8SyaDolv2hK23/qt45k3ecZdJ"
      "3adw2u4HrFr+JQw6gWWzDzzl0g+pnHf4Ba9ReM3CY68FTKPqGcxjGped/iBqFd+y8txnCduk9jUXv0k7pHYxOKX3bLz2"
      "W8E1q3/LzX/KHrmTtt9hVPMumMqA5sqKuYee8xiGVS8AAG9GWgG3iM3WAAAAAElFTkSuQmCC");
}

/// A line across a page, in a format of vectors.
inline std::string vectorPicture(const std::string &ending) {
  Drawing drawing{{100, 80}};
  drawing.title = "A line";
  drawing.description = "It goes across the page.";
  PathPart line;
  line.path.steps = {{PageStep::Kind::Move, {}, {}, {10, 10}}, {PageStep::Kind::Line, {}, {}, {90, 70}}};
  line.pen = Pen{};
  drawing.parts = {line};
  return formatOfFile("x" + ending)->write(drawing, math::fonts(), TextAs::Shapes);
}

inline std::string pictureOf(const Carrier &carrier) {
  return carrier.name == "PNG" ? pngPicture() : vectorPicture(carrier.ending);
}

inline const Carrier &carrierCalled(const std::string &name) {
  for (const Carrier &carrier : carriers())
    if (carrier.name == name)
      return carrier;
  throw std::invalid_argument(name);
}

/// As `writeSession` writes, with letters beyond ASCII.
inline std::string someSession() {
  return "{\n \"format\": \"halfspace\",\n \"version\": 4,\n \"lesson\": \"Ä₂ <&>\",\n \"scene\": []\n}\n";
}

/// The sentence of what was refused; the text, marked, of what was not.
inline std::string sentenceOf(const Result<std::string> &taken) {
  return taken ? "taken: " + *taken : taken.problem().sentence;
}

constexpr const char *foreign = "This picture holds no scene of Halfspace.";

} // namespace halfspace::test
