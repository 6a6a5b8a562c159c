// Blocks of Markdown as paragraphs of a document.
#include "widgets/text/markdown_writer.h"

#include "widgets/text/unbroken.h"

#include <QFontInfo>
#include <QTextBlock>
#include <QTextList>
#include <QtTest>

#include <algorithm>
#include <memory>

using namespace halfspace;

namespace {

struct Written {
  std::unique_ptr<QTextDocument> document = std::make_unique<QTextDocument>();
  std::vector<std::size_t> formulas{};

  [[nodiscard]] QTextBlock paragraph(int index) const { return document->findBlockByNumber(index); }
};

QTextCharFormat asText(std::size_t, const QTextCharFormat &text) { return text; }

Written write(const QString &markdown, const FormulaFormat &formulaFormat = asText,
              const QColor &ink = Qt::black) {
  QFont font;
  font.setPixelSize(20);
  Written written;
  written.document->setDefaultFont(font);
  written.formulas = writeMarkdown(readMarkdown(markdown.toStdString())->blocks, {font, ink}, formulaFormat,
                                   *written.document);
  return written;
}

/// The format of the letters of a word that stands once.
QTextCharFormat formatOf(const Written &written, const QString &word) {
  QTextCursor found = written.document->find(word);
  return found.isNull() ? QTextCharFormat() : found.charFormat();
}

/// Formulas and words in every kind of block.
const char *const everyBlock =
    "# A $a$\n\nB $b$ c\n\n> D $d$\n\n- E $e$\n  1. F $f$\n\n```\nG\nH\n```\n\n---";

} // namespace

class MarkdownWriterTest : public QObject {
  Q_OBJECT

private slots:
  void faceOfAPieceIsThatOfItsLettersOnly_data() {
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<bool>("strong");
    QTest::addColumn<bool>("emphasized");
    QTest::addColumn<bool>("struck");
    QTest::addColumn<bool>("code");
    QTest::newRow("plain") << "before word behind" << false << false << false << false;
    QTest::newRow("strong") << "before **word** behind" << true << false << false << false;
    QTest::newRow("emphasized") << "before *word* behind" << false << true << false << false;
    QTest::newRow("struck") << "before ~~word~~ behind" << false << false << true << false;
    QTest::newRow("code") << "before `word` behind" << false << false << false << true;
    QTest::newRow("strong and emphasized") << "before ***word*** behind" << true << true << false << false;
    QTest::newRow("strong in struck") << "before ~~**word**~~ behind" << true << false << true << false;
  }
  void faceOfAPieceIsThatOfItsLettersOnly() {
    QFETCH(QString, markdown);
    const Written written = write(markdown);
    const QTextCharFormat word = formatOf(written, "word");
    QTEST(word.fontWeight() == QFont::Bold, "strong");
    QTEST(word.fontItalic(), "emphasized");
    QTEST(word.fontStrikeOut(), "struck");
    QTEST(word.fontFixedPitch(), "code");
    for (const char *beside : {"before", "behind"}) {
      const QTextCharFormat format = formatOf(written, beside);
      QVERIFY(format.isValid());
      QVERIFY(format.fontWeight() != QFont::Bold && !format.fontItalic() && !format.fontStrikeOut() &&
              !format.fontFixedPitch());
    }
  }

  void everyWordHasTheInk() {
    const Written written = write(everyBlock, asText, Qt::darkCyan);
    for (const char *letter : {"A", "B", "D", "E", "F", "G", "H"})
      QCOMPARE(formatOf(written, letter).foreground().color(), QColor(Qt::darkCyan));
  }

