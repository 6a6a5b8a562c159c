#include "widgets/exports/space_things.h"

#include "widgets/exports/page_polygon.h"
#include "widgets/picture/shapes/mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace halfspace {
namespace {

/// A line fades in so many steps.
constexpr int fadeSteps = 8;
/// The corners of the base of an arrow's head.
constexpr int headCorners = 24;
/// A head is as wide as its base at one end alone: on average it reaches this part of it to either side.
constexpr double headReach = 0.6;
/// The shaft goes this part of the head into it, so that no gap shows.
constexpr double shaftInHead = 0.1;

/// Draws shapes one by one.
class ThingPainter {
public:
  ThingPainter(const LineRoom &room, std::vector<PaintedThing> &things) : m_room(room), m_things(things) {}

  void paint(const Shape &shape, const LineShape &line) {
    if (line.fade && line.path.size() == 2)
      return paintFading(shape, line);
    const std::size_t pieces = line.path.size() - (line.isClosed ? 0 : 1);
    if (line.rhythm.empty() || line.path.size() < 3)
      return addLine(lineOf(shape, line.path, line.radius, line.rhythm, line.isClosed));
    for (std::size_t i = 0; i < pieces; ++i) // in a rhythm of its own each
      addLine(lineOf(shape, {line.path[i], line.path[(i + 1) % line.path.size()]}, line.radius, line.rhythm,
                     false));
  }

  void paint(const Shape &shape, const ArrowShape &arrow) {
    const double length = glm::length(arrow.vector);
    const Place tip = arrow.from + arrow.vector;
    if (!(length > 0))
      return;
    const Place along = arrow.vector / length;
    const ArrowHead head = headOfArrow(length, arrow.radius * penPerTube * (isSeen(tip) ? unitAt(tip) : 1));
    const Place neck = tip - along * head.length;
    if (!isSeen(tip) || !isSeen(neck))
      return addLine(lineOf(shape, {arrow.from, tip}, arrow.radius, arrow.rhythm, false));
    addLine(lineOf(shape, {arrow.from, neck + along * (shaftInHead * head.length)}, arrow.radius,
                   arrow.rhythm, false));
    addHead(shape, neck, tip, head.radius);
  }

  void paint(const Shape &shape, const BallShape &ball) {
    if (!isSeen(ball.center))
      return;
    const Spot spot = m_room.paper.spotOf(ball.center);
    PaintedThing thing;
    thing.spine = {spot};
    thing.veils = m_room.veils.standingOf(ball.center, m_room.questions);
    thing.rank = PaintedThing::Rank::Ball;
    thing.reach = ball.radius * discPerBall * m_room.paper.pointsPerUnit();
    PagePath outline = circlePath(spot.at, thing.reach);
    add(std::move(thing), std::move(outline), shape);
  }

  // These are drawn elsewhere.
  void paint(const Shape &, const FaceShape &) {}
  void paint(const Shape &, const BodyShape &) {}
  void paint(const Shape &, const HairlineShape &) {}
  void paint(const Shape &, const LeaderShape &) {}
  void paint(const Shape &, const LabelShape &) {}

private:
  [[nodiscard]] bool isSeen(const Place &place) const { return m_room.paper.isSeen(place); }

  /// By how much longer than at the target something must be at a place to be seen as long there.
  [[nodiscard]] double unitAt(const Place &place) const {
    return m_room.paper.pointsPerUnit() / m_room.paper.pointsPerUnitAt(place);
  }

  [[nodiscard]] DrawnLine lineOf(const Shape &shape, std::vector<Place> path, double radius,
                                 const Rhythm &rhythm, bool isClosed) const {
    const double unit = m_room.paper.pointsPerUnit();
    DrawnLine line{shape.mark, shape.color, std::move(path), isClosed, 2 * radius * penPerTube * unit};
    for (const double length : rhythm)
      line.dashes.push_back(length * dashPerTube * unit);
    const double length =
        rhythm.empty() ? 0 : lengthOnPage(line.path.front(), line.path.back(), m_room.paper);
    line.dashes = length > 0 ? fittedTo(length, line.dashes) : Rhythm();
    return line;
  }

