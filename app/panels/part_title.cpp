#include "app/panels/part_title.h"

#include <QCoreApplication>

namespace halfspace {
namespace {

struct PartTitle {
  Q_DECLARE_TR_FUNCTIONS(halfspace::PartTitle)
};

} // namespace

QString partTitle(bool ShownParts::*part) {
  if (part == &ShownParts::labels)
    return PartTitle::tr("La&bels");
  if (part == &ShownParts::coordinates)
    return PartTitle::tr("Coord&inates");
  if (part == &ShownParts::dropLines)
    return PartTitle::tr("Drop &Lines");
  if (part == &ShownParts::axes)
    return PartTitle::tr("Ax&es");
  return part == &ShownParts::grid ? PartTitle::tr("&Grid") : PartTitle::tr("Sha&dows");
}

} // namespace halfspace
