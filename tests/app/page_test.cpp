// The page beside the scene, the drawer and the card over it, and how the window is shared among them.
#include "app/panels/page_width.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "tests/app/window_fixture.h"
#include "widgets/lesson/contents_drawer.h"
#include "widgets/lesson/lesson_page.h"

#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSaveFile>
#include <QSplitter>
#include <QTemporaryDir>

using namespace halfspace;

namespace {

class PageFixture : public WindowFixture {
public:
  explicit PageFixture(QSize size = {1280, 800}) : WindowFixture("signed-distance") {
    window.look().setSizeScale(1);
    resize(size);
  }
  void resize(QSize size) {
    window.resize(size);
    QTest::qWait(100);
  }
  LessonPage &page() { return *window.findChild<LessonPage *>(); }
  QSplitter &split() { return *window.findChild<QSplitter *>(); }
  /// As a hand does.
  void moveSplit(int pixels) {
    QWidget *handle = split().handle(1);
    const QPoint from = handle->rect().center();
    QTest::mousePress(handle, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, from + QPoint(pixels, 0),
                     handle->mapToGlobal(from + QPoint(pixels, 0)), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(handle, &move);
    QTest::mouseRelease(handle, Qt::LeftButton, {}, from);
  }
  /// The scene's part of the window's area.
  double shareOfScene() {
    const QSize part = scene().size();
    return double(part.width()) * part.height() / (double(window.width()) * window.height());
  }
};

} // namespace

class PageTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName("halfspace-test");
    QCoreApplication::setApplicationName("page");
  }
  void init() { forgetStarts(); }

  void scene_takesMostOfTheWindow_data() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<double>("share");
    QTest::newRow("usual") << QSize(1280, 800) << 0.6;
    QTest::newRow("small") << QSize(1024, 600) << 0.5;
    QTest::newRow("large") << QSize(1900, 1000) << 0.6;
  }
  void page_hasAsManyLettersInALineAsItsShareAllows() {
    PageFixture fixture;
    QVERIFY(fixture.ready);
    for (const QSize size : {QSize(1280, 800), QSize(1024, 600), QSize(1600, 900)}) {
      fixture.resize(size);
      const int wanted = pageWidthIn(size.width(), fixture.page().fontMetrics());
      QVERIFY2(std::abs(fixture.page().width() - wanted) < 10,
               qPrintable(QString::number(fixture.page().width())));
    }
  }
  void scene_takesMostOfTheWindow() {
    QFETCH(QSize, size);
    QFETCH(double, share);
    PageFixture fixture(size);
    QVERIFY(fixture.ready);
    for (int step = 0; step < static_cast<int>(fixture.model().lesson().steps.size()); ++step) {
      fixture.model().setStep(step);
      QTest::qWait(20);
      QCOMPARE(fixture.window.size(), size);
      QVERIFY2(fixture.shareOfScene() >= share, qPrintable(QString::number(fixture.shareOfScene())));
    }
  }

  void page_inAHighWindow_standsBelowTheScene() {
    PageFixture fixture({700, 1000});
    QVERIFY(fixture.ready);
    const auto top = [&](QWidget &widget) { return widget.mapTo(&fixture.window, QPoint(0, 0)).y(); };
    QVERIFY(top(fixture.page()) >= top(fixture.scene()) + fixture.scene().height());
    QVERIFY(fixture.scene().height() > 0.4 * 1000);
    fixture.resize({1280, 800});
    QCOMPARE(top(fixture.page()), top(fixture.scene()));
  }

  void keys_showTheSceneAloneAndThePageAlone_andBothAgain() {
    PageFixture fixture;
    QVERIFY(fixture.ready);
    const auto parts = [&] { return std::pair(fixture.scene().isVisible(), fixture.page().isVisible()); };
    const auto press = [&](Qt::Key key) { QTest::keyClick(&fixture.window, key); };
    fixture.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
    press(Qt::Key_F9);
    QVERIFY(parts() == std::pair(true, false));
    QTRY_VERIFY(fixture.shareOfScene() > 0.8);
    const double usual = fixture.page().font().pointSizeF();
    press(Qt::Key_F8);
    QVERIFY(parts() == std::pair(false, true));
    QVERIFY(fixture.page().font().pointSizeF() > 1.2 * usual);
    QVERIFY(!fixture.action(Qt::Key_F9)->isChecked());
    press(Qt::Key_F8);
    QVERIFY(parts() == std::pair(true, true));
    QCOMPARE(fixture.page().font().pointSizeF(), usual);
    press(Qt::Key_F9);
    press(Qt::Key_F9);
    QVERIFY(parts() == std::pair(true, true));
    QTRY_VERIFY(fixture.shareOfScene() < 0.7);
  }

  void key_fillsTheScreen_andLeavesItAgain() {
    PageFixture fixture;
    QVERIFY(fixture.ready);
    fixture.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
    QTest::keyClick(&fixture.window, Qt::Key_F11);
    QVERIFY(fixture.window.windowState().testFlag(Qt::WindowFullScreen));
    QTest::keyClick(&fixture.window, Qt::Key_F11);
    QVERIFY(!fixture.window.windowState().testFlag(Qt::WindowFullScreen));
  }

  void numbers_openOnDemand_byTheirKeyAndTheirTool() {
    PageFixture fixture;
    QVERIFY(fixture.ready);
    auto *numbers = fixture.window.findChild<QDockWidget *>("numbersDock");
    QVERIFY(!numbers->isVisible());
    fixture.action(QKeySequence("Ctrl+I"))->trigger();
    QVERIFY(numbers->isVisible());
    QTest::mouseClick(fixture.window.findChildren<QToolButton *>("sceneTool").last(), Qt::LeftButton);
    QVERIFY(!numbers->isVisible());
  }

  void numbers_leaveTheSceneMostOfASmallWindow_andGiveBackWhatTheyTook() {
    PageFixture fixture;
    QVERIFY(fixture.ready);
    fixture.resize({1024, 600});
    const QList<int> usual = fixture.split().sizes();
    fixture.action(QKeySequence("Ctrl+I"))->trigger();
    QTest::qWait(100);
    QVERIFY2(fixture.scene().width() > 350, qPrintable(QString::number(fixture.scene().width())));
    QVERIFY(fixture.scene().width() > fixture.page().width());
    fixture.action(QKeySequence("Ctrl+I"))->trigger();
    QTRY_COMPARE(fixture.split().sizes(), usual);
  }

  void layout_thatWasChanged_isRestored() {
    PageFixture fixture;
    QVERIFY(fixture.ready);
    const QList<int> usual = fixture.split().sizes();
    auto *numbers = fixture.window.findChild<QDockWidget *>("numbersDock");
    fixture.moveSplit(-150);
    numbers->show();
    numbers->setFloating(true);
    fixture.action(Qt::Key_F11)->trigger();
    fixture.action(Qt::Key_F8)->trigger();
    fixture.window.findChild<QAction *>("restoreLayout")->trigger();
    QVERIFY(!fixture.window.windowState().testFlag(Qt::WindowFullScreen));
    QVERIFY(!numbers->isVisible() && !numbers->isFloating());
    QVERIFY(fixture.scene().isVisible() && fixture.page().isVisible());
    for (const Qt::Key key : {Qt::Key_F8, Qt::Key_F9, Qt::Key_F11})
      QVERIFY(!fixture.action(key)->isChecked());
    fixture.resize({1280, 800});
    QCOMPARE(fixture.split().sizes(), usual);
  }

  void split_thatTheUserMoved_staysForTheNextStart() {
    QList<int> mine;
    {
      PageFixture fixture;
      QVERIFY(fixture.ready);
      const int usual = fixture.split().sizes()[1];
      fixture.moveSplit(-120);
      mine = fixture.split().sizes();
      QVERIFY2(mine[1] > usual + 100, qPrintable(QString::number(mine[1])));
      fixture.resize({1290, 800}); // it is not shared anew
      QVERIFY(std::abs(fixture.split().sizes()[1] - mine[1]) <= 10);
      fixture.resize({1280, 800});
      mine = fixture.split().sizes();
      QVERIFY(fixture.window.close());
    }
    PageFixture next;
    QCOMPARE(next.split().sizes(), mine);
  }

  void flatPicture_thatWasFolded_staysSoForTheNextStart() {
    for (const bool unfolded : {false, true}) {
      {
        WindowFixture fixture("ray-plane-picture");
        QVERIFY(fixture.ready);
        QCOMPARE(fixture.action(Qt::Key_6)->isChecked(), !unfolded);
        fixture.action(Qt::Key_6)->trigger();
        QVERIFY(fixture.window.close());
      }
      WindowFixture next("ray-plane-picture");
      QCOMPARE(next.action(Qt::Key_6)->isChecked(), unfolded);
      QVERIFY(next.window.close());
    }
  }

  void type_thatGrows_getsAWiderPage_andLeavesHalfToTheScene() {
    PageFixture fixture;
    QVERIFY(fixture.ready);
    const int usual = fixture.page().width();
    fixture.window.look().setSizeScale(2.5);
    fixture.resize({1280, 800});
    QCOMPARE(fixture.window.width(), 1280);
    QVERIFY(fixture.page().width() > usual);
    QVERIFY2(fixture.scene().width() >= 600, qPrintable(QString::number(fixture.scene().width())));
    fixture.action(QKeySequence("Ctrl+0"))->trigger();
    QTest::qWait(100);
    QCOMPARE(fixture.page().width(), usual);
  }

  void dragInTheScene_movesNothingOnThePage() {
    PageFixture fixture;
    QVERIFY(fixture.ready);
    fixture.goToLine("length");
    QTest::qWait(100);
    const auto places = [&] {
      std::vector<double> tops;
      for (const PlacedLine &line : fixture.lines().placed().lines)
        tops.push_back(line.box.top());
      tops.push_back(fixture.lines().mapTo(&fixture.window, QPoint(0, 0)).y());
      return tops;
    };
    const auto before = places();
    const int sceneHeight = fixture.scene().height();
    const QPoint from = *handlePosition(fixture.scene(), "Q");
    fixture.press(from);
    for (int i = 0; i < 12; ++i) {
      fixture.moveTo(from + QPoint(8 * i, -5 * i));
      QTest::qWait(20);
      const auto now = places();
      QCOMPARE(now.size(), before.size());
      for (std::size_t k = 0; k < now.size(); ++k)
        QVERIFY2(now[k] >= before[k], "nothing comes up");
      QVERIFY(fixture.scene().height() <= sceneHeight);
    }
    fixture.release();
  }

  void selectedObject_hasItsNumbersOnTheCard_thatFollowADrag() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QVERIFY(!fixture.card().given().field("Q", 0));
    const QPoint from = *handlePosition(fixture.scene(), "Q");
    fixture.press(from);
    fixture.moveTo(from + QPoint(60, 30));
    QVERIFY(fixture.card().given().field("Q", 0));
    QTRY_COMPARE(fixture.card().given().field("Q", 0)->text(),
                 QString::fromStdString(toText(fixture.value("Q").x)));
    QVERIFY(fixture.card().given().field("Q", 0)->text() != "11");
    fixture.release();
    fixture.scene().handles().select({});
    QVERIFY(!fixture.card().given().field("Q", 0));
  }

  void lastStep_leadsOnToTheNextLesson_asTheMenuDoesFromAnywhere() {
    WindowFixture fixture("plane-implicit");
    QVERIFY(fixture.ready);
    const auto &lessons = fixture.model().library().lessons;
    const auto lessonAfter = [&](std::size_t index) {
      return lessons.begin()[static_cast<std::ptrdiff_t>(index)].id;
    };
    fixture.model().openLesson(lessonAfter(0));
    auto *next = fixture.window.findChild<QPushButton *>("next");
    fixture.model().setStep(static_cast<int>(lessons[0].steps.size()) - 1);
    QCOMPARE(next->text(), QString("Next lesson"));
    QTest::mouseClick(next, Qt::LeftButton);
    QCOMPARE(fixture.model().session().lesson, lessonAfter(1));
    QCOMPARE(fixture.model().session().step, 0);
    fixture.action(QKeySequence("Ctrl+Shift+Right"))->trigger();
    QCOMPARE(fixture.model().session().lesson, lessonAfter(2));
    fixture.model().openLesson(lessons.back().id);
    fixture.model().setStep(static_cast<int>(lessons.back().steps.size()) - 1);
    QVERIFY(!next->isEnabled());
    fixture.action(QKeySequence("Ctrl+Shift+Right"))->trigger();
    QCOMPARE(fixture.model().session().lesson, lessons.back().id);
  }

  void step_whoseLinesTheSceneLacks_beginsWithTheSceneBefore_whichCanBeUndone() {
    WindowFixture fixture("ray-plane-dot");
    QVERIFY(fixture.ready);
    SessionModel &model = fixture.model();
    QAction *next = fixture.action(QKeySequence("Ctrl+Right"));
    const auto edit = [&](const ExactVec3 &start, const ExactVec3 &direction) {
      const RayObject ray{start, direction};
      QCOMPARE(model.history().edit(ChangeObject{"L", ray}, "drag"), QString());
    };
    edit({10, 15, 8}, {-1, 3, 2});
    while (model.step().title != "When there is no t")
      next->trigger();
    const Scene before = model.session().scene;
    edit({10, 15, 8}, {0, 1, -1});
    const Scene parallel = model.session().scene;
    next->trigger();
    QCOMPARE(QString::fromStdString(model.step().title), QString("The facing normal"));
    QVERIFY(model.session().scene == before);
    model.history().undo();
    QVERIFY(model.session().scene == parallel);
    QAction *previous = fixture.action(QKeySequence("Ctrl+Left"));
    previous->trigger(); // to a step that has its lines in this case as well
    QVERIFY(model.session().scene == parallel);
    previous->trigger();
    QVERIFY(model.session().scene == model.lesson().scene);
  }

  void contents_opened_leadToALesson_andGiveTheKeysBack() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    auto *drawer = fixture.window.findChild<ContentsDrawer *>();
    auto *button = fixture.window.findChild<QToolButton *>("contentsButton");
    auto *list = drawer->findChild<QListWidget *>();
    const int sceneWidth = fixture.scene().width();
    fixture.action(QKeySequence("Ctrl+L"))->trigger();
    QVERIFY(drawer->isVisible() && button->isChecked());
    QTest::qWait(50); // it stands over the scene and moves nothing
    QCOMPARE(drawer->mapTo(&fixture.window, QPoint(0, 0)),
             fixture.scene().mapTo(&fixture.window, QPoint(0, 0)));
    QVERIFY(drawer->height() > fixture.scene().height());
    QCOMPARE(fixture.scene().width(), sceneWidth);
    QTest::keyClick(fixture.window.focusWidget(), Qt::Key_Escape);
    QVERIFY(!drawer->isVisible() && !button->isChecked());
    QCOMPARE(fixture.window.focusWidget(), &fixture.scene());
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(drawer->isVisible());
    QCOMPARE(list->currentItem()->data(Qt::UserRole).toString(), QString("signed-distance"));
    QVERIFY2(!(list->item(0)->flags() & Qt::ItemIsEnabled), "the chapter");
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(1)).center());
    QCOMPARE(fixture.model().session().lesson, fixture.model().library().lessons[0].id);
    QVERIFY(!drawer->isVisible() && !button->isChecked());
    QCOMPARE(fixture.window.findChild<QLabel *>("lessonTitle")->text(),
             QString::fromStdString(fixture.model().lesson().title));
  }

  void answer_isBackAtTheNextStart_andTheContentsSayThatTheLessonIsBegun() {
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      QVERIFY(fixture.questionIsOpen());
      fixture.answer(0);
      QVERIFY(!fixture.questionIsOpen());
      QVERIFY(fixture.window.close());
    }
    WindowFixture next("signed-distance");
    QVERIFY(next.ready);
    QVERIFY(!next.questionIsOpen());
    next.action(QKeySequence("Ctrl+L"))->trigger();
    const auto *list = next.window.findChild<ContentsDrawer *>()->findChild<QListWidget *>();
    QVERIFY(list->currentItem()->data(Qt::AccessibleTextRole).toString().endsWith("begun"));
    QVERIFY(!list->item(1)->data(Qt::AccessibleTextRole).toString().endsWith("begun"));
  }

  void lessonFile_changed_isReadAnewAtTheSameStep_itsMistakesAreTold_andADamagedOneIsLeftOut() {
    QTemporaryDir folder;
    const QString file = folder.filePath("own.md");
    const auto save = [&](const QByteArray &text) {
      QSaveFile written(file); // puts another file in its place, as editors do
      QVERIFY(written.open(QIODevice::WriteOnly));
      written.write(text);
      QVERIFY(written.commit());
    };
    const QByteArray text = "---\nid: own\ntitle: Own\nscene:\n  - {name: Q, point: [1, 2, 3]}\n---\n"
                            "## One\nWords.\n## Two\nMore words.\n";
    save(text);
    PageFixture fixture;
    QVERIFY(fixture.ready);
    LessonLibrary library = fixture.model().library();
    addOwnLessons(library, folder.path().toStdString());
    QCOMPARE(library.lessons.back().chapter, std::string("Own lessons"));
    fixture.model().setLibrary(library);
    fixture.model().openLesson("own");
    fixture.model().setStep(1);
    const QByteArray changed = QByteArray(text).replace("## Two", "## Second");
    save(changed);
    QTRY_COMPARE(fixture.model().step().title, std::string("Second"));
    save(QByteArray(changed).replace("Words.", "Words $\\foo$."));
    QTRY_VERIFY(
        fixture.window.findChild<QLabel *>("message")->text().contains("own.md:8: In “\\foo”, column 1"));
    save("no lesson at all");
    QTRY_VERIFY(fixture.window.findChild<QLabel *>("message")->text().contains("own.md"));
    QCOMPARE(fixture.model().step().title, std::string("Second"));
    save(text);
    QTRY_COMPARE(fixture.model().step().title, std::string("Two"));
  }

  void question_triedAgainOfAnotherScene_hidesTheNumbersAgain() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const auto hidesNumbers = [&] {
      return fixture.questionIsOpen() && fixture.lines().shownNumbers().inLine(0).empty();
    };
    QVERIFY(hidesNumbers());
    fixture.answer(1);
    QVERIFY(!fixture.questionIsOpen());
    QVERIFY(!fixture.lines().shownNumbers().inLine(0).empty());
    fixture.model().history().edit(ChangeObject{"Q", PointObject{{-1, 1, 1}}}, "move Q"); // to the other side
    QTest::mouseClick(fixture.window.findChild<QToolButton *>("again"), Qt::LeftButton);
    QVERIFY(hidesNumbers());
    fixture.answer(0);
    QVERIFY(!fixture.questionIsOpen());
  }

  void newNumbers_askTheQuestionOnceMore() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.answer(0);
    QTest::mouseClick(fixture.practice().findChild<QToolButton *>("newNumbers"), Qt::LeftButton);
    QVERIFY(fixture.questionIsOpen());
    QCOMPARE(fixture.model().history().count(), 1);
  }
};

QTEST_MAIN(PageTest)
#include "page_test.moc"