  void formulasAreToldInTheOrderInWhichTheyStand() {
    const Written written = write(everyBlock);
    QCOMPARE(written.formulas, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    QCOMPARE(written.document->toPlainText().count(QChar::ObjectReplacementCharacter), 5);
  }

  void formulaGetsTheFormatThatIsAskedForIt_fromThatOfTheTextInItsPlace() {
    constexpr int property = QTextFormat::UserProperty + 7;
    const Written written = write("a $x$ **b $y$**", [](std::size_t formula, QTextCharFormat text) {
      text.setProperty(property, QString("%1 %2").arg(formula).arg(text.fontWeight() == QFont::Bold));
      return text;
    });
    QStringList asked;
    for (int at = 0; at < written.document->characterCount(); ++at) {
      QTextCursor behind(written.document.get());
      behind.setPosition(std::min(at + 1, written.document->characterCount() - 1));
      if (written.document->characterAt(at) == QChar::ObjectReplacementCharacter)
        asked << behind.charFormat().stringProperty(property);
      else
        QVERIFY(!behind.charFormat().hasProperty(property) || at == written.document->characterCount() - 1);
    }
    QCOMPARE(asked, (QStringList{"0 0", "1 1"}));
  }

  void formulaThatTheTextsCharacterForOneImitates_isNone() {
    const Written written = write(QString("a%1b $x$ c%1").arg(QChar(QChar::ObjectReplacementCharacter)));
    QCOMPARE(breakable(written.document->toPlainText()),
             QString("ab %1 c").arg(QChar(QChar::ObjectReplacementCharacter)));
    QCOMPARE(written.formulas.size(), std::size_t(1));
  }

  void headingIsLargerTheHigherItStands() {
    int before = 0;
    for (int level = 1; level <= 6; ++level) {
      const Written written = write(QString(level, '#') + " Words");
      QCOMPARE(written.paragraph(0).blockFormat().headingLevel(), level);
      const QTextCharFormat format = formatOf(written, "Words");
      QCOMPARE(format.fontWeight(), int(QFont::Bold));
      const int size = format.intProperty(QTextFormat::FontSizeAdjustment);
      QVERIFY(level == 1 || size == before - 1);
      before = size;
    }
  }

  void listShowsItsMark_data() {
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<int>("style");
    QTest::addColumn<QString>("second");
    QTest::newRow("disc") << "- a\n- b" << int(QTextListFormat::ListDisc) << ".";
    QTest::newRow("circle") << "* a\n* b" << int(QTextListFormat::ListCircle) << ".";
    QTest::newRow("square") << "+ a\n+ b" << int(QTextListFormat::ListSquare) << ".";
    QTest::newRow("point") << "1. a\n2. b" << int(QTextListFormat::ListDecimal) << "2.";
    QTest::newRow("parenthesis") << "1) a\n2) b" << int(QTextListFormat::ListDecimal) << "2)";
  }
  void listShowsItsMark() {
    QFETCH(QString, markdown);
    const Written written = write(markdown);
    const QTextList *list = written.paragraph(0).textList();
    QVERIFY(list);
    QCOMPARE(list->count(), 2);
    QCOMPARE(written.paragraph(1).textList(), list);
    QTEST(int(list->format().style()), "style");
    QTEST(list->itemText(written.paragraph(1)), "second");
  }

  void listThatIsInterruptedByAnInnerOne_goesOnCounting() {
    const Written written = write("1. a\n   - b\n   - c\n2. d");
    QCOMPARE(written.document->toPlainText(), QString("a\nb\nc\nd"));
    const QTextList *outer = written.paragraph(0).textList();
    const QTextList *inner = written.paragraph(1).textList();
    QVERIFY(outer && inner && outer != inner);
    QCOMPARE(written.paragraph(2).textList(), inner);
    QCOMPARE(outer->itemText(written.paragraph(3)), QString("2."));
    QVERIFY(inner->format().indent() > outer->format().indent());
  }

  void itemsFurtherParagraph_isIndentedAndHasNoMark() {
    const Written written = write("- a\n\n  b\n\nc");
    QVERIFY(written.paragraph(0).textList());
    QVERIFY(!written.paragraph(1).textList());
    QCOMPARE(written.paragraph(1).blockFormat().indent(), written.paragraph(0).textList()->format().indent());
    QCOMPARE(written.paragraph(2).blockFormat().indent(), 0);
  }

  void boxOfAnItemIsTickedWhereItWas() {
    const Written written = write("- [x] a\n- [ ] b\n- c");
    using Marker = QTextBlockFormat::MarkerType;
    QCOMPARE(written.paragraph(0).blockFormat().marker(), Marker::Checked);
    QCOMPARE(written.paragraph(1).blockFormat().marker(), Marker::Unchecked);
    QCOMPARE(written.paragraph(2).blockFormat().marker(), Marker::NoMarker);
  }

  void itemsMarkIsNoLargerBeforeAHeading() {
    const Written written = write("- # Words\n- more");
    QCOMPARE(written.paragraph(0).charFormat().intProperty(QTextFormat::FontSizeAdjustment), 0);
    QVERIFY(formatOf(written, "Words").intProperty(QTextFormat::FontSizeAdjustment) > 0);
  }

  void quoteIsIndentedByItsDepth() {
    const Written written = write("a\n\n> b\n>\n> > c\n\nd");
    const auto margin = [&](int index) { return written.paragraph(index).blockFormat().leftMargin(); };
    QCOMPARE(margin(0), 0.0);
    QVERIFY(margin(1) > 0);
    QCOMPARE(margin(2), 2 * margin(1));
    QCOMPARE(margin(3), 0.0);
  }

  void codeKeepsItsLines() {
    const Written written = write("```\na\n\n  b | c\n```");
    QCOMPARE(written.document->blockCount(), 3);
    QVERIFY(written.paragraph(1).text().isEmpty());
    QVERIFY(written.paragraph(2).text().startsWith("  b"));
    QVERIFY(formatOf(written, "a").fontFixedPitch());
  }

  void codeWithoutALine_takesNoRoom() {
    QCOMPARE(write("a\n\n```\n```\n\nb").document->toPlainText(), QString("a\nb"));
  }

  void brokenLineStaysInItsParagraph() {
    const Written written = write("a\\\nb");
    QCOMPARE(written.document->blockCount(), 1);
    QCOMPARE(written.paragraph(0).text(), QString("a%1b").arg(QChar(QChar::LineSeparator)));
  }

  void placesWhereALineMayNotEnd_areFoundAcrossPieces() {
    const Written written = write("so **t** = *3* and **|u|** $x$ = `4`");
    QString shown = written.paragraph(0).text();
    shown.replace(QChar(QChar::Nbsp), '_')
        .replace(wordJoiner, '^')
        .replace(QChar::ObjectReplacementCharacter, '$');
    QCOMPARE(shown, QString("so t_=_3 and |^u|^ $^_=_4"));
    QVERIFY(formatOf(written, "3").fontItalic());
    QVERIFY(formatOf(written, "4").fontFixedPitch());
    QCOMPARE(formatOf(written, "u").fontWeight(), int(QFont::Bold));
    QVERIFY(formatOf(written, "and").fontWeight() != QFont::Bold);
  }

  void paragraphsAreFartherFromEachOtherThanItems_andNothingIsBelowTheLast() {
    const Written written = write("a\n\nb\n\n- c\n- d");
    const auto gap = [&](int index) { return written.paragraph(index).blockFormat().bottomMargin(); };
    QCOMPARE(gap(0), gap(1));
    QVERIFY(gap(2) > 0 && gap(2) < gap(1));
    QCOMPARE(gap(3), 0.0);
  }
};

QTEST_MAIN(MarkdownWriterTest)
#include "markdown_writer_test.moc"
