#include "lessons/scene/file/shape_text.h"

#include "geometry/decide.h"
#include "lessons/object/drawing.h"
#include "lessons/reading/typed_number.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

namespace halfspace {
namespace {

/// Faces of so many triangles at the most have no more corners.
constexpr std::size_t mostCorners = 3 * mostWrittenTriangles;

std::vector<std::string_view> wordsIn(std::string_view text) {
  std::vector<std::string_view> all = partsOf(text, " \t\r\n");
  std::erase(all, std::string_view());
  return all;
}

Problem problemOf(std::string field, std::string sentence) {
  return {std::move(sentence), "", 0, std::move(field)};
}

/// A coordinate of a corner; or why it cannot be one.
Result<double> readCornerCoordinate(std::string_view text) {
  const auto exact = parseRational(text);
  if (!exact)
    return problemOf(cornersField, words("“{text}” is not a number: write it as 3, -1.5 or 0.25.",
                                         {{"text", shortened(text)}}));
  if (auto refused = refuseCoordinate(*exact))
    return problemOf(cornersField, std::move(*refused));
  const double value = toDouble(*exact);
  if (exactly(value) != *exact)
    return problemOf(
        cornersField,
        words("{text} cannot be a coordinate of a corner: take a whole number or one with halves, "
              "quarters, eighths …, and let k scale the mesh.",
              {{"text", shortened(text)}}));
  return value;
}

Result<std::vector<Vec3<double>>> readCorners(std::string_view text) {
  const auto parts = partsOf(text, ",");
  if (parts.size() > mostCorners)
    return problemOf(cornersField, words("These are too many corners: at most {limit} are read.",
                                         {{"limit", std::to_string(mostCorners)}}));
  std::vector<Vec3<double>> corners;
  for (const std::string_view part : parts) {
    const auto numbers = wordsIn(part);
    if (numbers.size() != 3)
      return problemOf(cornersField, words("“{text}” is no corner: three numbers are, as 1 2 3.",
                                           {{"text", shortened(part)}}));
    Vec3<double> corner{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto value = readCornerCoordinate(numbers[static_cast<std::size_t>(axis)]);
      if (!value)
        return value.problem();
      corner[axis] = *value;
    }
    corners.push_back(corner);
  }
  return corners;
}

std::optional<std::uint32_t> readIndex(std::string_view text, std::size_t count) {
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc{} || end != text.data() + text.size() || index >= count)
    return {};
  return index;
}

Result<MeshFace> readFace(std::string_view text, const std::vector<Vec3<double>> &corners) {
  MeshFace face;
  std::vector<ExactVec3> places;
  for (const std::string_view word : wordsIn(text)) {
    const auto index = readIndex(word, corners.size());
    if (!index)
      return problemOf(facesField,
                       words("“{text}” is not the number of a corner: they are counted from 0 to {last}.",
                             {{"text", shortened(word)}, {"last", std::to_string(corners.size() - 1)}}));
    face.push_back(*index);
    places.push_back(exactly(corners[*index]));
  }
  if (face.size() < 3 || face.size() > mostFaceCorners || (face.size() > 3 && !isFlatAndConvex(places)))
    return problemOf(facesField,
                     words("“{text}” is no flat, convex face of three to {most} corners. Cut it into "
                           "triangles.",
                           {{"text", shortened(text)}, {"most", std::to_string(mostFaceCorners)}}));
  return face;
}

Result<std::vector<MeshFace>> readFaces(std::string_view text, const std::vector<Vec3<double>> &corners) {
  if (trimmed(text).empty())
    return problemOf(facesField, words("The mesh has no faces."));
  std::vector<MeshFace> faces;
  std::size_t triangles = 0;
  for (const std::string_view part : partsOf(text, ",")) {
    auto face = readFace(part, corners);
    if (!face)
      return face.problem();
    triangles += face->size() - 2;
    if (triangles > mostWrittenTriangles)
      return problemOf(facesField, words("These are too many faces: at most {limit} triangles are read.",
                                         {{"limit", std::to_string(mostWrittenTriangles)}}));
    faces.push_back(std::move(*face));
  }
  return faces;
}

std::string textOf(const MeshFace &face) {
  std::string text;
  for (const std::uint32_t corner : face)
    text += (text.empty() ? "" : " ") + std::to_string(corner);
  return text;
}

} // namespace

Result<std::shared_ptr<const MeshShape>> readShape(std::string_view corners, std::string_view faces) {
  if (trimmed(corners).empty())
    return problemOf(cornersField, words("The mesh has no corners."));
  auto places = readCorners(corners);
  if (!places)
    return places.problem();
  auto around = readFaces(faces, *places);
  if (!around)
    return around.problem();
  return std::make_shared<const MeshShape>(std::move(*places), std::move(*around));
}

WrittenShape written(const MeshShape &shape) {
  WrittenShape text;
  const auto goOn = [](std::string &list, const std::string &next) {
    list += (list.empty() ? "" : ", ") + next;
  };
  for (const Vec3<double> &corner : shape.mesh()->corners)
    goOn(text.corners,
         toText(exactly(corner.x)) + " " + toText(exactly(corner.y)) + " " + toText(exactly(corner.z)));
  for (const MeshFace &face : shape.faces())
    goOn(text.faces, textOf(face));
  if (shape.faces().empty())
    for (const auto &[a, b, c] : shape.mesh()->triangles)
      goOn(text.faces, textOf({a, b, c}));
  return text;
}

} // namespace halfspace
