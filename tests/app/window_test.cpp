// The window as a user has it: typing, undoing, hovering, steps, questions, files, pictures.
#include "app/export/figure_export.h"
#include "lessons/object/kinds/point.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/scene/near_special_cases.h"
#include "tests/app/window_fixture.h"
#include "widgets/carriers/found_session.h"
#include "widgets/lesson/task_row.h"
#include "widgets/numbers/inspector.h"
#include "widgets/picture/camera_views.h"
#include "widgets/text/math_label.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>

#include <glm/geometric.hpp>

#include <cmath>

using namespace halfspace;

namespace {

void typeInto(NumberField &field, const QString &text) {
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, text);
  QTest::keyClick(&field, Qt::Key_Return);
}

/// Presses OK on the next message box and gives back what it said.
class MessageBoxReader {
public:
  MessageBoxReader() {
    QTimer::singleShot(100, [this] {
      for (QWidget *widget : QApplication::topLevelWidgets())
        if (auto *box = qobject_cast<QMessageBox *>(widget)) {
          text = box->text();
          box->accept();
        }
    });
  }
  QString text;
};

} // namespace

class WindowTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void begunOnASession_showsItsStepAndItsView() {
    LessonLibrary library = readLessons(TEST_LESSONS_FOLDER);
    Session asked = startOf(*library.find("signed-distance"));
    asked.step = 2;
    asked.view = ChosenView{{{1, 0, 0.5}, {6, 8, 4}, 12}, true};
    WindowFixture fixture(asked, std::move(library));
    QVERIFY(fixture.ready);
    QVERIFY(fixture.model().session() == asked);
    QVERIFY(!fixture.window.isWindowModified());
    QVERIFY(fixture.scene().viewpoint().camera().orthographic);
    QVERIFY(fixture.action(QKeySequence("O"))->isChecked());
    const QString title = QString::fromStdString(fixture.model().step().title);
    const auto labels = fixture.window.findChildren<QLabel *>();
    QVERIFY(std::any_of(labels.begin(), labels.end(),
                        [&](const QLabel *label) { return label->isVisible() && label->text() == title; }));
  }

  void number_typed_isTakenExactlyAsOneUndoStep_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("exact");
    QTest::newRow("fraction") << "-10/3"
                              << "-10/3";
    QTest::newRow("decimal") << "1.5"
                             << "3/2";
    QTest::newRow("thousandths") << "0.125"
                                 << "1/8";
  }

  void number_typed_isTakenExactlyAsOneUndoStep() {
    QFETCH(QString, text);
    QFETCH(QString, exact);
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    NumberField *field = fixture.field("Q", 0);
    QVERIFY(field);
    typeInto(*field, text);
    QCOMPARE(QString::fromStdString(toText(fixture.value("Q").x)), exact);
    QCOMPARE(fixture.model().history().count(), 1);
    fixture.model().history().undo();
    QVERIFY(fixture.value("Q").x == 11);
    QTRY_COMPARE(field->text(), QString("11"));
  }

  void keysOfTheWindow_inAFieldThatWaits_areLeftToIt_data() {
    QTest::addColumn<int>("key");
    QTest::newRow("undo") << int(Qt::Key_Z);
    QTest::newRow("next step") << int(Qt::Key_Right);
    QTest::newRow("step before") << int(Qt::Key_Left);
  }

  void keysOfTheWindow_inAFieldThatWaits_areLeftToIt() {
    QFETCH(int, key);
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    NumberField *field = fixture.field("Q", 0);
    QVERIFY(field);
    const auto takesKey = [&] {
      QKeyEvent press(QEvent::ShortcutOverride, key, Qt::ControlModifier);
      press.ignore();
      QCoreApplication::sendEvent(field, &press);
      return press.isAccepted();
    };
    typeInto(*field, "3");
    QVERIFY(!takesKey());
    QTest::keyClicks(field, "12"); // half typed: the key belongs to the field
    QVERIFY(takesKey());
  }

  void number_thatIsNone_isRefusedWithASentence_andTheSessionStays_data() {
    QTest::addColumn<QString>("text");
    for (const char *text : {"nan", "inf", "", "1/0", "abc", "1e999", "99999999999999999999"})
      QTest::newRow(*text ? text : "empty") << text;
  }

  void number_thatIsNone_isRefusedWithASentence_andTheSessionStays() {
    QFETCH(QString, text);
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    NumberField *field = fixture.field("Q", 0);
    QSignalSpy refused(field, &NumberField::refused);
    field->setFocus();
    field->selectAll();
    QTest::keyClick(field, Qt::Key_Delete);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(refused.count() > 0);
    QVERIFY(!refused.last().first().toString().isEmpty());
    QVERIFY(fixture.model().session() == before);
  }

  void number_scrubbed_movesBySteps_asOneUndoStep() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    NumberField *field = fixture.field("Q", 0);
    QTest::mousePress(field, Qt::LeftButton, {}, {20, 8});
    for (int x = 20; x <= 60; x += 8) {
      QMouseEvent move(QEvent::MouseMove, QPoint(x, 8), field->mapToGlobal(QPoint(x, 8)), Qt::NoButton,
                       Qt::LeftButton, {});
      QCoreApplication::sendEvent(field, &move);
    }
    QTest::mouseRelease(field, Qt::LeftButton, {}, {60, 8});
    QVERIFY(fixture.value("Q").x == 16);
    QCOMPARE(fixture.model().history().count(), 1);
  }

  void number_thatHasTheFocus_isScrubbedTooUntilItIsTypedIn() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    NumberField *field = fixture.field("Q", 0);
    field->setFocus();
    const auto drag = [&] {
      QTest::mousePress(field, Qt::LeftButton, {}, {20, 8});
      QMouseEvent move(QEvent::MouseMove, QPoint(60, 8), field->mapToGlobal(QPoint(60, 8)), Qt::NoButton,
                       Qt::LeftButton, {});
      QCoreApplication::sendEvent(field, &move);
      QTest::mouseRelease(field, Qt::LeftButton, {}, {60, 8});
    };
    drag();
    QVERIFY(fixture.value("Q").x == 16);
    QTest::keyClicks(field, "7");
    drag();
    QVERIFY(fixture.value("Q").x == 16);
  }

  void refusedText_isGoneAfterStartOver() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    NumberField *field = fixture.field("Q", 0);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "seven");
    QTest::keyClick(field, Qt::Key_Return);
    fixture.action(QKeySequence("Ctrl+R"))->trigger();
    QCOMPARE(field->text(), QString("11"));
    QVERIFY(!field->property("wrong").toBool());
  }

  void number_scrubbedThroughACaseWithOtherResults_staysOneGesture() {
    WindowFixture fixture("ray-plane-dot");
    QVERIFY(fixture.ready);
    Object ray = *findObject(fixture.model().session().scene, "L");
    coordinate(ray, 1) = ExactVec3(-2, 1, 1);
    fixture.model().history().edit(ChangeObject{"L", ray}, "nearly parallel");
    QPointer<NumberField> field = fixture.field("L.r", 0);
    QTRY_COMPARE(field->text(), QString("-2"));
    const auto moveTo = [&](int x) {
      QMouseEvent move(QEvent::MouseMove, QPoint(x, 8), field->mapToGlobal(QPoint(x, 8)), Qt::NoButton,
                       Qt::LeftButton, {});
      QCoreApplication::sendEvent(field, &move);
      QTest::qWait(60);
    };
    QTest::mousePress(field, Qt::LeftButton, {}, {40, 8});
    moveTo(24); // two steps down: r = (−4, 1, 1) is parallel
    QCOMPARE(fixture.caseName(), std::string("parallel"));
    QVERIFY(field);
    moveTo(16);
    QTest::mouseRelease(field, Qt::LeftButton, {}, {16, 8});
    QVERIFY(fixture.value("L.r") == ExactVec3(-5, 1, 1));
    QCOMPARE(fixture.model().history().count(), 2);
    QVERIFY(!fixture.model().history().inGesture());
  }

  void scrub_escaped_restoresTheNumber() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    NumberField *field = fixture.field("Q", 0);
    QTest::mousePress(field, Qt::LeftButton, {}, {20, 8});
    QMouseEvent move(QEvent::MouseMove, QPoint(60, 8), field->mapToGlobal(QPoint(60, 8)), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(field, &move);
    QVERIFY(fixture.value("Q").x != 11);
    QTest::keyClick(field, Qt::Key_Escape);
    QVERIFY(fixture.value("Q").x == 11);
    QCOMPARE(fixture.model().history().count(), 0);
  }

  void saving_afterAnotherLessonWasOpened_leavesTheFileAsItWas() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.halfspace");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QVERIFY(fixture.window.files().saveTo(file));
    fixture.model().openLesson("plane-implicit");
    QTimer::singleShot(300, [] {
      if (QWidget *dialog = QApplication::activeModalWidget())
        dialog->close();
    });
    fixture.window.findChild<QAction *>("save")->trigger();
    const auto kept = findSession(file.toStdString());
    QVERIFY(kept);
    QCOMPARE(kept->session.lesson, std::string("signed-distance"));
  }

  void undo_afterAnotherLessonWasOpened_staysInIt_andTheChangesAreFoundAgain() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.scene().handles().select("Q");
    QTest::keyClick(&fixture.scene(), Qt::Key_PageUp);
    fixture.model().setStep(2);
    const Session changed = fixture.model().session();
    fixture.model().openLesson("plane-implicit");
    QVERIFY(!fixture.model().history().undoText());
    fixture.model().history().undo();
    QCOMPARE(fixture.model().session().lesson, std::string("plane-implicit"));
    QVERIFY(fixture.window.isWindowModified());
    fixture.model().openLesson("signed-distance");
    QVERIFY(fixture.model().session() == changed);
    QVERIFY(!fixture.model().history().undoText());
  }

  void unsavedWork_ofAProgramThatWasCutOff_comesBackWithItsFile() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.halfspace");
    UnsavedWork work;
    {
      WindowFixture fixture("signed-distance");
      work.session = fixture.model().session();
    }
    setObject(work.session.scene, "Q", PointObject{ExactVec3(1, 2, Rational(-10, 3))});
    work.file = std::make_shared<KnownFile>(KnownFile{file, "", work.session.lesson});
    QVERIFY(!Recovery(Recovery::standardFolder()).keep(work)); // ends without forgetting it
    WindowFixture fixture("plane-implicit");
    fixture.window.leftovers().restoreNewest();
    QVERIFY(fixture.model().session() == work.session);
    QVERIFY(fixture.window.windowTitle().startsWith("mine.halfspace"));
    QVERIFY(fixture.window.isWindowModified());
    fixture.window.findChild<QAction *>("save")->trigger();
    QTRY_VERIFY(QDir(Recovery::standardFolder()).entryList({"*.json"}).empty());
    const auto saved = findSession(file.toStdString());
    QVERIFY(saved && saved->session == work.session);
  }

  void file_withUnsavedChangesOfAProgramThatWasCutOff_offersThem() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.halfspace");
    UnsavedWork work;
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.window.files().saveTo(file));
      work.session = fixture.model().session();
    }
    const std::string textInFile = writeSession(work.session);
    setObject(work.session.scene, "Q", PointObject{ExactVec3(1, 2, 3)});
    work.file = std::make_shared<KnownFile>(KnownFile{file, textInFile, work.session.lesson});
    QVERIFY(!Recovery(Recovery::standardFolder()).keep(work));
    WindowFixture fixture("plane-implicit");
    fixture.window.files().open(file);
    QVERIFY(fixture.value("Q") == ExactVec3(11, 15, 8));
    QTimer::singleShot(100, [] {
      for (QWidget *widget : QApplication::topLevelWidgets())
        if (auto *box = qobject_cast<QMessageBox *>(widget))
          box->button(QMessageBox::Yes)->click();
    });
    fixture.window.leftovers().offer();
    QVERIFY(fixture.value("Q") == ExactVec3(1, 2, 3));
    QVERIFY(fixture.window.isWindowModified());
    QVERIFY(fixture.window.files().saveTo(file));
  }

  void zeroNormal_typed_isExplained_andEndsWithTheNextNumber() {
    WindowFixture fixture("plane-implicit");
    QVERIFY(fixture.ready);
    for (int axis = 0; axis < 3; ++axis)
      typeInto(*fixture.field("E.n", axis), "0");
    QCOMPARE(fixture.caseName(), std::string("zero-normal"));
    QVERIFY(fixture.model().shown().degenerate);
    typeInto(*fixture.field("E.n", 2), "1");
    QCOMPARE(fixture.caseName(), std::string("plane"));
  }

  void blankLine_filledIn_hidesTheNumbersUntilItIsRight() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.window.findChild<QDockWidget *>("numbersDock")->show();
    fixture.goToLine("length");
    QLabel *words = fixture.window.findChild<QLabel *>("case");
    QTRY_VERIFY(words->text().contains("10"));
    fixture.chooseFading("Last blank");
    QTRY_COMPARE(fixture.lines().findChildren<QLineEdit *>().size(), 1);
    QVERIFY(!words->text().contains("10"));
    const auto isShown = [&] {
      for (const MathLabel *label : fixture.window.findChild<Inspector *>()->findChildren<MathLabel *>())
        if (label->accessibleName() == "= 10" && label->isVisible())
          return true;
      return false;
    };
    QVERIFY(!isShown());
    QLineEdit *field = fixture.lines().findChild<QLineEdit *>();
    QTest::keyClicks(field, "10");
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_VERIFY(words->text().contains("10"));
    QTRY_VERIFY(isShown());
  }

  void newNumbers_clicked_areOneUndoStep_inView_andToBeFilledIn_data() {
    QTest::addColumn<QString>("lesson");
    for (const char *lesson : {"plane-implicit", "signed-distance", "ray-plane-dot", "ray-triangle-perp"})
      QTest::newRow(lesson) << lesson;
  }

  void newNumbers_clicked_areOneUndoStep_inView_andToBeFilledIn() {
    QFETCH(QString, lesson);
    WindowFixture fixture(lesson.toStdString());
    QVERIFY(fixture.ready);
    for (int step = 0; !fixture.practice().hasBlanks(); ++step) {
      QVERIFY(step < static_cast<int>(fixture.model().lesson().steps.size()));
      fixture.model().setStep(step);
      if (!predictionOf(fixture.model().step()))
        fixture.chooseFading("All blank");
    }
    const Session before = fixture.model().session();
    const std::string caseBefore = fixture.caseName();
    for (int i = 1; i <= 5; ++i) {
      QTest::mouseClick(fixture.practice().findChild<QToolButton *>("newNumbers"), Qt::LeftButton);
      QCOMPARE(fixture.model().history().count(), i);
      QVERIFY(!(fixture.model().session() == before));
      QCOMPARE(fixture.caseName(), caseBefore);
      QVERIFY(fixture.practice().hasBlanks());
      const auto &blocks = fixture.practice().working().blocks();
      QVERIFY(std::any_of(blocks.begin(), blocks.end(), [&](const WorkingBlock *block) {
        return block->isAncestorOf(fixture.window.focusWidget());
      }));
      const QRect view = fixture.scene().rect();
      for (const Place &place : placesOf(fixture.model().figure()))
        QVERIFY(view.contains(fixture.pixelOf(place)));
    }
    while (fixture.model().history().undoText())
      fixture.model().history().undo();
    QVERIFY(fixture.model().session() == before);
  }

  void newNumbers_afterLookingAround_areFittedIntoTheView() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.goToLine("length");
    const auto seesAll = [&] {
      const std::vector<Place> places = placesOf(fixture.model().shown().figure);
      return std::all_of(places.begin(), places.end(), [&](const Place &place) {
        return fixture.scene().rect().contains(fixture.pixelOf(place));
      });
    };
    for (int i = 0; i < 15; ++i) {
      QWheelEvent nearer({20, 20}, fixture.scene().mapToGlobal(QPoint(20, 20)), {}, {0, 120}, Qt::NoButton,
                         Qt::NoModifier, Qt::NoScrollPhase, false);
      QApplication::sendEvent(&fixture.scene(), &nearer);
    }
    QVERIFY(!seesAll());
    QTest::mouseClick(fixture.practice().findChild<QToolButton *>("newNumbers"), Qt::LeftButton);
    QVERIFY(seesAll());
  }

  void task_trueOnArrival_isDoneOnlyAfterItWasBroughtAbout() {
    WindowFixture fixture("ray-plane-dot");
    QVERIFY(fixture.ready);
    fixture.model().setStep(4); // t is negative at the start
    const auto isDone = [&] { return fixture.window.findChild<TaskRow *>()->state() == TaskState::Done; };
    const auto turn = [&](const ExactVec3 &direction) {
      Object ray = *findObject(fixture.model().session().scene, "L");
      coordinate(ray, 1) = direction;
      fixture.model().history().edit(ChangeObject{"L", ray}, "turn");
      QTest::qWait(100);
    };
    QTest::qWait(100);
    QVERIFY(!isDone());
    turn({1, -3, -2});
    QVERIFY(!isDone());
    turn({-1, 3, 2});
    QVERIFY(isDone());
  }

  void task_thatHoldsOnlyOnTheWayOfADrag_isNotDone() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.model().setStep(1); // Q is to come to rest in the plane
    const auto isDone = [&] { return fixture.window.findChild<TaskRow *>()->state() == TaskState::Done; };
    GestureToken held = GestureToken::Nobodys;
    const auto move = [&](const ExactVec3 &place) {
      fixture.model().history().moveGesture(held, ChangeObject{"Q", PointObject{place}});
      QTest::qWait(50);
    };
    held = fixture.model().history().beginGesture("move Q");
    move({5, 4, 7});
    QVERIFY(!isDone());
    move({5, 4, 6});
    fixture.model().history().endGesture(held);
    QVERIFY(!isDone());
    held = fixture.model().history().beginGesture("move Q");
    move({5, 4, 7});
    fixture.model().history().cancelGesture(held);
    QVERIFY(!isDone());
    held = fixture.model().history().beginGesture("move Q");
    move({5, 4, 7});
    fixture.model().history().endGesture(held);
    QVERIFY(isDone());
  }

  void task_whileTheQuestionIsOpen_doesNotTellWhetherItHolds() {
    WindowFixture fixture("plane-implicit"); // P is to be dragged to the negative side
    QVERIFY(fixture.ready);
    const auto state = [&] { return fixture.window.findChild<TaskRow *>()->state(); };
    const auto moveP = [&](const ExactVec3 &place) {
      QVERIFY(fixture.model().history().edit(ChangeObject{"P", PointObject{place}}, "move").isEmpty());
      QTest::qWait(50);
    };
    moveP({9, 9, 9});
    moveP({0, 0, 0});
    QVERIFY(state() == TaskState::Open);
    fixture.answer(2);
    QTRY_VERIFY(state() == TaskState::HoldsAlready);
  }

  void task_thatNewNumbersMakeTrue_isNotDone() {
    WindowFixture fixture("plane-implicit");
    QVERIFY(fixture.ready);
    fixture.model().setStep(5); // whose task is about n alone
    for (int i = 0; i < 30; ++i) {
      QTest::mouseClick(fixture.practice().findChild<QToolButton *>("newNumbers"), Qt::LeftButton);
      QTest::qWait(5);
      for (const TaskRow *task : fixture.window.findChildren<TaskRow *>())
        QVERIFY(task->state() != TaskState::Done);
    }
  }

  void answer_whenTheSceneHasBecomeAnotherCase_saysThatItWasAboutTheOldOne() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.answer(0);
    const auto reason = [&] { return fixture.window.findChild<PredictionBox *>()->reason()->plain(); };
    const QString before = reason();
    QVERIFY(fixture.model().history().edit(ChangeObject{"Q", PointObject{{1, 1, 1}}}, "move").isEmpty());
    QTRY_VERIFY(reason() != before);
    fixture.model().history().undo();
    QTRY_COMPARE(reason(), before);
  }

  void nearestSpecialCase_isToldOnceNumbersAreShown_andOneClickLeadsThere() {
    WindowFixture fixture("ray-plane-dot");
    QVERIFY(fixture.ready);
    auto *nearby = fixture.window.findChild<QLabel *>("nearby");
    QVERIFY(fixture.questionIsOpen());
    QVERIFY2(nearby->text().isEmpty(), "it would give the answer away");
    fixture.goToLine("denominator");
    QVERIFY2(nearby->text().contains("parallel"), qPrintable(nearby->text()));
    const Session before = fixture.model().session();
    QTest::mouseClick(fixture.window.findChild<QPushButton *>("there"), Qt::LeftButton);
    QCOMPARE(fixture.caseName(), std::string("parallel"));
    QVERIFY2(nearby->text().contains("lie in the plane"), qPrintable(nearby->text()));
    fixture.model().history().undo();
    QVERIFY(fixture.model().session() == before);
  }

  void lines_whileTheQuestionIsOpen_areTheSameInEverySpecialCase() {
    WindowFixture fixture("ray-plane-dot");
    QVERIFY(fixture.ready);
    SessionModel &model = fixture.model();
    const auto linesShown = [&] {
      QStringList lines;
      for (const WorkingBlock *block : fixture.practice().working().blocks())
        if (!block->isHidden())
          lines << block->spoken();
      return lines.join('\n');
    };
    int cases = 0;
    for (const Lesson &lesson : model.library().lessons) {
      model.openLesson(lesson.id);
      for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
        if (!predictionOf(lesson.steps[step]))
          continue;
        model.setStep(static_cast<int>(step));
        const QString before = linesShown();
        std::set<std::string> entries;
        for (const WorkingLine &line : model.shown().working.lines)
          entries.insert(entryOf(line.id));
        for (const NearSpecialCase &near : specialCasesNear(lesson.scene, model.evaluation(), entries))
          if (near.change) {
            QCOMPARE(model.history().edit(*near.change, "go there"), QString());
            QVERIFY2(linesShown() == before,
                     qPrintable(QString::fromStdString(lesson.id + ": " + near.sentence)));
            QVERIFY(!fixture.window.findChild<QPushButton *>("afresh")->isVisible());
            model.history().undo();
            ++cases;
          }
      }
    }
    QVERIFY(cases > 30);
  }

  void startOver_asksTheQuestionOfTheStepAgain() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.answer(0);
    QVERIFY(!fixture.questionIsOpen());
    const Scene start = fixture.model().session().scene;
    QCOMPARE(fixture.model().history().edit(ChangeObject{"Q", PointObject{{1, 2, 3}}}, "move"), QString());
    QSignalSpy changed(&fixture.model(), &SessionModel::outcomeChanged);
    fixture.action(QKeySequence("Ctrl+R"))->trigger();
    QVERIFY(fixture.questionIsOpen());
    QVERIFY(fixture.model().session().scene == start);
    QCOMPARE(changed.count(), 1);
    fixture.answer(0);
    fixture.action(QKeySequence("Ctrl+R"))->trigger(); // nothing else has changed
    QVERIFY(fixture.questionIsOpen());
  }

  void step_whoseCaseLacksItsLines_offersToStartAfresh() {
    WindowFixture fixture("ray-plane-dot");
    QVERIFY(fixture.ready);
    fixture.goToLine("t");
    auto *afresh = fixture.window.findChild<QPushButton *>("afresh");
    QVERIFY(!afresh->isVisible());
    const Scene start = fixture.model().session().scene;
    Object ray = *findObject(start, "L");
    coordinate(ray, 1) = {0, 0, 0};
    QCOMPARE(fixture.model().history().edit(ChangeObject{"L", ray}, "no direction"), QString());
    QVERIFY(afresh->isVisible());
    QTest::mouseClick(afresh, Qt::LeftButton);
    QVERIFY(fixture.model().session().scene == start);
    QVERIFY(!afresh->isVisible());
  }

  void slider_ofANumber_changesItInStepsWithinItsBounds() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    Object number = *makeObject("number");
    number[1].x = -1;
    number[2].x = 2;
    number[3].x = Rational(1, 2);
    QCOMPARE(fixture.model().history().edit(AddEntry{0, {"k", number}}, "add"), QString());
    fixture.window.findChild<QDockWidget *>("numbersDock")->show(); // hidden, it has no rows
    auto *slider = fixture.window.findChild<Inspector *>()->findChild<QSlider *>();
    QVERIFY(slider);
    QCOMPARE(slider->maximum(), 6);
    QCOMPARE(slider->value(), 2);
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY((*findObject(fixture.model().session().scene, "k"))[0].x == Rational(1, 2));
    QTest::keyClick(slider, Qt::Key_End);
    QVERIFY((*findObject(fixture.model().session().scene, "k"))[0].x == 2);
    fixture.model().history().undo();
    QCOMPARE(slider->value(), 3);
  }

  void pointer_overAMark_lightsUpItsTerms() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.model().setStep(1);
    QSignalSpy hovered(&fixture.scene().handles(), &SceneHandles::markHovered);
    QTest::mouseMove(&fixture.scene(), *handlePosition(fixture.scene(), "Q"));
    QTRY_VERIFY(hovered.count() > 0);
    QCOMPARE(hovered.last().first().toString(), QString("Q"));
    QVERIFY(fixture.scene().drawn().highlighted().contains("Q"));
  }

  void session_savedAndOpened_isTheSame() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.halfspace");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.scene().handles().select("Q");
    QTest::keyClick(&fixture.scene(), Qt::Key_PageUp, Qt::ShiftModifier);
    const Session mine = fixture.model().session();
    QVERIFY(fixture.window.files().saveTo(file));
    QVERIFY(!fixture.window.isWindowModified());
    fixture.model().openLesson("plane-implicit");
    fixture.window.files().open(file);
    QVERIFY(fixture.model().session() == mine);
  }

  void session_savedAfterTurning_isOpenedWithItsCamera() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.halfspace");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.drag({8, 8}, {90, 40});
    fixture.scene().viewpoint().setOrthographic(true);
    const Camera mine = fixture.scene().viewpoint().camera();
    QVERIFY2(!fixture.window.isWindowModified(), "who looks from elsewhere has changed nothing");
    QVERIFY(fixture.window.files().saveTo(file));
    fixture.model().openLesson("plane-implicit");
    QVERIFY(!fixture.scene().viewpoint().camera().orthographic);
    WindowFixture next("ray-plane-dot");
    QVERIFY(next.ready);
    for (WindowFixture *opened : {&fixture, &next}) {
      opened->window.files().open(file);
      const Camera camera = opened->scene().viewpoint().camera();
      QVERIFY(camera.orthographic);
      QVERIFY(glm::distance(camera.target, mine.target) < 1e-4);
      QVERIFY(glm::distance(camera.viewDirection(), mine.viewDirection()) < 1e-4);
      QVERIFY(std::abs(camera.height - mine.height) < 1e-4);
    }
  }

  void damagedFile_opened_isRefusedWithASentence_andTheSessionStays() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("damaged.halfspace");
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write("{\"format\":\"halfspace\",\"version\":1,\"lesson\":");
    out.close();
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const Session before = fixture.model().session();
    const MessageBoxReader reader;
    fixture.window.files().open(file);
    QVERIFY(reader.text.contains("damaged.halfspace"));
    QVERIFY(fixture.model().session() == before);
  }

  void unwritablePlace_savedTo_isRefusedWithASentence() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const MessageBoxReader reader;
    QVERIFY(!fixture.window.files().saveTo("/nowhere/at/all.halfspace"));
    QVERIFY(reader.text.contains("is not saved"));
  }

  void picture_copied_leavesTheSceneDrawing() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.window.findChild<FigureExport *>()->copy();
    QVERIFY(!QApplication::clipboard()->image().isNull());
    // The live view still draws after the other context was current.
    QSignalSpy drawn(&fixture.scene().drawing(), &SceneDrawing::frameDrawn);
    fixture.scene().handles().select("Q");
    QTRY_VERIFY(drawn.count() > 0);
  }

  void everyTheme_chosen_drawsTheSceneInItsColours() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    for (const Theme &theme : themes()) {
      fixture.window.look().setThemeNamed(QString::fromStdString(theme.name));
      const auto cornerIs = [&] {
        const QColor corner =
            fixture.scene().grabFramebuffer().pixelColor(2, fixture.scene().screen().size().height - 3);
        return std::abs(corner.red() - theme.backgroundBottom.red) < 8 &&
               std::abs(corner.blue() - theme.backgroundBottom.blue) < 8;
      };
      QTRY_VERIFY2(cornerIs(), theme.name.c_str());
    }
  }

  void oneMove_ofAHandle_isDrawnOnce_andOnceMoreAtRest() {
    WindowFixture fixture("ray-triangle-perp");
    QVERIFY(fixture.ready);
    const QPoint from = *handlePosition(fixture.scene(), "T.P1");
    fixture.press(from);
    QTest::qWait(400); // until labels have come and the view is at rest
    QSignalSpy evaluated(&fixture.model(), &SessionModel::outcomeChanged);
    QSignalSpy drawn(&fixture.scene().drawing(), &SceneDrawing::frameDrawn);
    const QPoint at = from + QPoint(60, 30);
    QMouseEvent move(QEvent::MouseMove, at, fixture.scene().mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                     {});
    QCoreApplication::sendEvent(&fixture.scene(), &move);
    QTRY_COMPARE(evaluated.count(), 1);
    QTest::qWait(4 * FramePacer::restDelay);
    QVERIFY2(drawn.count() <= 2, qPrintable(QString::number(drawn.count())));
    fixture.release();
  }

  void drag_withManyMoves_drawsAtMostOneFrameAnEvaluation() {
    WindowFixture fixture("ray-triangle-perp");
    QVERIFY(fixture.ready);
    QTest::qWait(400); // until labels have come and the view is at rest
    QSignalSpy evaluated(&fixture.model(), &SessionModel::outcomeChanged);
    QSignalSpy drawn(&fixture.scene().drawing(), &SceneDrawing::frameDrawn);
    const QPoint from = *handlePosition(fixture.scene(), "T.P1");
    fixture.press(from);
    for (int i = 1; i <= 200; ++i) {
      const QPoint at = from + QPoint(i / 2, i / 4);
      QMouseEvent move(QEvent::MouseMove, at, fixture.scene().mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                       {});
      QCoreApplication::sendEvent(&fixture.scene(), &move);
    }
    // None of the moves has waited for a frame; the next frame takes up the last of them.
    QVERIFY(evaluated.count() <= 1);
    QTRY_VERIFY(drawn.count() > 0);
    QVERIFY(evaluated.count() <= drawn.count());
    const auto reached = handlePosition(fixture.scene(), "T.P1");
    QVERIFY(reached);
    fixture.release();
    QVERIFY((*handlePosition(fixture.scene(), "T.P1") - (from + QPoint(100, 50))).manhattanLength() < 60);
    QCOMPARE(fixture.model().history().count(), 1);
  }
};

QTEST_MAIN(WindowTest)
#include "window_test.moc"
