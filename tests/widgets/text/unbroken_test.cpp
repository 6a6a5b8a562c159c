// Where lines of running text may not break.
#include "widgets/text/unbroken.h"

#include <QFont>
#include <QTextLayout>
#include <QtTest>

using namespace halfspace;

namespace {

/// The lines of the text where each is as short as may be, as they are read.
QStringList shortestLines(const QString &words) {
  const QString text = unbroken(words);
  QStringList lines;
  QTextLayout layout(text, QFont());
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(1);
    lines << text.mid(line.textStart(), line.textLength())
                 .remove(QChar(0x2060))
                 .replace(QChar(QChar::Nbsp), QChar(' '))
                 .trimmed();
  }
  layout.endLayout();
  return lines;
}

} // namespace

class UnbrokenTest : public QObject {
  Q_OBJECT

private slots:
  void textBreaksOnlyWhereAReaderDoesNotStumble_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QStringList>("lines");
    QTest::newRow("plain words") << "so it is" << QStringList{"so", "it", "is"};
    for (const QString relation : {"=", "≈", "<", ">", "≤", "≥"})
      QTest::newRow(qPrintable("beside " + relation))
          << "so t " + relation + " 3 holds" << QStringList{"so", "t " + relation + " 3", "holds"};
    QTest::newRow("chain of relations") << "so a = b = c holds" << QStringList{"so", "a = b = c", "holds"};
    QTest::newRow("chain of several letters") << "0 < ab ≤ 10 is" << QStringList{"0 < ab ≤ 10", "is"};
    QTest::newRow("length") << "so |n| holds" << QStringList{"so", "|n|", "holds"};
    QTest::newRow("length that equals") << "so |n| = 3 holds" << QStringList{"so", "|n| = 3", "holds"};
    QTest::newRow("arithmetic") << "so a + b holds" << QStringList{"so", "a", "+", "b", "holds"};
  }
  void textBreaksOnlyWhereAReaderDoesNotStumble() {
    QFETCH(QString, words);
    QFETCH(QStringList, lines);
    QCOMPARE(shortestLines(words), lines);
  }

  void textGrowsByOneCharacterForEachBarOnly_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<int>("bars");
    QTest::newRow("none") << "t = 3 and s ≥ 4" << 0;
    QTest::newRow("length") << "|n| = 3" << 2;
    QTest::newRow("norm") << "||n|| = 3" << 4;
    QTest::newRow("nothing at all") << "" << 0;
  }
  void textGrowsByOneCharacterForEachBarOnly() {
    QFETCH(QString, words);
    QFETCH(int, bars);
    QCOMPARE(unbroken(words).size(), words.size() + bars);
  }

  void relationWithoutAPartner_leavesItsSpaces() {
    for (const QString words : {"= 3", "t =", "t=3", "a  = b"})
      QCOMPARE(unbroken(words), words);
  }
};

QTEST_MAIN(UnbrokenTest)
#include "unbroken_test.moc"
