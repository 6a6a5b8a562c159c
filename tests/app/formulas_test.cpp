// The formulas of each chapter, from a key, and from there to a lesson.
#include "tests/app/window_fixture.h"
#include "widgets/lesson/formula_dialog.h"
#include "widgets/text/rich_label.h"

#include <QListWidget>
#include <QScrollArea>
#include <QScrollBar>

namespace halfspace {
namespace {

FormulaDialog *dialogOf(WindowFixture &fixture) { return fixture.window.findChild<FormulaDialog *>(); }

QListWidget &chaptersOf(WindowFixture &fixture) {
  return *dialogOf(fixture)->findChild<QListWidget *>("chapters");
}

QStringList lessonsOn(const FormulaDialog &dialog) {
  QStringList lessons;
  for (const QToolButton *lesson : dialog.findChildren<QToolButton *>("formulaLesson"))
    lessons << lesson->text();
  return lessons;
}

} // namespace

class FormulasTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void key_opensThem_atTheChapterOfTheLesson() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.action(QKeySequence("Ctrl+Shift+G"))->trigger();
    QVERIFY(dialogOf(fixture)->isVisible());
    QCOMPARE(chaptersOf(fixture).currentItem()->text(), QString("Distances"));
    QVERIFY(lessonsOn(*dialogOf(fixture)).contains("How far is a point from a plane?"));
    const auto words = dialogOf(fixture)->findChildren<RichLabel *>();
    QVERIFY(!words.isEmpty());
    for (const RichLabel *label : words)
      QVERIFY(!label->plain().isEmpty());
  }

  void lesson_clicked_isOpened_andThePageStaysAsItWas() {
    WindowFixture fixture("signed-distance");
    QVERIFY(fixture.ready);
    fixture.action(QKeySequence("Ctrl+Shift+G"))->trigger();
    chaptersOf(fixture).setCurrentRow(0);
    const QString chapter = chaptersOf(fixture).currentItem()->text();
    QScrollBar *bar = dialogOf(fixture)->findChild<QScrollArea *>()->verticalScrollBar();
    QTRY_VERIFY(bar->maximum() > 20); // layouts take their time
    bar->setValue(20);
    dialogOf(fixture)->findChild<QToolButton *>("formulaLesson")->click();
    QCOMPARE(fixture.model().session().lesson, fixture.model().library().lessons.front().id);
    QCOMPARE(chaptersOf(fixture).currentItem()->text(), chapter);
    QCOMPARE(bar->value(), 20);
  }
};

} // namespace halfspace

QTEST_MAIN(halfspace::FormulasTest)
#include "formulas_test.moc"
