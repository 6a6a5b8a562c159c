// The drawer of lessons: how it opens and closes, and what it tells of each lesson.
#include "widgets/lesson/contents_drawer.h"

#include "widgets/colors.h"

#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

using namespace halfspace;

namespace {

/// A drawer in a window with a field and a button that it does not cover.
struct ShownDrawer {
  ShownDrawer() {
    window.resize(900, 600);
    field.setGeometry(700, 20, 150, 30);
    button.setGeometry(700, 80, 150, 30);
    drawer.setLessons({{"plane", "What is a plane?", LessonState::Done},
                       {"distance", "How far is a point?", LessonState::Begun},
                       {"ray", "Where does a ray meet it?", LessonState::New}},
                      "distance");
    window.show();
    ready = QTest::qWaitForWindowActive(&window);
    field.setFocus();
  }
  QListWidget &list() { return *drawer.findChild<QListWidget *>("lessonList"); }
  QLineEdit &search() { return *drawer.findChild<QLineEdit *>("lessonSearch"); }
  /// The lines of the list that can be seen.
  QStringList rows() {
    QStringList texts;
    for (int i = 0; i < list().count(); ++i)
      if (!list().item(i)->isHidden())
        texts << list().item(i)->text();
    return texts;
  }
  QPoint middleOf(int lesson) { return list().visualItemRect(list().item(lesson)).center(); }
  QString chosenId() const { return chosen.isEmpty() ? QString() : chosen.last().first().toString(); }

  QWidget window;
  QLineEdit field{&window};
  QPushButton button{&window};
  ContentsDrawer drawer{&window};
  QSignalSpy chosen{&drawer, &ContentsDrawer::lessonChosen};
  QSignalSpy changed{&drawer, &ContentsDrawer::openChanged};
  bool ready = false;
};

} // namespace

class ContentsDrawerTest : public QObject {
  Q_OBJECT

private slots:
  void lessons_standUnderTheirChapters_withWhatTheyNeed_andTheKeysPassTheseBy() {
    ShownDrawer shown;
    QVERIFY(shown.ready);
    shown.drawer.setLessons(
        {{"plane", "What is a plane?", LessonState::Done, "Planes"},
         {"side", "On which side?", LessonState::New, "Planes", {"plane"}},
         {"ray", "Where does a ray meet it?", LessonState::New, "Rays", {"plane", "side"}}},
        "plane");
    QStringList rows;
    for (int i = 0; i < shown.list().count(); ++i)
      rows << shown.list().item(i)->text();
    QCOMPARE(rows, (QStringList{"Planes", "What is a plane?", "On which side?", "after plane", "Rays",
                                "Where does a ray meet it?", "after plane, side"}));
    shown.drawer.open();
    QTest::keyClick(&shown.search(), Qt::Key_Down);
    QTest::keyClick(&shown.search(), Qt::Key_Down);
    QCOMPARE(shown.list().currentItem()->text(), QString("Where does a ray meet it?"));
    QTest::mouseClick(shown.list().viewport(), Qt::LeftButton, {}, shown.middleOf(4));
    QVERIFY2(shown.chosen.isEmpty(), "a chapter is no lesson");
    QVERIFY(shown.drawer.isVisible());
  }

  void drawer_opens_atTheLeftEdge_asHighAsTheWindow_withTheKeys() {
    ShownDrawer shown;
    QVERIFY(shown.ready);
    QVERIFY(!shown.drawer.isVisible());
    shown.drawer.open();
    QVERIFY(shown.drawer.isVisible());
    QCOMPARE(shown.drawer.geometry().topLeft(), QPoint(0, 0));
    QCOMPARE(shown.drawer.height(), 600);
    QVERIFY(shown.drawer.width() < 700);
    QCOMPARE(shown.window.focusWidget(), &shown.search());
    QCOMPARE(shown.list().currentItem()->text(), QString("How far is a point?"));
    shown.drawer.open();
    QCOMPARE(shown.changed.count(), 1);
    shown.window.resize(300, 400);
    QCOMPARE(shown.drawer.size(), QSize(300, 400));
  }

  void drawer_closesWithEscape_andGivesTheKeysBack() {
    ShownDrawer shown;
    QVERIFY(shown.ready);
    shown.drawer.open();
    QTest::keyClick(&shown.search(), Qt::Key_Escape);
    QVERIFY(!shown.drawer.isVisible());
    QCOMPARE(shown.changed.count(), 2);
    QVERIFY(!shown.changed.last().first().toBool());
    QCOMPARE(shown.window.focusWidget(), &shown.field);
    QVERIFY(shown.chosen.isEmpty());
  }

