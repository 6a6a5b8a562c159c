// Labels as images with a halo.
#include "widgets/typeset/label_painter.h"

#include "widgets/picture/labels/label_setter.h"
#include "widgets/typeset/typesetter.h"

#include <QtTest>

using namespace halfspace;

namespace {

const LabelStyle style{{200, 0, 0}, {255, 255, 255}, 22};

struct Texel {
  int red, green, blue, alpha;
};

Texel at(const RgbaImage &label, int x, int y) {
  const std::size_t i = 4 * static_cast<std::size_t>(y * label.width + x);
  return {label.rgba[i], label.rgba[i + 1], label.rgba[i + 2], label.rgba[i + 3]};
}

} // namespace

class LabelPainterTest : public QObject {
  Q_OBJECT

private slots:
  void labelHasInkHaloAndAClearRim() {
    Typesetter typesetter;
    const LabelSetter set = labelSetter(typesetter.fonts());
    const LabelPainter paint = labelPainter(typesetter);
    const auto label = paint(set("\\mark{n}{\\rule{2em}{1em}}"), style);
    QVERIFY(label);
    QCOMPARE(label->rgba.size(), static_cast<std::size_t>(4 * label->width * label->height));
    const Texel center = at(*label, label->width / 2, label->height / 2);
    QCOMPARE(center.red, 200); // the style's ink, for marks too
    QCOMPARE(center.green, 0);
    QCOMPARE(center.alpha, 255);
    QCOMPARE(at(*label, 0, 0).alpha, 0);
    const Texel halo = at(*label, 2, label->height / 2);
    QVERIFY(halo.alpha > 200);
    QVERIFY(halo.green > 200);
  }

  void twiceTheTypeGivesTwiceThePicture() {
    Typesetter typesetter;
    const LabelSetter set = labelSetter(typesetter.fonts());
    const LabelPainter paint = labelPainter(typesetter);
    LabelStyle large = style;
    large.pixelSize *= 2;
    const auto one = paint(set("P_0"), style);
    const auto two = paint(set("P_0"), large);
    QVERIFY(std::abs(two->width - 2 * one->width) <= 6);
    QVERIFY(std::abs(two->height - 2 * one->height) <= 6);
  }

  void sameRequestGivesTheSamePicture() {
    Typesetter typesetter;
    const LabelSetter set = labelSetter(typesetter.fonts());
    const LabelPainter paint = labelPainter(typesetter);
    const auto formula = set("P_1");
    QCOMPARE(paint(formula, style), paint(formula, style));
    LabelStyle other = style;
    other.ink = {0, 0, 1};
    QVERIFY(paint(formula, style) != paint(formula, other));
  }
};

QTEST_MAIN(LabelPainterTest)
#include "label_painter_test.moc"
