#include "widgets/picture/hand/tool_ghost.h"

#include "lessons/object/drawing.h"
#include "lessons/scene/evaluation.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// What the marks of no entry belong to.
constexpr const char *wayId = "tool/way";

/// The marks of what comes into a scene with some entries. Their parts, which are points that have a letter
/// already, are without theirs.
Figure marksOfNew(const std::vector<Entry> &entries, const Evaluation &evaluation) {
  Scene scene = evaluation.scene;
  for (const Entry &entry : entries)
    scene.entries.push_back(entry);
  const Evaluation come = evaluate(scene, evaluation);
  Figure ghosts;
  for (const Entry &entry : entries)
    for (Mark mark : come.find(entry.name)->outcome->figure->marks) {
      baseOf(mark).role = Role::Ghost;
      if (baseOf(mark).id != entry.name)
        baseOf(mark).label.clear();
      ghosts.add(std::move(mark));
    }
  return ghosts;
}

/// The way along what was taken so far.
void addWay(const ObjectTool &tool, Figure &ghosts) {
  const std::size_t last = tool.picks.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const bool isClosing = i + 1 == tool.corners && tool.corners > 0;
    const ToolPick &from = tool.picks[i];
    const ToolPick &to = isClosing ? tool.picks.front() : tool.picks[std::min(i + 1, last)];
    if (from.at != to.at)
      ghosts.add(
          SegmentMark{{partOf(wayId, i), Role::Ghost, Subject::Measure}, place(from.at), place(to.at)});
  }
}

} // namespace

Figure ghostOf(const ObjectTool &tool, const std::optional<ToolPick> &next, const Evaluation &evaluation,
               const Stage &stage) {
  ObjectTool preview = next ? withPick(tool, *next) : tool;
  if (canClose(preview))
    preview = withClosedCorners(std::move(preview));
  Figure ghosts = marksOfNew(entriesOf(preview, evaluation.scene), evaluation);
  if (wishOf(preview) && !preview.picks.empty())
    addWay(preview, ghosts);
  return toStage(ghosts, stage);
}

} // namespace halfspace
