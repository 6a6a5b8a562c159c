// Which marks fade in, and what ends that.
#include "widgets/view/mark_fade.h"

#include <QSignalSpy>
#include <QTest>

using namespace halfspace;

namespace {

Figure figureOf(const std::set<std::string> &ids) {
  Figure figure;
  for (const std::string &id : ids) {
    PointMark point;
    point.id = id;
    figure.add(point);
  }
  return figure;
}

Session stepOf(const char *lesson, int step) { return {lesson, step, {}}; }

} // namespace

class MarkFadeTest : public QObject {
  Q_OBJECT

private slots:
  void otherStep_makesItsNewMarksArrive_once() {
    MarkFade fade;
    fade.show(stepOf("a", 0), figureOf({"P", "Q"}), true);
    QVERIFY(fade.arrival().marks.empty());
    QSignalSpy changed(&fade, &MarkFade::changed);
    fade.show(stepOf("a", 1), figureOf({"Q", "R"}), true);
    QVERIFY(fade.arrival().marks == std::set<std::string>{"R"});
    QVERIFY(fade.arrival().presence < 1);
    QTRY_VERIFY(fade.arrival().marks.empty());
    QVERIFY(changed.count() > 1);
    changed.clear();
    QTest::qWait(60);
    QCOMPARE(changed.count(), 0);
  }

  void edit_duringAFade_endsIt() {
    MarkFade fade;
    fade.show(stepOf("a", 0), figureOf({"P"}), true);
    fade.show(stepOf("a", 1), figureOf({"P", "R"}), true);
    QVERIFY(!fade.arrival().marks.empty());
    fade.show(stepOf("a", 1), figureOf({"P", "R"}), true);
    QVERIFY(fade.arrival().marks.empty());
    QSignalSpy changed(&fade, &MarkFade::changed);
    QTest::qWait(60);
    QCOMPARE(changed.count(), 0);
  }

  void otherLesson_orNoMotion_showsAllAtOnce() {
    MarkFade fade;
    fade.show(stepOf("a", 0), figureOf({"P"}), true);
    fade.show(stepOf("b", 1), figureOf({"P", "R"}), true);
    QVERIFY(fade.arrival().marks.empty());
    fade.show(stepOf("b", 2), figureOf({"P", "R", "S"}), false);
    QVERIFY(fade.arrival().marks.empty());
  }
};

QTEST_GUILESS_MAIN(MarkFadeTest)
#include "mark_fade_test.moc"
