// Which fragments have a row, and in which order.
#include "lessons/lesson/live_values.h"
#include "tests/widgets/flight/some_crossings.h"
#include "widgets/hit_table/fragment_rows.h"

#include <QtTest>

using namespace halfspace;
using namespace halfspace::test;

namespace {

std::vector<std::size_t> numbersOf(const FragmentRows &shown) {
  std::vector<std::size_t> numbers;
  for (const FragmentRow &row : shown.rows)
    numbers.push_back(row.crossing.number);
  return numbers;
}

using Numbers = std::vector<std::size_t>;

} // namespace

class FragmentRowsTest : public QObject {
  Q_OBJECT

private slots:
  void rows_ofCrossings_standInTheirOrder_partedAtTheStart() {
    const FragmentRows shown = rowsOf(someCrossings(), LiveValues::Shown, 24);
    QCOMPARE(numbersOf(shown), (Numbers{4, 3, 1, 5, 6, 2}));
    for (const FragmentRow &row : shown.rows)
      QCOMPARE(row.beginsRay, row.crossing.number == 3);
    QCOMPARE(shown.leftOut, std::size_t(0));
  }

  void rows_whileHidden_standByNumber_andTellNothing() {
    const FragmentRows shown = rowsOf(someCrossings(), LiveValues::Hidden, 24);
    QCOMPARE(numbersOf(shown), (Numbers{1, 2, 3, 4, 5, 6}));
    for (const FragmentRow &row : shown.rows)
      QVERIFY(!row.beginsRay);
  }

  void rows_ofThoseNotAskedYet_standBehindByNumber() {
    Crossings crossings = someCrossings();
    crossings.chosen = 2;
    crossings.nearestSoFar = 1;
    QCOMPARE(numbersOf(rowsOf(crossings, LiveValues::Shown, 24)), (Numbers{1, 2, 3, 4, 5, 6}));
    crossings.chosen = 4;
    crossings.nearestSoFar = 3;
    QCOMPARE(numbersOf(rowsOf(crossings, LiveValues::Shown, 24)), (Numbers{4, 3, 1, 2, 5, 6}));
  }

  void rows_whereThereIsRoomForFew_areHitsFirst() {
    QCOMPARE(numbersOf(rowsOf(someCrossings(), LiveValues::Shown, 3)), (Numbers{3, 1, 5}));
    Crossings crossings = someCrossings();
    crossings.chosen = 2;
    QCOMPARE(numbersOf(rowsOf(crossings, LiveValues::Shown, 3)), (Numbers{3, 1, 2}));
    QCOMPARE(rowsOf(crossings, LiveValues::Shown, 3).leftOut, std::size_t(3));
    QVERIFY(!rowsOf(crossings, LiveValues::Shown, 3).leftOutAreOutside);
  }

  void rows_ofManyOutside_sayWhatIsLeftOut() {
    Crossings crossings = someCrossings();
    crossings.all.erase(crossings.all.end() - 1);
    for (std::size_t i = 7; i < 19; ++i)
      crossings.all.push_back(crossingAt(i, RayTriangleCase::Miss, Rational(2)));
    crossings.fragments = crossings.all.size();
    const FragmentRows shown = rowsOf(crossings, LiveValues::Shown, 6);
    QCOMPARE(numbersOf(shown), (Numbers{4, 3, 1, 5, 6, 7})); // the hit behind the start, too
    QCOMPARE(shown.leftOut, std::size_t(11));
    QVERIFY(shown.leftOutAreOutside);
  }

  void rows_whileAsked_beyondTheRoom_keepTheOneThatIsAskedNext() {
    Crossings crossings = someCrossings();
    crossings.all.clear();
    for (std::size_t i = 1; i <= 40; ++i)
      crossings.all.push_back(crossingAt(i, RayTriangleCase::Miss, Rational(2)));
    crossings.all[4].which = RayTriangleCase::Hit;
    crossings.fragments = 40;
    crossings.nearest = 5;
    crossings.nearestSoFar = 5;
    for (const std::size_t asked : {5U, 20U, 39U}) {
      crossings.chosen = asked;
      const Numbers kept = numbersOf(rowsOf(crossings, LiveValues::Shown, 6));
      QCOMPARE(kept.size(), std::size_t(6));
      for (const std::size_t needed : {std::size_t(5), asked, asked + 1})
        QVERIFY(std::find(kept.begin(), kept.end(), needed) != kept.end());
    }
  }

  void rows_ofVeryMany_whileHidden_doNotTellTheNearest() {
    Crossings crossings = someCrossings();
    crossings.all = {crossings.all[1]};
    crossings.fragments = 1000;
    const FragmentRows shown = rowsOf(crossings, LiveValues::Hidden, 24);
    QVERIFY(shown.rows.empty());
    QCOMPARE(shown.leftOut, std::size_t(1000));
    QVERIFY(!shown.leftOutAreOutside);
  }

  void rows_ofVeryMany_countThoseThatAreNotTold() {
    Crossings crossings = someCrossings();
    crossings.all = {crossings.all[1]};
    crossings.fragments = 1'000'000;
    QCOMPARE(rowsOf(crossings, LiveValues::Shown, 24).leftOut, std::size_t(999'999));
    QVERIFY(!rowsOf(crossings, LiveValues::Shown, 24).leftOutAreOutside);
  }
};

QTEST_APPLESS_MAIN(FragmentRowsTest)
#include "fragment_rows_test.moc"
