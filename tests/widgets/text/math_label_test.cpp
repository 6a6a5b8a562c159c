// One formula as a label: how large it wants to be, and what is seen of it.
#include "widgets/text/math_label.h"

#include "widgets/formula/read_latex.h"

#include "tests/widgets/ink.h"

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QImage>
#include <QtTest>

using namespace halfspace;
using test::inkBox;
using test::painted;

namespace {

math::Row formula(const QString &latex) { return std::get<math::Row>(math::readLatex(latex.toStdString())); }

const QString longSum = QString("x") + QString("+x").repeated(12);

/// Whether a pixel is nearly of this colour.
bool hasInk(const QImage &image, const QColor &ink) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor color = image.pixelColor(x, y);
      if (std::abs(color.red() - ink.red()) + std::abs(color.green() - ink.green()) +
              std::abs(color.blue() - ink.blue()) <
          60)
        return true;
    }
  return false;
}

} // namespace

class MathLabelTest : public QObject {
  Q_OBJECT

private:
  const Typesetter m_typesetter;

private slots:
  void labelOfItsOwnSize_showsAllOfItsFormula_data() {
    QTest::addColumn<QString>("latex");
    for (const char *latex :
         {"x", "\\vec n", "\\frac{1}{\\frac{2}{3}}", "\\sqrt{\\frac{x}{y}}", "x_{y_{z}}", "(1,\\,2,\\,3)"})
      QTest::newRow(latex) << latex;
  }
  void labelOfItsOwnSize_showsAllOfItsFormula() {
    QFETCH(QString, latex);
    MathLabel label(m_typesetter);
    label.setFormula(formula(latex), "words");
    const QSize size = label.sizeHint();
    const QRect ink = inkBox(painted(label, size), 160);
    // As large as in a place with more than enough room around it.
    const QRect free = inkBox(painted(label, size + QSize(60, 60)), 160);
    QVERIFY(!ink.isEmpty());
    QCOMPARE(ink.size(), free.size());
    QVERIFY(size.width() - ink.width() < 12);
  }

  void labelWithoutAFormula_isAsTallAsALineAndShowsNothing() {
    MathLabel label(m_typesetter);
    QCOMPARE(label.sizeHint().width(), 0);
    QVERIFY(label.sizeHint().height() >= label.fontMetrics().height());
    QVERIFY(inkBox(painted(label, {40, 20}), 160).isEmpty());
  }

  void rowsOfFlatFormulas_areEquallyTall() {
    MathLabel label(m_typesetter);
    const int empty = label.sizeHint().height();
    for (const char *latex : {"x", "y", "-", "10"}) {
      label.setFormula(formula(latex), latex);
      QCOMPARE(label.sizeHint().height(), empty);
    }
    label.setFormula(formula("\\frac{1}{\\frac{2}{3}}"), "1/(2/3)");
    QVERIFY(label.sizeHint().height() > empty);
  }

  void formulaIsSaidInItsPlainWords() {
    MathLabel label(m_typesetter);
    label.setFormula(formula("P_0"), "P₀");
    QCOMPARE(label.accessibleName(), QString("P₀"));
    label.setFormula(formula("Q_0"), "Q₀");
    QCOMPARE(label.accessibleName(), QString("Q₀"));
  }

  void formulaGrowsWithTheFont() {
    MathLabel label(m_typesetter);
    label.setFormula(formula("\\frac{x}{y}"), "x/y");
    QFont font = label.font();
    font.setPixelSize(15);
    label.setFont(font);
    const QRect small = inkBox(painted(label, {200, 200}), 160);
    const QSize smallHint = label.sizeHint();
    font.setPixelSize(45);
    label.setFont(font);
    const QRect large = inkBox(painted(label, {200, 200}), 160);
    QVERIFY(std::abs(large.height() - 3 * small.height()) <= 6);
    QVERIFY(label.sizeHint().height() > 2 * smallHint.height());
    QVERIFY(label.sizeHint().width() > 2 * smallHint.width());
  }

  void formulaThatIsTooWide_isDrawnSmallerAndWhole() {
    MathLabel label(m_typesetter);
    label.setFormula(formula(longSum), "sum");
    const QSize wanted = label.sizeHint();
    const QRect whole = inkBox(painted(label, wanted), 160);
    const QSize narrow(wanted.width() * 7 / 10, wanted.height());
    const QRect smaller = inkBox(painted(label, narrow), 160);
    QVERIFY(smaller.right() < narrow.width());
    QVERIFY2(std::abs(smaller.width() - 0.7 * whole.width()) < 6,
             qPrintable(QString::number(smaller.width())));
    QVERIFY(smaller.height() < whole.height());
  }

