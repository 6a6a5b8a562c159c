#include "widgets/handout/handout_look.h"

#include "widgets/exports/lengths.h"

namespace halfspace {
namespace {

constexpr glm::dvec2 a4{595.276, 841.89};
constexpr glm::dvec2 letter{612, 792};
/// As wide as some 75 letters of the type.
constexpr double singleColumn = 148 * pointsPerMillimetre;
constexpr double singleType = 11;
constexpr double doubleSide = 18 * pointsPerMillimetre;
constexpr double doubleGutter = 8 * pointsPerMillimetre;
constexpr double doubleType = 9.5;
constexpr double topMargin = 25 * pointsPerMillimetre;
constexpr double bottomMargin = 26 * pointsPerMillimetre;

} // namespace

HandoutLook handoutLook(HandoutPaper paper, int columns) {
  HandoutLook look;
  look.page = paper == HandoutPaper::A4 ? a4 : letter;
  look.columns = columns;
  look.top = topMargin;
  look.bottom = bottomMargin;
  look.isJustified = columns == 1;
  look.side = columns == 1 ? (look.page.x - singleColumn) / 2 : doubleSide;
  look.gutter = columns == 1 ? 0 : doubleGutter;
  look.typeSize = columns == 1 ? singleType : doubleType;
  return look;
}

} // namespace halfspace