  void drawer_closesByAPressBesideIt_whichDoesNothingElse() {
    ShownDrawer shown;
    QVERIFY(shown.ready);
    QSignalSpy clicked(&shown.button, &QPushButton::clicked);
    shown.drawer.open();
    QTest::mouseClick(&shown.drawer, Qt::LeftButton, {}, {5, 5}); // inside
    QVERIFY(shown.drawer.isVisible());
    QTest::mouseClick(&shown.button, Qt::LeftButton);
    QVERIFY(!shown.drawer.isVisible());
    QVERIFY(clicked.isEmpty());
    QTest::mouseClick(&shown.button, Qt::LeftButton);
    QCOMPARE(clicked.count(), 1);
  }

  void pressInAnotherWindow_leavesItOpen() {
    ShownDrawer shown;
    QVERIFY(shown.ready);
    QPushButton elsewhere;
    elsewhere.show();
    shown.drawer.open();
    QTest::mouseClick(&elsewhere, Qt::LeftButton);
    QVERIFY(shown.drawer.isVisible());
  }

  void lesson_isChosenByAClickAndByEnter() {
    ShownDrawer shown;
    QVERIFY(shown.ready);
    shown.drawer.open();
    QTest::mouseClick(shown.list().viewport(), Qt::LeftButton, {}, shown.middleOf(2));
    QCOMPARE(shown.chosenId(), QString("ray"));
    QVERIFY(!shown.drawer.isVisible());
    shown.drawer.open();
    shown.list().setCurrentRow(0);
    QTest::keyClick(&shown.search(), Qt::Key_Return);
    QCOMPARE(shown.chosenId(), QString("plane"));
    QVERIFY(!shown.drawer.isVisible());
    QCOMPARE(shown.chosen.count(), 2);
  }

  void whatIsTyped_isLookedForInTitlesChaptersAndIds() {
    ShownDrawer shown;
    QVERIFY(shown.ready);
    shown.drawer.setLessons({{"plane-implicit", "What is a plane?", LessonState::Done, "Planes"},
                             {"signed-distance", "How far?", LessonState::New, "Planes", {"plane-implicit"}},
                             {"ray-plane-dot", "Where does it meet?", LessonState::New, "Rays", {"other"}}},
                            "plane-implicit");
    shown.drawer.open();
    QTest::keyClicks(&shown.search(), "signed");
    QCOMPARE(shown.rows(), (QStringList{"Planes", "How far?", "after plane-implicit"}));
    shown.search().clear();
    QTest::keyClicks(&shown.search(), "MEET dot");
    QCOMPARE(shown.rows(), (QStringList{"Rays", "Where does it meet?", "after other"}));
    QTest::keyClick(&shown.search(), Qt::Key_Return);
    QCOMPARE(shown.chosenId(), QString("ray-plane-dot"));
    shown.drawer.open();
    QCOMPARE(shown.rows().size(), 7); // it begins anew
    QTest::keyClicks(&shown.search(), "nothing of the kind");
    QCOMPARE(shown.rows(), QStringList());
  }

  void stateOfALesson_isToldToWhoCannotSeeItsMark() {
    ShownDrawer shown;
    const auto told = [&](int lesson) {
      return shown.list().item(lesson)->data(Qt::AccessibleTextRole).toString();
    };
    QCOMPARE(told(0), QString("What is a plane?, done"));
    QCOMPARE(told(1), QString("How far is a point?, begun"));
    QCOMPARE(told(2), QString("Where does a ray meet it?"));
  }

  void markOfALesson_standsWhereItIsDone() {
    ShownDrawer shown;
    QVERIFY(shown.ready);
    shown.drawer.setTheme(themes().front());
    shown.drawer.open();
    const QImage image = shown.list().viewport()->grab().toImage();
    const QColor done = toQColor(themes().front().inkOf(Subject::Triangle));
    const auto isMarked = [&](int lesson) {
      const QRect row = shown.list().visualItemRect(shown.list().item(lesson));
      for (int x = row.left(); x <= row.right(); ++x)
        if (image.pixelColor(x, row.center().y() + 4).rgb() == done.rgb())
          return true;
      return false;
    };
    QVERIFY(isMarked(0));
    QVERIFY(!isMarked(1));
    QVERIFY(!isMarked(2));
  }

  void longTitles_areWrapped_notCutOff() {
    ShownDrawer shown;
    QVERIFY(shown.ready);
    shown.drawer.open();
    const int one = shown.list().visualItemRect(shown.list().item(0)).height();
    shown.drawer.setLessons({{"long", QString("so many words ").repeated(12), LessonState::New}}, {});
    QVERIFY(shown.list().visualItemRect(shown.list().item(0)).height() > 2 * one);
    QVERIFY(shown.list().visualItemRect(shown.list().item(0)).width() <= shown.list().viewport()->width());
  }
};

QTEST_MAIN(ContentsDrawerTest)
#include "contents_drawer_test.moc"
