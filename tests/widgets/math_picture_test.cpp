// Formulas as pictures: what MathJax writes and what is read of it.
#include "widgets/typeset/typeset_worker.h"
#include "widgets/typeset/typesetter.h"

#include <QElapsedTimer>
#include <QImage>
#include <QPainter>
#include <QtTest>

using namespace halfspace;

class MathPictureTest : public QObject {
  Q_OBJECT

private:
  Typesetter m_typesetter;

  Typesetter::Picture typeset(const char *latex) { return m_typesetter.picture(QString::fromUtf8(latex)); }

private slots:
  void fractionHasANumeratorABarAndADenominator() {
    const auto picture = typeset("\\frac{3}{7}");
    QVERIFY2(picture->error().isEmpty(), qPrintable(picture->error()));
    QCOMPARE(picture->items().size(), std::size_t(3));
    const QRectF three = picture->items()[0].path.boundingRect();
    const QRectF seven = picture->items()[1].path.boundingRect();
    const QRectF bar = picture->items()[2].path.boundingRect();
    QVERIFY(three.bottom() < bar.top());
    QVERIFY(bar.bottom() < seven.top());
    QVERIFY(bar.left() < three.left() && bar.right() > three.right());
    QVERIFY(bar.top() < 0); // above the baseline
    QVERIFY(seven.bottom() > 0);
  }

  void shapesLieWithinTheBoxForTheFormulasOfTheLessons_data() {
    QTest::addColumn<QString>("latex");
    for (const char *latex :
         {"t = \\frac{(P_0-Q)\\cdot\\vec n}{\\vec r\\cdot\\vec n}", "\\frac{1}{3}\\sqrt{3}",
          "\\vec u^{\\perp}", "(1,\\,2,\\,2)", "\\left(\\begin{array}{c}1\\\\2\\\\2\\end{array}\\right)",
          "\\left\\lVert\\frac{\\frac{a}{b}}{c}\\right\\rVert", "\\underbrace{a+b+c+d}_{x}",
          "\\begin{vmatrix}1&2\\\\3&4\\end{vmatrix}", "\\boxed{x\\neq y}", "\\lambda\\approx 3.33"})
      QTest::newRow(latex) << latex;
  }
  void shapesLieWithinTheBoxForTheFormulasOfTheLessons() {
    QFETCH(QString, latex);
    const auto picture = m_typesetter.picture(latex);
    QVERIFY2(picture->error().isEmpty(), qPrintable(picture->error()));
    QVERIFY(!picture->items().empty());
    const QRectF room = picture->box().adjusted(-0.5, -0.5, 0.5, 0.5); // letters overhang a little
    for (const MathPicture::Item &item : picture->items()) {
      const QRectF box = item.path.boundingRect();
      QVERIFY(room.contains(item.clip.isNull() ? box : box.intersected(item.clip)));
    }
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
    QCOMPARE(picture->items()[0].mark, QString());
    QCOMPARE(picture->items()[2].mark, QStringLiteral("P0"));
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
    const auto picture = typeset("\\mark{red}{\\rule{2ex}{2ex}}\\rule{2ex}{2ex}");
    QImage image(100, 50, QImage::Format_ARGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    const double ex = 40 / picture->width();
    picture->paint(painter, {0, 45}, ex,
                   [](const QString &mark) { return mark == "red" ? Qt::red : Qt::blue; });
    painter.end();
    QCOMPARE(image.pixelColor(10, 40), QColor(Qt::red));
    QCOMPARE(image.pixelColor(30, 40), QColor(Qt::blue));
    QCOMPARE(image.pixelColor(60, 40), QColor(Qt::white));
  }

  void brokenLatexIsReportedAndShowsItsSource() {
    const auto picture = typeset("\\frac{1}{");
    QVERIFY(!picture->error().isEmpty());
    QVERIFY(picture->width() > 0);
    QVERIFY(!picture->items().empty());
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
    QTest::newRow("too long") << QString(TypesetWorker::longestLatex + 1, 'x');
    QTest::newRow("deeply nested") << QString(1300, '{') + "x" + QString(1300, '}');
    QTest::newRow("nested fractions") << QString("\\frac1{").repeated(400) + "x" + QString(400, '}');
    QTest::newRow("nested brackets") << QString("\\left(").repeated(300) + QString("\\right)").repeated(300);
    QTest::newRow("huge rule") << "\\rule{1e9em}{1e9em}";
    QTest::newRow("endless rule") << "\\rule{1e999em}{1em}";
    QTest::newRow("numbered") << "x\\tag{1}";
  }
  void hostileSourceIsRefusedQuickly() {
    QFETCH(QString, latex);
    (void)typeset("x"); // MathJax is loaded
    QElapsedTimer clock;
    clock.start();
    const auto picture = m_typesetter.picture(latex);
    QVERIFY(!picture->error().isEmpty());
    QVERIFY(picture->width() < MathPicture::largestSide);
    QVERIFY2(clock.elapsed() < 2 * Typesetter::patienceMilliseconds,
             qPrintable(QString::number(clock.elapsed())));
    QVERIFY(typeset("x^2")->error().isEmpty()); // and the next formula is typeset again
  }

  void longSumIsTypeset() {
    const auto picture = m_typesetter.picture(QString("+x_1").repeated(80));
    QVERIFY2(picture->error().isEmpty(), qPrintable(picture->error()));
  }

  void svgThatIsNoneIsAnError() {
    QVERIFY(!MathPicture::fromSvg("<svg viewBox='0 0 1 1'", "x").error().isEmpty());
    QVERIFY(!MathPicture::fromSvg("", "x").error().isEmpty());
    QVERIFY(!MathPicture::fromSvg("<svg viewBox='0 0 nan 1'/>", "x").error().isEmpty());
  }
};

QTEST_MAIN(MathPictureTest)
#include "math_picture_test.moc"
