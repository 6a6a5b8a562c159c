// Animations that the window saves.
#include "app/work/animation_export.h"
#include "tests/app/window_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImageReader>
#include <QProgressDialog>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>

using namespace halfspace;

namespace {

AnimationExport &exportOf(WindowFixture &fixture) { return *fixture.window.findChild<AnimationExport *>(); }

AnimationChoices choicesOf(const char *motion, const QString &file, double seconds) {
  AnimationChoices choices;
  choices.motion = findMotionKind(motion);
  choices.format = animationFormatOf(file.toStdString());
  choices.size = {320, 200};
  choices.seconds = seconds;
  choices.framesPerSecond = 10;
  return choices;
}

QStringList filesIn(const QTemporaryDir &folder) {
  return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden);
}

QStringList textsOf(const QComboBox &box) {
  QStringList texts;
  for (int i = 0; i < box.count(); ++i)
    texts << box.itemText(i);
  return texts;
}

} // namespace

class AnimationTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void gif_savedWhileTheWindowGoesOn_hasItsPictures() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("a.gif");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    int ticks = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&] {
      ++ticks;
      fixture.scene().handles().select("Q");
      QTest::keyClick(&fixture.scene(), ticks % 2 == 0 ? Qt::Key_PageUp : Qt::Key_PageDown);
    });
    timer.start(20);
    exportOf(fixture).saveTo(file, choicesOf("turn", file, 1));
    QVERIFY(exportOf(fixture).isSaving());
    QTRY_VERIFY_WITH_TIMEOUT(!exportOf(fixture).isSaving(), 60000);
    QVERIFY(ticks > 3);
    QImageReader reader(file);
    QCOMPARE(reader.imageCount(), 10);
    QCOMPARE(reader.size(), QSize(320, 200));
    QCOMPARE(filesIn(folder), QStringList("a.gif"));
  }

  void turn_showsWhatTheWindowShows_fromItsOwnView() {
    const QTemporaryDir folder;
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    const auto firstPicture = [&](const QString &name) {
      const QString file = folder.filePath(name + "%d.png");
      exportOf(fixture).saveTo(file, choicesOf("turn", file, 0.1));
      return QTest::qWaitFor([&] { return !exportOf(fixture).isSaving(); }, 60000)
                 ? QImage(folder.filePath(name + "0.png"))
                 : QImage();
    };
    const QImage first = firstPicture("a");
    QVERIFY(!first.isNull());
    fixture.model().setStep(1);
    const QImage step = firstPicture("b");
    QVERIFY(!step.isNull() && step != first);
    fixture.scene().viewpoint().show(NamedView::Front);
    const QImage front = firstPicture("c");
    QVERIFY(!front.isNull() && front != step);
  }

  void cancelled_leavesNothing_andIsNotTold() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("a.gif");
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    exportOf(fixture).saveTo(file, choicesOf("turn", file, 600));
    QTRY_VERIFY(fixture.window.findChild<QProgressDialog *>("animationProgress")->isVisible());
    fixture.window.findChild<QProgressDialog *>("animationProgress")->findChild<QPushButton *>()->click();
    QVERIFY(!exportOf(fixture).isSaving());
    QTRY_COMPARE(filesIn(folder), QStringList());
    QVERIFY(!QApplication::activeModalWidget());
  }

  void window_thatEndsMeanwhile_leavesNothing() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("a.gif");
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      exportOf(fixture).saveTo(file, choicesOf("turn", file, 600));
      QTRY_VERIFY(!filesIn(folder).isEmpty());
    }
    QCOMPARE(filesIn(folder), QStringList());
  }

  void dialog_offersWhatTheSceneHas_andTheTimeThatItTakes() {
    const LessonLibrary library = readLessons(TEST_LESSONS_FOLDER);
    AnimationDialog dialog(nullptr);
    AnimatedScene scene;
    const auto offer = [&](const std::string &lesson) {
      scene.lesson = std::make_shared<const Lesson>(*library.find(lesson));
      scene.scene = scene.lesson->scene;
      scene.size = {320, 200};
      dialog.setScene(scene);
    };
    auto *motion = dialog.findChild<QComboBox *>("motion");
    offer("signed-distance");
    QCOMPARE(textsOf(*motion).size(), 2);
    motion->setCurrentIndex(1);
    offer("photon-torpedo");
    QCOMPARE(textsOf(*motion).size(), 3);
    QCOMPARE(motion->currentIndex(), 2); // the turn, still
    QCOMPARE(dialog.choices().motion, findMotionKind("turn"));
    QCOMPARE(dialog.choices().seconds, 8.0);
  }

  void dialog_offersAClearBackgroundOnlyWhereAFormatHasOne() {
    AnimationDialog dialog(nullptr);
    auto *format = dialog.findChild<QComboBox *>("format");
    QCOMPARE(textsOf(*format), QStringList({"GIF", "MP4", "WebM", "PNG"}));
    QVERIFY(dialog.findChild<QCheckBox *>()->isEnabled());
    format->setCurrentIndex(1);
    QVERIFY(!dialog.findChild<QCheckBox *>()->isEnabled());
  }
};

QTEST_MAIN(AnimationTest)
#include "animation_test.moc"
