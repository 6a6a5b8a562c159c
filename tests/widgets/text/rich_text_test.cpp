// Markdown with formulas as documents.
#include "lessons/files/picture_bytes.h"
#include "tests/widgets/text/as_written.h"
#include "widgets/text/lesson_pictures.h"
#include "widgets/text/picture_object.h"
#include "widgets/text/rich_label.h"
#include "widgets/text/unbroken.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QHelpEvent>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextList>
#include <QToolTip>
#include <QtTest>

using namespace halfspace;
using test::asWritten;

namespace {

QString plain(const QString &markdown, const Typesetter &typesetter) {
  return RichText(asWritten(markdown), typesetter, {QFont(), Qt::black}).plain();
}

QImage painted(const RichText &text) {
  QImage image(300, 200, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  text.document().drawContents(&painter);
  return image;
}

/// A red picture as a file.
void writePicture(const QString &file, QSize size, const char *format = "png") {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::red);
  image.save(file, format);
}

/// The bytes of a red picture's file.
std::string pictureBytes(QSize size, const char *format) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::red);
  image.setText("title", QString(1000, 'a')); // PNG files have it compressed
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, format);
  return bytes.toStdString();
}

/// The same JPEG file, going over its picture so often.
std::string withScans(const std::string &jpeg, std::size_t scans) {
  const std::size_t begin = jpeg.find("\xFF\xDA");
  const std::size_t end = jpeg.rfind("\xFF\xD9");
  std::string many = jpeg.substr(0, begin);
  for (std::size_t i = 0; i < scans; ++i)
    many += jpeg.substr(begin, end - begin);
  return many + jpeg.substr(end);
}

/// How many columns of the text, laid out so wide, have red in them.
int redWidth(const RichText &text, int width) {
  text.document().setTextWidth(width);
  const QImage image = painted(text);
  int columns = 0;
  for (int x = 0; x < image.width(); ++x) {
    bool red = false;
    for (int y = 0; y < image.height(); ++y)
      red = red || image.pixel(x, y) == qRgb(255, 0, 0);
    columns += red ? 1 : 0;
  }
  return columns;
}

QFont usualFont() {
  QFont font;
  font.setPixelSize(16);
  return font;
}

} // namespace

class RichTextTest : public QObject {
  Q_OBJECT

private slots:
  void whatBelongsToAFormulaIsNotTornOffByTheEndOfALine() {
    const Typesetter typesetter;
    QCOMPARE(plain("now $t$ = $3$, so", typesetter), QString("now t = 3, so"));
    const RichText rich(asWritten("word |n| = (2√43)/3 word"), typesetter, {QFont(), Qt::black});
    rich.document().setTextWidth(QFontMetricsF(QFont()).horizontalAdvance("word |n| = (2√43)"));
    rich.document().size(); // lays it out
    const QTextLine first = rich.document().begin().layout()->lineAt(0);
    QCOMPARE(rich.document().begin().text().left(first.textLength()), QString("word "));
  }

  void everyFormulaStandsInTheDocument() {
    const Typesetter typesetter;
    const RichText rich(asWritten("The normal $\\vec n$ in **bold $x$** and\n\n- $\\frac{1}{2}$ in a list"),
                        typesetter, {QFont(), Qt::black});
    QCOMPARE(rich.document().toPlainText().count(QChar::ObjectReplacementCharacter), 3);
    QVERIFY(rich.plain().contains("in a list"));
  }

  void lineGrowsForATallFormula() {
    const Typesetter typesetter;
    const auto heightOf = [&](const QString &markdown) {
      return RichText(asWritten(markdown), typesetter, {QFont(), Qt::black}).document().size().height();
    };
    QVERIFY(heightOf("a $\\displaystyle\\frac{\\frac12}{\\frac12}$ b") > 1.3 * heightOf("a $x$ b"));
  }

