#include "widgets/typeset/label_painter.h"

#include "widgets/colors.h"
#include "widgets/typeset/typesetter.h"

#include <QCache>
#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace halfspace {

namespace {

/// The halo reaches this far around the strokes, in em.
constexpr double haloWidth = 0.11;
/// Nothing that is to be read is drawn larger.
constexpr int largestLabelSide = 4096;
/// How many labels are kept.
constexpr int mostKept = 400;

struct Label {
  QString latex;
  LabelStyle style;
  bool operator==(const Label &) const = default;
};
auto qHash(const Label &label) { return ::qHash(label.latex); }

LabelPicture fromImage(const QImage &image) {
  const QImage straight = image.convertToFormat(QImage::Format_RGBA8888);
  LabelPicture picture{straight.width(), straight.height(), {}};
  const auto rowBytes = static_cast<std::size_t>(picture.width) * 4;
  picture.rgba.resize(rowBytes * static_cast<std::size_t>(picture.height));
  for (int row = 0; row < picture.height; ++row)
    std::memcpy(picture.rgba.data() + rowBytes * static_cast<std::size_t>(row), straight.constScanLine(row),
                rowBytes);
  return picture;
}

} // namespace

LabelPicture paintLabel(const MathPicture &formula, const LabelStyle &style) {
  const double em = style.pixelSize;
  const double halo = haloWidth * em;
  const int margin = static_cast<int>(std::ceil(halo)) + 1;
  const auto side = [&](double length) {
    return std::clamp(static_cast<int>(std::ceil(length * em)) + 1 + 2 * margin, 1, largestLabelSide);
  };
  QImage image(side(formula.width()), side(formula.height()), QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  // The baseline stands on a whole pixel, so that labels in a row are equally crisp.
  const QPointF baseline(margin, margin + std::ceil(formula.ascent() * em));
  formula.paintHalo(painter, baseline, em, halo, toQColor(style.halo));
  formula.paint(painter, baseline, em, [&](const QString &) { return toQColor(style.ink); });
  painter.end();
  return fromImage(image);
}

LabelPainter labelPainter(const Typesetter &typesetter) {
  using Picture = std::shared_ptr<const LabelPicture>;
  using Cache = QCache<Label, Picture>;
  return [&typesetter, kept = std::make_shared<Cache>(mostKept)](const std::string &latex,
                                                                 const LabelStyle &style) -> Picture {
    const Label label{QString::fromStdString(latex), style};
    if (const Picture *picture = kept->object(label))
      return *picture;
    auto picture = std::make_shared<const LabelPicture>(paintLabel(*typesetter.picture(label.latex), style));
    kept->insert(label, new Picture(picture));
    return picture;
  };
}

} // namespace halfspace
