// How windows of all shapes and sizes of type are shared between scene and page.
#include "app/panels/page_width.h"

#include <QFont>
#include <QtTest>

using namespace halfspace;

namespace {

/// Type of so many pixels.
QFontMetrics type(int pixels) {
  QFont font;
  font.setPixelSize(pixels);
  return QFontMetrics(font);
}

constexpr int usualType = 13;
constexpr int largestType = 33; ///< at 2.5 times

double letters(int width, const QFontMetrics &type) { return double(width) / type.averageCharWidth(); }

} // namespace

class PageWidthTest : public QObject {
  Q_OBJECT

private slots:
  void page_standsBesideTheScene_orBelowInAHighWindow_data() {
    QTest::addColumn<QSize>("window");
    QTest::addColumn<bool>("below");
    QTest::newRow("usual") << QSize(1280, 800) << false;
    QTest::newRow("small") << QSize(1024, 600) << false;
    QTest::newRow("large") << QSize(1920, 1080) << false;
    QTest::newRow("square") << QSize(900, 900) << false;
    QTest::newRow("portrait") << QSize(800, 1280) << true;
  }
  void page_standsBesideTheScene_orBelowInAHighWindow() {
    QFETCH(QSize, window);
    QFETCH(bool, below);
    QCOMPARE(isPageBelow(window), below);
  }

  void page_hasUsualLines_andLeavesTheSceneItsShare_data() {
    QTest::addColumn<QSize>("window");
    QTest::addColumn<int>("pixels");
    QTest::addColumn<double>("mostShare");
    QTest::addColumn<double>("leastLetters");
    QTest::newRow("usual") << QSize(1280, 800) << usualType << 0.40 << 45.0;
    QTest::newRow("small") << QSize(1024, 600) << usualType << 0.37 << 40.0;
    QTest::newRow("large") << QSize(1920, 1080) << usualType << 0.40 << 59.0;
    QTest::newRow("low window, larger type") << QSize(1280, 720) << 16 << 0.40 << 54.0;
    QTest::newRow("usual window, largest type") << QSize(1280, 800) << largestType << 0.5 << 29.0;
    QTest::newRow("large window, largest type") << QSize(1920, 1080) << largestType << 0.5 << 29.0;
    QTest::newRow("small window, largest type") << QSize(1024, 600) << largestType << 0.5 << 20.0;
  }
  void page_hasUsualLines_andLeavesTheSceneItsShare() {
    QFETCH(QSize, window);
    QFETCH(int, pixels);
    QFETCH(double, mostShare);
    QFETCH(double, leastLetters);
    const int width = pageWidthIn(window.width(), type(pixels));
    QVERIFY2(width <= mostShare * window.width(), qPrintable(QString::number(width)));
    QVERIFY2(letters(width, type(pixels)) >= leastLetters, qPrintable(QString::number(width)));
    QVERIFY(letters(width, type(pixels)) <= usualPageLetters);
  }

  void page_alone_hasLargerTypeWhereItsLinesLeaveRoom() {
    QCOMPARE(typeScaleAlone(600, 550), 1.0);
    QCOMPARE(typeScaleAlone(1280, 550), 1.25);
    QCOMPARE(typeScaleAlone(1920, 550), 1.5);
    QCOMPARE(typeScaleAlone(3840, 550), 1.5);
  }

  void page_inAVeryLargeWindow_doesNotGrowBeyondItsLines() {
    QCOMPARE(pageWidthIn(3840, type(usualType)), pageWidthIn(2560, type(usualType)));
  }
};

QTEST_MAIN(PageWidthTest)
#include "page_width_test.moc"
