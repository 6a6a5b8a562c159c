#include "widgets/exports/drawn_lines.h"

#include "widgets/exports/page_number.h"
#include "widgets/picture/screen_shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace halfspace {
namespace {

/// The dashes of what is hidden, in design points; and how much thinner its lines are.
const Rhythm hiddenDashes{7, 5};
constexpr double hiddenWidth = 0.75;
/// What is shorter than so many of its periods is no place to look for where its dashes belong.
constexpr double leastPeriods = 2;
/// A line that leaves a straight one by less than this, in points, is straight.
constexpr double straightness = 0.05;

/// A part of a line that is painted at one time.
struct Run {
  std::vector<Spot> spots;
  double begin = 0; ///< how far along the line, on the page
  AmongVeils veils;

  [[nodiscard]] double length() const {
    double sum = 0;
    for (std::size_t i = 1; i < spots.size(); ++i)
      sum += glm::distance(spots[i - 1].at, spots[i].at);
    return sum;
  }
};

/// Collects the runs of a line.
class Runs {
public:
  explicit Runs(bool areToldApart) : m_areToldApart(areToldApart) {}

  /// Goes on with a run that begins where the last one ends, or elsewhere.
  void add(Run run) {
    if (!m_runs.empty() && goesOn(m_runs.back(), run))
      m_runs.back() = joined(std::move(m_runs.back()), run);
    else
      m_runs.push_back(std::move(run));
  }
  /// Of a closed line: the last goes on with the first.
  void joinEnds() {
    if (m_runs.size() < 2 || !goesOn(m_runs.back(), m_runs.front()))
      return;
    m_runs.front() = joined(std::move(m_runs.back()), m_runs.front());
    m_runs.pop_back();
  }
  [[nodiscard]] std::vector<Run> take() { return std::move(m_runs); }

private:
  [[nodiscard]] bool goesOn(const Run &run, const Run &next) const {
    const bool isTouched = run.spots.back().at == next.spots.front().at;
    const bool isOneKind = !m_areToldApart || run.veils.isHidden() == next.veils.isHidden();
    return isTouched && isOneKind && run.veils.with(next.veils).canBePainted();
  }
  static Run joined(Run run, const Run &next) {
    run.spots.insert(run.spots.end(), next.spots.begin() + 1, next.spots.end());
    run.veils = run.veils.with(next.veils);
    return run;
  }

  bool m_areToldApart; ///< what is hidden from what is not
  std::vector<Run> m_runs;
};

std::vector<Run> runsOf(const DrawnLine &line, const LineRoom &room) {
  Runs runs(room.hidden != HiddenLines::Paler);
  double along = 0;
  const std::size_t pieces = line.path.size() - (line.isClosed ? 0 : 1);
  for (std::size_t i = 0; i < pieces; ++i) {
    const Place &from = line.path[i];
    const Place &to = line.path[(i + 1) % line.path.size()];
    const auto seen = room.paper.seenPart(from, to);
    if (!seen)
      continue;
    const SightedPiece piece{glm::mix(from, to, seen->first), glm::mix(from, to, seen->second)};
    for (const StandingSpan &span : room.veils.spansOf(piece, room.questions)) {
      Run run;
      run.spots = {room.paper.spotOf(glm::mix(piece.from, piece.to, span.begin)),
                   room.paper.spotOf(glm::mix(piece.from, piece.to, span.end))};
      run.begin = along;
      run.veils = span.veils;
      along += run.length();
      runs.add(std::move(run));
    }
  }
  if (line.isClosed)
    runs.joinEnds();
  return runs.take();
}

/// Whether all spots lie on one straight line, as far as is seen.
bool isStraight(const std::vector<Spot> &spots) {
  return std::all_of(spots.begin(), spots.end(), [&](const Spot &spot) {
    return distanceToSegment(spot.at, spots.front().at, spots.back().at) < straightness;
  });
}

/// The rhythm of a hidden run, and how far into it the run begins.
struct HiddenRhythm {
  Rhythm dashes;
  double start = 0;
};

/// Dashes of straight lines have places on the page that hold for all lines there, whichever way they go: an
/// arrow along an edge covers the edge's dashes and leaves its gaps. Short and bent ones begin and end with a
/// dash.
HiddenRhythm hiddenRhythmOf(const Run &run, bool isStep, double designPoint) {
  const double dash = hiddenDashes.front() * designPoint;
  const double period = dash + hiddenDashes.back() * designPoint;
  const double length = run.length();
  if (!isStep && (length < leastPeriods * period || !isStraight(run.spots)))
    return {fittedTo(length, {dash, period - dash}), 0};
  const glm::dvec2 along = (run.spots.back().at - run.spots.front().at) / length;
  const double place = glm::dot(run.spots.front().at, along) + dash / 2; // from the middle of a dash
  return {{dash, period - dash}, place - std::floor(place / period) * period};
}

Pen penOf(const DrawnLine &line, const Run &run, const LineRoom &room) {
  Pen pen{line.color, line.width, line.dashes, line.dashStart + run.begin};
  const bool isDashed = run.veils.isHidden() && room.hidden == HiddenLines::Dashed;
  if (isDashed)
    pen.width *= hiddenWidth;
  if (isDashed && pen.dashes.empty()) {
    HiddenRhythm rhythm = hiddenRhythmOf(run, line.isStep, room.paper.designPoint());
    pen.dashes = std::move(rhythm.dashes);
    pen.dashStart = rhythm.start;
  }
  pen.cap = pen.dashes.empty() && !line.isStep ? Pen::Cap::Round : Pen::Cap::Flat;
  return pen;
}

PaintedThing thingOf(const DrawnLine &line, Run run, const LineRoom &room) {
  std::vector<glm::dvec2> spots;
  std::transform(run.spots.begin(), run.spots.end(), std::back_inserter(spots),
                 [](const Spot &spot) { return spot.at; });
  const bool isWhole = line.isClosed && spots.size() > 2 && spots.front() == spots.back();
  PaintedThing thing;
  thing.parts.push_back(
      {smoothPath(spots, isWhole), {}, penOf(line, run, room), line.mark, run.veils.isHidden()});
  thing.reach = line.width / 2;
  thing.spine = std::move(run.spots);
  thing.veils = std::move(run.veils);
  return thing;
}

} // namespace

std::vector<PaintedThing> piecesOf(const DrawnLine &line, const LineRoom &room) {
  std::vector<PaintedThing> things;
  if (line.path.size() < 2)
    return things;
  for (Run &run : runsOf(line, room))
    if (run.length() > leastWritten)
      things.push_back(thingOf(line, std::move(run), room));
  return things;
}

double lengthOnPage(const Place &from, const Place &to, const Paper &paper) {
  const auto seen = paper.seenPart(from, to);
  return seen ? glm::distance(paper.spotOf(glm::mix(from, to, seen->first)).at,
                              paper.spotOf(glm::mix(from, to, seen->second)).at)
              : 0;
}

Rhythm fittedTo(double length, Rhythm rhythm) {
  const double period = std::accumulate(rhythm.begin(), rhythm.end(), 0.0);
  const double rounds = std::clamp(std::round((length + rhythm.back()) / period), 1.0, mostRounds);
  const double stretch = length / (rounds * period - rhythm.back());
  for (double &each : rhythm)
    each *= stretch;
  return rhythm;
}

} // namespace halfspace
