#include "widgets/picture/hand/handle_selection.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace halfspace {
namespace {

const Handle *findHandle(const std::vector<Handle> &handles, const std::string &id) {
  const auto found =
      std::find_if(handles.begin(), handles.end(), [&](const Handle &each) { return each.id == id; });
  return found == handles.end() ? nullptr : &*found;
}

/// Whether it moves a coordinate that is a place, and not the tip of a direction.
bool movesPosition(const Handle &handle) {
  return handle.motion == Handle::Motion::Coordinate && isZero(handle.base);
}

} // namespace

void HandleSelection::take(std::vector<Handle> handles) {
  m_handles = std::move(handles);
  if (!selected())
    m_selected.clear();
  if (!find(m_hovered))
    m_hovered.clear();
}

const Handle *HandleSelection::find(const std::string &id) const { return findHandle(m_handles, id); }

void HandleSelection::select(const std::string &id) {
  if (m_selected != id)
    m_isVertical = false;
  m_selected = id;
}

std::string HandleSelection::next(bool forward) const {
  if (m_handles.empty())
    return {};
  const Handle *from = selected();
  const Handle &last = forward ? m_handles.back() : m_handles.front();
  if (!from)
    return forward ? m_handles.front().id : m_handles.back().id;
  if (from == &last)
    return {};
  return forward ? (from + 1)->id : (from - 1)->id;
}

std::optional<DragMode> HandleSelection::mode(const Camera &camera) const {
  const Handle *handle = selected();
  return handle ? grabMode(*handle, m_isVertical, camera) : std::nullopt;
}

const Handle *handleOfBody(const std::string &mark, const Figure &figure,
                           const std::vector<Handle> &handles) {
  const bool isBody = std::any_of(figure.marks.begin(), figure.marks.end(), [&](const Mark &each) {
    return std::holds_alternative<MeshMark>(each) && baseOf(each).id == mark;
  });
  const auto found = std::find_if(handles.begin(), handles.end(), [&](const Handle &handle) {
    return handle.object == mark && movesPosition(handle);
  });
  return isBody && found != handles.end() ? &*found : nullptr;
}

std::vector<Place> movedPositions(const std::vector<Handle> &before, const std::vector<Handle> &now) {
  std::unordered_map<std::string_view, const Handle *> old;
  for (const Handle &handle : before)
    old.emplace(handle.id, &handle);
  std::vector<Place> moved;
  for (const Handle &handle : now) {
    const auto known = old.find(handle.id);
    const bool isPosition = handle.motion == Handle::Motion::OnHost || movesPosition(handle);
    if (isPosition && known != old.end() && !(known->second->at == handle.at))
      moved.push_back(toDouble(handle.at));
  }
  return moved;
}

} // namespace halfspace
