#include "widgets/picture/named_views.h"

namespace halfspace {
namespace {

/// The places of a figure, with the sight's handles.
std::vector<Place> placesWithHandles(const Figure &figure, const Sight &sight) {
  std::vector<Place> places = placesOf(figure);
  places.insert(places.end(), sight.handles.begin(), sight.handles.end());
  return places;
}

Camera fittedTo(const std::vector<Place> &places, Camera from, const View &view) {
  from.orthographic = view.camera.orthographic;
  return fitted({from, view.size, view.pixelRatio, view.covered}, places);
}

/// The view turned like a camera.
Camera seenWhole(const Sight &sight, Camera from, const View &view) {
  const Figure near = nearGiven(sight.whole);
  std::vector<Place> places = placesWithHandles(near, sight);
  if (sight.hasAxes)
    for (const Place &tip : axisTips(near))
      places.push_back(tip);
  return fittedTo(places, from, view);
}

} // namespace

std::vector<Place> placesOf(const Sight &sight) { return placesWithHandles(sight.shown, sight); }

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
