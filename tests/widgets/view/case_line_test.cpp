// The line of words below the scene.
#include "widgets/text/indices.h"
#include "widgets/view/case_line.h"

#include <QLabel>
#include <QLayout>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
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
  /// As wide as that, and as high as it needs.
  void setWidth(int width) {
    line.resize(width, 40);
    QCoreApplication::processEvents();
    line.resize(width, line.heightForWidth(width));
    QCoreApplication::processEvents();
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
    QVERIFY2(shown.said("case") == "The plane is behind.", "what is so stays in sight");
    QCOMPARE(shown.said("nearby"), QString());
    QTRY_COMPARE(shown.said("message"), QString());
    QCOMPARE(shown.said("complaint"), QString("It cannot be kept."));
    QCOMPARE(shown.line.findChild<QLabel *>("complaint")->toolTip(),
             QString("The disk is full &lt;now&gt;."));
    QCOMPARE(shown.said("case"), QString("The plane is behind."));
    shown.line.complain({});
    QCOMPARE(shown.said("complaint"), QString());
  }

  void offerToStartAfresh_inANarrowWindow_takesNoMoreRoomThanAWayThere() {
    ShownLine shown;
    shown.line.resize(400, 40);
    shown.line.setNearby("The ray would lie in E.", {{"There", true}, {"There, too", true}});
    shown.line.layout()->activate();
    const int usual = shown.line.heightForWidth(400);
    shown.line.setNearby({}, {});
    shown.line.offerAfresh(true);
    shown.line.layout()->activate();
    QVERIFY(shown.line.heightForWidth(400) <= usual);
  }

  void line_whateverTheCaseIs_andWithAMessageOfOneRow_keepsItsHeight() {
    ShownLine shown;
    for (const int width : {400, 900}) {
      shown.line.resize(width, 40);
      QCoreApplication::processEvents();
      const auto height = [&] {
        QCoreApplication::processEvents();
        return shown.line.heightForWidth(width);
      };
      shown.line.setCase("t = 3.", false);
      const int usual = height();
      const QString many = QString("many words ").repeated(60);
      shown.line.setCase(many, false);
      QCOMPARE(height(), usual);
      shown.line.setNearby(many, {{many, true}, {many, true}});
      QCOMPARE(height(), usual);
      shown.line.say("Picture saved.");
      QCOMPARE(height(), usual);
    }
  }

  void case_ofUsualLength_isSeenWhole_andALongOneWhereThePointerRests() {
    ShownLine shown;
    shown.setWidth(600);
    QCoreApplication::processEvents();
    auto *label = shown.line.findChild<QLabel *>("case");
    const QString usual =
        "t = −10/3 is negative: the plane is behind the ray's start, so it does not hit it.";
    shown.line.setCase(usual, false);
    QCoreApplication::processEvents(); // it gets its room
    QCOMPARE(shown.said("case"), usual);
    QVERIFY(label->toolTip().isEmpty());
    const QString longOne = QString("many words ").repeated(60).trimmed();
    shown.line.setCase(longOne, false);
    QCoreApplication::processEvents();
    QVERIFY(shown.said("case").startsWith("many words") && shown.said("case").endsWith("…"));
    QVERIFY(label->toolTip().contains(longOne));
  }

  void longCase_isSeenWhole_inThePlaceOfWhatIsNear() {
    const QString sentence = "The ray's line goes through the triangle, inside the triangle. But λ = −3/5 is "
                             "negative: that is behind the ray's start. The Plücker products cannot see it.";
    ShownLine shown;
    shown.line.setNearby("It would touch.", {{"It would touch.", true}});
    shown.setWidth(400);
    const int height = shown.line.height();
    shown.line.setCase(sentence, false);
    QCoreApplication::processEvents();
    QCOMPARE(shown.said("case"), sentence);
    QCOMPARE(shown.said("nearby"), QString());
    shown.line.say("Saved.");
    QCoreApplication::processEvents();
    QCOMPARE(shown.said("message"), QString("Saved."));
    shown.line.setCase("It hits.", false);
    shown.line.endMessage();
    QCoreApplication::processEvents();
    QCOMPARE(shown.said("nearby"), QString("It would touch."));
    QCOMPARE(shown.line.heightForWidth(400), height);
  }

  void highWindow_hasRoomForTwoRowsOfTheCase_andALowOneForAQuarter() {
    ShownLine shown;
    const auto heightIn = [&](int window, int width) {
      shown.line.setWindowHeight(window);
      shown.setWidth(width);
      return shown.line.height();
    };
    QVERIFY(heightIn(1000, 1000) > heightIn(800, 1000));
    QVERIFY(heightIn(400, 200) <= 100);
  }

  void narrowLine_offersTheWayThereWithoutWords() {
    ShownLine shown;
    const QString near = "The ray would run parallel to the plane.";
    shown.line.setNearby(near, {{near, true}, {near, true}});
    for (const int width : {600, 240}) {
      shown.setWidth(width);
      QCoreApplication::processEvents();
      QCOMPARE(shown.line.findChild<QLabel *>("nearby")->isVisible(), width == 600);
      QVERIFY(shown.line.findChild<QPushButton *>("there")->isVisible());
      QCOMPARE(shown.line.findChild<QPushButton *>("there")->toolTip(), near);
    }
  }

  void words_withIndices_areSeenWhole() {
    for (const int width : {500, 900}) {
      ShownLine shown;
      const QString usual = "The six numbers of the line g are v_g = (1, 2, −2) and m_g = (−12, 12, 6).";
      const QString nearby = "The ray r_Q would go through the corner P_0.";
      shown.line.setNearby(nearby, {{nearby, true}});
      shown.line.setCase(usual, false);
      shown.setWidth(width);
      QCoreApplication::processEvents();
      QCOMPARE(shown.said("case"), richTextOf(usual));
      QCOMPARE(shown.said("nearby"), richTextOf(nearby));
    }
  }

  void message_besideTheNearestCase_hasTheWholeRow_andIsWholeAtEverySizeOfType() {
    const QString sentence =
        "own: 512 triangles, 16 × 16 × 2 of the file's units. Too large to be saved with "
        "the session.";
    const int usual = QApplication::font().pointSize();
    for (const int percent : {100, 150, 192, 250}) {
      ShownLine shown;
      shown.line.setStyleSheet(QString("* { font-size: %1pt }").arg(usual * percent / 100));
      shown.line.setNearby("It would be parallel.",
                           {{"It would be parallel.", true}, {"It would touch.", true}});
      shown.line.say(sentence);
      shown.setWidth(600);
      QCoreApplication::processEvents();
      const auto &message = *shown.line.findChild<QLabel *>("message");
      QCOMPARE(message.text(), sentence);
      QCOMPARE(message.width(), shown.line.width());
      QVERIFY2(message.height() >= message.heightForWidth(message.width()),
               qPrintable(QString::number(percent)));
      QVERIFY(!shown.line.findChild<QPushButton *>("there")->isVisible());
      shown.line.endMessage();
      QVERIFY(shown.line.findChild<QPushButton *>("there")->isVisible());
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
    QCOMPARE(shown.said("case"), QString("h &lt; v<sub><big>d</big></sub>"));
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

  void buttons_standAlike_withoutAMarkOfTheStyle() {
    ShownLine shown;
    shown.line.setNearby("It would be parallel.",
                         {{"It would be parallel.", true}, {"It would start in the plane.", true}});
    const auto *there = shown.line.findChild<QPushButton *>("there");
    const auto *others = shown.line.findChild<QPushButton *>("others");
    QVERIFY2(!others->menu(), "the style draws a mark for a button's menu");
    QCOMPARE(others->y(), there->y());
    QVERIFY(others->text().endsWith("▾"));
  }

  void nearestSpecialCase_isOfferedByAButton_andAllByAMenu() {
    ShownLine shown;
    shown.line.setNearby("It would be parallel.", {{"It would be parallel.", true},
                                                   {"It would touch, with roots.", false},
                                                   {"It would start in the plane.", true}});
    auto *there = shown.line.findChild<QPushButton *>("there");
    auto *others = shown.line.findChild<QPushButton *>("others");
    QVERIFY(there->isVisible() && others->isVisible());
    QSignalSpy chosen(&shown.line, &CaseLine::nearbyChosen);
    QTest::mouseClick(there, Qt::LeftButton);
    QCOMPARE(chosen.last().front().toInt(), 0);
    QTest::mouseClick(others, Qt::LeftButton);
    auto *all = others->findChild<QMenu *>();
    QVERIFY(all->isVisible());
    QCOMPARE(all->actions().size(), 2);
    all->actions().last()->trigger();
    all->hide();
    QCOMPARE(chosen.last().front().toInt(), 2);
    shown.line.setNearby("It would be parallel.", {{"It would be parallel.", true}});
    QVERIFY2(!others->isVisible(), "there are no others");
    shown.line.setNearby("It would touch, with roots.", {{"It would touch, with roots.", false}});
    QVERIFY(!there->isVisible() && !others->isVisible());
    shown.line.setNearby({}, {});
    QVERIFY(!there->isVisible());
  }

  void startAfresh_isOfferedWhereTheStepLacksSomething() {
    ShownLine shown;
    auto *afresh = shown.line.findChild<QPushButton *>("afresh");
    QVERIFY(!afresh->isVisible());
    shown.line.offerAfresh(true);
    QSignalSpy chosen(&shown.line, &CaseLine::afreshChosen);
    QTest::mouseClick(afresh, Qt::LeftButton);
    QCOMPARE(chosen.count(), 1);
  }

  void wordsOfStrangers_arePlainText() {
    ShownLine shown;
    for (const char *name : {"case", "nearby", "message", "complaint"})
      QCOMPARE(shown.line.findChild<QLabel *>(name)->textFormat(), Qt::PlainText);
  }
};

QTEST_MAIN(CaseLineTest)
#include "case_line_test.moc"
