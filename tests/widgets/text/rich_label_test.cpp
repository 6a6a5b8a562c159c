// A label of words with formulas: the room it asks for, its inks and its font.
#include "widgets/text/rich_label.h"

#include "tests/widgets/ink.h"

#include <QImage>
#include <QVBoxLayout>
#include <QtTest>

using namespace halfspace;
using test::inkBox;
using test::painted;

namespace {

const QString manyWords = QString("some words ").repeated(40);

/// How many pixels are red rather than green.
int redPixels(const QImage &image) {
  int red = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      red += qRed(image.pixel(x, y)) > qGreen(image.pixel(x, y)) + 100 ? 1 : 0;
  return red;
}

} // namespace

class RichLabelTest : public QObject {
  Q_OBJECT

private:
  const Typesetter m_typesetter;

private slots:
  void labelAsTallAsItAsks_showsAllItsLines_data() {
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<int>("width");
    QTest::newRow("one line") << "one line" << 300;
    QTest::newRow("many lines") << manyWords << 200;
    QTest::newRow("list") << "- a\n- b\n- g" << 200;
    QTest::newRow("formula alone") << "$(0, -1, 1)$" << 200;
    QTest::newRow("formula alone in the last line") << "a\n\n$\\lvert\\vec v\\rvert = 1$." << 200;
    QTest::newRow("tall formula last") << "a\n\n$$\\frac{1}{\\frac{2}{3}}$$" << 200;
  }
  void labelAsTallAsItAsks_showsAllItsLines() {
    QFETCH(QString, markdown);
    QFETCH(int, width);
    RichLabel label(m_typesetter);
    label.setMarkdown(markdown);
    const int height = label.heightForWidth(width);
    const QRect ink = inkBox(painted(label, {width, height}));
    QCOMPARE(ink, inkBox(painted(label, {width, height + 100})));
    QVERIFY2(height - ink.bottom() < label.fontMetrics().height(), "no empty line below");
  }

  void emptyLabel_isNoTallerThanALine() {
    RichLabel label(m_typesetter);
    QVERIFY(label.heightForWidth(100) <= label.fontMetrics().height() + 1);
    QVERIFY(inkBox(painted(label, {100, 40})).isEmpty());
  }

  void fewWordsAskForTheirOwnWidth_andManyForThatOfAColumn() {
    RichLabel label(m_typesetter);
    label.setMarkdown("few");
    const QSize few = label.sizeHint();
    QVERIFY(few.width() < 2 * label.fontMetrics().horizontalAdvance("few"));
    label.setMarkdown("few more");
    QVERIFY(label.sizeHint().width() > few.width());
    QCOMPARE(label.sizeHint().height(), few.height());
    label.setMarkdown(manyWords);
    const QSize many = label.sizeHint();
    label.setMarkdown(manyWords + manyWords);
    QCOMPARE(label.sizeHint().width(), many.width());
    QVERIFY(label.sizeHint().height() > 1.5 * many.height());
  }

  void labelCanBeNarrowerThanItAsks_butOfFewWordsOnlyAsTheyAre() {
    RichLabel label(m_typesetter);
    label.setMarkdown(manyWords);
    QVERIFY(label.minimumSizeHint().width() < label.sizeHint().width() / 2);
    QVERIFY(label.minimumSizeHint().width() > 0);
    label.setMarkdown("a");
    QCOMPARE(label.minimumSizeHint().width(), label.sizeHint().width());
  }

  void askingForASize_doesNotChangeWhatIsShown() {
    RichLabel label(m_typesetter);
    label.setMarkdown(manyWords);
    const QImage before = painted(label, {250, 400});
    (void)label.sizeHint();
    (void)label.heightForWidth(80);
    QCOMPARE(painted(label, {250, 400}), before);
  }

  void inkIsThatOfTheWords_andTheWarningOfFormulasThatCannotBeRead() {
    RichLabel label(m_typesetter);
    label.setMarkdown("word");
    QCOMPARE(redPixels(painted(label, {200, 40})), 0);
    label.setInk(Qt::red, Qt::blue);
    QVERIFY(redPixels(painted(label, {200, 40})) > 10);
    label.setInk(Qt::black, Qt::red);
    QCOMPARE(redPixels(painted(label, {200, 40})), 0);
    label.setMarkdown("word $\\foo$");
    QVERIFY(redPixels(painted(label, {200, 40})) > 10);
    label.setMarkdown("word $x$");
    QCOMPARE(redPixels(painted(label, {200, 40})), 0);
  }

  void inkStaysWithOtherWords() {
    RichLabel label(m_typesetter);
    label.setInk(Qt::red, Qt::blue);
    label.setMarkdown("words");
    QVERIFY(redPixels(painted(label, {200, 40})) > 10);
  }

  void largerFontMakesWordsAndFormulasLarger() {
    for (const char *markdown : {"word", "$xyz$"}) {
      RichLabel label(m_typesetter);
      QFont font = label.font();
      font.setPixelSize(16);
      label.setFont(font);
      label.setMarkdown(markdown);
      const QRect small = inkBox(painted(label, {400, 200}));
      const QSize hint = label.sizeHint();
      font.setPixelSize(48);
      label.setFont(font);
      const QRect large = inkBox(painted(label, {400, 200}));
      QVERIFY2(large.width() > 2.5 * small.width() && large.width() < 3.5 * small.width(), markdown);
      QVERIFY(label.sizeHint().height() > 2 * hint.height());
    }
  }

  void formulaThatCannotBeRead_isToldWhereItStandsInTheWidthThatIsShown() {
    RichLabel label(m_typesetter);
    label.setMarkdown("first second $\\foo$");
    const int line = label.fontMetrics().height();
    // Where every word has a line of its own, the formula stands at the left of the third.
    label.resize(label.fontMetrics().horizontalAdvance("second") + 4, 200);
    const QPoint below(4, int(2.5 * 1.28 * line));
    QVERIFY(label.problemAt(below).contains("is unknown"));
    QVERIFY(label.problemAt({4, line / 2}).isEmpty());
    label.resize(600, 200);
    QVERIFY(label.problemAt(below).isEmpty());
    QVERIFY(label.problemAt({label.fontMetrics().horizontalAdvance("first second ") + 4, line / 2})
                .contains("is unknown"));
  }

  void layoutGivesMoreHeightToLongerWords() {
    QWidget column;
    auto *layout = new QVBoxLayout(&column);
    auto *label = new RichLabel(m_typesetter);
    layout->addWidget(label);
    layout->addStretch();
    label->setMarkdown("few words");
    column.resize(200, 900);
    column.show();
    const int flat = label->height();
    label->setMarkdown(manyWords);
    QTRY_VERIFY(label->height() > 4 * flat);
    QCOMPARE(label->height(), label->heightForWidth(label->width()));
    QCOMPARE(label->accessibleName(), manyWords.trimmed());
  }
};

QTEST_MAIN(RichLabelTest)
#include "rich_label_test.moc"
