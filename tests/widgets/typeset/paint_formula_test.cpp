// Formulas drawn on whole pixels where there are pixels, and as outlines elsewhere.
#include "widgets/typeset/paint_formula.h"
#include "widgets/typeset/typesetter.h"

#include "tests/widgets/ink.h"

#include <QImage>
#include <QPainter>
#include <QPicture>
#include <QtTest>

#include <set>

using namespace halfspace;
using test::inkBox;

namespace {

constexpr QSize size(300, 120);

using Paint = std::function<void(QPainter &)>;

QImage painted(const Paint &paint) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  paint(painter);
  return image;
}

/// How many pixels are neither black nor white.
int grayPixels(const QImage &image) {
  int gray = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      gray += qGray(image.pixel(x, y)) > 10 && qGray(image.pixel(x, y)) < 245 ? 1 : 0;
  return gray;
}

} // namespace

class PaintFormulaTest : public QObject {
  Q_OBJECT

private:
  const Typesetter m_typesetter;
  const MathTypeface m_typeface;

  void paint(QPainter &painter, const QString &latex, QPointF baseline, double em, double rim = 0) const {
    paintFormula(painter, *m_typesetter.picture(latex)->layout(), m_typeface,
                 {baseline, em, rim, [](const math::Ink &) { return QColor(Qt::black); }});
  }

private slots:
  void baselineBetweenPixels_isMovedToAWholeOne_data() {
    QTest::addColumn<double>("below");
    for (const double below : {-0.4, 0.2, 0.45})
      QTest::newRow(qPrintable(QString::number(below))) << below;
  }
  void baselineBetweenPixels_isMovedToAWholeOne() {
    QFETCH(double, below);
    const auto at = [&](double y) {
      return painted([&](QPainter &painter) { paint(painter, "\\frac{Q}{3}=x", {20, y}, 30); });
    };
    QCOMPARE(at(60 + below), at(60));
    QVERIFY(at(61) != at(60));
  }

  void rulesAreSharp_howeverTheyLie() {
    for (const double em : {15.0, 19.3, 24.32, 41.7})
      for (const double x : {20.0, 20.3, 20.7}) {
        const QImage image = painted([&](QPainter &painter) {
          paint(painter, "\\rule{1em}{0.5em}", {x, 60}, em);
        });
        QCOMPARE(grayPixels(image), 0);
        QVERIFY(std::abs(inkBox(image).width() - em) < 2);
        QVERIFY(std::abs(inkBox(image).height() - em / 2) < 2);
      }
  }

  void thinnestRule_isStillSeen() {
    const QImage image = painted([&](QPainter &painter) {
      paint(painter, "\\rule{2em}{0.01em}", {20, 60}, 10);
    });
    QCOMPARE(inkBox(image).height(), 1);
    QCOMPARE(grayPixels(image), 0);
  }

  void movedAndScaledPainter_drawsAsThePlaceAndSizeThatItMeans() {
    const QImage plain = painted([&](QPainter &painter) {
      paint(painter, "\\sqrt{\\frac{x}{2}}", {50, 70}, 40);
    });
    const QImage moved = painted([&](QPainter &painter) {
      painter.translate(10, 30);
      painter.scale(2, 2);
      paint(painter, "\\sqrt{\\frac{x}{2}}", {20, 20}, 20);
    });
    QCOMPARE(moved, plain);
  }

  void painterIsLeftAsItWas_data() {
    QTest::addColumn<double>("angle");
    QTest::addColumn<double>("em");
    QTest::newRow("in pixels") << 0.0 << 30.0;
    QTest::newRow("large") << 0.0 << 300.0;
    QTest::newRow("turned") << 20.0 << 30.0;
  }
  void painterIsLeftAsItWas() {
    QFETCH(double, angle);
    QFETCH(double, em);
    painted([&](QPainter &painter) {
      painter.translate(5, 7);
      painter.rotate(angle);
      painter.setPen(Qt::red);
      const QTransform before = painter.transform();
      paint(painter, "\\frac{x}{y}", {20, 40}, em);
      QCOMPARE(painter.transform(), before);
      QCOMPARE(painter.pen().color(), QColor(Qt::red));
      QVERIFY(painter.brush() == QBrush());
      QVERIFY(!painter.testRenderHint(QPainter::Antialiasing));
    });
  }

