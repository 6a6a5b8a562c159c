#include "widgets/picture/named_views.h"

namespace halfspace {
namespace {

std::vector<Place> withHandles(std::vector<Place> places, const Sight &sight) {
  places.insert(places.end(), sight.handles.begin(), sight.handles.end());
  return places;
}

Camera fittedTo(const std::vector<Place> &places, Camera from, const View &view) {
  from.orthographic = view.camera.orthographic;
  return fitted({from, view.size, view.pixelRatio, view.covered}, places);
}

/// The view turned like a camera.
Camera seenWhole(const Sight &sight, Camera from, const View &view) {
  return fittedTo(withHandles(placesNearGiven(sight.whole, sight.hasAxes), sight), from, view);
}

} // namespace

std::vector<Place> placesOf(const Sight &sight) { return withHandles(placesOf(sight.shown), sight); }

Camera seenAs(NamedView name, const Sight &sight, const View &view) {
  const Camera &now = view.camera;
  switch (name) {
  case NamedView::Home:
    return seenWhole(sight, Camera(sight.start), view);
  case NamedView::Fit:
    return fittedTo(placesOf(sight), now, view);
  case NamedView::Whole:
    return seenWhole(sight, now, view);
  case NamedView::Front:
    return seenWhole(sight, seenAlong(AxisView::Front, now), view);
  case NamedView::Right:
    return seenWhole(sight, seenAlong(AxisView::Right, now), view);
  case NamedView::Top:
    return seenWhole(sight, seenAlong(AxisView::Top, now), view);
  case NamedView::AlongPlane:
    return seenWhole(sight, seenAlongPlane(sight.whole, now), view);
  case NamedView::FacingPlane:
    return seenWhole(sight, seenFacingPlane(sight.whole, now), view);
  case NamedView::DownCourse:
    return seenAlongCourse(AlongCourse::Down, sight.shown, now);
  case NamedView::AgainstCourse:
    break;
  }
  return seenWhole(sight, seenAlongCourse(AlongCourse::Against, sight.shown, now), view);
}

} // namespace halfspace
