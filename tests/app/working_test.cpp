// The numbers in the worked lines, in the window: where they come from, and how they change the scene.
#include "tests/app/window_fixture.h"

#include "lessons/object/kinds/plane.h"
#include "lessons/term/plain_text.h"

#include <QApplication>
#include <QClipboard>

using namespace halfspace;

namespace {

using Ids = std::set<std::string>;

/// The lesson on the signed distance at a step with the lines f, length and distance.
class LinesFixture : public WindowFixture {
public:
  LinesFixture() : WindowFixture("signed-distance") { goToLine("length"); }

  /// Where the line's first number that reads so stands among the lines.
  [[nodiscard]] QPoint at(const std::string &line, const std::string &text) {
    const ShownNumbers numbers = lines().shownNumbers();
    for (std::size_t i = 0; i < lines().placed().lines.size(); ++i)
      for (const NumberPlace &place : numbers.inLine(i))
        if (place.line == line && plainText(place.number) == text)
          return numbers.boxesOf(place).front().center().toPoint();
    QTest::qFail(("no " + text + " in " + line).c_str(), __FILE__, __LINE__);
    return {};
  }
  void click(const QPoint &place) { QTest::mouseClick(&lines(), Qt::LeftButton, {}, place); }
  void press(const QPoint &place) { QTest::mousePress(&lines(), Qt::LeftButton, {}, place); }
  void release(const QPoint &place) { QTest::mouseRelease(&lines(), Qt::LeftButton, {}, place); }
  void drag(const QPoint &to) { dragOn(lines(), to); }
  static void dragOn(QWidget &widget, const QPoint &to) {
    QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&widget, &move);
    QTest::qWait(20);
  }
  /// Edit > Copy Working As.
  [[nodiscard]] QMenu &copyMenu() const { return *window.findChild<QMenu *>("copyWorking"); }
  NumberField *openField(const QPoint &place) {
    QTest::mouseDClick(&lines(), Qt::LeftButton, {}, place);
    return lines().findChild<NumberField *>();
  }
  [[nodiscard]] Ids tracedLines() { return practice().working().traced().lines; }
};

} // namespace

class WorkingTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void number_clicked_lightsUpItsLinesAndMarksUntilEscape() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    fixture.click(fixture.at("distance.distance", "10"));
    QCOMPARE(fixture.tracedLines(), (Ids{"distance.f", "distance.length"}));
    QCOMPARE(fixture.scene().drawn().highlighted(), (Ids{"E.P0", "E.n", "Q"}));
    QTest::keyClick(&fixture.lines(), Qt::Key_Escape);
    QCOMPARE(fixture.scene().drawn().highlighted(), Ids());
    fixture.click(fixture.at("distance.length", "3"));
    QCOMPARE(fixture.scene().drawn().highlighted(), Ids{"E.n"});
    fixture.scene().setFocus();
    QTest::keyClick(&fixture.scene(), Qt::Key_Escape);
    QCOMPARE(fixture.scene().drawn().highlighted(), Ids());
  }

  void workingOfTheStep_copiedFromTheEditMenu_isInTheChosenFormat() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    QTRY_VERIFY(!fixture.practice().working().toldLines().empty()); // once the blocks have their place
    const QString beginnings[] = {"\\begin{align*}\n", "<p><math ", "f(Q) = "};
    for (int i = 0; i < 3; ++i) {
      fixture.copyMenu().actions().at(i)->trigger();
      const QString copied = QApplication::clipboard()->text();
      QVERIFY2(copied.startsWith(beginnings[i]), qPrintable(copied));
    }
    QVERIFY(QApplication::clipboard()->text().contains("dist = f(Q)/|n| = 30/3 = 10\n"));
  }

  void workingBehindAnOpenQuestion_isNotCopied() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    const auto &steps = fixture.model().lesson().steps;
    const auto asks = std::find_if(steps.begin(), steps.end(), predictionOf);
    QVERIFY(asks != steps.end());
    fixture.model().setStep(static_cast<int>(asks - steps.begin()));
    QTest::qWait(1); // what stood on the page before is gone
    fixture.copyMenu().actions().at(2)->trigger();
    for (const ToldLine &told : fixture.practice().working().toldLines())
      QVERIFY(!told.isWhole);
  }

  void traceOfANumber_endsWithItsStep() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    fixture.click(fixture.at("distance.distance", "10"));
    fixture.goToLine("cosine");
    QCOMPARE(fixture.scene().drawn().highlighted(), Ids());
    fixture.goToLine("length");
    QCOMPARE(fixture.tracedLines(), Ids());
  }

  void traceOfANumber_staysWhileTheSceneIsDragged() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    fixture.click(fixture.at("distance.distance", "10"));
    const QPoint from = *handlePosition(fixture.scene(), "Q");
    fixture.WindowFixture::drag(from, from + QPoint(40, 10));
    QVERIFY(fixture.value("Q") != ExactVec3(11, 15, 8));
    QCOMPARE(fixture.tracedLines(), (Ids{"distance.f", "distance.length"}));
    QVERIFY(fixture.scene().drawn().highlighted().contains("E.n"));
  }

  void coordinate_scrubbedInAFormula_movesTheSceneAsOneUndoStep() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    const QPoint from = fixture.at("distance.length", "1");
    fixture.press(from);
    for (int x = 8; x <= 40; x += 8)
      fixture.drag(from + QPoint(x, 0));
    QVERIFY(fixture.model().history().inGesture());
    fixture.release(from + QPoint(40, 0));
    QVERIFY(fixture.value("E.n") == ExactVec3(6, 2, 2));
    QCOMPARE(fixture.model().history().count(), 1);
    fixture.model().history().undo();
    QVERIFY(fixture.value("E.n") == ExactVec3(1, 2, 2));
  }

  void scrubInAFormula_escaped_restoresTheNumber() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    const QPoint from = fixture.at("distance.length", "1");
    fixture.press(from);
    fixture.drag(from + QPoint(40, 0));
    QVERIFY(fixture.value("E.n").x == 6);
    QTest::keyClick(&fixture.lines(), Qt::Key_Escape);
    QVERIFY(fixture.value("E.n").x == 1);
    QCOMPARE(fixture.model().history().count(), 0);
    fixture.release(from + QPoint(40, 0));
  }

  void scrubInAFormula_throughAZeroNormal_goesOn() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    fixture.model().history().edit(ChangeObject{"E", PlaneObject{{5, 4, 7}, {1, 0, 0}}}, "level");
    const QPoint from = fixture.at("distance.length", "1");
    fixture.press(from);
    fixture.drag(from - QPoint(8, 0));
    QVERIFY(fixture.model().shown().degenerate); // the line is gone
    fixture.drag(from - QPoint(16, 0));
    fixture.release(from - QPoint(16, 0));
    QVERIFY(fixture.value("E.n") == ExactVec3(-1, 0, 0));
    QCOMPARE(fixture.model().history().count(), 2);
  }

  void scrubInAField_throughAZeroNormal_goesOn() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    fixture.model().history().edit(ChangeObject{"E", PlaneObject{{5, 4, 7}, {1, 0, 0}}}, "level");
    NumberField *field = fixture.openField(fixture.at("distance.length", "1"));
    QVERIFY(field);
    const QPoint from = field->rect().center();
    QTest::mousePress(field, Qt::LeftButton, {}, from);
    LinesFixture::dragOn(*field, from - QPoint(8, 0));
    QVERIFY(fixture.model().shown().degenerate); // the line is gone
    QCOMPARE(fixture.lines().findChild<NumberField *>(), field);
    QVERIFY(field->isVisible());
    LinesFixture::dragOn(*field, from - QPoint(16, 0));
    QTest::mouseRelease(field, Qt::LeftButton, {}, from - QPoint(16, 0));
    QVERIFY(!fixture.model().history().inGesture());
    QVERIFY(fixture.value("E.n") == ExactVec3(-1, 0, 0));
    QCOMPARE(fixture.model().history().count(), 2);
  }

  void fieldThatIsScrubbedToAZeroNormal_goesWithItsLineAtTheEnd() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    fixture.model().history().edit(ChangeObject{"E", PlaneObject{{5, 4, 7}, {1, 0, 0}}}, "level");
    NumberField *field = fixture.openField(fixture.at("distance.length", "1"));
    QVERIFY(field);
    const QPoint from = field->rect().center();
    QTest::mousePress(field, Qt::LeftButton, {}, from);
    LinesFixture::dragOn(*field, from - QPoint(8, 0));
    QCOMPARE(fixture.lines().findChild<NumberField *>(), field);
    QTest::mouseRelease(field, Qt::LeftButton, {}, from - QPoint(8, 0));
    QVERIFY(!fixture.model().history().inGesture());
    QVERIFY(fixture.value("E.n") == ExactVec3(0, 0, 0));
    QTRY_VERIFY(!fixture.lines().findChild<NumberField *>());
  }

  void coordinate_typedInAFormula_isTakenExactlyAsOneUndoStep() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    NumberField *field = fixture.openField(fixture.at("distance.length", "1"));
    QVERIFY(field);
    QTest::keyClicks(field, "-10/3");
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(fixture.value("E.n").x == Rational(-10, 3));
    QCOMPARE(fixture.model().history().count(), 1);
    QTRY_VERIFY(!fixture.lines().findChild<NumberField *>());
  }

  void coordinate_beingTypedInAFormula_isKeptByAnEndWhileBusy_unlessItIsTakenBack() {
    const auto leftovers = [] { return Recovery(Recovery::standardFolder()).leftovers(); };
    for (const bool takenBack : {false, true}) {
      init();
      {
        LinesFixture fixture;
        QVERIFY(fixture.ready);
        NumberField *field = fixture.openField(fixture.at("distance.length", "1"));
        QVERIFY(field);
        QTest::keyClicks(field, "-10/3");
        if (takenBack)
          QTest::keyClick(field, Qt::Key_Escape);
        fixture.window.endWhileBusy();
      }
      QCOMPARE(leftovers().size(), takenBack ? 0U : 1U);
      if (!takenBack)
        QVERIFY(coordinate(*findObject(leftovers().front().work.session.scene, "E"), 1).x ==
                Rational(-10, 3));
    }
  }

  void numberThatIsNone_typedInAFormula_isRefusedWithASentence() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    NumberField *field = fixture.openField(fixture.at("distance.length", "1"));
    QVERIFY(field);
    QTest::keyClicks(field, "1e999");
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(fixture.model().session() == before);
    bool isSaid = false;
    for (const PlacedLine &line : fixture.lines().placed().lines)
      isSaid = isSaid || !line.remark.empty();
    QVERIFY(isSaid);
    QTest::keyClick(field, Qt::Key_Escape);
    QVERIFY(fixture.model().session() == before);
  }

  void newNumbers_dropWhatIsTypedInAFormula() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    NumberField *field = fixture.openField(fixture.at("distance.length", "1"));
    QVERIFY(field);
    QTest::keyClicks(field, "seven");
    QTest::keyClick(field, Qt::Key_Return);
    QTest::mouseClick(fixture.practice().findChild<QToolButton *>("newNumbers"), Qt::LeftButton);
    QTRY_VERIFY(!fixture.lines().findChild<NumberField *>());
    for (const PlacedLine &line : fixture.lines().placed().lines)
      QVERIFY(line.remark.empty());
  }

  void numbersOfBlankLines_cannotBeClicked() {
    LinesFixture fixture;
    QVERIFY(fixture.ready);
    const QPoint result = fixture.at("distance.distance", "10");
    fixture.chooseFading("All blank");
    for (std::size_t i = 0; i < fixture.lines().placed().lines.size(); ++i)
      QVERIFY(fixture.lines().shownNumbers().inLine(i).empty());
    fixture.click(result);
    QCOMPARE(fixture.scene().drawn().highlighted(), Ids());
  }
};

QTEST_MAIN(WorkingTest)
#include "working_test.moc"
