// Where one label may stand on the screen, and what it may come upon there.
#pragma once

#include "widgets/picture/camera.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace halfspace {

/// Says whose a label is: each mark that has one has a number.
using LabelOwner = std::size_t;
inline constexpr LabelOwner nobody = std::numeric_limits<LabelOwner>::max();

/// A place on the screen that a label may stand beside.
struct LabelAnchor {
  glm::dvec2 pixel{};
  glm::dvec2 toward{1, -1}; ///< the side where the label is best, need not be unit
  double clearance = 0;     ///< pixels around the anchor that the mark itself covers
};

/// How a label stands.
enum class LabelStand {
  Beside,  ///< where it is clear of everything, as near to an anchor as can be
  Pinned,  ///< centred on its first anchor, or nowhere: where something is already there, it is left out
  Passing, ///< beside an anchor, but soon gone: those beside stay where they are; or nowhere
  ByHand   ///< where somebody has put it, whatever is there
};

/// The place of a pinned label among those of its row, as the numbers at an axis are. Rows are counted from
/// 1; in row 0 each label stands for itself.
struct LabelRow {
  std::size_t number = 0;
  int place = 0;
};

/// A label to be placed. Its anchors are tried in order of liking; those off the screen do not count.
struct LabelRequest {
  std::string id;
  glm::dvec2 extent{}; ///< width and height in pixels
  std::vector<LabelAnchor> anchors;
  LabelStand stand = LabelStand::Beside;
  LabelOwner owner = nobody;
  LabelRow row{};
  glm::dvec2 offset{}; ///< by hand: from its one anchor to its middle
};

/// What labels should not cover.
struct LabelObstacles {
  struct Disc {
    glm::dvec2 center{};
    double radius = 0;
    LabelOwner owner = nobody; ///< of its label, where it is a point that has one
  };
  struct Segment {
    glm::dvec2 from{};
    glm::dvec2 to{};
    bool isThick = false;      ///< an axis or an arrow: crossed by one, a label cannot be read
    LabelOwner owner = nobody; ///< of its label, where it is a line or an arrow that has one
  };
  std::vector<Disc> discs;       ///< points, heads of arrows and knobs
  std::vector<Segment> segments; ///< lines: better not crossed
  std::vector<Segment> ticks;    ///< of the axes, beside which their pinned numbers stand anyway
  std::vector<Segment> tools;    ///< lines of the hand's tools, for which only passing labels make room
  std::vector<PixelBox> covered; ///< what lies over the picture: never reached
};

/// What a label chooses: the anchor's number, the direction's and the distance's.
struct LabelChoice {
  std::size_t anchor = 0;
  std::size_t direction = 0;
  std::size_t distance = 0;
  bool operator==(const LabelChoice &) const = default;
  /// So far from its anchor that a line leads there.
  [[nodiscard]] bool needsLeader() const;
};

/// A place for a label.
struct LabelCandidate {
  LabelChoice choice;
  PixelBox box;
  double cost = 0; ///< by itself, whatever else is on the screen: as well as it is liked
  glm::dvec2 anchor{};
  double clearance = 0;
  PixelBox room{}; ///< the box and so much to its sides that what stands there is not read together with it
};

/// The line that leads from an anchor to a label's box.
[[nodiscard]] LabelObstacles::Segment leaderTo(const PixelBox &box, glm::dvec2 anchor);

/// The part of the screen that labels may stand on.
struct LabelScreen {
  PixelSize size;
  double pixelRatio = 1;
  std::vector<PixelBox> covered; ///< what lies over it
  [[nodiscard]] bool isCovered(const PixelBox &box) const;
};

/// The places of one label, and the obstacles that it may come upon: each of these is looked at once for a
/// label before it is for each of its places. Mostly a label stays where it was, and its other places are
/// never worked out.
class LabelOptions {
public:
  /// Requires that request and screen live longer.
  LabelOptions(const LabelRequest &request, const LabelScreen &screen, const LabelObstacles &all);

  [[nodiscard]] const LabelObstacles &obstacles() const { return m_obstacles; }
  /// All places, the cheapest first.
  [[nodiscard]] const std::vector<LabelCandidate> &candidates() const;
  /// The place of a choice; nothing where the label may not stand there any more. Not for what is pinned.
  [[nodiscard]] std::optional<LabelCandidate> chosen(const LabelChoice &choice) const;

  /// From a label at a place to what it names: to the nearest of its lines, or else to the edge of what
  /// covers its anchor; negative within that.
  [[nodiscard]] double reachToOwn(const LabelCandidate &candidate) const;
  /// Whether a label at a place, so far from what it names, would be taken for that of a point: it stands
  /// nearer to that, from edge to edge or from middle to middle, or beside a line's end that lies in the
  /// point. A leader tells whose it is.
  [[nodiscard]] bool isTakenForThatOf(const LabelObstacles::Disc &disc, const LabelCandidate &candidate,
                                      double reachToOwn) const;
  /// Or for that of a line, which is as near. Not of one through its anchor: whatever is named there lies on
  /// it; but the label of a thin line, beside an arrow on it, would be the arrow's.
  [[nodiscard]] bool isTakenForThatOf(const LabelObstacles::Segment &line, const LabelCandidate &candidate,
                                      double reachToOwn) const;

private:
  /// What an anchor costs because others on the screen are liked better.
  [[nodiscard]] double costOfAnchor(std::size_t anchor) const;
  [[nodiscard]] std::vector<LabelCandidate> pinned() const;
  [[nodiscard]] std::vector<LabelCandidate> byHand() const;
  [[nodiscard]] std::vector<LabelCandidate> beside() const;
  [[nodiscard]] PixelBox roomAround(const PixelBox &box) const;
  /// Whether a label at a place could be taken for that of something that has an owner.
  [[nodiscard]] bool canBeTakenForThatOf(LabelOwner owner, const LabelCandidate &candidate) const;

  const LabelRequest &m_request;
  const LabelScreen &m_screen;
  LabelObstacles m_obstacles;
  std::vector<LabelObstacles::Segment> m_own; ///< of its obstacles, the lines that it names
  mutable std::optional<std::vector<LabelCandidate>> m_candidates; ///< worked out when asked
};

} // namespace halfspace
