// Where labels go on the screen: beside what they name, clear of one another and of points, within the
// screen.
#pragma once

#include "widgets/picture/camera.h"

#include <map>
#include <optional>
#include <string>

namespace halfspace {

/// A place on the screen that a label may stand beside.
struct LabelAnchor {
  glm::dvec2 pixel{};
  glm::dvec2 toward{1, -1}; ///< the side where the label is best, need not be unit
  double clearance = 0;     ///< pixels around the anchor that the mark itself covers
};

/// A label to be placed. Its anchors are tried in order of liking; those off the screen do not count.
struct LabelRequest {
  std::string id;
  glm::dvec2 extent{}; ///< width and height in pixels
  std::vector<LabelAnchor> anchors;
  bool isPinned = false; ///< centred on its first anchor, whatever else is there
  bool yields = false;   ///< stands beside all others, which take no notice of it
};

/// What labels should not cover.
struct LabelObstacles {
  struct Disc {
    glm::dvec2 center{};
    double radius = 0;
  };
  struct Segment {
    glm::dvec2 from{};
    glm::dvec2 to{};
  };
  std::vector<Disc> discs;       ///< points: hardly ever covered
  std::vector<Segment> segments; ///< lines: better not crossed
};

/// A label's place: the top left pixel, and the anchor that it belongs to.
struct PlacedLabel {
  std::string id;
  glm::dvec2 topLeft{};
  glm::dvec2 extent{};
  glm::dvec2 anchor{};
  bool needsLeader = false; ///< it had to move far from its anchor
};

/// Places labels from frame to frame: a label stays on the side where it was unless another is clearly
/// better.
class LabelLayout {
public:
  /// Labels without an anchor on the screen are left out. Sizes and distances are multiplied by the pixel
  /// ratio.
  [[nodiscard]] std::vector<PlacedLabel> place(const std::vector<LabelRequest> &requests,
                                               const LabelObstacles &obstacles, PixelSize size,
                                               double pixelRatio);

private:
  /// What a label chose: the anchor's number, the direction's and the distance's.
  struct Choice {
    std::size_t anchor = 0;
    std::size_t direction = 0;
    std::size_t distance = 0;
    bool operator==(const Choice &) const = default;
  };
  struct Candidate;
  struct Options;
  struct Board;

  [[nodiscard]] static std::vector<Candidate> candidatesOf(const LabelRequest &request, const Board &board);
  /// The cost of a candidate beside all else that is on the screen; any number beyond the limit once that is
  /// passed.
  [[nodiscard]] static double costOf(const Candidate &candidate, std::size_t label,
                                     const LabelObstacles &obstacles, const Board &board, double limit);

  /// The cheapest place for a label beside what is placed so far; nothing where it may stand nowhere.
  [[nodiscard]] std::optional<Candidate> cheapestFor(std::size_t label, const std::string &id,
                                                     const Options &options, const Board &board) const;

  std::map<std::string, Choice> m_choices;
};

} // namespace halfspace
