// A label of words with formulas: the room it asks for, its inks and its font.
#include "widgets/text/rich_label.h"

#include "tests/widgets/ink.h"
#include "tests/widgets/text/as_written.h"

#include <QDesktopServices>
#include <QImage>
#include <QLineEdit>
#include <QUrl>
#include <QVBoxLayout>
#include <QtTest>

using namespace halfspace;
using test::asWritten;
using test::inkBox;
using test::painted;

namespace {

constexpr Color red{255, 0, 0};
constexpr Color blue{0, 0, 255};

Theme warningIn(Color color) {
  Theme theme = themes().front();
  theme.warning = color;
  return theme;
}

const QString manyWords = QString("some words ").repeated(40);

/// How many pixels are red rather than green.
int redPixels(const QImage &image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      count += qRed(image.pixel(x, y)) > qGreen(image.pixel(x, y)) + 100 ? 1 : 0;
  return count;
}

} // namespace

/// Stands for the browser.
class Opened : public QObject {
  Q_OBJECT
public:
  Opened() { QDesktopServices::setUrlHandler("https", this, "open"); }
  ~Opened() override { QDesktopServices::unsetUrlHandler("https"); }
  Q_INVOKABLE void open(const QUrl &url) { addresses << url.toString(); }

  QStringList addresses;
};

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
    label.setWords(asWritten(markdown));
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
    label.setWords(asWritten("few"));
    const QSize few = label.sizeHint();
    QVERIFY(few.width() < 2 * label.fontMetrics().horizontalAdvance("few"));
    label.setWords(asWritten("few more"));
    QVERIFY(label.sizeHint().width() > few.width());
    QCOMPARE(label.sizeHint().height(), few.height());
    label.setWords(asWritten(manyWords));
    const QSize many = label.sizeHint();
    label.setWords(asWritten(manyWords + manyWords));
    QCOMPARE(label.sizeHint().width(), many.width());
    QVERIFY(label.sizeHint().height() > 1.5 * many.height());
  }

  void labelCanBeNarrowerThanItAsks_butOfFewWordsOnlyAsTheyAre() {
    RichLabel label(m_typesetter);
    label.setWords(asWritten(manyWords));
    QVERIFY(label.minimumSizeHint().width() < label.sizeHint().width() / 2);
    QVERIFY(label.minimumSizeHint().width() > 0);
    label.setWords(asWritten("a"));
    QCOMPARE(label.minimumSizeHint().width(), label.sizeHint().width());
  }

  void askingForASize_doesNotChangeWhatIsShown() {
    RichLabel label(m_typesetter);
    label.setWords(asWritten(manyWords));
    const QImage before = painted(label, {250, 400});
    (void)label.sizeHint();
    (void)label.heightForWidth(80);
    QCOMPARE(painted(label, {250, 400}), before);
  }

  void inkIsThatOfTheWords_andTheWarningOfFormulasThatCannotBeRead() {
    RichLabel label(m_typesetter);
    label.setWords(asWritten("word"));
    QCOMPARE(redPixels(painted(label, {200, 40})), 0);
    label.setInk(red, warningIn(blue));
    QVERIFY(redPixels(painted(label, {200, 40})) > 10);
    label.setInk({0, 0, 0}, warningIn(red));
    QCOMPARE(redPixels(painted(label, {200, 40})), 0);
    label.setWords(asWritten("word $\\foo$"));
    QVERIFY(redPixels(painted(label, {200, 40})) > 10);
    label.setWords(asWritten("word $x$"));
    QCOMPARE(redPixels(painted(label, {200, 40})), 0);
  }

  void inkStaysWithOtherWords() {
    RichLabel label(m_typesetter);
    label.setInk(red, warningIn(blue));
    label.setWords(asWritten("words"));
    QVERIFY(redPixels(painted(label, {200, 40})) > 10);
  }

  void largerFontMakesWordsAndFormulasLarger() {
    for (const char *markdown : {"word", "$xyz$"}) {
      RichLabel label(m_typesetter);
      QFont font = label.font();
      font.setPixelSize(16);
      label.setFont(font);
      label.setWords(asWritten(markdown));
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
    label.setWords(asWritten("first second $\\foo$"));
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

  void link_isOpenedByAClickAndByNothingElse() {
    const Opened opened;
    RichLabel label(m_typesetter);
    label.setWords(asWritten("[one](https://a.b) and more words"));
    label.resize(300, 100);
    label.show();
    QVERIFY(QTest::qWaitForWindowExposed(&label));
    const QPoint onLink(6, label.fontMetrics().height() / 2);
    const QPoint beside(label.fontMetrics().horizontalAdvance("one and m"), onLink.y());
    QCOMPARE(label.linkAt(onLink), QString("https://a.b"));
    QTest::mouseMove(&label, onLink);
    QTest::mouseClick(&label, Qt::LeftButton, {}, beside);
    QTest::mouseClick(&label, Qt::RightButton, {}, onLink);
    QTest::mousePress(&label, Qt::LeftButton, {}, onLink); // and away with it
    QTest::mouseRelease(&label, Qt::LeftButton, {}, beside);
    QCOMPARE(opened.addresses, QStringList());
    QTest::mouseClick(&label, Qt::LeftButton, {}, onLink);
    QCOMPARE(opened.addresses, QStringList("https://a.b"));
  }

  void links_areReachedByTab_andOpenedByEnter() {
    const Opened opened;
    QWidget column;
    auto *layout = new QVBoxLayout(&column);
    auto *label = new RichLabel(m_typesetter);
    auto *plain = new RichLabel(m_typesetter);
    auto *behind = new QLineEdit;
    layout->addWidget(label);
    layout->addWidget(plain);
    layout->addWidget(behind);
    label->setWords(asWritten("[one](https://a.b) and [two](https://c.d)"));
    plain->setWords(asWritten("words"));
    QCOMPARE(plain->focusPolicy(), Qt::NoFocus);
    column.show();
    QVERIFY(QTest::qWaitForWindowExposed(&column));
    label->setFocus(Qt::TabFocusReason);
    QTest::keyClick(label, Qt::Key_Return);
    QTest::keyClick(label, Qt::Key_Tab);
    QTest::keyClick(label, Qt::Key_Return);
    QCOMPARE(opened.addresses, QStringList({"https://a.b", "https://c.d"}));
    QTest::keyClick(label, Qt::Key_Tab);
    QTRY_VERIFY(behind->hasFocus());
    QTest::keyClick(behind, Qt::Key_Backtab);
    QTRY_VERIFY(label->hasFocus());
    QTest::keyClick(label, Qt::Key_Return);
    QCOMPARE(opened.addresses.back(), QString("https://c.d"));
  }

  void layoutGivesMoreHeightToLongerWords() {
    QWidget column;
    auto *layout = new QVBoxLayout(&column);
    auto *label = new RichLabel(m_typesetter);
    layout->addWidget(label);
    layout->addStretch();
    label->setWords(asWritten("few words"));
    column.resize(200, 900);
    column.show();
    const int flat = label->height();
    label->setWords(asWritten(manyWords));
    QTRY_VERIFY(label->height() > 4 * flat);
    QCOMPARE(label->height(), label->heightForWidth(label->width()));
    QCOMPARE(label->plain(), manyWords.trimmed());
  }
};

QTEST_MAIN(RichLabelTest)
#include "rich_label_test.moc"
