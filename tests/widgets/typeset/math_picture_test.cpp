// Formulas as pictures: their sizes, their marks, and how they are painted.
#include "widgets/formula/read_latex.h"
#include "widgets/typeset/typesetter.h"

#include <QElapsedTimer>
#include <QImage>
#include <QPainter>
#include <QtTest>

#include <cmath>

using namespace halfspace;

namespace {

/// On white, 20 pixels an em: what is marked “red” in red, all else in blue.
QImage paintedRedAndBlue(const MathPicture &picture) {
  QImage image(100, 50, QImage::Format_ARGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  picture.paint(painter, {0, 45}, 20, [](const QString &mark) { return mark == "red" ? Qt::red : Qt::blue; });
  painter.end();
  return image;
}

/// Black on white, with a margin around.
QImage paintedAt(const MathPicture &picture, double em, double ratio = 1) {
  constexpr int margin = 10;
  const auto side = [&](double length) { return static_cast<int>(std::ceil(length * em)) + 2 * margin; };
  QImage image(QSize(side(picture.width()), side(picture.height())) * ratio, QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::white);
  QPainter painter(&image);
  picture.paint(painter, {margin, margin + std::ceil(picture.ascent() * em)}, em,
                [](const QString &) { return Qt::black; });
  return image;
}

/// How many pixels are covered.
double inkOf(const QImage &image) {
  double ink = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      ink += (255 - qGray(image.pixel(x, y))) / 255.0;
  return ink;
}

QRect inkBox(const QImage &image) {
  QRect box;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (qGray(image.pixel(x, y)) < 128)
        box |= QRect(x, y, 1, 1);
  return box;
}

} // namespace

class MathPictureTest : public QObject {
  Q_OBJECT

private:
  const Typesetter m_typesetter;

  Typesetter::Picture typeset(const char *latex) { return m_typesetter.picture(QString::fromUtf8(latex)); }

private slots:
  void shapesFillTheBoxForTheFormulasOfTheLessons_data() {
    QTest::addColumn<QString>("latex");
    for (const char *latex :
         {"t = \\frac{(P_0-Q)\\cdot\\vec n}{\\vec r\\cdot\\vec n}", "\\frac{1}{3}\\sqrt{3}",
          "\\vec u^{\\perp}", "(1,\\,2,\\,2)", "\\left(\\begin{array}{c}1\\\\2\\\\2\\end{array}\\right)",
          "\\left\\lVert\\frac{\\frac{a}{b}}{c}\\right\\rVert", "\\underbrace{a+b+c+d}_{x}",
          "\\begin{vmatrix}1&2\\\\3&4\\end{vmatrix}", "\\boxed{x\\neq y}", "\\lambda\\approx 3.33"})
      QTest::newRow(latex) << latex;
  }
  void shapesFillTheBoxForTheFormulasOfTheLessons() {
    QFETCH(QString, latex);
    const auto picture = m_typesetter.picture(latex);
    QVERIFY2(picture->error().isEmpty(), qPrintable(picture->error()));
    constexpr double em = 40;
    const QRectF room(10, 10, picture->width() * em, picture->height() * em);
    const QRectF ink = inkBox(paintedAt(*picture, em));
    QVERIFY2(room.adjusted(-6, -6, 6, 6).contains(ink), "letters overhang a little"); // and arrows
    QVERIFY(ink.width() > 0.7 * room.width() && ink.height() > 0.7 * room.height());
  }

  void markHasItsTermsBoxInsideThePicture() {
    const auto picture = typeset("a + \\mark{P0}{P_0} + \\mark{E.n}{\\vec n}");
    QCOMPARE(picture->markBoxes().size(), std::size_t(2));
    QCOMPARE(picture->markBoxes()[0].first, QStringLiteral("P0"));
    QCOMPARE(picture->markBoxes()[1].first, QStringLiteral("E.n"));
    for (const auto &[mark, box] : picture->markBoxes()) {
      QVERIFY(!box.isEmpty());
      QVERIFY(picture->box().contains(box));
    }
    QVERIFY(picture->markBoxes()[0].second.right() < picture->markBoxes()[1].second.left());
  }

