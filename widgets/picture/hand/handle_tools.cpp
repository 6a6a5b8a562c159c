#include "widgets/picture/hand/handle_tools.h"

#include "geometry/decide.h"
#include "lessons/term/latex.h"
#include "lessons/words.h"
#include "widgets/picture/shapes/gizmo_shape.h"

namespace halfspace {
namespace {

Gizmo::Mode gizmoMode(DragMode mode) {
  switch (mode) {
  case DragMode::Horizontal:
    return Gizmo::Mode::Horizontal;
  case DragMode::Vertical:
    return Gizmo::Mode::Vertical;
  case DragMode::AxisX:
    return Gizmo::Mode::AlongX;
  case DragMode::AxisY:
    return Gizmo::Mode::AlongY;
  case DragMode::AxisZ:
    return Gizmo::Mode::AlongZ;
  case DragMode::OwnAxis:
    return Gizmo::Mode::AlongAxis;
  case DragMode::OwnPlane:
  case DragMode::OwnSphere:
    return Gizmo::Mode::InPlane;
  case DragMode::PlaneYZ:
  case DragMode::PlaneZX:
    break;
  }
  return Gizmo::Mode::None;
}

} // namespace

Gizmo gizmoOf(const Handle &handle, std::optional<DragMode> mode) {
  Gizmo gizmo;
  gizmo.at = shownPlace(handle);
  gizmo.axes = mode && !isOwn(*mode);
  if (!mode)
    return gizmo;
  if (handle.hasAxis())
    gizmo.axis = toDouble(handle.axis);
  gizmo.normal = handle.center ? toDouble(handle.at - *handle.center) : toDouble(handle.normal);
  gizmo.mode = gizmoMode(*mode);
  return gizmo;
}

std::string fixedNote(const Handle &handle, const Scene &scene, const Evaluation &evaluation) {
  const Object &object = *findObject(scene, handle.object);
  Symbol symbol = letter("z");
  const EvaluatedEntry *entry = evaluation.find(handle.object);
  if (entry && coordinatesOf(object)[handle.coordinate].role == CoordinateRole::Direction) {
    symbol = entry->own->letters[handle.coordinate];
    symbol.isVector = false;
    symbol.subscript += symbol.subscript.empty() ? "z" : ",z";
  }
  // Among words a fraction would be smaller than in other labels.
  const std::string formula =
      "$\\displaystyle " + latexOf(symbol) + relatedLatex(Term(object[handle.coordinate].z)) + "$";
  return "\\text{" + words("{formula} fixed", {{"formula", formula}}) + "}";
}

std::vector<Knob> knobsOf(const HandleSelection &selection, const Camera &camera) {
  std::vector<Knob> knobs;
  for (const Handle &handle : selection.handles())
    if (auto knob = knobOf(handle, selection.isHot(handle));
        knob && grabMode(handle, selection.isVertical(), camera))
      knobs.push_back(std::move(*knob));
  return knobs;
}

Touched touchedAt(glm::dvec2 pixel, const HandleSelection &selection, const std::vector<Grip> &grips,
                  const std::optional<Gizmo> &tool, const View &view) {
  const auto within = [&](double margin) {
    return selection.find(handleGrabbedAt(pixel, grips, margin * view.pixelRatio));
  };
  if (const Handle *handle = within(grabMargin))
    return {handle};
  if (tool)
    if (const auto part = gizmoPartAt(*tool, view.camera, view.size, view.pixelRatio, pixel))
      return {nullptr, part};
  return {within(missMargin)};
}

} // namespace halfspace