  void addLine(const DrawnLine &line) {
    std::vector<PaintedThing> pieces = piecesOf(line, m_room);
    std::move(pieces.begin(), pieces.end(), std::back_inserter(m_things));
  }

  /// In steps from its own colour towards that which it fades into.
  void paintFading(const Shape &shape, const LineShape &line) {
    const Place &from = line.path.front();
    const Place &to = line.path.back();
    const double part = line.fade->length / glm::distance(from, to);
    DrawnLine whole = lineOf(shape, line.path, line.radius, line.rhythm, false);
    whole.isStep = true;
    const auto addPart = [&](double begin, double end, double strength) {
      DrawnLine step = whole;
      step.path = {glm::mix(from, to, begin), glm::mix(from, to, end)};
      step.color = mix(line.fade->into, shape.color, strength);
      addLine(step);
      whole.dashStart += lengthOnPage(step.path.front(), step.path.back(), m_room.paper);
    };
    const auto strengthOf = [](int step) { return std::lerp(fadedStrength, 1.0, (step + 0.5) / fadeSteps); };
    if (line.fade->isAtBothEnds)
      for (int step = 0; step < fadeSteps; ++step)
        addPart(part * step / fadeSteps, part * (step + 1) / fadeSteps, strengthOf(step));
    addPart(line.fade->isAtBothEnds ? part : 0, 1 - part, 1);
    for (int step = fadeSteps - 1; step >= 0; --step)
      addPart(1 - part * (step + 1) / fadeSteps, 1 - part * step / fadeSteps, strengthOf(step));
  }

  /// A head that goes through a veil is cut there.
  void addHead(const Shape &shape, const Place &neck, const Place &tip, double radius) {
    std::vector<StandingSpan> spans;
    for (StandingSpan &span : m_room.veils.spansOf({neck, tip}, m_room.questions))
      if (!spans.empty() && spans.back().veils.with(span.veils).canBePainted())
        spans.back() = {spans.back().begin, span.end, spans.back().veils.with(span.veils)};
      else
        spans.push_back(std::move(span));
    const Place square = glm::cross(tip - neck, m_room.paper.sightTo(neck));
    const Place across = square == Place(0) ? square : glm::normalize(square) * radius;
    for (const StandingSpan &span : spans) {
      const auto side = [&](double part, double way) {
        return m_room.paper.spotOf(glm::mix(neck, tip, part) + across * (way * (1 - part))).at;
      };
      PaintedThing thing;
      thing.rank = PaintedThing::Rank::Head;
      thing.veils = span.veils;
      thing.spine = {m_room.paper.spotOf(glm::mix(neck, tip, span.begin)),
                     m_room.paper.spotOf(glm::mix(neck, tip, span.end))};
      thing.reach = radius * m_room.paper.pointsPerUnitAt(neck) * headReach;
      add(std::move(thing),
          spans.size() == 1
              ? straightPath(coneOutline(neck, tip, radius), true)
              : straightPath(
                    {side(span.begin, 1), side(span.end, 1), side(span.end, -1), side(span.begin, -1)}, true),
          shape);
    }
  }

  [[nodiscard]] std::vector<glm::dvec2> coneOutline(const Place &neck, const Place &tip,
                                                    double radius) const {
    std::vector<glm::dvec2> spots{m_room.paper.spotOf(tip).at};
    for (const Place &corner : circleAround(neck, glm::normalize(tip - neck), radius, headCorners))
      spots.push_back(m_room.paper.spotOf(corner).at);
    return hullOf(std::move(spots));
  }

  void add(PaintedThing thing, PagePath outline, const Shape &shape) {
    thing.parts.push_back({std::move(outline), Fill{shape.color}, {}, shape.mark, thing.veils.isHidden()});
    m_things.push_back(std::move(thing));
  }

  const LineRoom &m_room;
  std::vector<PaintedThing> &m_things;
};

} // namespace

std::vector<PaintedThing> thingsOf(const std::vector<Shape> &shapes, const LineRoom &room) {
  std::vector<PaintedThing> things;
  ThingPainter painter(room, things);
  for (const Shape &shape : shapes)
    std::visit([&](const auto &form) { painter.paint(shape, form); }, shape.form);
  return things;
}

} // namespace halfspace