  void imagesAndOutlines_standInTheSamePlace_data() {
    QTest::addColumn<QString>("latex");
    for (const char *latex : {"Q", "\\frac{x}{2}", "\\sqrt{x}", "x_1^2", "\\vec n"})
      QTest::newRow(latex) << latex;
  }
  void imagesAndOutlines_standInTheSamePlace() {
    QFETCH(QString, latex);
    const QRect pixels = inkBox(painted([&](QPainter &painter) { paint(painter, latex, {20, 60}, 40); }));
    const QRect outlines = inkBox(painted([&](QPainter &painter) {
      painter.shear(0.000'01, 0); // no longer upright
      paint(painter, latex, {20, 60}, 40);
    }));
    QVERIFY(!pixels.isEmpty());
    for (const int apart : {pixels.left() - outlines.left(), pixels.right() - outlines.right(),
                            pixels.top() - outlines.top(), pixels.bottom() - outlines.bottom()})
      QVERIFY2(std::abs(apart) <= 1, qPrintable(QString::number(apart)));
  }

  void typeGrowsEvenly_whereImagesEnd() {
    const auto heightAt = [&](double em) {
      return inkBox(painted([&](QPainter &painter) { paint(painter, "x", {20, 100}, em); })).height();
    };
    QVERIFY(std::abs(heightAt(127.9) - heightAt(128.1)) <= 1);
    QVERIFY(std::abs(heightAt(160) - 1.25 * heightAt(128)) <= 2);
  }

  void vectorFile_getsOutlinesAndNoImages() {
    QPicture recorded;
    {
      QPainter painter(&recorded);
      paint(painter, "Q", {20, 60}, 30);
    }
    // Outlines stay sharp: ten times as large they have few gray pixels beside many black ones.
    const QImage large = painted([&](QPainter &painter) {
      painter.translate(-200, -500);
      painter.scale(10, 10);
      recorded.play(&painter);
    });
    int black = 0;
    for (int y = 0; y < large.height(); ++y)
      for (int x = 0; x < large.width(); ++x)
        black += qGray(large.pixel(x, y)) < 10 ? 1 : 0;
    QVERIFY2(black > 1000, qPrintable(QString::number(black)));
    QVERIFY2(grayPixels(large) < black / 5, qPrintable(QString("%1 %2").arg(grayPixels(large)).arg(black)));
  }

  void rim_reachesAsFarOnAllSides() {
    for (const char *latex : {"\\rule{1em}{1em}", "Q"}) {
      const QRect plain = inkBox(painted([&](QPainter &painter) { paint(painter, latex, {50, 80}, 40); }));
      const QRect rimmed = inkBox(painted([&](QPainter &painter) {
        paint(painter, latex, {50, 80}, 40, 0.1);
      }));
      for (const int more : {plain.left() - rimmed.left(), rimmed.right() - plain.right(),
                             plain.top() - rimmed.top(), rimmed.bottom() - plain.bottom()})
        QVERIFY2(std::abs(more - 4) <= 1, qPrintable(QString("%1 %2").arg(latex).arg(more)));
    }
  }

  void everyShape_isAskedForItsColor() {
    const auto picture = m_typesetter.picture("\\mark{a}{x}+\\mark{b}{\\rule{1em}{1em}}");
    std::set<int> asked;
    painted([&](QPainter &painter) {
      paintFormula(painter, *picture->layout(), m_typeface, {{20, 60}, 30, 0, [&](const math::Ink &ink) {
                                                               asked.insert(ink.tag);
                                                               return QColor(Qt::black);
                                                             }});
    });
    QCOMPARE(asked, (std::set<int>{math::noTag, 0, 1}));
  }
};

QTEST_MAIN(PaintFormulaTest)
#include "paint_formula_test.moc"
