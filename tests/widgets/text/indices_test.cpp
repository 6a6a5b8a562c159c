// Indices of letters in plain text.
#include "widgets/text/indices.h"

#include <QTextCursor>
#include <QTextDocument>
#include <QtTest>

using namespace halfspace;

class IndicesTest : public QObject {
  Q_OBJECT

private slots:
  void runsOfPlainText_areLettersAndTheirIndices_data() {
    QTest::addColumn<QString>("plain");
    QTest::addColumn<QString>("marked"); // an index in brackets
    QTest::newRow("none") << "t = 3"
                          << "t = 3";
    QTest::newRow("nothing") << ""
                             << "";
    QTest::newRow("one") << "v_d is 3"
                         << "v[d] is 3";
    QTest::newRow("at both ends") << "n_G = d_G"
                                  << "n[G] = d[G]";
    QTest::newRow("behind a small digit") << "−n_G·P₀_G"
                                          << "−n[G]·P[0,G]";
    QTest::newRow("small digits alone") << "P₁₂ and P₀"
                                        << "P₁₂ and P₀";
    QTest::newRow("Greek") << "λ_G"
                           << "λ[G]";
    QTest::newRow("between bars") << "|m_g|"
                                  << "|m[g]|";
    QTest::newRow("a blank to fill in") << "___ and a _ b"
                                        << "___ and a _ b";
  }
  void runsOfPlainText_areLettersAndTheirIndices() {
    QFETCH(QString, plain);
    QFETCH(QString, marked);
    QString written;
    for (const TextRun &run : runsOf(plain))
      written += run.isIndex ? "[" + run.text + "]" : run.text;
    QCOMPARE(written, marked);
  }

  void richText_saysTheSame_withNothingReadAsTags() {
    QTextDocument document;
    document.setHtml(richTextOf("h < R_b> and v_d"));
    QCOMPARE(document.toPlainText(), QString("h < Rb> and vd"));
    QTextCursor cursor(&document);
    cursor.movePosition(QTextCursor::End);
    QCOMPARE(cursor.charFormat().verticalAlignment(), QTextCharFormat::AlignSubScript);
    QCOMPARE(cursor.charFormat().intProperty(QTextFormat::FontSizeAdjustment), 1); // by 1.2
  }

  void index_isSmallerThanItsText_andStandsLower() {
    QFont text;
    text.setPixelSize(20);
    QVERIFY(indexFont(text).pixelSize() < 18);
    QVERIFY(indexFont(text).pixelSize() > 14);
    QVERIFY(indexDrop(text) > 2);
  }
};

QTEST_MAIN(IndicesTest)
#include "indices_test.moc"
