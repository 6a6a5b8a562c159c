#include "app/export/size_words.h"

#include "widgets/exports/paper_look.h"
#include "widgets/text/figures.h"

#include <QCoreApplication>
#include <QStringList>

namespace halfspace {
namespace {

struct SizeWords {
  Q_DECLARE_TR_FUNCTIONS(halfspace::SizeWords)
};

/// More digits are for nobody: a tenth of a millimetre, a kilobyte of a hundred.
constexpr int mostDigits = 3;
constexpr double bytesPerKilobyte = 1e3;
constexpr double bytesPerMegabyte = 1e6;

QString centimetres(double points) { return roundedText(points / pointsPerCentimetre, mostDigits); }

} // namespace

QString toWords(const FigureExtent &extent) {
  QStringList parts;
  if (extent.onPaper)
    parts << SizeWords::tr("%1 × %2 cm").arg(centimetres(extent.onPaper->x), centimetres(extent.onPaper->y));
  if (extent.inPixels)
    parts << SizeWords::tr("%1 × %2 pixels").arg(extent.inPixels->width).arg(extent.inPixels->height);
  return parts.join(", ");
}

QString bytesInWords(std::size_t bytes) {
  const auto count = static_cast<double>(bytes);
  return count < bytesPerMegabyte
             ? SizeWords::tr("%1 KB").arg(roundedText(count / bytesPerKilobyte, mostDigits - 1))
             : SizeWords::tr("%1 MB").arg(roundedText(count / bytesPerMegabyte, mostDigits - 1));
}

} // namespace halfspace
