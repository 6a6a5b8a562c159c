#include "widgets/view/handle_hints.h"

#include <QCoreApplication>

namespace halfspace {
namespace {

struct HandleHints {
  Q_DECLARE_TR_FUNCTIONS(halfspace::HandleHints)
};

QString hintOf(DragMode mode, const Handle &handle, const Camera &camera) {
  switch (mode) {
  case DragMode::Horizontal:
    if (grabMode(handle, true, camera) != DragMode::Vertical)
      return HandleHints::tr("Moves in x and y. Look from the side to move it up and down.");
    return HandleHints::tr("Moves in x and y. Click it again, or hold Shift, for up and down. X, Y, Z lock "
                           "an axis. Ctrl frees it from the grid.");
  case DragMode::Vertical:
    if (grabMode(handle, false, camera) != DragMode::Horizontal)
      return HandleHints::tr("Moves up and down. Look from higher above to move it in x and y.");
    return HandleHints::tr("Moves up and down. Click it again for x and y.");
  case DragMode::AxisX:
    return HandleHints::tr("Moves along x only.");
  case DragMode::AxisY:
    return HandleHints::tr("Moves along y only.");
  case DragMode::AxisZ:
    return HandleHints::tr("Moves along z only.");
  case DragMode::PlaneYZ:
    return HandleHints::tr("Moves in y and z.");
  case DragMode::PlaneZX:
    return HandleHints::tr("Moves in x and z.");
  case DragMode::OwnAxis:
    return HandleHints::tr("Moves along its line only.");
  case DragMode::OwnPlane:
    return HandleHints::tr("Moves in its plane only.");
  case DragMode::OwnSphere:
    break;
  }
  return HandleHints::tr("Moves on its sphere only.");
}

} // namespace

QString hintOf(const Handle &handle, std::optional<DragMode> mode, const Camera &camera) {
  return mode ? hintOf(*mode, handle, camera)
              : HandleHints::tr("Turn the view: from here this handle is seen end-on.");
}

QString firstHint() {
  return HandleHints::tr("Drag a handle to move it, drag beside it to turn the view. The wheel zooms.");
}

QString noAxesHint() { return HandleHints::tr("The origin and the axes lie far outside of this picture."); }

QString typedAwayHint() {
  return HandleHints::tr("What was typed lies outside of the view. F brings all into it.");
}

QString mostCornersHint(int count) {
  return HandleHints::tr("It has %n corners, as many as there can be.", nullptr, count);
}

QString fewestCornersHint(int count) {
  return HandleHints::tr("It has %n corners, as few as there can be.", nullptr, count);
}

} // namespace halfspace
