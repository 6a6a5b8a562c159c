#include "widgets/view/object_tool_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

struct ObjectTools {
  Q_DECLARE_TR_FUNCTIONS(halfspace::ObjectTools)
};

/// What is said of a tool, to be translated when it is said.
struct ToolTexts {
  ToolObject object;
  const char *id;
  const char *title;
  const char *description;
  std::array<const char *, 5> prompts; ///< after so many picks; behind the last one null
};

constexpr std::array allTexts{
    ToolTexts{ToolObject::Point,
              "point",
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Point"),
              QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                                "A new point, on the ground or, with Shift held, above it."),
              {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                                 "Click a place for the point. Shift lifts it off the ground.")}},
    ToolTexts{ToolObject::PointOn,
              "point-on",
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Point on an object"),
              QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                                "A point that stays on a plane, a line, a ray, a triangle or a sphere."),
              {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                                 "Click a place on a plane, a line, a ray, a triangle or a sphere.")}},
    ToolTexts{
        ToolObject::Segment,
        "segment",
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Segment"),
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "A segment between two points."),
        {QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click one end, or an empty place for a new point."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the other end.")}},
    ToolTexts{ToolObject::Line,
              "line",
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Line"),
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "The line through two points."),
              {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                                 "Click a point of the line, or an empty place for a new point."),
               QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click another point of the line.")}},
    ToolTexts{ToolObject::Ray,
              "ray",
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Ray"),
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "A ray from one point through another."),
              {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                                 "Click the start of the ray, or an empty place for a new point."),
               QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click a point that the ray goes through.")}},
    ToolTexts{ToolObject::Vector,
              "vector",
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Vector"),
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "The vector from one point to another."),
              {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                                 "Click the start of the vector, or an empty place for a new point."),
               QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click its tip.")}},
    ToolTexts{ToolObject::PlaneThroughPoints,
              "plane-through-points",
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Plane through three points"),
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "The plane through three points."),
              {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                                 "Click a point of the plane, or an empty place for a new point."),
               QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click a second point of the plane."),
               QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click a third point of the plane.")}},
    ToolTexts{
        ToolObject::PlaneWithNormal,
        "plane-with-normal",
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Plane by point and normal"),
        QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                          "The plane through a point, perpendicular to the way from it to another point."),
        {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                           "Click a point of the plane, or an empty place for a new point."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the tip of its normal.")}},
    ToolTexts{ToolObject::Triangle,
              "triangle",
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Triangle"),
              QT_TRANSLATE_NOOP("halfspace::ObjectTools", "A triangle between three points."),
              {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                                 "Click the first corner, or an empty place for a new point."),
               QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the second corner."),
               QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the third corner.")}},
    ToolTexts{
        ToolObject::Polygon,
        "polygon",
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Polygon"),
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "A polygon of three to eight corners."),
        {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                           "Click the first corner, or an empty place for a new point."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the second corner."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the third corner."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                           "Click the next corner. Enter, or the first corner again, closes the polygon.")}},
    ToolTexts{
        ToolObject::Sphere,
        "sphere",
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Sphere"),
        QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                          "A sphere around a point; its radius is a number that can be changed."),
        {QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the centre, or an empty place for a new point."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click how far the sphere reaches.")}},
    ToolTexts{
        ToolObject::Tetrahedron,
        "tetrahedron",
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Tetrahedron"),
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "A tetrahedron between four points."),
        {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                           "Click the first corner, or an empty place for a new point."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the second corner."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the third corner."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the fourth corner, above or below the first.")}},
    ToolTexts{
        ToolObject::Box,
        "box",
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Box"),
        QT_TRANSLATE_NOOP(
            "halfspace::ObjectTools",
            "A box along the axes, between two corners of its base and a point at the height of its top."),
        {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                           "Click a corner of the base, or an empty place for a new point."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the opposite corner of the base."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the height of the box.")}},
    ToolTexts{
        ToolObject::Prism,
        "prism",
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Prism"),
        QT_TRANSLATE_NOOP("halfspace::ObjectTools", "A prism over a base of three to eight corners."),
        {QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                           "Click the first corner of the base, or an empty place for a new point."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the second corner."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the third corner."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools",
                           "Click the next corner. Enter, or the first corner again, closes the base."),
         QT_TRANSLATE_NOOP("halfspace::ObjectTools", "Click the top, above or below the first corner.")}},
};

const ToolTexts &textsOf(ToolObject object) {
  return *std::find_if(allTexts.begin(), allTexts.end(),
                       [&](const ToolTexts &each) { return each.object == object; });
}

} // namespace

std::vector<ObjectToolWords> objectTools() {
  std::vector<ObjectToolWords> tools;
  tools.reserve(allTexts.size());
  for (const ToolTexts &each : allTexts)
    tools.push_back({each.object, QString::fromLatin1(each.id), ObjectTools::tr(each.title),
                     ObjectTools::tr(each.description)});
  return tools;
}

QString promptOf(const ObjectTool &tool) {
  if (!wishOf(tool))
    return {};
  const auto &prompts = textsOf(tool.object).prompts;
  const auto count = static_cast<std::size_t>(
      std::count_if(prompts.begin(), prompts.end(), [](const char *prompt) { return prompt != nullptr; }));
  if (tool.object == ToolObject::Prism && tool.corners > 0)
    return ObjectTools::tr(prompts.at(count - 1));
  // Of corners there are as many as the hand likes: further ones are asked for as the last that has words.
  const std::size_t last = count - (tool.object == ToolObject::Prism ? 2 : 1);
  return ObjectTools::tr(prompts.at(std::min(tool.picks.size(), last)));
}

QString endOnPrompt() { return ObjectTools::tr("Turn the view: from here no place can be clicked."); }

} // namespace halfspace