  void formulaStandsOnTheTextsBaseline_data() {
    QTest::addColumn<QString>("latex");
    QTest::newRow("flat") << "\\rule{1em}{1em}";
    QTest::newRow("deep") << "\\rule{1em}{1em}\\frac{x}{\\rule{1em}{2em}}";
    QTest::newRow("high and deep") << "\\rule{1em}{1em}\\frac{\\rule{1em}{2em}}{\\rule{1em}{2em}}";
  }
  void formulaStandsOnTheTextsBaseline() {
    QFETCH(QString, latex);
    const Typesetter typesetter;
    QFont font;
    font.setPixelSize(40);
    const RichText rich(asWritten("H $" + latex + "$"), typesetter, {font, Qt::black});
    QImage image(400, 400, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    rich.document().drawContents(&painter);
    painter.end();
    const auto lowestInk = [&](int column) {
      int row = image.height() - 1;
      while (row > 0 && qGray(image.pixel(column, row)) > 127)
        --row;
      return row;
    };
    int stem = 0;
    while (lowestInk(stem) == 0)
      ++stem;
    const int rule = QFontMetrics(font).horizontalAdvance("H ") + 10;
    QVERIFY2(std::abs(lowestInk(stem + 1) - lowestInk(rule)) <= 1,
             qPrintable(QString("%1 %2").arg(lowestInk(stem + 1)).arg(lowestInk(rule))));
  }

  void htmlStandsAsWrittenAndImagesAreNotLoaded() {
    const Typesetter typesetter;
    const RichText rich(
        asWritten("<b>no</b> ![a picture](file:///etc/hostname) and [a link](https://example.org)"),
        typesetter, {QFont(), Qt::black});
    QVERIFY(rich.plain().contains("<b>no</b>"));
    QVERIFY(rich.plain().contains("a link"));
    QVERIFY(!rich.document().toPlainText().contains(QChar::ObjectReplacementCharacter));
    for (QTextBlock block = rich.document().begin(); block.isValid(); block = block.next())
      for (auto fragment = block.begin(); !fragment.atEnd(); ++fragment)
        QVERIFY(!fragment.fragment().charFormat().isImageFormat());
  }

  void plainTextReadsTheFormulas() {
    QCOMPARE(plain("Is $P_0$ **here**?", Typesetter()), QString("Is P₀ here?"));
    QCOMPARE(plain("a\\\n$x$,\n\n- b\n- $y$ c\n\n```\nd\ne\n```", Typesetter()),
             QString("a\nx,\nb\ny c\nd\ne"));
    QCOMPARE(plain(QString("a $x$ ") + QChar(QChar::ObjectReplacementCharacter) + " $y$", Typesetter()),
             QString("a x  y"));
  }

  void blocksLookLikeWhatTheyAre() {
    const Typesetter typesetter;
    const RichText rich(
        asWritten("# a $x$ b\n\n> c\n\n3. d\n   - e\n\n   f\n\n```\ng\nh\n```\n\n---\n\n- [x] i"), typesetter,
        {QFont(), Qt::black});
    QStringList looks;
    for (QTextBlock block = rich.document().begin(); block.isValid(); block = block.next()) {
      const QTextBlockFormat format = block.blockFormat();
      looks << QStringList{breakable(block.text()).replace(QChar::ObjectReplacementCharacter, '$'),
                           block.textList() ? block.textList()->itemText(block) +
                                                  QString::number(block.textList()->format().indent())
                                            : QString(),
                           format.headingLevel() > 0 ? "heading" : "",
                           format.leftMargin() > 0 ? "quote" : "",
                           format.indent() > 0 ? "indented" : "",
                           block.charFormat().fontFixedPitch() ? "code" : "",
                           format.hasProperty(QTextFormat::BlockTrailingHorizontalRulerWidth) ? "rule" : "",
                           format.marker() == QTextBlockFormat::MarkerType::Checked ? "ticked" : ""}
                   .filter(QRegularExpression("."))
                   .join(' ');
    }
    QCOMPARE(looks, (QStringList{"a $ b heading", "c quote", "d 1.1", "e .2", "f indented", "g code",
                                 "h code", "rule", "i .1 ticked"}));
  }

  void wordsOfAHeadingKeepItsSizeBehindAFormulaAndInOtherFaces() {
    const Typesetter typesetter;
    const RichText rich(asWritten("# a $x$ *b* `c` d"), typesetter, {QFont(), Qt::black});
    const QTextBlock heading = rich.document().begin();
    for (auto fragment = heading.begin(); !fragment.atEnd(); ++fragment) {
      const QTextCharFormat format = fragment.fragment().charFormat();
      QCOMPARE(format.intProperty(QTextFormat::FontSizeAdjustment), 3);
      QCOMPARE(format.fontWeight(), int(QFont::Bold));
    }
  }

  void wordsThatAreTooLongForMarkdownStandAsTheyAreWritten() {
    const Typesetter typesetter;
    const QString words("*a* $x$ ");
    const QString tooLong = words.repeated(int(maxMarkdownBytes) / words.size() + 1);
    QCOMPARE(plain(tooLong, typesetter), tooLong.trimmed());
  }

  void macrosAreKnownToTheEyeAndToTheEar() {
    const Typesetter typesetter = Typesetter().with({{"len", {1, "\\lvert #1\\rvert"}}});
    const RichText rich(asWritten("So $\\len n$ is"), typesetter, {QFont(), Qt::black});
    const RichText same(asWritten("So $\\lvert n\\rvert$ is"), typesetter, {QFont(), Qt::black});
    QCOMPARE(painted(rich), painted(same));
    QCOMPARE(rich.plain(), QString("So |n| is"));
  }

  void barsAndRelationsInWords_areReadOutAsTheyAreWritten() {
    const Typesetter typesetter;
    const RichText rich(asWritten("So |n| = 3 here"), typesetter, {QFont(), Qt::black});
    QCOMPARE(rich.plain(), QString("So |n| = 3 here"));
  }

  void formulaThatCannotBeReadStandsOutAndSaysWhyToEyeAndEar() {
    const Typesetter typesetter;
    RichText rich(asWritten("Words, $x$ and $\\foo$."), typesetter, {QFont(), Qt::black, Qt::red});
    rich.document().setTextWidth(300);
    const QString why("Column 1: `\\foo` is unknown.");
    QCOMPARE(rich.plain(), QString("Words, x and foo. (a formula that cannot be read: " + why + ")"));
    const QImage image = painted(rich);
    int told = 0;
    for (int x = 0; x < image.width(); ++x)
      for (int y = 0; y < image.height(); ++y) {
        const QString problem = rich.problemAt(QPointF(x, y));
        QVERIFY(problem.isEmpty() || problem == why);
        told += problem.isEmpty() ? 0 : 1;
        const QColor color = image.pixelColor(x, y);
        if (color.red() - color.green() > 100)
          QVERIFY2(!problem.isEmpty(), qPrintable(QString("red at %1, %2").arg(x).arg(y)));
        if (color.red() < 100 && color.green() < 100)
          QVERIFY2(problem.isEmpty(), qPrintable(QString("black at %1, %2").arg(x).arg(y)));
      }
    QVERIFY(told > 50);
    rich.setWords(asWritten("Words, $x$ and $y$."));
    QCOMPARE(rich.plain(), QString("Words, x and y."));
    QVERIFY(rich.problemAt(QPointF(120, 10)).isEmpty());
  }

  void text_withOtherValuesInTheSameWords_isAsIfMadeAnew() {
    const Typesetter typesetter;
    const QString words("Now $t$ is $%1$, and **so** on:\n\n- one\n- $s = %2$");
    RichText changed(asWritten(words.arg("3", "1")), typesetter, {QFont(), Qt::black});
    for (const char *value : {"\\frac{10}{3}", "4", "\\sqrt{\\frac{1}{\\frac{2}{3}}}"}) {
      const QString markdown = words.arg("-2", value);
      changed.setWords(asWritten(markdown));
      const RichText fresh(asWritten(markdown), typesetter, {QFont(), Qt::black});
      QCOMPARE(changed.plain(), fresh.plain());
      QCOMPARE(changed.document().size(), fresh.document().size());
      QCOMPARE(painted(changed), painted(fresh));
    }
    changed.setWords(asWritten("Other words"));
    QCOMPARE(changed.plain(), QString("Other words"));
  }

  void liveNumbers_arePaintedAndReadOutAsFormulas() {
    const Typesetter typesetter;
    const QString words("Now $t$ = %1, and **so** %1.\n\n| a |\n|---|\n| [%1](https://b.c) |\n\n%1");
    const auto half = [](const std::string &) { return LiveNumber{number(Rational(-1, 2))}; };
    const RichText live(filledIn(MarkdownText(words.arg("{t}").toStdString()).markdown(), half), typesetter,
                        {QFont(), Qt::black});
    const RichText written(asWritten(words.arg("$-1/2$")), typesetter, {QFont(), Qt::black});
    QCOMPARE(painted(live), painted(written));
    QCOMPARE(live.plain(), written.plain());
    QVERIFY2(live.plain().startsWith("Now t = −1/2, and so −1/2.\n"), qPrintable(live.plain()));
  }

  void liveNumbers_besideAFormulaThatCannotBeRead_stillTellWhy() {
    const Typesetter typesetter;
    const auto three = [](const std::string &) { return LiveNumber{number(3)}; };
    const RichText live(filledIn(MarkdownText("So $\\foo$ = {t}.").markdown(), three), typesetter,
                        {QFont(), Qt::black});
    QCOMPARE(live.plain(),
             QString("So foo = 3. (a formula that cannot be read: Column 1: `\\foo` is unknown.)"));
  }

  void newValues_setAnewOnlyTheNumbersThatChanged() {
    const Typesetter typesetter;
    const Markdown words = MarkdownText("So $t$ = {t}, and $u$ = {u}.").markdown();
    const auto with = [&](int t, int u) {
      return filledIn(words,
                      [=](const std::string &name) { return LiveNumber{number(name == "t" ? t : u)}; });
    };
    RichText text(with(1, 2), typesetter, {QFont(), Qt::black});
    const QSignalSpy changes(&text.document(), &QTextDocument::contentsChange);
    text.setWords(with(1, 2));
    QCOMPARE(changes.size(), 0);
    text.setWords(with(1, 3));
    QCOMPARE(changes.size(), 1);
    const int secondFormula = QStringLiteral("So ?? and ").size(); // behind each an invisible character
    QCOMPARE(changes.first(), (QList<QVariant>{secondFormula, 1, 1}));
    QCOMPARE(text.plain(), QString("So t = 1, and u = 3."));
  }

  void pictureOfTheLessonsFolder_isDrawnNoWiderThanTheLines_andReadOut() {
    const Typesetter typesetter;
    const QTemporaryDir folder;
    writePicture(folder.filePath("a.png"), {100, 20});
    writePicture(folder.filePath("b.jpg"), {100, 20}, "jpg");
    const RichText rich(asWritten("words ![a box](a.png) and $x$"), typesetter,
                        {usualFont(), Qt::black, {}, {}, folder.path().toStdString()});
    QCOMPARE(redWidth(rich, 290), 100);
    QCOMPARE(redWidth(rich, 60), 60);
    QCOMPARE(rich.plain(), QString("words a box and x"));
    QFont large = usualFont();
    large.setPixelSize(32);
    const RichText grown(asWritten("![a box](a.png)"), typesetter,
                         {large, Qt::black, {}, {}, folder.path().toStdString()});
    QCOMPARE(redWidth(grown, 290), 200);
    const RichText jpeg(asWritten("![a box](b.jpg)"), typesetter,
                        {usualFont(), Qt::black, {}, {}, folder.path().toStdString()});
    QVERIFY(!jpeg.document().toPlainText().contains("a box"));
  }

  void pictureThatCannotBeShown_isDescribedWithTheReason_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    QTest::newRow("not there") << "b.png"
                               << "There is no picture";
    QTest::newRow("outside") << "../outside.png"
                             << "is not in";
    QTest::newRow("text") << "text.png"
                          << "neither a PNG nor a JPEG";
    QTest::newRow("drawing") << "drawing.svg"
                             << "neither a PNG nor a JPEG";
    QTest::newRow("cut off") << "cut.png"
                             << "damaged";
    QTest::newRow("too many pixels") << "huge.png"
                                     << "too many pixels";
  }
  void pictureThatCannotBeShown_isDescribedWithTheReason() {
    QFETCH(QString, name);
    QFETCH(QString, reason);
    const Typesetter typesetter;
    const QTemporaryDir outer;
    writePicture(outer.filePath("outside.png"), {100, 100});
    const QDir folder(outer.filePath("lesson"));
    QVERIFY(folder.mkpath("."));
    const auto write = [&](const QString &file, const QByteArray &bytes) {
      QFile out(folder.filePath(file));
      QVERIFY(out.open(QFile::WriteOnly));
      out.write(bytes);
    };
    write("text.png", "words");
    write("drawing.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>");
    writePicture(folder.filePath("whole.png"), {100, 100});
    QFile whole(folder.filePath("whole.png"));
    QVERIFY(whole.open(QFile::ReadOnly));
    write("cut.png", whole.readAll().left(60));
    QImage(5000, 5000, QImage::Format_Mono).save(folder.filePath("huge.png"));
    const RichText rich(asWritten("![a box](" + name + ") and $x$"), typesetter,
                        {usualFont(), Qt::black, Qt::red, {}, folder.path().toStdString()});
    QVERIFY2(rich.plain().startsWith("a box (") && rich.plain().contains(name) &&
                 rich.plain().contains(reason),
             qPrintable(rich.plain()));
    QVERIFY(redWidth(rich, 290) > 10);
  }

