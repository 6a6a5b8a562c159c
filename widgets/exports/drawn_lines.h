// Lines of a figure in space, cut where something stands before them.
#pragma once

#include "widgets/exports/painting.h"
#include "widgets/exports/paper_look.h"

namespace halfspace {

/// A line in space as a pen draws it; lengths on the page are in points.
struct DrawnLine {
  std::string mark;
  Color color;
  std::vector<Place> path;
  bool isClosed = false;
  double width = 1;
  Rhythm dashes{};      ///< empty: it is whole
  double dashStart = 0; ///< how far into the rhythm it begins
  bool isStep =
      false; ///< of several on one straight line, which differ in colour: none reaches into the next
};

/// Where lines are drawn, and how.
struct LineRoom {
  const Paper &paper;
  const Veils &veils;
  HiddenLines hidden;
  Questions &questions; ///< that are left to all that is drawn there
};

/// The pieces of a line, each to be painted at one time. A closed line and one with corners stay in one piece
/// where they can. A line that is seen from its end has none.
[[nodiscard]] std::vector<PaintedThing> piecesOf(const DrawnLine &line, const LineRoom &room);

/// How long a straight piece is on the page, as far as it is seen.
[[nodiscard]] double lengthOnPage(const Place &from, const Place &to, const Paper &paper);

/// More rounds of a rhythm than this are not told apart any more.
inline constexpr double mostRounds = 400;

/// Dashes in a rhythm, stretched or shrunk as it takes for one to begin and one to end at the ends of a line
/// of a length; as addDashes does.
[[nodiscard]] Rhythm fittedTo(double length, Rhythm rhythm);

} // namespace halfspace