  void markDoesNotChangeTheFormulasSize() {
    QCOMPARE(typeset("\\mark{a}{x}\\mark{b}{=}\\mark{c}{y}+1")->box(), typeset("x=y+1")->box());
  }

  void markInsideAMarkKeepsBothBoxesTheInnerLast() {
    const auto picture = typeset("\\mark{outer}{\\mark{inner}{x}}");
    QCOMPARE(picture->markBoxes().size(), std::size_t(2));
    QCOMPARE(picture->markBoxes()[0].first, QStringLiteral("outer"));
    QVERIFY(picture->markBoxes()[0].second.contains(picture->markBoxes()[1].second));
  }

  void markWithAForeignNameIsAnError() { QVERIFY(!typeset("\\mark{a\" onload=\"x}{y}")->error().isEmpty()); }

  void paintingTakesTheInkOfEachMark() {
    const auto picture = typeset("\\mark{red}{\\rule{1em}{1em}}\\rule{1em}{1em}");
    const QImage image = paintedRedAndBlue(*picture);
    QCOMPARE(image.pixelColor(10, 35), QColor(Qt::red));
    QCOMPARE(image.pixelColor(30, 35), QColor(Qt::blue));
    QCOMPARE(image.pixelColor(60, 35), QColor(Qt::white));
  }

  void piecesTaggedWithAnIndexHaveTheInkAroundThem() {
    const auto square = [](std::size_t index) {
      return math::row(math::tagged(index, std::get<math::Row>(math::readLatex("\\rule{1em}{1em}"))));
    };
    const auto picture =
        m_typesetter.picture(math::row(math::tagged("red", square(3)), math::row(square(5))));
    QCOMPARE(picture->markBoxes().size(), std::size_t(1));
    QCOMPARE(picture->indexBoxes().size(), std::size_t(2));
    QCOMPARE(picture->indexBoxes()[0].first, std::size_t(3));
    QCOMPARE(picture->indexBoxes()[0].second, picture->markBoxes()[0].second);
    const QImage image = paintedRedAndBlue(*picture);
    QCOMPARE(image.pixelColor(10, 35), QColor(Qt::red));
    QCOMPARE(image.pixelColor(30, 35), QColor(Qt::blue));
  }

  void finerScreen_showsTheSamePixelsAsLargerType() {
    const auto picture = typeset("t = \\frac{1}{3}\\sqrt{3}");
    QImage fine = paintedAt(*picture, 20, 2);
    fine.setDevicePixelRatio(1);
    QImage large(fine.size(), QImage::Format_RGB32);
    large.fill(Qt::white);
    QPainter painter(&large);
    picture->paint(painter, QPointF(10, 10 + std::ceil(picture->ascent() * 20)) * 2, 40,
                   [](const QString &) { return Qt::black; });
    painter.end();
    QCOMPARE(fine, large);
  }

  void letters_asImagesAndAsOutlines_areEquallyHeavy() {
    const auto picture = typeset("Q = (11,\\,15,\\,8) - \\lambda\\vec r");
    const QImage upright = paintedAt(*picture, 60);
    QImage turned(upright.height(), upright.width(), QImage::Format_RGB32);
    turned.fill(Qt::white);
    QPainter painter(&turned);
    painter.translate(turned.width(), 0);
    painter.rotate(90);
    picture->paint(painter, {10, 10 + std::ceil(picture->ascent() * 60)}, 60,
                   [](const QString &) { return Qt::black; });
    painter.end();
    QVERIFY2(std::abs(inkOf(turned) / inkOf(upright) - 1) < 0.02,
             qPrintable(QString("%1 %2").arg(inkOf(turned)).arg(inkOf(upright))));
  }

