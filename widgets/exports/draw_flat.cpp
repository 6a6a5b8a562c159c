#include "widgets/exports/draw_flat.h"

#include "widgets/exports/append.h"
#include "widgets/exports/label_parts.h"
#include "widgets/picture/labels/label_page.h"
#include "widgets/picture/shapes/flat_shapes.h"

#include <algorithm>
#include <iterator>

namespace halfspace {
namespace {

PathPart partOf(const FlatShape &shape, double scale) {
  std::vector<glm::dvec2> spots;
  std::transform(shape.path.begin(), shape.path.end(), std::back_inserter(spots),
                 [&](glm::dvec2 pixel) { return pixel * scale; });
  PathPart part;
  if (shape.isDisc) { // it was made as much thinner as lines are
    part.path = circlePath(spots.front(), shape.width / 2 * scale * (discPerBall / penPerTube));
    part.fill = Fill{shape.color, shape.opacity};
  } else if (shape.width == 0) {
    part.path = straightPath(spots, true);
    part.fill = Fill{shape.color, shape.opacity};
  } else {
    part.path = smoothPath(spots, shape.isClosed);
    part.pen = Pen{shape.color, shape.width * scale};
    part.pen->opacity = shape.opacity;
    for (const double length : shape.rhythm)
      part.pen->dashes.push_back(length * dashPerTube * scale);
    part.pen->cap = shape.rhythm.empty() ? Pen::Cap::Round : Pen::Cap::Flat;
  }
  return part;
}

} // namespace

Drawing flatDrawingOf(const SceneContent &content, const Theme &theme, const View &view,
                      const PaperLook &look, const LabelSetter &set) {
  const double scale = look.width / view.size.width;
  Drawing drawing;
  drawing.size = glm::dvec2(view.size.width, view.size.height) * scale;
  drawing.ground = groundOf(look, theme.backgroundBottom);
  Theme thinner = theme;
  thinner.lineScale *= penPerTube;
  for (const FlatShape &shape : flatShapes(content, thinner, view))
    drawing.parts.emplace_back(partOf(shape, scale));
  const auto labels = LabelPage().place(writtenLabels(content, {}, theme, view),
                                        obstaclesOf(content, std::nullopt, theme, view), set, view);
  append(drawing.parts, labelParts(shapesOf(labels, theme.mutedInk, leaderWidth * view.pixelRatio), scale));
  return drawing;
}

} // namespace halfspace
