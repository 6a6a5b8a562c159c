// The horizontal strokes of glyphs on whole rows of pixels.
#include "widgets/typeset/sharp_bars.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace halfspace;

Q_DECLARE_METATYPE(QPainterPath)

namespace {

constexpr double em = 20;

QPainterPath bars(const std::vector<QRectF> &rects) {
  QPainterPath path;
  for (const QRectF &rect : rects)
    path.addRect(rect);
  return path;
}

/// The parts of the path, from top to bottom.
std::vector<QRectF> parts(const QPainterPath &path) {
  std::vector<QRectF> boxes;
  for (const QPolygonF &polygon : path.toSubpathPolygons())
    boxes.push_back(polygon.boundingRect());
  std::sort(boxes.begin(), boxes.end(), [](const QRectF &a, const QRectF &b) { return a.top() < b.top(); });
  return boxes;
}

bool isWhole(double number) { return std::abs(number - std::round(number)) < 1e-6; }

} // namespace

class SharpBarsTest : public QObject {
  Q_OBJECT

private slots:
  void bar_drawnWithItsPen_fillsWholeRowsNearWhereItWas_data() {
    QTest::addColumn<double>("top");
    QTest::addColumn<double>("thickness");
    QTest::addColumn<double>("pen");
    QTest::addColumn<int>("rows");
    QTest::newRow("thin") << -5.3 << 0.4 << 0.0 << 1;
    QTest::newRow("nearly one row") << -5.3 << 0.9 << 0.0 << 1;
    QTest::newRow("nearly two rows") << -5.8 << 1.6 << 0.0 << 2;
    QTest::newRow("thin with a pen") << -5.3 << 0.9 << 0.3 << 1;
    QTest::newRow("two rows by the pen") << -5.3 << 1.2 << 0.5 << 2;
    QTest::newRow("below the baseline") << 3.7 << 1.1 << 0.2 << 1;
  }
  void bar_drawnWithItsPen_fillsWholeRowsNearWhereItWas() {
    QFETCH(double, top);
    QFETCH(double, thickness);
    QFETCH(double, pen);
    QFETCH(int, rows);
    const QRectF bar(1, top, 12, thickness);
    const QRectF moved = parts(withSharpBars(bars({bar}), em, pen)).at(0);
    QVERIFY(isWhole(moved.top() - pen / 2));
    QVERIFY(isWhole(moved.bottom() + pen / 2));
    QCOMPARE(qRound(moved.height() + pen), rows);
    QVERIFY(std::abs(moved.center().y() - bar.center().y()) <= 0.5);
    QCOMPARE(moved.left(), bar.left());
    QCOMPARE(moved.right(), bar.right());
  }

  void shapeWithoutALongThinBar_staysAsItIs_data() {
    QTest::addColumn<QPainterPath>("path");
    QPainterPath slanted(QPointF(0, -5.3));
    slanted.lineTo(12, -4.3);
    slanted.lineTo(12, -3.3);
    slanted.lineTo(0, -4.3);
    slanted.closeSubpath();
    QPainterPath round;
    round.addEllipse(QRectF(0.3, -9.7, 9, 9));
    QTest::newRow("empty") << QPainterPath();
    QTest::newRow("serif") << bars({{1, -5.3, 5.9, 1.1}});
    QTest::newRow("block") << bars({{1, -5.3, 12, 2.5}});
    QTest::newRow("slanted") << slanted;
    QTest::newRow("round") << round;
  }
  void shapeWithoutALongThinBar_staysAsItIs() {
    QFETCH(QPainterPath, path);
    QCOMPARE(withSharpBars(path, em, 0.3), path);
  }

  void longAndThinIsMeant_byTheSizeOfTheType() {
    const QPainterPath path = bars({{1, -5.3, 12, 1.1}});
    QVERIFY(withSharpBars(path, 20, 0) != path);
    QCOMPARE(withSharpBars(path, 50, 0), path); // there it is a serif
    QCOMPARE(withSharpBars(path, 9, 0), path);  // and there a block
  }

  void barsOfAnEqualsSign_areEquallyThick_andDoNotMeet() {
    for (const double size : {9.0, 13.7, 20.0, 24.32, 41.0}) {
      const auto equals = parts(withSharpBars(
          bars({{0, -0.4 * size, 0.6 * size, 0.05 * size}, {0, -0.2 * size, 0.6 * size, 0.05 * size}}), size,
          0));
      QCOMPARE(equals.size(), std::size_t(2));
      QVERIFY(std::abs(equals[0].height() - equals[1].height()) < 1e-6);
      QVERIFY(isWhole(equals[0].top()) && isWhole(equals[1].top()));
      QVERIFY(equals[1].top() - equals[0].bottom() >= 1 - 1e-6);
    }
  }

  void restOfTheGlyph_goesWithItsBars_andKeepsItsOrder() {
    // A plus, whose upright reaches above and below the bar, and a mark between two bars.
    const QRectF bar(0, -5.3, 12, 1.1);
    const auto plus = parts(withSharpBars(bars({{5, -11, 1, 13}, bar}), em, 0));
    const double shift = plus[1].top() - bar.top();
    QVERIFY(std::abs(plus[0].top() - (-11 + shift)) < 1e-6);
    QVERIFY(isWhole(plus[1].bottom()));
    const auto between =
        parts(withSharpBars(bars({{0, -9.3, 12, 1.1}, {5, -7, 1, 1}, {0, -4.4, 12, 1.1}}), em, 0));
    QVERIFY(between[0].bottom() < between[1].top());
    QVERIFY(between[1].bottom() < between[2].top());
  }
};

QTEST_MAIN(SharpBarsTest)
#include "sharp_bars_test.moc"
