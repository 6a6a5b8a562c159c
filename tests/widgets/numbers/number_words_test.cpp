// What is said of a number in a formula: where it comes from, and what can be done with it.
#include "widgets/numbers/number_words.h"

#include <QtTest>

using namespace halfspace;

namespace {

const Term P0 = given(letter("P", "0"), {5, 4, 7}, "E", 0);
const Term Q = given(letter("Q"), {11, 15, 8}, "Q", 0);
const Term n = given(vectorLetter("n"), {1, 2, 2}, "E", 1);

/// −30, calculated as (P₀ − Q)·n.
Term calculatedNumber() { return number(Rational(-30), dot(P0 - Q, n)); }

/// The number of a coordinate: of n, by its letter.
Term componentOfN(int axis) { return number(Rational(2), n, CoordinateSource{"E", 1, axis}); }

} // namespace

class NumberWordsTest : public QObject {
  Q_OBJECT

private slots:
  void coordinate_ofEachAxis_isCalledByIt() {
    for (const auto &[axis, called] : {std::pair{0, "x of n"}, {1, "y of n"}, {2, "z of n"}})
      QCOMPARE(nameOfCoordinate(componentOfN(axis)), QString(called));
  }

  void coordinate_withoutALetter_isCalledByItsObject() {
    QCOMPARE(nameOfCoordinate(number(Rational(3), {}, CoordinateSource{"Q", 0, 1})), QString("y of Q"));
  }

  void tip_ofACoordinate_saysThatItCanBeChanged() {
    const QString tip = tipOf(componentOfN(2));
    QVERIFY2(tip.startsWith(nameOfCoordinate(componentOfN(2)) + ":"), qPrintable(tip));
    QVERIFY(tip.contains("drag") && tip.contains("double-click"));
  }

  void tip_ofACalculatedNumber_saysWhatItComesFrom() {
    const QString tip = tipOf(calculatedNumber());
    QVERIFY2(tip.startsWith("From ") && tip.contains(QString::fromUtf8("P₀")), qPrintable(tip));
    QVERIFY2(!tip.contains("drag"), "what comes out cannot be dragged");
  }

  void tip_ofALongCalculation_leavesItOut() {
    Term origin = dot(P0 - Q, n);
    while (nameOfCoordinate(number(Rational(0), origin, CoordinateSource{"Q", 0, 0})).size() < 60)
      origin = origin + dot(Q, n);
    const QString tip = tipOf(number(Rational(-30), origin));
    QVERIFY2(tip.size() < 60 && !tip.contains("Q"), qPrintable(tip));
    QVERIFY(tip.contains("Click"));
  }

  void speech_ofACalculatedNumber_isItsValueAndItsOrigin() {
    QCOMPARE(spokenWithOrigin(calculatedNumber()),
             QString("minus 30, from open parenthesis P 0 minus Q close parenthesis dot n"));
  }

  void speech_ofACoordinate_isItsValueAndItsName() {
    const QString said = spokenWithOrigin(componentOfN(1));
    QVERIFY2(said.startsWith("2, y of ") && said.endsWith("n"), qPrintable(said));
  }
};

QTEST_GUILESS_MAIN(NumberWordsTest)
#include "number_words_test.moc"
