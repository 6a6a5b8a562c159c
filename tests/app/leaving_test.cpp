// Nothing is lost when the window closes, is told to end, or finds its file changed.
#include "app/termination.h"
#include "lessons/object/kinds/point.h"
#include "tests/app/box_answerer.h"
#include "tests/app/window_fixture.h"
#include "tests/mesh_files/mesh_texts.h"
#include "widgets/carriers/found_session.h"
#include "widgets/numbers/inspector.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>

#include <csignal>
#include <memory>

using namespace halfspace;

namespace {

/// Where Q is, and is moved to from now on: what the pointer has done last is taken when a drag ends.
void follow(WindowFixture &fixture, ExactVec3 &place) {
  place = fixture.value("Q");
  QObject::connect(&fixture.model(), &SessionModel::outcomeChanged, &fixture.window,
                   [&] { place = fixture.value("Q"); });
}

/// Types without entering.
void beginTyping(NumberField &number, const QString &text) {
  number.setFocus();
  number.selectAll();
  QTest::keyClicks(&number, text);
}

void moveUp(WindowFixture &fixture, const char *handle) {
  fixture.scene().handles().select(handle);
  QTest::keyClick(&fixture.scene(), Qt::Key_PageUp);
}

ExactVec3 pointOf(const Session &session, const char *name) {
  return coordinate(*findObject(session.scene, name), 0);
}

std::vector<Recovery::Leftover> leftovers() { return Recovery(Recovery::standardFolder()).leftovers(); }

/// Where nothing can be kept: a file stands in the folder's place.
void blockUnsavedFolder() {
  const QString folder = Recovery::standardFolder();
  QDir(folder).removeRecursively();
  QDir().mkpath(QFileInfo(folder).path());
  QFile blocking(folder);
  QVERIFY(blocking.open(QIODevice::WriteOnly));
}

} // namespace

class LeavingTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void closing_inTheMiddleOfADrag_keepsWhatWasDragged() {
    ExactVec3 dragged;
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      const QPoint from = *handlePosition(fixture.scene(), "Q");
      fixture.press(from);
      fixture.moveTo(from + QPoint(60, 20));
      QVERIFY(!(fixture.value("Q") == ExactVec3(11, 15, 8)));
      follow(fixture, dragged);
      QVERIFY(fixture.window.close());
    }
    QCOMPARE(leftovers().size(), 1U);
    QVERIFY(pointOf(leftovers().front().work.session, "Q") == dragged);
  }

  void closing_withANumberTypedAndNotEntered_keepsIt() {
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      beginTyping(*fixture.field("Q", 0), "3/7");
      QVERIFY(fixture.window.close());
    }
    QCOMPARE(leftovers().size(), 1U);
    QVERIFY(pointOf(leftovers().front().work.session, "Q").x == Rational(3, 7));
  }

  void saving_withANumberTypedAndNotEntered_savesIt() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.halfspace");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QVERIFY(fixture.window.files().saveTo(file));
    beginTyping(*fixture.field("Q", 0), "3/7");
    QVERIFY(fixture.window.files().save());
    QVERIFY(pointOf(findSession(file.toStdString())->session, "Q").x == Rational(3, 7));
  }

  void saving_withATextThatIsNoNumber_isRefusedWithTheReason() {
    const QTemporaryDir folder;
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QVERIFY(fixture.window.files().saveTo(folder.filePath("mine.halfspace")));
    beginTyping(*fixture.field("Q", 0), "three");
    const BoxAnswerer box("OK");
    QVERIFY(!fixture.window.files().save());
    QVERIFY2(box.text.contains("“three” is not a number"), qPrintable(box.text));
  }

  void closing_withATextThatIsNoNumber_asks() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    beginTyping(*fixture.field("Q", 0), "three");
    {
      const BoxAnswerer box("Cancel");
      QVERIFY(!fixture.window.close());
      QVERIFY2(box.text.contains("“three” is not a number"), qPrintable(box.text));
    }
    const BoxAnswerer box("Yes");
    QVERIFY(fixture.window.close());
  }

  void closing_whereUnsavedWorkCannotBeKept_asks() {
    blockUnsavedFolder();
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    moveUp(fixture, "Q");
    {
      const BoxAnswerer box("Cancel");
      QVERIFY(!fixture.window.close());
      QVERIFY2(box.text.contains("cannot be kept"), qPrintable(box.text));
      QVERIFY(fixture.window.isVisible());
    }
    const BoxAnswerer box("Discard");
    QVERIFY(fixture.window.close());
  }

  void closing_withNothingUnsaved_asksNothing_evenWhereNothingCanBeKept() {
    blockUnsavedFolder();
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const BoxAnswerer box("Cancel");
    QVERIFY(fixture.window.close());
    QVERIFY(box.text.isEmpty());
  }

  void aFileThatAnotherWindowSaved_isNotReplacedInSilence() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("ours.halfspace");
    WindowFixture first("signed-distance");
    QVERIFY(first.ready);
    QVERIFY(first.window.files().saveTo(file));
    WindowFixture second("signed-distance");
    QVERIFY(second.ready);
    second.window.files().open(file);
    moveUp(first, "Q");
    QVERIFY(first.window.files().save());
    moveUp(second, "E.P0");
    const std::string firstsText = findSession(file.toStdString())->text;
    {
      const BoxAnswerer box("Cancel");
      QVERIFY(!second.window.files().save());
      QVERIFY2(box.text.contains("ours.halfspace"), qPrintable(box.text));
      QCOMPARE(findSession(file.toStdString())->text, firstsText);
      QVERIFY(second.window.isWindowModified());
    }
    const BoxAnswerer box("Replace");
    QVERIFY(second.window.files().save());
    QVERIFY(findSession(file.toStdString())->session == second.model().session());
    QVERIFY(second.window.files().save()); // from now on it is known again: no further question
  }

  void endingWithoutQuestions_keepsWhatIsUnsaved_withItsFile() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.halfspace");
    Session session;
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      QVERIFY(fixture.window.files().saveTo(file));
      moveUp(fixture, "Q");
      session = fixture.model().session();
      fixture.window.endWithoutQuestions();
    }
    QCOMPARE(leftovers().size(), 1U);
    QVERIFY(leftovers().front().work.session == session);
    QCOMPARE(leftovers().front().work.file->path, file);
    QVERIFY(!(findSession(file.toStdString())->session == session));
  }

  void endingWithoutQuestions_inADragOrWithANumberNotEntered_keepsThem() {
    ExactVec3 dragged;
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      const QPoint from = *handlePosition(fixture.scene(), "Q");
      fixture.press(from);
      fixture.moveTo(from + QPoint(60, 20));
      follow(fixture, dragged);
      fixture.window.endWithoutQuestions();
    }
    QVERIFY(!(dragged == ExactVec3(11, 15, 8)));
    QVERIFY(pointOf(leftovers().front().work.session, "Q") == dragged);
    init();
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      beginTyping(*fixture.field("Q", 0), "3/7");
      fixture.window.endWithoutQuestions();
    }
    QVERIFY(pointOf(leftovers().front().work.session, "Q").x == Rational(3, 7));
  }

  void unsavedWorkThatCannotBeKept_isSaidWhileOneWorks_untilItCan() {
    blockUnsavedFolder();
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const auto warning = [&]() -> QLabel * {
      for (QLabel *label : fixture.window.findChildren<QLabel *>("complaint"))
        if (label->text().contains("cannot be kept"))
          return label;
      return nullptr;
    };
    moveUp(fixture, "Q");
    QTRY_VERIFY(warning() && warning()->isVisible());
    QVERIFY2(warning()->toolTip().contains("something else stands there"), qPrintable(warning()->toolTip()));
    QVERIFY(QFile::remove(Recovery::standardFolder()));
    moveUp(fixture, "Q");
    QTRY_VERIFY(!warning());
  }

  void closing_whereWorkCannotBeKept_savesItElsewhere() {
    blockUnsavedFolder();
    const QTemporaryDir folder;
    const QString file = folder.filePath("elsewhere.halfspace");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    moveUp(fixture, "Q");
    const BoxAnswerer box("Save");
    QTimer chooser;
    connect(&chooser, &QTimer::timeout, [&] {
      if (auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget())) {
        chooser.stop();
        dialog->findChild<QLineEdit *>()->setText(file); // selectFile does nothing once this has the focus
        QMetaObject::invokeMethod(dialog, "accept");
      }
    });
    chooser.start(50);
    QVERIFY(fixture.window.close());
    const auto saved = findSession(file.toStdString());
    QVERIFY(saved && saved->session == fixture.model().session());
  }

  void closing_whereWorkCannotBeKept_doesNotLoseOtherLessonsWithASave() {
    blockUnsavedFolder();
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    moveUp(fixture, "Q");
    fixture.model().openLesson("plane-implicit");
    const BoxAnswerer box("Cancel");
    QVERIFY(!fixture.window.close());
    QVERIFY2(box.text.contains("other lessons"), qPrintable(box.text));
  }

  void closing_afterOnlyLookingAtAnotherLesson_asksNothing() {
    blockUnsavedFolder();
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.model().openLesson("plane-implicit");
    const BoxAnswerer box("Cancel");
    QVERIFY(fixture.window.close());
    QVERIFY(box.text.isEmpty());
  }

  void savingAtTheClose_withARefusedNumber_goesOnWithoutIt() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.halfspace");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QVERIFY(fixture.window.files().saveTo(file));
    moveUp(fixture, "Q");
    beginTyping(*fixture.field("Q", 0), "three");
    const BoxAnswerer without("Yes");
    std::unique_ptr<BoxAnswerer> save;
    QTimer::singleShot(400, &fixture.window, [&] { save = std::make_unique<BoxAnswerer>("Save"); });
    QVERIFY(fixture.window.close());
    QVERIFY(findSession(file.toStdString())->session == fixture.model().session());
  }

  void aLargeNumber_typed_isComeToByFittingTheView() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    for (const char *text : {"40", "100", "20000", "1000000000", "11"}) {
      beginTyping(*fixture.field("Q", 0), text);
      QTest::keyClick(fixture.field("Q", 0), Qt::Key_Return);
      fixture.scene().viewpoint().show(NamedView::Fit);
      QVERIFY2(handlePosition(fixture.scene(), "Q"), text);
      QVERIFY2(handlePosition(fixture.scene(), "E.P0"), text);
    }
  }

  void aSceneOfVeryManyObjects_showsSoManyRowsAndNoMore() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    Session many{"many", 0, {}};
    for (int i = 0; i < 500; ++i)
      many.scene.entries.push_back({"Q" + std::to_string(i), PointObject{ExactVec3(i % 20, i / 20, 0)}});
    fixture.window.files().startWith(many);
    fixture.window.findChild<QDockWidget *>("numbersDock")->show(); // hidden, it has no rows
    const auto rows = [&] {
      return fixture.window.findChild<Inspector *>()->findChildren<NumberField *>().size() / 3;
    };
    QTRY_COMPARE(rows(), 60);
  }

  void closing_afterSaving_keepsTheChangesOfOtherLessons() {
    const QTemporaryDir folder;
    Session left;
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      moveUp(fixture, "Q");
      left = fixture.model().session();
      fixture.model().openLesson("plane-implicit");
      QVERIFY(fixture.window.files().saveTo(folder.filePath("plane.halfspace")));
      const BoxAnswerer box("Cancel");
      QVERIFY(fixture.window.close());
      QVERIFY(box.text.isEmpty());
    }
    QCOMPARE(leftovers().size(), 1U);
    QVERIFY(leftovers().front().work.left.at("signed-distance") == left);
  }

  void workThatEndedItsProgram_isOfferedInsteadOfOpened() {
    UnsavedWork work;
    {
      WindowFixture fixture("signed-distance");
      moveUp(fixture, "Q");
      work.session = fixture.model().session();
    }
    init();
    { QVERIFY(!Recovery(Recovery::standardFolder()).keep(work)); }
    {
      Recovery ended(Recovery::standardFolder());
      QVERIFY(ended.adopt(ended.leftovers().front().path)); // … and is gone before all is shown
    }
    WindowFixture fixture("plane-implicit");
    QVERIFY(fixture.ready);
    {
      const BoxAnswerer box("Cancel");
      fixture.window.leftovers().restoreNewest();
      QTRY_VERIFY(box.text.contains("ended while it was opening"));
      QCOMPARE(fixture.model().session().lesson, std::string("plane-implicit"));
      QCOMPARE(leftovers().size(), 1U);
    }
    const BoxAnswerer box("Open");
    fixture.window.leftovers().restoreNewest();
    QTRY_VERIFY(fixture.model().session() == work.session);
  }

  void workThatIsAllShown_isOpenedByItselfTheNextTime() {
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      moveUp(fixture, "Q");
      QVERIFY(fixture.window.close());
    }
    {
      WindowFixture next("plane-implicit");
      QVERIFY(next.ready);
      next.window.leftovers().restoreNewest();
      const QDir unsaved(Recovery::standardFolder());
      QCOMPARE(unsaved.entryList({"*.opening"}).size(), 1);
      QTRY_VERIFY(unsaved.entryList({"*.opening"}).isEmpty());
    }
    QCOMPARE(leftovers().size(), 1U);
    QVERIFY(!leftovers().front().endedItsProgram);
  }

  void longFraction_inItsField_isRoundedAndMarkedUntilItIsTyped() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.window.findChild<QDockWidget *>("numbersDock")->show();
    QTest::qWait(50); // its layout
    NumberField &number = *fixture.window.findChild<Inspector *>()->given().field("Q", 0);
    number.setValue(Rational(1234567890123456789, 987654321987654321));
    QVERIFY(number.text().contains('/'));
    QVERIFY2(number.shownText().startsWith("≈ 1.2"), qPrintable(number.shownText()));
    number.setValue(Rational(1, 123456789012345));
    QVERIFY2(number.shownText().endsWith("·10⁻¹⁵"), qPrintable(number.shownText()));
    QApplication::setActiveWindow(&fixture.window);
    number.setFocus();
    QTRY_COMPARE(number.shownText(), number.text());
  }

  void signal_isHeardInTheEventLoop() {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
      int heard = 0;
      const Termination termination([&](int number) { heard = number; },
                                    [](int) { QFAIL("the loop was there"); }, 60000);
      QCOMPARE(std::raise(signal), 0);
      QTRY_COMPARE(heard, signal);
    }
  }

  void signal_whileTheLoopDoesNotGoOn_isHeardInAThread_andNotTwice() {
    int heardInLoop = 0;
    int heardInThread = 0;
    QSemaphore heard;
    const Termination termination([&](int number) { heardInLoop = number; },
                                  [&](int number) {
                                    heardInThread = number;
                                    heard.release();
                                  },
                                  10);
    QCOMPARE(std::raise(SIGTERM), 0);
    QVERIFY(heard.tryAcquire(1, 60000)); // the loop does not go on before it is there
    QCOMPARE(heardInThread, SIGTERM);
    QCoreApplication::processEvents();
    QCOMPARE(heardInLoop, 0);
  }

  void endingWhileBusy_keepsWhatIsUnderTheHand_fromAnotherThread() {
    ExactVec3 dragged;
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      const QPoint from = *handlePosition(fixture.scene(), "Q");
      fixture.press(from);
      fixture.moveTo(from + QPoint(60, 20));
      dragged = fixture.value("Q");
      const std::unique_ptr<QThread> other(QThread::create([&] { fixture.window.endWhileBusy(); }));
      other->start();
      QVERIFY(other->wait());
    }
    QVERIFY(!(dragged == ExactVec3(11, 15, 8)));
    QCOMPARE(leftovers().size(), 1U);
    QVERIFY(pointOf(leftovers().front().work.session, "Q") == dragged);
  }

  void endingWhileBusy_keepsWhatIsBeingTyped_unlessItIsTakenBack() {
    for (const bool takenBack : {false, true}) {
      init();
      {
        WindowFixture fixture("signed-distance");
        QVERIFY(fixture.ready);
        NumberField &field = *fixture.field("Q", 0);
        beginTyping(field, "3/7");
        if (takenBack)
          QTest::keyClick(&field, Qt::Key_Escape);
        fixture.window.endWhileBusy();
        QVERIFY(fixture.value("Q").x == 11);
      }
      QCOMPARE(leftovers().size(), takenBack ? 0U : 1U);
      if (!takenBack)
        QVERIFY(pointOf(leftovers().front().work.session, "Q").x == Rational(3, 7));
    }
  }

  void closing_whileAMeshIsRead_endsAllThatGoesOn_andLeavesTheWorkToTheNextStart() {
    const QTemporaryDir folder;
    QFile hanging(folder.filePath("hang.stl")); // is read for ever
    QVERIFY(hanging.open(QIODevice::WriteOnly));
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    moveUp(fixture, "Q");
    auto *loader = fixture.window.findChild<MeshLoader *>();
    loader->setProgram(MESH_CHILD);
    const QSignalSpy progressed(loader, &MeshLoader::progressed);
    const QSignalSpy closed(&fixture.window, &MainWindow::closed);
    fixture.window.meshes().open(hanging.fileName());
    QTRY_VERIFY(!progressed.isEmpty());
    QTRY_VERIFY(fixture.window.findChild<QWidget *>("meshProgress")->isVisible());
    QVERIFY(fixture.window.close());
    QCOMPARE(closed.count(), 1);
    QVERIFY(!loader->isLoading());
    for (const QWidget *widget : QApplication::topLevelWidgets())
      QVERIFY2(!widget->isVisible(), qPrintable(widget->objectName()));
    QCOMPARE(leftovers().size(), 1U); // though this program still lives
  }

  void closing_whileAMeshWaits_doesNotTakeIt() {
    const QTemporaryDir folder;
    QFile file(folder.filePath("one.stl"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    const std::string stl = binaryStl(tetrahedronTriangles());
    QCOMPARE(file.write(stl.data(), static_cast<qint64>(stl.size())), static_cast<qint64>(stl.size()));
    file.close();
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    auto *loader = fixture.window.findChild<MeshLoader *>();
    loader->setProgram(MESH_CHILD);
    const QSignalSpy loaded(loader, &MeshLoader::loaded);
    fixture.press(*handlePosition(fixture.scene(), "Q")); // in whose hand nothing is put into the scene
    fixture.window.meshes().open(file.fileName());
    QTRY_COMPARE(loaded.count(), 1);
    const std::string lesson = fixture.model().session().lesson;
    QVERIFY(fixture.window.close());
    QTest::qWait(300); // longer than until it would be looked again whether the hand is free
    QCOMPARE(fixture.model().session().lesson, lesson);
  }

  void program_openedOnADamagedFile_showsItsWindow_andEndsInOrderWhenItIsTold() {
    const QTemporaryDir home;
    QFile damaged(home.filePath("damaged.halfspace"));
    QVERIFY(damaged.open(QIODevice::WriteOnly));
    damaged.write("{\"format\":");
    damaged.close();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HOME", home.path());
    environment.insert("XDG_CONFIG_HOME", home.filePath("config"));
    environment.insert("XDG_DATA_HOME", home.filePath("data"));
    QProcess program;
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::MergedChannels);
    program.start(HALFSPACE_PROGRAM, {damaged.fileName()});
    QVERIFY(program.waitForReadyRead(20000));
    QVERIFY(program.readAll().contains("damaged.halfspace"));
    // Told on standard error, it goes on and shows the same in its window: it has not ended.
    QVERIFY(!program.waitForFinished(4000));
    QCOMPARE(::kill(static_cast<pid_t>(program.processId()), SIGTERM), 0);
    QVERIFY(program.waitForFinished(20000));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.exitCode(), statusAfterSignal(SIGTERM));
  }
};

QTEST_MAIN(LeavingTest)
#include "leaving_test.moc"