  void barsOfSigns_areSharpAtEverySize() {
    for (const char *sign : {"=", "-", "-\\frac{3}{2}"})
      for (const double em : {15.0, 19.3, 22.0, 24.32, 30.0, 41.7}) {
        const QImage image = paintedAt(*typeset(sign), em);
        for (int y = 0; y < image.height(); ++y) {
          const int gray = qGray(image.pixel(10 + static_cast<int>(0.39 * em), y));
          QVERIFY2(gray < 70 || gray > 220, qPrintable(QString("%1 %2: %3").arg(sign).arg(em).arg(gray)));
        }
      }
  }

  void cornersOfABox_areFlush() {
    for (const double em : {15.0, 19.3, 22.0, 24.32, 30.0, 41.7}) {
      const QImage image = paintedAt(*typeset("\\boxed{x}"), em);
      const QRect box = inkBox(image);
      for (const QPoint &corner : {box.topLeft(), box.topRight(), box.bottomLeft(), box.bottomRight()})
        QVERIFY2(qGray(image.pixel(corner)) < 128, qPrintable(QString::number(em)));
    }
  }

  void halo_reachesAroundEveryShape() {
    const auto picture = typeset("\\frac{Q}{|\\vec n|}");
    QImage image(80, 100, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    picture->paintHalo(painter, {20, 50}, 30, 4, Qt::white);
    picture->paint(painter, {20, 50}, 30, [](const QString &) { return Qt::red; });
    painter.end();
    for (int y = 1; y < 99; ++y)
      for (int x = 1; x < 79; ++x)
        if (image.pixelColor(x, y).red() > 200 && image.pixelColor(x, y).green() < 50)
          for (const QPoint beside : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)})
            QVERIFY(image.pixelColor(QPoint(x, y) + beside).red() > 200); // ink or halo
  }

  void brokenLatexIsReportedWithItsColumnAndShowsItsSource() {
    const auto picture = typeset("x + \\foo");
    QVERIFY2(picture->error().contains("\\foo") && picture->errorColumn() == 5, qPrintable(picture->error()));
    QVERIFY(inkOf(paintedAt(*picture, 20)) > 20);
    QVERIFY(!typeset("\\frac{1}{")->error().isEmpty());
  }

  void dangerousCommandsAreUnknown_data() {
    QTest::addColumn<QString>("latex");
    for (const char *latex :
         {"\\require{html}", "\\href{https://example.org}{x}", "\\def\\a{\\a\\a}\\a",
          "\\newcommand{\\a}{x}\\a", "\\style{color:red}{x}", "\\class{x}{y}", "\\unicode{65}"})
      QTest::newRow(latex) << latex;
  }
  void dangerousCommandsAreUnknown() {
    QFETCH(QString, latex);
    QVERIFY(!m_typesetter.picture(latex)->error().isEmpty());
  }

  void hostileSourceIsRefusedQuickly_data() {
    QTest::addColumn<QString>("latex");
    QTest::newRow("too long") << QString(100'000, 'x');
    QTest::newRow("deeply nested") << QString(1300, '{') + "x" + QString(1300, '}');
    QTest::newRow("nested fractions") << QString("\\frac1{").repeated(400) + "x" + QString(400, '}');
    QTest::newRow("nested brackets") << QString("\\left(").repeated(300) + QString("\\right)").repeated(300);
    QTest::newRow("huge rule") << "\\rule{1e9em}{1e9em}";
    QTest::newRow("endless rule") << "\\rule{1e999em}{1em}";
    QTest::newRow("too wide") << QString("+x_1").repeated(800);
  }
  void hostileSourceIsRefusedQuickly() {
    QFETCH(QString, latex);
    QElapsedTimer clock;
    clock.start();
    const auto picture = m_typesetter.picture(latex);
    QVERIFY(!picture->error().isEmpty());
    QVERIFY(picture->width() < math::largestFormula);
    QVERIFY2(clock.elapsed() < 200, qPrintable(QString::number(clock.elapsed())));
  }

  void longSumIsTypeset() {
    const auto picture = m_typesetter.picture(QString("+x_1").repeated(80));
    QVERIFY2(picture->error().isEmpty(), qPrintable(picture->error()));
  }
};

QTEST_MAIN(MathPictureTest)
#include "math_picture_test.moc"
