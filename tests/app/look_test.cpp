// Size, motion and menus of the window, and that figures look as it does.
#include "app/figures/figure_maker.h"
#include "app/menus/help_dialog.h"
#include "app/panels/panel_style.h"
#include "tests/app/window_fixture.h"
#include "tests/likeness.h"
#include "widgets/lesson/lesson_page.h"
#include "widgets/picture/labels/label_requests.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <QAction>
#include <QApplication>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QScreen>
#include <QScrollArea>
#include <QSignalSpy>
#include <QStyleOption>

using namespace halfspace;

namespace {

QAction &action(MainWindow &window, const char *name) { return *window.findChild<QAction *>(name); }

/// Whether a press so far below a handle grabs it.
bool grabsBelow(WindowFixture &fixture, const std::string &handle, int pixels) {
  fixture.scene().handles().select({});
  fixture.press(*handlePosition(fixture.scene(), handle) + QPoint(0, pixels));
  fixture.release();
  return fixture.scene().handles().selection().selectedId() == handle;
}

/// Waits until nothing is drawn any more.
void waitForRest(QSignalSpy &drawn) {
  int before = -1;
  while (before != drawn.count()) {
    before = drawn.count();
    QTest::qWait(400);
  }
}

/// A figure of as many pixels as the scene has on the screen, with type of the same size.
FigureChoices asOnTheScreen(WindowFixture &fixture) {
  FigureChoices choices;
  choices.size = fixture.scene().screen().size();
  choices.theme = fixture.window.look().theme();
  // As if a pixel were a point.
  constexpr double pixelsPerInch = 72;
  choices.paper = PaperSize{static_cast<double>(choices.size.width),
                            fixture.scene().screen().designRatio() * markTextSize * choices.theme.textScale,
                            pixelsPerInch};
  return choices;
}

} // namespace

class LookTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName("halfspace-test");
    QCoreApplication::setApplicationName("look");
  }
  void init() { forgetStarts(); }

  void size_changed_scalesTextLabelsAndHandlesAtOnce() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.window.look().setSizeScale(1);
    const double points = QApplication::font().pointSizeF();
    const double ratio = fixture.scene().screen().designRatio();
    QVERIFY(!grabsBelow(fixture, "Q", 32));
    for (int i = 0; i < 4; ++i)
      action(fixture.window, "larger").trigger();
    QCOMPARE(fixture.window.look().sizeScale(), 2.0);
    QCOMPARE(QApplication::font().pointSizeF(), 2 * points);
    QCOMPARE(fixture.scene().screen().designRatio(), 2 * ratio);
    QVERIFY(grabsBelow(fixture, "Q", 32));
  }

  void size_keepsItsBounds_togetherWithAThemeOfLargeType() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.window.look().setSizeScale(1);
    QVERIFY(!action(fixture.window, "smaller").isEnabled());
    const double points = QApplication::font().pointSizeF();
    for (const char *theme : {"light", "projector"}) {
      fixture.window.look().setThemeNamed(theme);
      for (int i = 0; i < 20; ++i)
        action(fixture.window, "larger").trigger();
      QVERIFY(!action(fixture.window, "larger").isEnabled());
      QCOMPARE(QApplication::font().pointSizeF(), 2.5 * points);
    }
    action(fixture.window, "usualSize").trigger();
    QCOMPARE(fixture.window.look().sizeScale(), usualSizeScale(*fixture.window.screen()));
  }

  void size_hasTheUsualKeys() {
    WindowFixture fixture("signed-distance");
    QVERIFY(action(fixture.window, "larger").shortcuts().contains(QKeySequence("Ctrl++")));
    QCOMPARE(action(fixture.window, "smaller").shortcut(), QKeySequence("Ctrl+-"));
    QCOMPARE(action(fixture.window, "usualSize").shortcut(), QKeySequence("Ctrl+0"));
  }

  void sizeAndMotion_areKeptForTheNextWindow() {
    {
      WindowFixture fixture("signed-distance");
      QVERIFY(fixture.ready);
      fixture.window.look().setSizeScale(1.75);
      action(fixture.window, "motion").setChecked(false);
      fixture.window.close();
    }
    WindowFixture next("signed-distance");
    QCOMPARE(next.window.look().sizeScale(), 1.75);
    QVERIFY(!action(next.window, "motion").isChecked());
  }

  void step_withMotion_fadesItsMarksIn_andThenRests() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QSignalSpy drawn(&fixture.scene().drawing(), &SceneDrawing::frameDrawn);
    fixture.model().setStep(3); // so that its labels are there the next time
    waitForRest(drawn);
    const auto framesOfStep = [&](bool motion) {
      fixture.scene().setMotion(false);
      fixture.model().setStep(1);
      waitForRest(drawn);
      fixture.scene().setMotion(motion);
      waitForRest(drawn);
      drawn.clear();
      fixture.model().setStep(3);
      waitForRest(drawn); // ends only when nothing is drawn any more
      return drawn.count();
    };
    const int still = framesOfStep(false);
    const int moving = framesOfStep(true);
    QVERIFY2(moving >= still + 3, qPrintable(QString("%1 and %2 frames").arg(still).arg(moving)));
  }

  void grabbing_duringAFade_endsIt() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    QSignalSpy drawn(&fixture.scene().drawing(), &SceneDrawing::frameDrawn);
    fixture.model().setStep(3);
    waitForRest(drawn);
    fixture.model().setStep(1);
    waitForRest(drawn);
    fixture.scene().setMotion(true);
    waitForRest(drawn);
    fixture.model().setStep(3);
    QTRY_VERIFY(drawn.count() > 0);
    fixture.press(*handlePosition(fixture.scene(), "Q"));
    QTest::qWait(20);
    drawn.clear();
    QTest::qWait(MarkFade::fadeTime);
    QVERIFY2(drawn.count() <= 2, "only what rests is drawn once more");
    fixture.release();
  }

  void viewOfThePlane_isOfferedOnlyWhereThereIsOne() {
    WindowFixture fixture("dot-product-projection");
    QVERIFY(fixture.ready);
    QTRY_VERIFY(!action(fixture.window, "facePlane").isEnabled());
    for (const char *lesson : {"signed-distance", "triangle-degenerate"}) {
      fixture.model().openLesson(lesson);
      QTRY_COMPARE(action(fixture.window, "facePlane").isEnabled(), lesson == std::string("signed-distance"));
    }
  }

  void pageAlone_andBack_leavesTheWidthAsItWas() {
    WindowFixture fixture("three-methods");
    QVERIFY(fixture.ready);
    fixture.model().setStep(5);
    const auto &page = *fixture.window.findChild<LessonPage *>();
    for (const char *size : {"usualSize", "larger"}) {
      action(fixture.window, size).trigger();
      QTest::qWait(50);
      const int width = page.width();
      fixture.action(Qt::Key_F8)->trigger();
      QTRY_VERIFY(page.width() > width);
      QTest::qWait(50);
      fixture.action(Qt::Key_F8)->trigger();
      QTRY_COMPARE(page.width(), width);
    }
  }

  void viewAlongARayOrLine_isOfferedOnlyWhereThereIsOne() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    for (const char *way : {"downCourse", "againstCourse"}) {
      QTRY_VERIFY(!action(fixture.window, way).isEnabled());
      for (const char *lesson : {"ray-plane-dot", "pluecker-lines"}) {
        fixture.model().openLesson(lesson);
        QTRY_VERIFY(action(fixture.window, way).isEnabled());
      }
      fixture.model().openLesson("plane-implicit");
      QTRY_VERIFY(!action(fixture.window, way).isEnabled());
    }
  }

  void figureOfPixels_asLargeAsTheScreen_showsTheSame() {
    const Typesetter typesetter;
    FigureMaker maker(typesetter);
    for (const char *lesson : {"signed-distance", "ray-triangle-perp", "ray-sphere"}) {
      LessonLibrary library = readLessons(TEST_LESSONS_FOLDER);
      Session session = startOf(*library.find(lesson));
      session.step = 2; // from the beginning: labels stay where they stood in a step before
      WindowFixture fixture(std::move(session), std::move(library));
      QVERIFY(fixture.ready);
      QSignalSpy drawn(&fixture.scene().drawing(), &SceneDrawing::frameDrawn);
      waitForRest(drawn);
      FigureSubject subject;
      subject.content = fixture.scene().drawn().pictureContent();
      subject.content.knobs = fixture.scene().handles().knobs(); // these are on the screen alone
      subject.camera = fixture.scene().viewpoint().camera();
      const auto figure = maker.picture(subject, asOnTheScreen(fixture));
      QVERIFY(figure);
      const RgbaImage screen = fromImage(fixture.scene().grabFramebuffer());
      QCOMPARE(screen.width, figure->width);
      QCOMPARE(screen.height, figure->height);
      // But for labels: on the screen they make room for what lies over a corner of the picture.
      const test::Patch patch = test::largestDifference(screen, *figure, {test::Compared::Hues, 1, 20});
      QVERIFY2(patch.area < 20, qPrintable(QString(lesson) + ": " + patch.text().c_str()));
    }
  }

  void checkBox_inEveryTheme_standsOutFromThePanel() {
    for (const Theme &theme : themes()) {
      WindowFixture fixture("plane-implicit");
      fixture.window.look().setThemeNamed(QString::fromStdString(theme.name));
      const QColor panel = QApplication::palette().color(QPalette::Window);
      QImage image(16, 16, QImage::Format_RGB32);
      image.fill(panel);
      QPainter painter(&image);
      QStyleOptionButton box;
      box.rect = image.rect();
      box.palette = QApplication::palette();
      box.state = QStyle::State_Enabled;
      PanelStyle(1).drawPrimitive(QStyle::PE_IndicatorCheckBox, &box, &painter, nullptr);
      painter.end();
      int contrast = 0;
      for (int x = 0; x < image.width(); ++x)
        contrast = std::max(contrast, std::abs(qGray(image.pixel(x, 8)) - qGray(panel.rgb())));
      QVERIFY2(contrast > 100, theme.name.c_str());
    }
  }

  void help_fitsTheScreenAtEverySize_andNothingIsCutOff() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    for (const double scale : {1.0, 1.25, 2.5}) {
      fixture.window.look().setSizeScale(scale);
      HelpDialog help(&fixture.window);
      help.show();
      QVERIFY(QTest::qWaitForWindowExposed(&help));
      const QSize room = fixture.window.screen()->availableSize();
      QVERIFY(help.width() <= room.width() && help.height() <= room.height());
      const auto &scroll = *help.findChild<QScrollArea *>();
      QVERIFY2(scroll.widget()->width() <= scroll.viewport()->width(), "nothing to the right");
      for (const QLabel *label : help.findChildren<QLabel *>())
        QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
    }
  }

  void entriesOfMenus_atEverySize_areNotElided() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.model().setStep(3);
    for (const double scale : {1.0, 1.25, 1.5}) {
      fixture.window.look().setSizeScale(scale);
      for (const char *fading : {"All lines", "Gaps", "Last blank", "All blank"}) {
        fixture.chooseFading(fading);
        QCoreApplication::processEvents();
        for (const QToolButton *button : fixture.window.findChildren<QToolButton *>())
          if (button->isVisible())
            QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
      }
      for (QMenu *menu : fixture.window.findChildren<QMenu *>()) {
        menu->popup({});
        for (QAction *entry : menu->actions()) {
          const QString text =
              entry->text().remove('&') + entry->shortcut().toString(QKeySequence::NativeText);
          const int needed = menu->fontMetrics().horizontalAdvance(text);
          QVERIFY2(!entry->isVisible() || menu->actionGeometry(entry).width() > needed, qPrintable(text));
        }
        QVERIFY(menu->width() <= fixture.window.screen()->availableSize().width());
        menu->hide();
      }
    }
  }
};

QTEST_MAIN(LookTest)
#include "look_test.moc"
