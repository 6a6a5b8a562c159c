// Counts and measurements in sentences.
#include "widgets/text/figures.h"

#include "tests/lessons/spoken_to_in.h"

#include <QTranslator>
#include <QtTest>

#include <limits>

using namespace halfspace;

namespace {

/// Of a language in which two, three and four have a form of their own.
class CzechTriangles : public QTranslator {
public:
  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char * /*context*/, const char * /*english*/,
                                  const char * /*disambiguation*/, int count) const override {
    return count >= 2 && count <= 4 ? "%1 trojúhelníky" : "%1 trojúhelníků";
  }
};

} // namespace

class FiguresTest : public QObject {
  Q_OBJECT

private slots:
  void counts_areWrittenInGroups_andOneTriangleIsNoPlural() {
    QCOMPARE(counted(0), QString("0"));
    QCOMPARE(counted(1'234'567), QString("1,234,567"));
    QCOMPARE(trianglesInWords(1), QString("1 triangle"));
    QCOMPARE(trianglesInWords(0), QString("0 triangles"));
    QCOMPARE(trianglesInWords(25'000), QString("25,000 triangles"));
  }

  void triangles_areInTheFormThatTheirCountHas() {
    CzechTriangles czech;
    QCoreApplication::installTranslator(&czech);
    QCOMPARE(trianglesInWords(3), QString("3 trojúhelníky"));
    QCOMPARE(trianglesInWords(5), QString("5 trojúhelníků"));
    QCOMPARE(trianglesInWords(25'000), QString("25,000 trojúhelníků"));
    QCOMPARE(formOf(std::numeric_limits<std::size_t>::max()), std::numeric_limits<int>::max());
  }

  void measurements_haveSoManyDigits_andNoPowersOfTen() {
    QCOMPARE(roundedText(0, 2), QString("0"));
    QCOMPARE(roundedText(0.012345, 2), QString("0.012"));
    QCOMPARE(roundedText(1.26, 2), QString("1.3"));
    QCOMPARE(roundedText(12345, 2), QString("12,000"));
    QCOMPARE(roundedText(16, 4), QString("16"));
    QCOMPARE(roundedText(1.2345e-7, 4), QString("0.000000123"));
    QCOMPARE(roundedText(2.5, 4), QString("2.5"));
    QCOMPARE(roundedText(123456.7, 4), QString("123,500"));
    QCOMPARE(measuredText(2.5, 4), QString("2.5"));
    QCOMPARE(measuredText(123456.7, 4), QString("≈ 123,500"));
  }

  void marks_areThoseOfTheLanguage() {
    const test::SpokenToIn german(test::withDecimalComma());
    QCOMPARE(counted(1'234'567), QString("1.234.567"));
    QCOMPARE(measuredText(1.26, 2), QString("≈ 1,3"));
    QCOMPARE(measuredText(1234.5, 5), QString("1.234,5"));
  }
};

QTEST_GUILESS_MAIN(FiguresTest)
#include "figures_test.moc"
