#include "widgets/exports/draw_shapes.h"

#include "widgets/exports/append.h"
#include "widgets/exports/body_faces.h"
#include "widgets/exports/ground_parts.h"
#include "widgets/exports/label_parts.h"
#include "widgets/exports/space_things.h"

#include <map>
#include <set>

namespace halfspace {
namespace {

/// The faces of a list as veils, each with what it is painted with.
class FaceVeils {
public:
  FaceVeils(const std::vector<Shape> &faces, const Paper &paper) : m_paper(paper), m_veils(paper) {
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (const auto *face = std::get_if<FaceShape>(&faces[i].form); face && face->globe)
        addPiece(i, faces[i].mark, *face->globe);
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (const auto *face = std::get_if<FaceShape>(&faces[i].form))
        face->globe ? addGlobe(i, faces[i], *face) : addFlat(faces[i], *face);
  }

  [[nodiscard]] const Veils &veils() const { return m_veils; }
  [[nodiscard]] const std::vector<VeilLook> &looks() const { return m_looks; }

private:
  /// A ball among the faces: where the first and the last of its pieces come, and its halves; without them
  /// the pieces are veils themselves.
  struct Ball {
    std::size_t first = 0;
    std::size_t last = 0;
    std::optional<BallVeil> far{};
    std::optional<BallVeil> near{};
  };

  void add(Veil veil, const Shape &shape, const FaceShape &face) {
    m_veils.add(std::move(veil));
    m_looks.push_back({shape.mark, {shape.color, face.opacity}});
  }

  void addFlat(const Shape &shape, const FaceShape &face) {
    const std::vector<Place> seen = m_paper.seenPart(face.corners);
    if (seen.size() < 3)
      return;
    if (auto veil = FlatVeil::of(seen, m_paper))
      add(std::move(*veil), shape, face);
  }

  void addPiece(std::size_t number, const std::string &mark, const Globe &globe) {
    const auto [known, isNew] = m_balls.try_emplace(mark);
    if (isNew)
      known->second = {number, number, BallVeil::of(globe, BallVeil::Half::Far, m_paper),
                       BallVeil::of(globe, BallVeil::Half::Near, m_paper)};
    known->second.last = number;
  }

  /// The far half of a ball comes where the first of its pieces does, the near one where the last does.
  void addGlobe(std::size_t number, const Shape &shape, const FaceShape &face) {
    const Ball &ball = m_balls.at(shape.mark);
    if (!ball.far || !ball.near)
      return addFlat(shape, face);
    if (number == ball.first)
      add(*ball.far, shape, face);
    if (number == ball.last)
      add(*ball.near, shape, face);
  }

  const Paper &m_paper;
  Veils m_veils;
  std::vector<VeilLook> m_looks;
  std::map<std::string, Ball> m_balls; ///< by their marks
};

/// Parts of a drawing, and the marks of which nothing is on it because they are wholly hidden.
struct SpaceParts {
  std::vector<PathPart> parts;
  std::set<std::string> hiddenMarks{};
};

/// Takes the hidden things away. Marks that nothing is left of are those that are wholly hidden.
std::set<std::string> leaveOutHidden(std::vector<PaintedThing> &things) {
  std::set<std::string> hidden;
  std::set<std::string> seen;
  for (const PaintedThing &thing : things)
    for (const PathPart &part : thing.parts)
      (thing.veils.isHidden() ? hidden : seen).insert(part.mark);
  std::erase_if(things, [](const PaintedThing &thing) { return thing.veils.isHidden(); });
  for (const std::string &mark : seen)
    hidden.erase(mark);
  return hidden;
}

SpaceParts spaceParts(const ShapeList &list, const Paper &paper, HiddenLines hidden) {
  const FaceVeils faces(facesWithBodies(list, paper), paper);
  Questions questions;
  const LineRoom room{paper, faces.veils(), hidden, questions};
  std::vector<PaintedThing> things = thingsOf(*list.layer(Layer::Axes), room);
  append(things, thingsOf(*list.layer(Layer::Solids), room));
  SpaceParts space;
  if (hidden == HiddenLines::LeftOut)
    space.hiddenMarks = leaveOutHidden(things);
  for (const VeilLook &face : faces.looks()) // the border of a face may be hidden by others, the face is not
    space.hiddenMarks.erase(face.mark);
  space.parts = inPaintingOrder(faces.veils(), faces.looks(), std::move(things));
  return space;
}

/// The labels and leaders of what is on a drawing. Those of the axes are of no mark.
std::vector<Shape> labelsWithout(const std::set<std::string> &marks, std::vector<Shape> labels) {
  std::erase_if(labels,
                [&](const Shape &shape) { return !shape.mark.empty() && marks.contains(shape.mark); });
  return labels;
}

} // namespace

Drawing drawingOf(const ShapeList &list, const PaperLook &look) {
  const Paper paper(list, look.width);
  Drawing drawing;
  drawing.size = paper.size();
  drawing.leavesOutSurfaces = list.leavesOutSurfaces;
  if (list.background.isVisible)
    drawing.ground = groundOf(look, list.background.bottom);
  append(drawing.parts, groundParts(list, paper));
  SpaceParts space = spaceParts(list, paper, look.hidden);
  append(drawing.parts, std::move(space.parts));
  append(drawing.parts,
         labelParts(labelsWithout(space.hiddenMarks, *list.layer(Layer::Labels)), paper.pointsPerPixel()));
  return drawing;
}

} // namespace halfspace
