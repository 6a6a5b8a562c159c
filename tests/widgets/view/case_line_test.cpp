// The line of words below the scene.
#include "widgets/view/case_line.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QVBoxLayout>
#include <QtTest>

using namespace halfspace;

namespace {

constexpr std::chrono::milliseconds shortTime{60};

struct ShownLine {
  explicit ShownLine(std::chrono::milliseconds readingTime = CaseLine::usualReadingTime) : line(readingTime) {
    line.resize(600, 40);
    line.show();
  }
  /// That it wants at this width, with all that it says now.
  int heightAt(int width) {
    line.layout()->activate();
    return line.heightForWidth(width);
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
    const auto height = [&] { return shown.heightAt(600); };
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

  void message_thatIsEnded_leavesItsPlaceToTheCase() {
    ShownLine shown;
    shown.line.setCase("3", false);
    shown.line.say("Saved.");
    shown.line.endMessage();
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

  void indicesAreLowered_andSignsAreNoTags() {
    ShownLine shown;
    shown.line.setCase("h < v_d", false);
    QCOMPARE(shown.said("case"), QString("h &lt; v<sub>d</sub>"));
    shown.line.setCase("h < v", false);
    QCOMPARE(shown.said("case"), QString("h < v"));
    QCOMPARE(shown.line.findChild<QLabel *>("case")->textFormat(), Qt::PlainText);
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

  void line_thatBecameHigher_staysSo_untilItsWidthChanges() {
    QWidget window;
    auto *column = new QVBoxLayout(&window);
    column->addWidget(new QWidget, 1);
    auto *line = new CaseLine;
    column->addWidget(line);
    window.resize(500, 400);
    window.show();
    line->setCase("3", false);
    QCoreApplication::processEvents();
    const int usual = line->height();
    line->setCase(QString("many words ").repeated(30), false);
    QTRY_VERIFY(line->height() > usual);
    const int grown = line->height();
    line->setCase("3", false);
    QTest::qWait(50);
    QCOMPARE(line->height(), grown);
    window.resize(520, 400);
    QTRY_COMPARE(line->height(), usual);
  }

  void nearestSpecialCase_isOfferedByAButton_andItsRowStaysWithoutOne() {
    ShownLine shown;
    shown.line.setNearby("It would be parallel.", true);
    const int height = shown.heightAt(600);
    auto *there = shown.line.findChild<QPushButton *>("there");
    QVERIFY(there->isVisible());
    QSignalSpy chosen(&shown.line, &CaseLine::nearbyChosen);
    QTest::mouseClick(there, Qt::LeftButton);
    QCOMPARE(chosen.count(), 1);
    shown.line.setNearby("It would touch, with roots.", false);
    QVERIFY(!there->isVisible());
    shown.line.setNearby({}, false);
    QVERIFY(!there->isVisible());
    QCOMPARE(shown.heightAt(600), height);
  }

  void wordsOfStrangers_arePlainText() {
    ShownLine shown;
    for (const QLabel *label : shown.line.findChildren<QLabel *>())
      QCOMPARE(label->textFormat(), Qt::PlainText);
  }
};

QTEST_MAIN(CaseLineTest)
#include "case_line_test.moc"
