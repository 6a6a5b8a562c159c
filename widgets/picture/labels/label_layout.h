// Where labels go on the screen: beside what they name, clear of one another, of points and of lines, within
// the part of the screen that nothing covers.
#pragma once

#include "widgets/picture/labels/label_options.h"

#include <map>
#include <optional>
#include <string>

namespace halfspace {

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
  /// Labels without an anchor on the screen are left out, and pinned and passing ones without room. One that
  /// somebody has put beside the screen is left out, too; one on its edge is moved inside. Sizes and
  /// distances are multiplied by the pixel ratio.
  [[nodiscard]] std::vector<PlacedLabel> place(const std::vector<LabelRequest> &requests,
                                               const LabelObstacles &obstacles, PixelSize size,
                                               double pixelRatio);

private:
  /// By the label's number, while they are placed.
  using Placed = std::vector<std::optional<LabelCandidate>>;

  /// The cost of a label's candidate beside all else that is on the screen; any number beyond the limit once
  /// that is passed.
  [[nodiscard]] static double costOf(const LabelCandidate &candidate, std::size_t label,
                                     const LabelOptions &options, const Placed &placed, double limit);

  /// The place where a label was, if nothing is wrong with it.
  [[nodiscard]] std::optional<LabelCandidate>
  keptFor(std::size_t label, const std::string &id, const LabelOptions &options, const Placed &placed) const;
  /// That, or else the cheapest place for a label beside what is placed so far; nothing where it may stand
  /// nowhere.
  [[nodiscard]] std::optional<LabelCandidate>
  bestFor(std::size_t label, const std::string &id, const LabelOptions &options, const Placed &placed) const;

  /// What a label chose: for its place, or else where it was.
  [[nodiscard]] std::optional<LabelChoice> currentChoice(const std::string &id,
                                                         const std::optional<LabelCandidate> &placed) const;

  /// Gives two labels that are in each other's way the two places that are best together.
  void placeTogether(std::size_t first, std::size_t second, const std::vector<LabelRequest> &requests,
                     const std::vector<LabelOptions> &options, Placed &placed) const;

  /// Places a label together with each that is in its way.
  void untangle(std::size_t first, const std::vector<std::size_t> &labels,
                const std::vector<LabelRequest> &requests, const std::vector<LabelOptions> &options,
                Placed &placed) const;
  [[nodiscard]] static double costOfAll(const std::vector<std::size_t> &labels,
                                        const std::vector<LabelOptions> &options, const Placed &placed,
                                        double limit);
  /// All places with one label at a certain one, and those that are in its way there at the best ones then.
  [[nodiscard]] Placed withRoomFor(const LabelCandidate &candidate, std::size_t first,
                                   const std::vector<std::size_t> &labels,
                                   const std::vector<LabelRequest> &requests,
                                   const std::vector<LabelOptions> &options, Placed placed) const;
  /// Gives a label that is hard to read one of its better places, where that is best for all labels together.
  void makeRoom(std::size_t first, const std::vector<std::size_t> &labels,
                const std::vector<LabelRequest> &requests, const std::vector<LabelOptions> &options,
                Placed &placed) const;
  /// All labels that stand beside something begin where they were, so that nothing moves without a reason.
  /// Each takes the best place beside those placed before it; then, beside all others, until none moves. Two
  /// that are in each other's way, and neither of which comes away alone, are placed together.
  void placeBeside(const std::vector<LabelRequest> &requests, const std::vector<LabelOptions> &options,
                   PixelSize size, Placed &placed) const;

  /// Whether a label can be read at a place, beside what is placed.
  [[nodiscard]] static bool canBeRead(const LabelCandidate &there, std::size_t label,
                                      const LabelOptions &options, const Placed &placed);
  /// Writes those of a row of pinned labels that there is room for beside what else is placed.
  static void pinRow(const std::vector<std::size_t> &row, const std::vector<LabelRequest> &requests,
                     const std::vector<LabelOptions> &options, Placed &placed);

  /// What is placed, remembered for the next frame.
  [[nodiscard]] std::vector<PlacedLabel> taken(const std::vector<LabelRequest> &requests,
                                               const Placed &placed);

  std::map<std::string, LabelChoice> m_choices;
};

} // namespace halfspace
