// Explore in a real window: lines that are typed, the list of the scene, one selection for all, what fits.
#include "app/export/scene_paste.h"
#include "lessons/typed/read_line.h"
#include "tests/app/explore_fixture.h"

#include <QClipboard>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QSlider>

#include <memory>
#include <random>

using namespace halfspace;

namespace {

const QStringList distanceLines{"Q = (11, 15, 8)", "E: x + 2y + 2z = 27", "d = distance(Q, E)"};

} // namespace

class ExploreTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void newFromALesson_isAnEmptyScene_withTheFieldAndTheList() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    auto *bar = fixture.window.findChild<EntryBar *>();
    auto *panel = fixture.window.findChild<ExplorePanel *>();
    QVERIFY(!bar->isVisible() && !panel->isVisible());
    fixture.action(QKeySequence::New)->trigger();
    QCOMPARE(fixture.model().session().lesson, std::string("explore"));
    QCOMPARE(fixture.model().session().scene.entries.size(), std::size_t(0));
    QVERIFY(bar->isVisible() && panel->isVisible());
  }

  void linesEntered_areTheScene_andTheirWorkingIsShown() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const QString &line : distanceLines)
      fixture.enter(line);
    QCOMPARE(fixture.scene(),
             (QStringList{"Q = (11, 15, 8)", "E: x + 2y + 2z = 27", "d = signed-distance(E, Q)"}));
    QCOMPARE(fixture.field().text(), QString());
    QCOMPARE(fixture.selection().ids(), (std::vector<std::string>{"d"}));
    QVERIFY(!fixture.model().shown().working.lines.empty());
    QCOMPARE(fixture.row("d", EntryRows::Value).data().toString(), QString("dist = 10"));
    fixture.model().history().undo();
    QCOMPARE(fixture.scene().size(), 2);
  }

  void wrongLine_staysWithItsFault_andEnterTakesTheMend() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("Q = (11, 15, 8)");
    fixture.enter("E: x + 2y + 2z = 27");
    fixture.enter("d = distanc(Q, E)");
    QCOMPARE(fixture.field().text(), QString("d = distanc(Q, E)"));
    QCOMPARE(fixture.sentence(), QString("There is no “distanc”."));
    QVERIFY(fixture.field().fault());
    QCOMPARE(fixture.field().fault()->begin, 4);
    QCOMPARE(fixture.field().fault()->length, 7);
    QCOMPARE(fixture.suggestions().topLevelItem(0)->text(0), QString("d = distance(Q, E)"));
    QTest::keyClick(&fixture.field(), Qt::Key_Return);
    QCOMPARE(fixture.scene().last(), QString("d = signed-distance(E, Q)"));
  }

  void takenName_ofALine_leavesTheSceneAsItWas() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("Q = (11, 15, 8)");
    fixture.enter("Q = (1, 2, 3)");
    QCOMPARE(fixture.scene(), (QStringList{"Q = (11, 15, 8)"}));
    QCOMPARE(fixture.sentence(), QString("There is “Q” already."));
  }

  void upInTheField_bringsEarlierLines() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("A = (1, 2, 3)");
    fixture.enter("B = (4, 5, 6)");
    fixture.field().setFocus();
    QTest::keyClick(&fixture.field(), Qt::Key_Up);
    QCOMPARE(fixture.field().text(), QString("B = (4, 5, 6)"));
    QTest::keyClick(&fixture.field(), Qt::Key_Up);
    QCOMPARE(fixture.field().text(), QString("A = (1, 2, 3)"));
    QTest::keyClick(&fixture.field(), Qt::Key_Down);
    QCOMPARE(fixture.field().text(), QString("B = (4, 5, 6)"));
  }

  void wordsOfAMenu_areFoundAndDone() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.type("theme dark");
    QCOMPARE(fixture.suggestions().topLevelItemCount(), 1);
    QCOMPARE(fixture.suggestions().topLevelItem(0)->text(0), QString("View: Theme: Dark"));
    QTest::keyClick(&fixture.field(), Qt::Key_Return);
    QCOMPARE(fixture.window.look().theme().name, std::string("dark"));
    QCOMPARE(fixture.scene(), QStringList());
  }

  void lettersTypedInThePicture_beginALine() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.WindowFixture::scene().setFocus();
    QTest::keyClicks(&fixture.WindowFixture::scene(), "Q");
    QCOMPARE(fixture.field().text(), QString("Q"));
    QCOMPARE(fixture.window.focusWidget(), static_cast<QWidget *>(&fixture.field()));
    QTest::keyClicks(&fixture.field(), " = (1, 2, 3)");
    QTest::keyClick(&fixture.field(), Qt::Key_Return);
    QCOMPARE(fixture.scene(), (QStringList{"Q = (1, 2, 3)"}));
  }

  void entryInTheList_isEditedAsItsLine_andWhatHangsOnItFollows() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const QString &line : distanceLines)
      fixture.enter(line);
    fixture.clickRow("Q");
    QTest::qWait(30); // what fits it is offered
    QTest::mouseDClick(fixture.list().viewport(), Qt::LeftButton, {},
                       fixture.list().visualRect(fixture.row("Q", 1)).center());
    QCOMPARE(fixture.field().text(), QString("Q = (11, 15, 8)"));
    fixture.field().setText("P = (2, 15, 8)");
    QTest::keyClick(&fixture.field(), Qt::Key_Return);
    QCOMPARE(fixture.scene(),
             (QStringList{"P = (2, 15, 8)", "E: x + 2y + 2z = 27", "d = signed-distance(E, P)"}));
  }

  void deleteInTheList_takesAlongWhatHangsOnIt_andOneUndoBringsAllBack() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const QString &line : distanceLines)
      fixture.enter(line);
    const QStringList before = fixture.scene();
    fixture.clickRow("E");
    QTest::keyClick(&fixture.list(), Qt::Key_Delete);
    QCOMPARE(fixture.scene(), (QStringList{"Q = (11, 15, 8)"}));
    QVERIFY(fixture.window.findChild<QLabel *>("message")->text().contains("d"));
    fixture.model().history().undo();
    QCOMPARE(fixture.scene(), before);
  }

  void checkBoxOfARow_hidesTheEntry_andShowsItAgain() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("Q = (11, 15, 8)");
    auto *rows = fixture.list().model();
    rows->setData(fixture.row("Q"), Qt::Unchecked, Qt::CheckStateRole);
    QCOMPARE(fixture.scene(), (QStringList{"Q = (11, 15, 8), hidden"}));
    QVERIFY(!findMark(fixture.WindowFixture::scene().drawn().figure(), "Q"));
    rows->setData(fixture.row("Q"), Qt::Checked, Qt::CheckStateRole);
    QVERIFY(findMark(fixture.WindowFixture::scene().drawn().figure(), "Q"));
  }

  void lineWithoutAName_getsOne_andKeepsWhatWasTyped() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const char *line : {"A = (1, 2, 3)", "B = (4, 0, 1)", "C = (2, 6, 1)", "triangle(A, B, C)",
                             "x + y = 3", "distance(A, B)"})
      fixture.enter(line);
    QCOMPARE(fixture.scene().mid(3),
             (QStringList{"T = triangle(A, B, C)", "E: x + y = 3", "d = distance(A, B)"}));
    fixture.enter("angle(E, T)");
    QCOMPARE(fixture.scene().size(), 6);
    QCOMPARE(fixture.field().text(), QString("angle(E, T)"));
    QVERIFY(!fixture.sentence().isEmpty());
  }

  void mendOfALineWithoutAName_leavesTheNameToTheEntry() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const char *line : {"E: z = 0", "F: x = 0", "angle(E, G)"})
      fixture.enter(line);
    QVERIFY(!fixture.sentence().isEmpty());
    QTest::keyClick(&fixture.field(), Qt::Key_Return); // takes what was perhaps meant
    QCOMPARE(fixture.scene().mid(2), (QStringList{"a = plane-angle(E, F)"}));
  }

  void fitThatWantsAnObject_takesTheNextOneThatIsClicked() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const char *line : {"A = (1, 2, 3)", "B = (4, 0, 1)", "E: z = 0"})
      fixture.enter(line);
    fixture.clickRow("A");
    QCoreApplication::sendPostedEvents();
    for (QPushButton *button : fixture.fits().findChildren<QPushButton *>("fit"))
      if (button->text().startsWith("distance of the points"))
        button->click();
    QCoreApplication::processEvents();
    fixture.clickRow("B");
    QCoreApplication::processEvents();
    QCOMPARE(fixture.scene().mid(3), (QStringList{"d = distance(A, B)"}));
    fixture.clickRow("A");
    fixture.clickRow("B");
    QCOMPARE(fixture.scene().size(), 4); // the wish is fulfilled
  }

  void keyOfUndo_isLeftToTheMenu_whereNothingWasTyped() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("A = (1, 2, 3)");
    const auto isTakenByField = [&] {
      QKeyEvent key(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
      QCoreApplication::sendEvent(&fixture.field(), &key);
      return key.isAccepted();
    };
    QVERIFY(!isTakenByField());
    fixture.type("B = ");
    QVERIFY(isTakenByField());
  }

  void lineOfAnEntry_thatGoesMeanwhile_isPutAway() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("A = (1, 2, 3)");
    fixture.clickRow("A");
    QTest::keyClick(&fixture.list(), Qt::Key_Return);
    QCOMPARE(fixture.field().text(), QString("A = (1, 2, 3)"));
    fixture.model().history().undo();
    QCOMPARE(fixture.field().text(), QString());
  }

  void rightButtonOnAMark_hasTheMenuOfItsEntry() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("A = (1, 2, 3)");
    fixture.selection().set({});
    QTest::qWait(50);
    QTest::mouseClick(&fixture.WindowFixture::scene(), Qt::RightButton, {}, fixture.placeOf("A"));
    QVERIFY(fixture.selection().contains("A"));
    auto *menu = fixture.window.findChild<QMenu *>("entryMenu");
    QVERIFY(menu && menu->isVisible() && menu->findChild<QMenu *>("labelMenu"));
    menu->close();
  }

  void renamingWhatIsMade_isThatOfItsEntry() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const char *line : {"E: z = 0", "F: x = 0", "i = intersect(E, F)"})
      fixture.enter(line);
    fixture.clickRow("i.g");
    QTest::keyClick(&fixture.list(), Qt::Key_F2);
    auto *name = fixture.list().findChild<QLineEdit *>();
    QVERIFY(name);
    QTest::keyClicks(name, "cut");
    QTest::keyClick(name, Qt::Key_Return);
    QCoreApplication::processEvents(); // only then is it told
    QCOMPARE(fixture.scene().at(2), QString("cut = intersect(E, F)"));
  }

  void whatHasRoots_isOfferedNothing_andSaysWhy() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("T = tetrahedron((0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2))");
    fixture.enter("c = circumsphere(T)");
    fixture.clickRow("c.S");
    QCoreApplication::sendPostedEvents();
    QVERIFY(fixture.fits().findChildren<QPushButton *>("fit").isEmpty());
    QVERIFY(fixture.fits().findChild<QLabel *>("heading")->text().contains("no fractions"));
  }

  void selectedObject_thatIsNotThere_tellsWhy_belowThePicture() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const char *line : {"k = 0", "R = (1/k, 2, 3)"})
      fixture.enter(line);
    QCOMPARE(fixture.model().shown().description,
             std::string("R is not there now. This would be divided by zero."));
    QCOMPARE(fixture.row("R", EntryRows::Value).data().toString(), QString("not there now"));
    fixture.clickRow("k");
    QCOMPARE(fixture.model().shown().description, std::string());
  }

  void textPastedOverThePicture_isLines() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    QGuiApplication::clipboard()->setText("0,5; 1; 2\n4; 5; 6\n");
    fixture.window.findChild<ScenePaste *>()->paste();
    QCOMPARE(fixture.scene(), (QStringList{"A = (1/2, 1, 2)", "B = (4, 5, 6)"}));
  }

  void menuOfARow_choosesLinesAndLabels_eachAnUndoStep() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("g = (1, 2, 3) + t(1, 0, 1)");
    fixture.clickRow("g");
    const auto choose = [&](const QString &submenu, const QString &item) {
      fixture.chooseInMenu(submenu, item);
    };
    choose("lineMenu", "Dotted");
    QCOMPARE(fixture.scene(), (QStringList{"g = line((1, 2, 3), (1, 0, 1)), dotted"}));
    choose("labelMenu", "Name and Value");
    QCOMPARE(fixture.scene(), (QStringList{"g = line((1, 2, 3), (1, 0, 1)), dotted, value"}));
    choose("labelMenu", "None");
    QVERIFY(isLabelHidden(fixture.model().session().scene.labels, "g"));
    choose("labelMenu", "Automatic");
    QVERIFY(!isLabelHidden(fixture.model().session().scene.labels, "g"));
    QCOMPARE(fixture.scene(), (QStringList{"g = line((1, 2, 3), (1, 0, 1)), dotted"}));
    fixture.model().history().undo();
    QVERIFY(isLabelHidden(fixture.model().session().scene.labels, "g"));
  }

  void menuOfWhatIsMade_isThatOfItsConstruction_whoseResultsAreColoured() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const char *line : {"E: z = 0", "F: x = 0", "i = intersect(E, F)", "k = angle(E, F)"})
      fixture.enter(line);
    fixture.clickRow("i.g");
    fixture.chooseInMenu("colorMenu", "Pink");
    QCOMPARE(fixture.scene().at(2), QString("i = intersect(E, F), pink"));
    fixture.chooseInMenu("lineMenu", "Dotted");
    const MarkBase &line = baseOf(*findMark(fixture.model().figure(), "i.g"));
    QVERIFY(hueOf(line) == Hue::Pink && line.look.line == LineStyle::Dotted);
    QVERIFY(hueOf(baseOf(*findMark(fixture.model().figure(), "i.g.v"))) == Hue::Pink);
    QVERIFY(hueOf(baseOf(*findMark(fixture.model().figure(), "E"))) != Hue::Pink);
    fixture.clickRow("k");
    fixture.chooseInMenu("labelMenu", "Name and Value");
    QVERIFY(baseOf(*findMark(fixture.model().figure(), "k.phi")).numbers.find("90") != std::string::npos);
    fixture.clickRow("i.g");
    QTest::keyClick(&fixture.list(), Qt::Key_Delete);
    QCOMPARE(fixture.scene().size(), 3);
  }

  void rowThatIsDragged_isMoved_asFarAsItsEntryMay() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const char *line : {"A = (1, 2, 3)", "E: z = 0", "d = distance(A, E)", "B = (4, 5, 6)"})
      fixture.enter(line);
    auto *rows = fixture.list().model();
    const QStringList before = fixture.scene();
    const auto drop = [&](const std::string &name, const QModelIndex &above) {
      const std::unique_ptr<QMimeData> data(rows->mimeData({fixture.row(name)}));
      rows->dropMimeData(data.get(), Qt::MoveAction, above.row(), 0, {});
    };
    const QSignalSpy told(&fixture.window.findChild<ExplorePanel *>()->edits(), &EntryEdits::told);
    drop("A", fixture.row("B")); // below what looks at it
    QCOMPARE(fixture.scene(), before);
    QCOMPARE(told.count(), 1);
    drop("B", fixture.row("E"));
    QCOMPARE(fixture.scene(), (QStringList{before[0], before[3], before[1], before[2]}));
    drop("B", {}); // beyond the last row
    QCOMPARE(fixture.scene(), before);
    QVERIFY(rows->flags(fixture.row("d")) & Qt::ItemIsDragEnabled);
    QVERIFY(!(rows->flags(fixture.row("d.F")) & Qt::ItemIsDragEnabled));
  }

  void clickInThePicture_selectsTheRow_andARowItsHandle() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("A = (4, 0, 1)");
    fixture.enter("B = (0, 6, 2)");
    QTest::qWait(50);
    const QPoint place = fixture.placeOf("A");
    fixture.press(place);
    fixture.release();
    QCOMPARE(fixture.selection().ids(), (std::vector<std::string>{"A"}));
    QVERIFY(fixture.list().selectionModel()->isRowSelected(fixture.row("A").row(), {}));
    fixture.clickRow("B");
    QCOMPARE(fixture.WindowFixture::scene().handles().selection().selectedId(), std::string("B"));
  }

  void twoSelected_offerWhatFits_andOneClickAddsIt() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("Q = (11, 15, 8)");
    fixture.enter("E: x + 2y + 2z = 27");
    fixture.clickRow("Q");
    fixture.clickRow("E", Qt::ControlModifier);
    QCOMPARE(fixture.selection().ids(), (std::vector<std::string>{"Q", "E"}));
    QPushButton *distance = fixture.fit("signed-distance(");
    QVERIFY(distance);
    QTest::mouseClick(distance, Qt::LeftButton);
    QCoreApplication::processEvents();
    QCOMPARE(fixture.scene().last().section(" = ", 1), QString("signed-distance(E, Q)"));
  }

  void offers_inASmallWindow_areShortened_andNotCutOff() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.window.resize(1024, 600);
    for (const char *line : {"E: z = 0", "F: x = 0", "g = (0, 0, 0) + t(1, 1, 1)"})
      fixture.enter(line);
    fixture.clickRow("E");
    QTest::qWait(50);
    const auto buttons = fixture.fits().findChildren<QPushButton *>("fit");
    QVERIFY(!buttons.isEmpty());
    QWidget &room = *fixture.fits().parentWidget()->parentWidget();
    for (QPushButton *button : buttons)
      QVERIFY2(button->mapTo(&room, button->rect().topRight()).x() < room.width(),
               qPrintable(button->text()));
  }

  void numberWithASlider_isMovedByKeysAndPlays_eachTimeInOneStep() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("k = 1, 0 <= k <= 2, step 1/2");
    auto *slider = fixture.window.findChild<QSlider *>("numberSlider");
    QVERIFY(slider->isVisible());
    QCOMPARE(slider->maximum(), 4);
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(fixture.scene(), (QStringList{"k = 3/2, 0 <= k <= 2, step 1/2"}));
    const int steps = fixture.model().history().count();
    auto *play = fixture.window.findChild<QToolButton *>("playNumber");
    play->click();
    QVERIFY(QTest::qWaitFor([&] { return fixture.value("k").x == 0; }));
    play->click();
    QCOMPARE(fixture.model().history().count(), steps + 1);
    fixture.model().history().undo();
    QCOMPARE(fixture.scene(), (QStringList{"k = 3/2, 0 <= k <= 2, step 1/2"}));
  }

  void whatHolds_ofSelectedObjects_isTold() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    for (const char *line : {"A = (0, 0, 0)", "B = (2, 2, 2)", "M = (A + B)/2"})
      fixture.enter(line);
    fixture.clickRow("A");
    fixture.clickRow("B", Qt::ControlModifier);
    fixture.clickRow("M", Qt::ControlModifier);
    QTest::mouseClick(fixture.window.findChild<QPushButton *>("discover"), Qt::LeftButton);
    const QString told = fixture.window.findChild<QLabel *>("discoveries")->text();
    QVERIFY2(told.contains("on one line") && told.contains("wherever"), qPrintable(told));
  }

  void lineBeingEdited_isNoMoreWhenAnotherIsBegun() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("A = (1, 2, 3)");
    emit fixture.list().lineWanted("A");
    QCOMPARE(fixture.field().text(), QString("A = (1, 2, 3)"));
    for (QAction *action : fixture.window.findChild<QMenu *>("add")->actions())
      if (action->text().contains("Number"))
        action->trigger();
    QTest::keyClick(&fixture.field(), Qt::Key_Return);
    QCOMPARE(fixture.scene().size(), 2);
    QCOMPARE(fixture.scene().first(), QString("A = (1, 2, 3)"));
  }

  void entryOfAnotherKind_hasOtherFits() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("Q = (1, 2, 3)");
    fixture.enter("P = (4, 5, 6)");
    fixture.clickRow("Q");
    fixture.clickRow("P", Qt::ControlModifier);
    QVERIFY(fixture.fit("midpoint("));
    fixture.window.findChild<ExplorePanel *>()->edits().replace(
        "Q", std::get<Entry>(readLine("Q: x = 1", Scene())));
    QVERIFY(!fixture.fit("midpoint("));
    QVERIFY(fixture.fit("signed-distance("));
  }

  void oneLongWord_findsTheCommand_beforeNamesAreMadeOfIt() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.type("dark");
    QTest::keyClick(&fixture.field(), Qt::Key_Return);
    QCOMPARE(fixture.window.look().theme().name, std::string("dark"));
  }

  void numberWithMoreStepsThanASliderHasPlaces_isMovedAllTheSame() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("k = 1, 0 <= k <= 1000000, step 1/1000000000");
    auto *slider = fixture.window.findChild<QSlider *>("numberSlider");
    QVERIFY(slider->maximum() > 0 && slider->maximum() <= 1000);
    QTest::keyClick(slider, Qt::Key_End);
    QVERIFY(fixture.value("k").x == 1000000);
  }

  void whatAToolHasMade_isSelected() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("A = (1, 2, 0)");
    fixture.WindowFixture::scene().objectHand().begin(ToolObject::Point);
    const QPoint place = fixture.pixelOf({5, 5, 0});
    QTest::mouseMove(&fixture.WindowFixture::scene(), place);
    fixture.press(place);
    fixture.release();
    QCOMPARE(fixture.scene().size(), 2);
    QCOMPARE(fixture.selection().ids(), (std::vector<std::string>{"B"}));
  }

  void linesPastedTogether_areOneStep_andAWrongOneAddsNothing() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    QGuiApplication::clipboard()->setText("1, 2, 3\n4, 5, 6\ng = line(A, B)\n");
    fixture.field().setFocus();
    QTest::keyClick(&fixture.field(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(fixture.scene().size(), 3);
    QCOMPARE(fixture.model().history().count(), 1);
    QGuiApplication::clipboard()->setText("7, 8, 9\nh = lin(A, B)\n");
    QTest::keyClick(&fixture.field(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(fixture.scene().size(), 3);
    QVERIFY2(fixture.sentence().startsWith("Nothing was added. Line 2:"), qPrintable(fixture.sentence()));
  }

  void deleteInThePicture_takesAwayWhatIsSelected() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.enter("A = (4, 0, 1)");
    fixture.enter("B = (0, 6, 2)");
    fixture.clickRow("B");
    QTest::keyClick(&fixture.WindowFixture::scene(), Qt::Key_Delete);
    QCOMPARE(fixture.scene(), (QStringList{"A = (4, 0, 1)"}));
  }

  void partOfThePicture_switchedOff_isNotDrawn() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    fixture.window.findChild<QMenu *>("parts")->findChild<QAction *>("grid")->setChecked(false);
    QVERIFY(!fixture.WindowFixture::scene().drawn().drawnContent().shown.grid);
    QVERIFY(fixture.WindowFixture::scene().drawn().drawnContent().shown.axes);
  }

  void whatIsDoneAtRandom_isUndoneAndDoneAgain_inAnyOrder() {
    ExploreFixture fixture;
    QVERIFY(fixture.ready);
    EntryEdits &edits = fixture.window.findChild<ExplorePanel *>()->edits();
    std::mt19937 dice(20);
    const auto below = [&dice](std::size_t count) { return static_cast<std::size_t>(dice() % count); };
    const QStringList typed{
        "(%1, 2, 3)",     "x + %1y + 2z = 9", "%1 + t(1, 2, 3)", "(%1, 0, 1) + t(-1, 3, 2)",
        "distance(A, B)", "intersect(E, r)",  "midpoint(A, B)",  "triangle(A, B, C)",
        "plane(A, B, C)", "sphere(A, %1)",    "(A + B)/%1",      "%1/2, 0 <= k <= 9"};
    std::vector<Scene> scenes{fixture.model().session().scene};
    const auto entries = [&]() -> const NamedList<Entry> & {
      return fixture.model().session().scene.entries;
    };
    const auto anyName = [&] { return entries()[below(entries().size())].name; };
    const auto doSomething = [&] {
      if (entries().size() < 4 || below(2) == 0) {
        const QString names = "ABCEFrgkTd";
        const QString &line = typed[static_cast<int>(below(static_cast<std::size_t>(typed.size())))];
        const QString name = names[static_cast<int>(below(10))];
        const QString number = QString::number(below(9) + 1);
        return fixture.enter(name + (line.contains("z =") ? ": " : " = ") + line.arg(number));
      }
      const std::string name = anyName();
      switch (below(7)) {
      case 0:
        return edits.remove({name});
      case 1:
        return edits.move(name, below(2) == 0 ? 1 : -1);
      case 2:
        return static_cast<void>(edits.rename(name, name + "1"));
      case 3:
        return edits.setHidden(name, below(2) == 0);
      case 4:
        return edits.setColor(name, static_cast<Hue>(below(hueCount)));
      case 5:
        return edits.setLabel(name, LabelText::Value);
      default:
        return edits.setLine(name, LineStyle::Dashed);
      }
    };
    const SessionHistory &history = fixture.model().history();
    for (int i = 0; i < 150; ++i) {
      doSomething();
      QVERIFY(history.index() >= static_cast<int>(scenes.size()) - 1);
      if (history.index() == static_cast<int>(scenes.size()))
        scenes.push_back(fixture.model().session().scene);
    }
    QVERIFY(scenes.size() > 60);
    for (int i = 0; i < 300; ++i) {
      below(2) == 0 ? fixture.model().history().undo() : fixture.model().history().redo();
      QVERIFY(fixture.model().session().scene == scenes.at(static_cast<std::size_t>(history.index())));
    }
  }

  void lineTypedInALesson_leadsToExplore_andLeavesTheLesson() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Scene lesson = fixture.model().session().scene;
    fixture.action(QKeySequence("Ctrl+K"))->trigger();
    auto *field = fixture.window.findChild<EntryField *>();
    QCOMPARE(fixture.window.focusWidget(), static_cast<QWidget *>(field));
    QTest::keyClicks(field, "M = (1, 2, 3)");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(fixture.model().session().lesson, std::string("explore"));
    QCOMPARE(fixture.model().session().scene.entries.size(), lesson.entries.size() + 1);
    fixture.model().openLesson("signed-distance");
    QVERIFY(fixture.model().session().scene == lesson);
  }
};

QTEST_MAIN(ExploreTest)
#include "explore_test.moc"
