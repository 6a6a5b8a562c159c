#include "widgets/typeset/label_painter.h"

#include "widgets/colors.h"
#include "widgets/typeset/typesetter.h"

#include <QCache>
#include <QImage>
#include <QPainter>

#include <cstring>
#include <new>

namespace halfspace {

namespace {

/// How many labels are kept.
constexpr int mostKept = 400;

struct Label {
  LabelFormula formula;
  LabelStyle style;
  bool operator==(const Label &) const = default;
};
auto qHash(const Label &label) { return ::qHash(label.formula.get()); }

} // namespace

RgbaImage fromImage(const QImage &image) {
  const QImage straight = image.convertToFormat(QImage::Format_RGBA8888);
  if (straight.isNull() && !image.isNull()) // as Qt tells it
    throw std::bad_alloc();
  RgbaImage picture{straight.width(), straight.height(), {}};
  const auto rowBytes = static_cast<std::size_t>(picture.width) * 4;
  picture.rgba.resize(rowBytes * static_cast<std::size_t>(picture.height));
  for (int row = 0; row < picture.height; ++row)
    std::memcpy(picture.rgba.data() + rowBytes * static_cast<std::size_t>(row), straight.constScanLine(row),
                rowBytes);
  return picture;
}

QImage toImage(const RgbaImage &image) {
  const QImage sameBytes(image.rgba.data(), image.width, image.height, image.width * 4,
                         QImage::Format_RGBA8888);
  return sameBytes.copy(); // which lives on its own
}

RgbaImage paintLabel(const MathPicture &formula, const LabelStyle &style) {
  const double em = style.pixelSize;
  const LabelRoom room = roomOf(*formula.layout(), style);
  QImage image(room.width, room.height, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  const QPointF baseline(room.left, room.baseline);
  formula.paintHalo(painter, baseline, em, haloWidth * em, toQColor(style.halo));
  formula.paint(painter, baseline, em, [&](const QString &) { return toQColor(style.ink); });
  painter.end();
  return fromImage(image);
}

LabelPainter labelPainter(const Typesetter &typesetter) {
  using Picture = std::shared_ptr<const RgbaImage>;
  return [&typesetter, kept = std::make_shared<QCache<Label, Picture>>(mostKept)](
             const LabelFormula &formula, const LabelStyle &style) -> Picture {
    const Label label{formula, style};
    if (const Picture *picture = kept->object(label))
      return *picture;
    auto picture = std::make_shared<const RgbaImage>(paintLabel(*typesetter.picture(formula), style));
    kept->insert(label, new Picture(picture));
    return picture;
  };
}

} // namespace halfspace
