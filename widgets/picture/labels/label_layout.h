// Where labels go on the screen: beside what they name, clear of one another, of points and of lines, within
// the part of the screen that nothing covers.
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

/// How a label stands.
enum class LabelStand {
  Beside, ///< where it is clear of everything, as near to an anchor as can be
  Pinned, ///< centred on its first anchor, or nowhere: where something is already there, it is left out
  Passing ///< beside an anchor, but soon gone: those beside stay where they are; or nowhere
};

/// A label to be placed. Its anchors are tried in order of liking; those off the screen do not count.
struct LabelRequest {
  std::string id;
  glm::dvec2 extent{}; ///< width and height in pixels
  std::vector<LabelAnchor> anchors;
  LabelStand stand = LabelStand::Beside;
};

/// What labels should not cover.
struct LabelObstacles {
  struct Disc {
    glm::dvec2 center{};
    double radius = 0;
    bool hasLabel =
        false; ///< a point with a name, which a label nearer to it than to its own would seem to be
  };
  struct Segment {
    glm::dvec2 from{};
    glm::dvec2 to{};
    bool isThick = false; ///< an axis or an arrow: crossed by one, a label cannot be read
  };
  std::vector<Disc> discs;       ///< points, heads of arrows and knobs
  std::vector<Segment> segments; ///< lines: better not crossed
  std::vector<Segment> ticks;    ///< of the axes, beside which their pinned numbers stand anyway
  std::vector<Segment> tools;    ///< lines of the hand's tools, for which only passing labels make room
  std::vector<PixelBox> covered; ///< what lies over the picture: never reached
};

/// A label's place: the top left pixel, and the anchor that it belongs to.
struct PlacedLabel {
  std::string id;
  glm::dvec2 topLeft{};
  glm::dvec2 extent{};
  glm::dvec2 anchor{};
  bool needsLeader = false; ///< it had to move far from its anchor
};

/// Places labels from frame to frame: a label stays on the side where it was for as long as nothing comes
/// upon it there, and goes back beside its anchor when it can.
class LabelLayout {
public:
  /// Labels without an anchor on the screen are left out, and pinned and passing ones without room. Sizes and
  /// distances are multiplied by the pixel ratio.
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
  class Options;
  struct Board;

  /// The cost of a candidate beside all else that is on the screen; any number beyond the limit once that is
  /// passed.
  [[nodiscard]] static double costOf(const Candidate &candidate, std::size_t label,
                                     const LabelObstacles &obstacles, const Board &board, double limit);

  /// The place where a label was, if nothing is wrong with it.
  [[nodiscard]] std::optional<Candidate> keptFor(std::size_t label, const std::string &id,
                                                 const Options &options, const Board &board) const;
  /// That, or else the cheapest place for a label beside what is placed so far; nothing where it may stand
  /// nowhere.
  [[nodiscard]] std::optional<Candidate> bestFor(std::size_t label, const std::string &id,
                                                 const Options &options, const Board &board) const;

  /// Gives two labels that lie on one another the two places that are best together.
  void placeTogether(std::size_t first, std::size_t second, const std::vector<LabelRequest> &requests,
                     const std::vector<Options> &options, Board &board) const;

  /// Places each label together with those that it lies on.
  void untangle(std::size_t first, const std::vector<std::size_t> &labels,
                const std::vector<LabelRequest> &requests, const std::vector<Options> &options,
                Board &board) const;
  /// All labels that stand beside something begin where they were, so that nothing moves without a reason.
  /// Each takes the best place beside those placed before it; then, beside all others. Two that are in each
  /// other's way, and neither of which comes away alone, are placed together.
  void placeBeside(const std::vector<LabelRequest> &requests, const std::vector<Options> &options,
                   Board &board) const;

  /// What is placed, remembered for the next frame.
  [[nodiscard]] std::vector<PlacedLabel> taken(const std::vector<LabelRequest> &requests, const Board &board);

  std::map<std::string, Choice> m_choices;
};

} // namespace halfspace
