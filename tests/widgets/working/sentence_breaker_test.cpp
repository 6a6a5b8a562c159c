// Sentences broken on lines.
#include "widgets/working/sentence_breaker.h"

#include <QFontMetricsF>
#include <QtTest>

using namespace halfspace;

namespace {

QFont fontOf(int pixels) {
  QFont font;
  font.setPixelSize(pixels);
  return font;
}

QStringList texts(const std::vector<SentenceBreaker::Line> &lines) {
  QStringList all;
  for (const SentenceBreaker::Line &line : lines)
    all << line.text;
  return all;
}

const QString sentence("So many steps lead from the point to the plane, and no more.");

} // namespace

class SentenceBreakerTest : public QObject {
  Q_OBJECT

private slots:
  void linesFitIntoTheWidth_andSayTheWholeSentence_data() {
    QTest::addColumn<double>("width");
    for (const double width : {90.0, 150.0, 260.0, 2000.0})
      QTest::newRow(qPrintable(QString::number(width))) << width;
  }
  void linesFitIntoTheWidth_andSayTheWholeSentence() {
    QFETCH(double, width);
    SentenceBreaker breaker;
    const auto &lines = breaker.lines(sentence, fontOf(16), width);
    for (const SentenceBreaker::Line &line : lines)
      QVERIFY(QFontMetricsF(fontOf(16)).horizontalAdvance(line.text.trimmed()) <= width + 1);
    QCOMPARE(texts(lines).join(QString()), sentence);
    QCOMPARE(lines.size() == 1, width == 2000);
  }

  void wordThatFitsNowhere_standsOnALineOfItsOwn() {
    SentenceBreaker breaker;
    QCOMPARE(texts(breaker.lines("a perpendicular b", fontOf(16), 20)),
             (QStringList{"a ", "perpendicular ", "b"}));
  }

  void relationAndLength_stayOnOneLine() {
    SentenceBreaker breaker;
    const QString kept("t = |n|");
    const QFont font = fontOf(16);
    const auto &lines =
        breaker.lines("word " + kept, font, QFontMetricsF(font).horizontalAdvance("word t = |"));
    QCOMPARE(lines.size(), std::size_t(2));
    QCOMPARE(lines[0].text, QString("word "));
  }

  void indices_standBehindTheirLetters_smallerThanThese() {
    SentenceBreaker breaker;
    const QFont font = fontOf(16);
    const auto &lines = breaker.lines("So v_d is one step", font, 70);
    QCOMPARE(texts(lines).join(QString()), QString("So vd is one step"));
    QVERIFY(lines.size() > 1);
    const auto &runs = lines[0].runs;
    QCOMPARE(runs.size(), std::size_t(3));
    QVERIFY(!runs[0].isIndex && runs[1].isIndex && !runs[2].isIndex);
    QVERIFY(qAbs(runs[1].x - QFontMetricsF(font).horizontalAdvance("So v")) < 1);
    QVERIFY(runs[2].x - runs[1].x < QFontMetricsF(font).horizontalAdvance("d"));
    QCOMPARE(lines[1].runs[0].x, 0.0);
  }

  void emptySentence_hasAtMostAnEmptyLine() {
    SentenceBreaker breaker;
    QVERIFY(texts(breaker.lines({}, fontOf(16), 100)).join(QString()).isEmpty());
  }

  void sameSentence_isBrokenAnewForAnotherWidthOrFont() {
    SentenceBreaker breaker;
    const QStringList wide = texts(breaker.lines(sentence, fontOf(16), 300));
    const double height = breaker.lines(sentence, fontOf(16), 300).front().height;
    QVERIFY(texts(breaker.lines(sentence, fontOf(16), 100)).size() > wide.size());
    QCOMPARE(texts(breaker.lines(sentence, fontOf(16), 300)), wide);
    QVERIFY(texts(breaker.lines(sentence, fontOf(32), 300)).size() > wide.size());
    QVERIFY(breaker.lines(sentence, fontOf(32), 300).front().height > 1.7 * height);
    QCOMPARE(texts(breaker.lines(sentence, fontOf(16), 300)), wide);
  }

  void linesOfALongDrag_areThoseOfTheirOwnSentences() {
    SentenceBreaker breaker;
    for (int round = 0; round < 2; ++round)
      for (int i = 0; i < 500; ++i) {
        const QString each = QString("The distance is %1 here.").arg(i);
        QCOMPARE(texts(breaker.lines(each, fontOf(16), 2000)), QStringList{each});
      }
  }

  void lettersStandBetweenTheTopOfTheLineAndItsBottom() {
    SentenceBreaker breaker;
    for (const SentenceBreaker::Line &line : breaker.lines(sentence, fontOf(16), 100)) {
      QVERIFY(line.ascent > 0.5 * 16);
      QVERIFY(line.ascent < line.height);
    }
  }
};

QTEST_MAIN(SentenceBreakerTest)
#include "sentence_breaker_test.moc"