  void formulaIsNotDrawnSmallerThanCanBeRead() {
    MathLabel label(m_typesetter);
    label.setFormula(formula(longSum), "sum");
    const QSize least = label.minimumSizeHint();
    QVERIFY(std::abs(least.width() - label.sizeHint().width() / 2) <= 1);
    QCOMPARE(least.height(), label.sizeHint().height());
    const QRect smallest = inkBox(painted(label, least), 160);
    QVERIFY(smallest.right() < least.width());
    const QRect cut = inkBox(painted(label, {least.width() / 2, least.height()}), 160);
    QCOMPARE(cut.height(), smallest.height());
  }

  void formulaStandsInTheMiddleOfATallPlace() {
    MathLabel label(m_typesetter);
    label.setFormula(formula("\\rule{1em}{1em}"), "box");
    for (const int height : {40, 80, 121}) {
      const QRect ink = inkBox(painted(label, {100, height}), 160);
      QVERIFY(std::abs(ink.top() - (height - 1 - ink.bottom())) <= 2);
    }
  }

  void formulaHasTheColorOfText_alsoAfterItChanges() {
    MathLabel label(m_typesetter);
    label.setFormula(formula("\\rule{1em}{1em}"), "box");
    for (const QColor &color : {QColor(Qt::red), QColor(Qt::darkGreen)}) {
      QPalette palette = label.palette();
      palette.setColor(QPalette::WindowText, color);
      label.setPalette(palette);
      QVERIFY(hasInk(painted(label, label.sizeHint()), color));
    }
  }

  void markHasItsOwnInk() {
    MathLabel label(m_typesetter);
    label.setFormula(formula("\\rule{1em}{1em}\\mark{P0}{\\rule{1em}{1em}}"), "boxes");
    QVERIFY(!hasInk(painted(label, label.sizeHint()), Qt::red));
    label.setInkOf([](const QString &mark) { return mark == "P0" ? QColor(Qt::red) : QColor(Qt::blue); });
    const QImage image = painted(label, label.sizeHint());
    QVERIFY(hasInk(image.copy(0, 0, image.width() / 2 - 2, image.height()), Qt::blue));
    QVERIFY(hasInk(image.copy(image.width() / 2 + 2, 0, image.width(), image.height()), Qt::red));
  }

  void widerFormulaGetsItsRoomAtOnce_andOneOfTheSameSizeMovesNothing() {
    QWidget row;
    auto *layout = new QHBoxLayout(&row);
    auto *label = new MathLabel(m_typesetter);
    layout->addWidget(label);
    layout->addStretch();
    label->setFormula(formula("x"), "x");
    row.resize(600, 60);
    row.show();
    const int narrow = label->width();
    label->setFormula(formula("x+x+x"), "x + x + x");
    QTRY_VERIFY(label->width() > narrow);
    QCOMPARE(label->width(), label->sizeHint().width());
    const QRect before = label->geometry();
    label->setFormula(formula("x-x-x"), "x − x − x");
    QCoreApplication::processEvents();
    QCOMPARE(label->geometry(), before);
  }

  void formulaTooWide_isBrokenWhereThereIsHeight_andIsReadWhereThePointerRests() {
    MathLabel label(m_typesetter);
    label.setFormula(formula(longSum), "the sum");
    const QSize whole = label.sizeHint();
    const int half = whole.width() / 2;
    QCOMPARE(label.heightForWidth(whole.width()), whole.height());
    QVERIFY(label.heightForWidth(half) > whole.height());
    QVERIFY(label.narrowestWidth() < half);
    const QRect broken = inkBox(painted(label, {half, label.heightForWidth(half)}), 160);
    const QRect smaller = inkBox(painted(label, {half, whole.height()}), 160);
    QVERIFY2(broken.height() > smaller.height(), "on two lines, and not drawn smaller");
    QHelpEvent rests(QEvent::ToolTip, {1, 1}, {1, 1});
    QCoreApplication::sendEvent(&label, &rests);
    QCOMPARE(label.toolTip(), QString("the sum"));
  }
};

QTEST_MAIN(MathLabelTest)
#include "math_label_test.moc"
