// The line of words below the scene.
#include "widgets/view/case_line.h"

#include <QLabel>
#include <QtTest>

using namespace halfspace;

namespace {

constexpr std::chrono::milliseconds shortTime{60};

struct ShownLine {
  explicit ShownLine(std::chrono::milliseconds readingTime = CaseLine::usualReadingTime) : line(readingTime) {
    line.resize(600, 40);
    line.show();
  }
  /// What a label says; empty where it is hidden.
  QString said(const char *name) const {
    const auto *label = line.findChild<QLabel *>(name);
    return label->isVisible() ? label->text() : QString();
  }
  CaseLine line;
};

} // namespace

class CaseLineTest : public QObject {
  Q_OBJECT

private slots:
  void message_goesAfterItsTime_andAComplaintStaysUntilItIsMended() {
    ShownLine shown(shortTime);
    shown.line.setCase("The plane is behind.", false);
    shown.line.complain("It cannot be kept.", "The disk is full <now>.");
    shown.line.say("Text at 125 %.");
    QCOMPARE(shown.said("message"), QString("Text at 125 %."));
    QCOMPARE(shown.said("case"), QString());
    QTRY_COMPARE(shown.said("message"), QString());
    QCOMPARE(shown.said("complaint"), QString("It cannot be kept."));
    QCOMPARE(shown.line.findChild<QLabel *>("complaint")->toolTip(),
             QString("The disk is full &lt;now&gt;."));
    QCOMPARE(shown.said("case"), QString("The plane is behind."));
    shown.line.complain({});
    QCOMPARE(shown.said("complaint"), QString());
  }

  void message_ofAsManyWordsAsTheCase_leavesTheLineItsHeight() {
    ShownLine shown;
    const auto height = [&] { return shown.line.heightForWidth(600); };
    const QString words = QString("some words ").repeated(6);
    QVERIFY(QFontMetrics(shown.line.font()).horizontalAdvance(words) > 300); // more than half of the line
    shown.line.setCase(words, false);
    const int usual = height();
    shown.line.say(words);
    QCOMPARE(height(), usual);
  }

  void line_hasRoomForALongCaseFromTheStart() {
    ShownLine shown;
    for (const int width : {400, 900}) {
      shown.line.resize(width, 40);
      QCoreApplication::processEvents();
      const auto height = [&] { return shown.line.heightForWidth(width); };
      shown.line.setCase("t = 3.", false);
      const int usual = height();
      shown.line.setCase("t = −10/3 is negative: the plane is behind the ray's start, so it does not hit it.",
                         false);
      QCOMPARE(height(), usual);
    }
  }

  void message_goesWhenSomethingIsDragged() {
    ShownLine shown;
    shown.line.setCase("3", false);
    shown.line.say("Saved.");
    shown.line.setHeld(true);
    QCOMPARE(shown.said("message"), QString());
    QCOMPARE(shown.said("case"), QString("3"));
  }

  void message_saidAnew_hasItsWholeTimeAgain() {
    ShownLine shown(std::chrono::milliseconds(400));
    shown.line.say("First.");
    QTest::qWait(250);
    shown.line.say("Second.");
    QTest::qWait(250);
    QCOMPARE(shown.said("message"), QString("Second."));
  }

  void warning_looksDifferent() {
    ShownLine shown;
    shown.line.setStyleSheet("QLabel#case { color: black } QLabel#case[degenerate=\"true\"] { color: red }");
    const auto ink = [&] {
      return shown.line.findChild<QLabel *>("case")->palette().color(QPalette::WindowText);
    };
    shown.line.setCase("0/0", true);
    QCOMPARE(ink(), QColor(Qt::red));
    shown.line.setCase("3", false);
    QCOMPARE(ink(), QColor(Qt::black));
  }

  void heldLine_doesNotBecomeLessHigh_untilItIsLetGo() {
    ShownLine shown;
    const auto leastHeight = [&] { return shown.line.minimumHeight(); };
    shown.line.resize(600, 90);
    shown.line.setHeld(true);
    shown.line.setCase("3", false);
    QCOMPARE(leastHeight(), 90);
    shown.line.setHeld(false);
    QVERIFY(leastHeight() < 90);
  }

  void wordsOfStrangers_arePlainText() {
    ShownLine shown;
    for (const QLabel *label : shown.line.findChildren<QLabel *>())
      QCOMPARE(label->textFormat(), Qt::PlainText);
  }
};

QTEST_MAIN(CaseLineTest)
#include "case_line_test.moc"
