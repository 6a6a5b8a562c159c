// How a crossing stands, in words and as a mark.
#include "tests/widgets/flight/some_crossings.h"
#include "widgets/flight/crossing_look.h"

#include <QImage>
#include <QPainter>
#include <QtTest>

#include <array>

using namespace halfspace;
using namespace halfspace::test;

namespace {

QImage markOf(Standing standing) {
  QImage image(40, 40, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  paintMark(painter, {20, 20}, 8, standing, Qt::black);
  return image;
}

} // namespace

class CrossingLookTest : public QObject {
  Q_OBJECT

private slots:
  void standing_ofEachCase_isTheCase_andTheNearestIsFirst() {
    const Crossings crossings = someCrossings();
    QCOMPARE(standingOf(crossings.all[0], crossings), Standing::Behind);
    QCOMPARE(standingOf(crossings.all[1], crossings), Standing::First);
    QCOMPARE(standingOf(crossings.all[2], crossings), Standing::Hit);
    QCOMPARE(standingOf(crossings.all[4], crossings), Standing::Outside);
    QCOMPARE(standingOf(crossings.all[5], crossings), Standing::Parallel);
  }

  void standing_ofAHitAsNearAsTheFirst_saysSo_whileALaterOneIsAHit() {
    Crossings crossings = someCrossings();
    crossings.all[2].at->t = crossings.all[1].at->t;
    QCOMPARE(standingOf(crossings.all[1], crossings), Standing::First);
    QCOMPARE(standingOf(crossings.all[2], crossings), Standing::FirstToo);
    QCOMPARE(standingOf(crossings.all[3], crossings), Standing::Hit);
    QCOMPARE(wordsOf(Standing::FirstToo), QString("hit first, too"));
    crossings.all[2].which = RayTriangleCase::Miss; // in the plane of the first, and beside it
    QCOMPARE(standingOf(crossings.all[2], crossings), Standing::Outside);
  }

  void standing_whileOneAfterTheOtherIsAsked_ofLaterOnesIsOpen() {
    Crossings crossings = someCrossings();
    crossings.chosen = 2;
    crossings.nearestSoFar = 1;
    QCOMPARE(standingOf(crossings.all[2], crossings), Standing::FirstSoFar);
    QCOMPARE(standingOf(crossings.all[1], crossings), Standing::NotAsked); // the nearest of all
    QCOMPARE(standingOf(crossings.all[5], crossings), Standing::Parallel);
    crossings.nearestSoFar = 0; // none was hit so far
    QCOMPARE(standingOf(crossings.all[1], crossings), Standing::NotAsked);
  }

  void standing_onceAllHaveBeenAsked_isFinal() {
    Crossings crossings = someCrossings();
    crossings.chosen = 6;
    crossings.nearestSoFar = 3;
    QCOMPARE(standingOf(crossings.all[1], crossings), Standing::First);
  }

  void sentence_ofARoundedNumber_hasNoEquals() {
    const Crossing exact = crossingAt(3, RayTriangleCase::Hit, Rational(1, 2));
    QCOMPARE(sentenceOf(exact, Standing::First), QString("barn 3: λ = 1/2, hit first"));
    const Crossing rounded = crossingAt(3, RayTriangleCase::Hit, Rational(12345677, 10000019));
    QCOMPARE(sentenceOf(rounded, Standing::Hit), QString("barn 3: λ ≈ 1.23457, hit"));
    QCOMPARE(sentenceOf({2, "barn 2", RayTriangleCase::Parallel, {}}, Standing::Parallel),
             QString("barn 2: parallel"));
    QVERIFY(!sentenceOf(exact, Standing::NotAsked).contains("1/2"));
  }

  void marks_seenWithoutColours_differInShape() {
    const std::array standings{Standing::First, Standing::Hit, Standing::Behind, Standing::Outside};
    for (const Standing a : standings)
      for (const Standing b : standings)
        QCOMPARE(markOf(a) == markOf(b), a == b);
    QCOMPARE(markOf(Standing::Behind).pixelColor(20, 20), QColor(Qt::white)); // hollow
    QCOMPARE(markOf(Standing::Hit).pixelColor(20, 20), QColor(Qt::black));
  }
};

QTEST_MAIN(CrossingLookTest)
#include "crossing_look_test.moc"
