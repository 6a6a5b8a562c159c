#include "tests/widgets/working/working_block_fixture.h"

#include "lessons/lesson/practice.h"
#include "widgets/working/copy_lines.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QMimeData>
#include <QTimer>
#include <QtTest>

#include <functional>

using namespace halfspace;

namespace {

const Term f = name(letter("f"), Rational(30));
const Term d = name(letter("d"), Rational(10));

Working twoLines() {
  return {{test::called("f", line(withResult(f), "Q put into the equation.")),
           test::called("d", line(withNumbers(d == f / 3), "It is < 11 & so on."))}};
}

ShownLines shownLines(Fade fade = {}) { return {twoLines(), {}, std::move(fade)}; }

const QMimeData &copied() { return *QApplication::clipboard()->mimeData(); }

} // namespace

class CopyLinesTest : public QObject {
  Q_OBJECT

private slots:
  void init() { QApplication::clipboard()->clear(); }

  void aLineAsLatex_isItsFormulaAsTextAndAsTex() {
    const ShownLines lines = shownLines();
    copyLines(lines.told(), 1, DocumentFormat::Latex);
    QCOMPARE(copied().text(), QString("d = \\frac{f}{3} = \\frac{30}{3} = 10"));
    QCOMPARE(QString::fromUtf8(copied().data("text/x-tex")), copied().text());
    QVERIFY(!copied().hasHtml());
  }

  void aLineAsMathMl_liesThereForWordProcessorsAndForEditors() {
    const ShownLines lines = shownLines();
    copyLines(lines.told(), 1, DocumentFormat::MathMl);
    QVERIFY(copied().text().startsWith("<math "));
    QVERIFY(copied().text().contains("<mfrac><mn>30</mn><mn>3</mn></mfrac>"));
    QCOMPARE(QString::fromUtf8(copied().data("application/mathml+xml")), copied().text());
    QVERIFY(copied().html().contains("<body>" + copied().text() + "</body>"));
    QVERIFY(copied().html().contains("charset=\"utf-8\""));
  }

  void allLinesAsMathMl_areAPageWithTheirSentences() {
    const ShownLines lines = shownLines();
    copyLines(lines.told(), {}, DocumentFormat::MathMl);
    QCOMPARE(copied().html().count("<math "), 2);
    QVERIFY(copied().html().contains("<p>Q put into the equation.</p>"));
    QVERIFY(copied().html().contains("<p>It is &lt; 11 &amp; so on.</p>"));
    QVERIFY(!copied().hasFormat("application/mathml+xml")); // of which each holds one formula
  }

  void allLinesAsPlainText_haveTheirSentencesBelow() {
    const ShownLines lines = shownLines();
    copyLines(lines.told(), {}, DocumentFormat::PlainText);
    QCOMPARE(copied().text(), QString("f = 30\n    Q put into the equation.\n"
                                      "d = f/3 = 30/3 = 10\n    It is < 11 & so on.\n"));
    QVERIFY(!copied().hasHtml() && !copied().hasFormat("text/x-tex"));
  }

  void whatTheLearnerIsToFind_isNotCopied() {
    const ShownLines lines = shownLines(withheld(twoLines()));
    for (const DocumentFormat format :
         {DocumentFormat::Latex, DocumentFormat::MathMl, DocumentFormat::PlainText})
      for (const std::optional<std::size_t> &line :
           {std::optional<std::size_t>(1), std::optional<std::size_t>()}) {
        copyLines(lines.told(), line, format);
        QVERIFY(!copied().text().isEmpty());
        QVERIFY(!copied().text().contains("10") && !copied().text().contains("30"));
        QVERIFY(!copied().text().contains("so on"));
      }
  }

  void menuOnALine_offersTheLineAndAllLines_inEachFormat() {
    QStringList offered;
    chooseFromMenu(0, [&](QMenu &menu) {
      for (const QAction *action : menu.actions())
        offered << action->text();
      menu.actions().at(1)->trigger();
    });
    QCOMPARE(offered, (QStringList{"Copy this line as LaTeX", "Copy this line as MathML",
                                   "Copy this line as plain text", "", "Copy these lines as LaTeX",
                                   "Copy these lines as MathML", "Copy these lines as plain text"}));
    QCOMPARE(copied().text().count("<math "), 1);
    QVERIFY(copied().text().contains("<mi>f</mi>"));
  }

  void menuBesideTheLines_offersAllOfThem() {
    chooseFromMenu({}, [](QMenu &menu) {
      QCOMPARE(menu.actions().size(), 3);
      menu.actions().back()->trigger();
    });
    QVERIFY(copied().text().startsWith("f = 30\n"));
  }

private:
  /// Opens the menu on a line, and lets it be used before it closes.
  static void chooseFromMenu(std::optional<std::size_t> line, const std::function<void(QMenu &)> &use) {
    QWidget block;
    block.show();
    bool wasOpen = false;
    QTimer::singleShot(0, &block, [&] {
      auto *menu = block.findChild<QMenu *>();
      QVERIFY(menu);
      wasOpen = true;
      use(*menu);
      menu->close();
    });
    showCopyMenu(block, {0, 0}, shownLines(), line);
    QVERIFY(wasOpen);
  }
};

QTEST_MAIN(CopyLinesTest)
#include "copy_lines_test.moc"