  void pngFile_isReadWithoutWhatIsNotSeen() {
    const std::string bytes = pictureBytes({10, 10}, "png");
    QVERIFY(bytes.find("tEXt") != std::string::npos || bytes.find("zTXt") != std::string::npos);
    int pixelsLeft = mostPixelsOfPage;
    const auto image = imageOf(bytes, pixelsLeft);
    QVERIFY(image);
    QVERIFY(image->textKeys().isEmpty());
    QCOMPARE(image->pixel(5, 5), qRgb(255, 0, 0));
    QCOMPARE(pixelsLeft, mostPixelsOfPage - leastPixelsTaken);
  }

  void pngFile_whoseLengthsLie_isCutOffThere() {
    const std::string bytes = pictureBytes({10, 10}, "png");
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      std::string damaged = bytes;
      damaged[at] = '\xFF';
      QVERIFY(seenPartOfPng(damaged).size() <= bytes.size());
      QVERIFY(seenPartOfPng(damaged.substr(0, at)).size() <= at);
    }
  }

  void jpegFile_goesOverItsPictureSoOftenAndNoMore() {
    const std::string once = pictureBytes({10, 10}, "jpg");
    QCOMPARE(scansOfJpeg(once), std::size_t(1));
    QCOMPARE(scansOfJpeg(withScans(once, 7)), std::size_t(7));
    QCOMPARE(scansOfJpeg(once.substr(0, 2)), std::size_t(0));
    for (std::size_t end = 0; end < once.size(); ++end)
      QVERIFY(scansOfJpeg(std::string_view(once).substr(0, end)) <= 1);
    int pixelsLeft = mostPixelsOfPage;
    // What a decoder makes of a scan that comes again is its own affair.
    const auto most = imageOf(withScans(once, mostPictureScans), pixelsLeft);
    QVERIFY(most || most.problem().sentence.find("scans") == std::string::npos);
    const auto refused = imageOf(withScans(once, mostPictureScans + 1), pixelsLeft);
    QVERIFY(!refused);
    QVERIFY(refused.problem().sentence.find("at most 24 scans") != std::string::npos);
  }

  void picturesOfAPage_haveSoManyPixelsTogetherAndNoMore() {
    const QSize large(1000, 1000);
    const std::string bytes = pictureBytes(large, "png");
    int pixelsLeft = 2 * large.width() * large.height() - 1;
    QVERIFY(imageOf(bytes, pixelsLeft));
    QCOMPARE(pixelsLeft, large.width() * large.height() - 1);
    const auto refused = imageOf(bytes, pixelsLeft);
    QVERIFY(!refused);
    QVERIFY(refused.problem().sentence.find("no room for it") != std::string::npos);
  }

  void smallOrDamagedPicture_takesSomeRoomToo() {
    for (const std::string &bytes : {pictureBytes({1, 1}, "png"), std::string("words")}) {
      int pixelsLeft = 2 * leastPixelsTaken - 1;
      QVERIFY(!whyNoMorePictures(pixelsLeft));
      (void)imageOf(bytes, pixelsLeft);
      QCOMPARE(pixelsLeft, leastPixelsTaken - 1);
      QVERIFY(whyNoMorePictures(pixelsLeft));
      const auto refused = imageOf(bytes, pixelsLeft);
      QVERIFY(refused.problem().sentence.find("no room for it") != std::string::npos);
    }
  }

  void piecesOfAPage_shareTheRoomForPictures_andOneMadeAnewGivesItsBack() {
    const Typesetter typesetter;
    const QTemporaryDir folder;
    writePicture(folder.filePath("a.png"), {10, 10});
    RichTextStyle style{usualFont(), Qt::black};
    style.pictures = {folder.path().toStdString(), std::make_shared<int>(leastPixelsTaken)};
    RichText first(asWritten("![first](a.png)"), typesetter, style);
    RichText second(asWritten("![second](a.png)"), typesetter, style);
    QCOMPARE(first.plain(), QString("first"));
    QVERIFY(second.plain().contains("no room for it"));
    style.ink = Qt::blue;
    first.setStyle(style);
    QCOMPARE(first.plain(), QString("first"));
    QVERIFY(redWidth(first, 290) == 10);
    first.setWords(asWritten("words"));
    second.setStyle(style);
    QCOMPARE(second.plain(), QString("second"));
  }

  void pictureWithoutAFolder_isDescribed() {
    const Typesetter typesetter;
    QCOMPARE(plain("![a box](a.png)", typesetter), QString("a box"));
  }

  void table_hasItsColumnsBesideEachOther_andNoLinesAroundIt() {
    const Typesetter typesetter;
    const RichText rich(asWritten("| left | right |\n|---|--:|\n| $x$ | b |\n| c | d |"), typesetter,
                        {usualFont(), Qt::black});
    rich.document().setTextWidth(290);
    const auto blockOf = [&](const QString &word) { return rich.document().find(word).block(); };
    const auto boxOf = [&](const QString &word) {
      return rich.document().documentLayout()->blockBoundingRect(blockOf(word));
    };
    QCOMPARE(boxOf("left").top(), boxOf("right").top());
    QVERIFY(boxOf("left").right() <= boxOf("right").left());
    QVERIFY(boxOf("c").top() > boxOf("left").bottom());
    QCOMPARE(blockOf("right").blockFormat().alignment(), Qt::AlignRight);
    QVERIFY(rich.document().find("left").charFormat().fontWeight() == QFont::Bold);
    QVERIFY(rich.document().find("d").charFormat().fontWeight() != QFont::Bold);
    const double line = QFontMetricsF(usualFont()).height();
    QVERIFY2(boxOf("right").left() - boxOf("left").right() > line / 2, "a gap between the columns");
    QVERIFY2(boxOf("left").top() < line, "no empty line above");
    QVERIFY2(rich.document().size().height() - boxOf("d").bottom() < 1.5 * line, "nor below");
    const RichText behind(asWritten("| a |\n|---|\n\nwords"), typesetter, {usualFont(), Qt::black});
    behind.document().setTextWidth(290);
    QCOMPARE(behind.document().lastBlock().text(), QString("words"));
  }

  void links_areFoundByTheirPlace_andInTheirOrder() {
    const Typesetter typesetter;
    const RichText rich(asWritten("[one *of*](https://a.b) and [$x$](https://c.d) [three](b.md)"), typesetter,
                        {usualFont(), Qt::black, {}, Qt::red});
    rich.document().setTextWidth(290);
    rich.document().size();
    QCOMPARE(rich.links().size(), std::size_t(2));
    QCOMPARE(rich.links()[0].selectedText(), QString("one of"));
    QCOMPARE(rich.links()[1].charFormat().anchorHref(), QString("https://c.d"));
    QCOMPARE(rich.linkAt({8, 8}), QString("https://a.b"));
    QVERIFY(rich.linkAt({8, 190}).isEmpty());
    QVERIFY(redWidth(rich, 290) > 10);
  }

  void labelShowsWhyAFormulaCannotBeReadAsAToolTip() {
    const Typesetter typesetter;
    RichLabel label(typesetter);
    label.setWords(asWritten("$\\foo$ and more"));
    label.resize(300, 100);
    label.show();
    QVERIFY(QTest::qWaitForWindowExposed(&label));
    const auto rest = [&](const QPoint &place) {
      QHelpEvent help(QEvent::ToolTip, place, label.mapToGlobal(place));
      QCoreApplication::sendEvent(&label, &help);
    };
    rest({10, 8});
    QVERIFY2(QToolTip::text().contains("is unknown"), qPrintable(QToolTip::text()));
    rest({200, 80});
    QTRY_VERIFY(!QToolTip::isVisible());
    QVERIFY(label.plain().contains("is unknown"));
  }

  void labelIsTallerInANarrowerPlace() {
    const Typesetter typesetter;
    RichLabel label(typesetter);
    label.setWords(asWritten("Some words with $\\vec n$ that need more than one line in a narrow place."));
    QVERIFY(label.heightForWidth(120) > label.heightForWidth(600));
    QVERIFY(label.plain().startsWith("Some words"));
  }

  void labelIsAsTallAsItsNewFormulaAtOnce() {
    const Typesetter typesetter;
    RichLabel label(typesetter);
    label.setWords(asWritten("$x$"));
    const int flat = label.heightForWidth(200);
    label.setWords(asWritten("$$\\frac{1}{\\frac{2}{3}}$$"));
    QVERIFY(label.heightForWidth(200) > flat);
  }
};

QTEST_MAIN(RichTextTest)
#include "rich_text_test.moc"
