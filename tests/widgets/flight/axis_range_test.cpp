// The part of the parameter that an axis shows, its ticks and its pixels.
#include "widgets/flight/axis_range.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace halfspace;

class AxisRangeTest : public QObject {
  Q_OBJECT

private slots:
  void range_withoutHits_isTheSmallest() {
    QCOMPARE(rangeFor({}, 0).low, -0.5);
    QCOMPARE(rangeFor({}, 0).high, 2.0);
  }

  void range_ofAnyHits_containsTheNearestAndThePresent() {
    std::mt19937 random(7);
    std::lognormal_distribution<double> size(0, 4);
    for (int i = 0; i < 2000; ++i) {
      const double nearest = size(random);
      const double t = (i % 2 == 0 ? 1 : -1) * size(random);
      const AxisRange range = rangeFor({nearest, nearest + size(random), -size(random)}, t);
      QVERIFY(range.contains(nearest) && range.contains(t));
      QVERIFY(range.contains(-0.5) && range.contains(2));
    }
  }

  void range_ofAHitFarBeyondTheNearest_leavesItOut() {
    QVERIFY(!rangeFor({1, 500}, 0).contains(500));
    QVERIFY(rangeFor({1, 10}, 0).contains(10));
    QVERIFY(rangeFor({300, 500}, 0).contains(500));
  }

  void range_ofAHitThatMovesALittle_staysMostly() {
    int changes = 0;
    for (int i = 0; i < 100; ++i)
      changes += rangeFor({3 + i / 100.0}, 0) != rangeFor({3 + (i + 1) / 100.0}, 0);
    QVERIFY(changes <= 4);
  }

  void scale_thereAndBack_isWhereItWas() {
    const AxisScale scale{{-0.5, 7.25}, 22, 411};
    double before = 0;
    for (double t = -0.5; t <= 7.25; t += 0.03125) {
      QVERIFY(std::abs(scale.tAt(scale.xOf(t)) - t) < 1e-12);
      QVERIFY(scale.xOf(t) > before);
      before = scale.xOf(t);
    }
  }

  void ticks_ofAnyRange_areApartAndInside() {
    std::mt19937 random(11);
    std::lognormal_distribution<double> size(0, 5);
    for (int i = 0; i < 500; ++i) {
      const double high = size(random);
      const AxisScale scale{{-size(random), high}, 20, 420};
      const AxisTicks ticks = ticksOf(scale, 40);
      const double apart = scale.xOf(toDouble(ticks.step)) - scale.xOf(0);
      QVERIFY(apart >= 39.999 && apart <= 100.001);
      for (const Rational &tick : ticks.at)
        QVERIFY(scale.xOf(toDouble(tick)) > 19.99 && scale.xOf(toDouble(tick)) < 420.01);
    }
  }
};

QTEST_APPLESS_MAIN(AxisRangeTest)
#include "axis_range_test.moc"
