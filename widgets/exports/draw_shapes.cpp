#include "widgets/exports/draw_shapes.h"

#include "widgets/exports/body_faces.h"
#include "widgets/exports/ground_parts.h"
#include "widgets/exports/label_parts.h"
#include "widgets/exports/space_things.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace halfspace {
namespace {

/// The faces of a list as veils, each with what it is painted with.
class FaceVeils {
public:
  FaceVeils(const std::vector<Shape> &faces, const Paper &paper) : m_paper(paper), m_veils(paper) {
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (const auto *face = std::get_if<FaceShape>(&faces[i].form); face && face->globe)
        m_pieces[faces[i].mark].push_back(i);
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (const auto *face = std::get_if<FaceShape>(&faces[i].form))
        face->globe ? addGlobe(i, faces[i], *face) : addFlat(faces[i], *face);
  }

  [[nodiscard]] const Veils &veils() const { return m_veils; }
  [[nodiscard]] const std::vector<VeilLook> &looks() const { return m_looks; }

private:
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

  /// The far half of a ball comes where the first of its pieces does, the near one where the last does.
  void addGlobe(std::size_t number, const Shape &shape, const FaceShape &face) {
    const std::vector<std::size_t> &pieces = m_pieces.at(shape.mark);
    for (const auto &[half, piece] :
         {std::pair(BallVeil::Half::Far, pieces.front()), {BallVeil::Half::Near, pieces.back()}}) {
      auto veil = BallVeil::of(*face.globe, half, m_paper);
      if (!veil) // the eye is in it
        return addFlat(shape, face);
      if (piece == number)
        add(std::move(*veil), shape, face);
    }
  }

  const Paper &m_paper;
  Veils m_veils;
  std::vector<VeilLook> m_looks;
  std::map<std::string, std::vector<std::size_t>> m_pieces; ///< of balls, by their marks
};

template <class Part> void append(std::vector<DrawingPart> &parts, std::vector<Part> more) {
  std::move(more.begin(), more.end(), std::back_inserter(parts));
}

std::vector<PathPart> spaceParts(const ShapeList &list, const Paper &paper, HiddenLines hidden) {
  const FaceVeils faces(facesWithBodies(list, paper), paper);
  const LineRoom room{paper, faces.veils(), hidden};
  std::vector<PaintedThing> things = thingsOf(*list.layer(Layer::Axes), room);
  std::vector<PaintedThing> solids = thingsOf(*list.layer(Layer::Solids), room);
  std::move(solids.begin(), solids.end(), std::back_inserter(things));
  return inPaintingOrder(faces.veils(), faces.looks(), std::move(things));
}

} // namespace

Drawing drawingOf(const ShapeList &list, const PaperLook &look) {
  const Paper paper(list, look.width);
  Drawing drawing;
  drawing.size = paper.size();
  if (list.background.isVisible)
    drawing.ground = groundOf(look, list.background.bottom);
  append(drawing.parts, groundParts(list, paper));
  append(drawing.parts, spaceParts(list, paper, look.hidden));
  append(drawing.parts, labelParts(*list.layer(Layer::Labels), paper.pointsPerPixel()));
  return drawing;
}

} // namespace halfspace
