// A task beside its mark, and the marks of verdicts.
#include "widgets/lesson/task_row.h"

#include "tests/widgets/text/as_written.h"
#include "widgets/colors.h"
#include "widgets/verdict.h"

#include <QLineEdit>
#include <QPainter>
#include <QPixmap>
#include <QSignalSpy>
#include <QToolButton>
#include <QVBoxLayout>
#include <QtTest>

using namespace halfspace;
using test::asWritten;

namespace {

const Theme &theme() { return themes().front(); }
QColor rightInk() { return toQColor(theme().inkOf(Subject::Triangle)); }

Lazy<FilledMarkdown> later(const char *markdown) {
  return Lazy<FilledMarkdown>([markdown] { return asWritten(markdown); });
}

/// Those that are seen.
QStringList hintsIn(const TaskRow &row) {
  QStringList hints;
  for (const RichLabel *label : row.findChild<HintColumn *>()->findChildren<RichLabel *>())
    if (label->isVisibleTo(&row))
      hints << label->plain();
  return hints;
}

QImage painted(Verdict verdict) {
  QImage image(40, 40, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  paintVerdict(painter, {20, 20}, 15, verdict, theme());
  return image;
}

int pixelsOf(const QImage &image, const QColor &ink) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      count += image.pixelColor(x, y).rgb() == ink.rgb();
  return count;
}

} // namespace

class TaskRowTest : public QObject {
  Q_OBJECT

private:
  Typesetter m_typesetter;

private slots:
  void verdicts_paintedAlike_haveFilledCirclesOfTheirOwnInk() {
    const double disc = 15 * 15 * 3.14;
    QVERIFY(pixelsOf(painted(Verdict::Right), rightInk()) > disc / 2);
    QVERIFY(pixelsOf(painted(Verdict::Wrong), toQColor(theme().warning)) > disc / 2);
    QCOMPARE(painted(Verdict::Open).pixelColor(20, 20), QColor(Qt::white));
    QVERIFY(painted(Verdict::Open).pixelColor(5, 20) != QColor(Qt::white)); // its circle
  }

  void verdicts_seenWithoutColours_differInShape() {
    const auto middle = [](Verdict verdict) { return painted(verdict).pixelColor(20, 20); };
    QCOMPARE(middle(Verdict::Wrong), toQColor(theme().panel)); // where the cross crosses itself
    QVERIFY(middle(Verdict::Right) != toQColor(theme().panel));
  }

  void row_ofATaskThatIsDone_paintsTheMarkAndSaysSo() {
    TaskRow row(m_typesetter);
    row.setWords(asWritten("Make $f(Q) = 0$."), later(""), later(""));
    row.resize(300, 40);
    QCOMPARE(row.spokenName(), QString("To do: Make f(Q) = 0."));
    QCOMPARE(pixelsOf(row.grab().toImage(), rightInk()), 0);
    row.setState(TaskState::Done);
    QCOMPARE(row.spokenName(), QString("Done: Make f(Q) = 0."));
    QVERIFY(pixelsOf(row.grab().toImage(), rightInk()) > 40);
    row.setState(TaskState::Open); // the scene was moved on
    QCOMPARE(pixelsOf(row.grab().toImage(), rightInk()), 0);
  }

  void row_ofATaskThatHoldsAlready_saysSoInALineOfItsOwn() {
    TaskRow row(m_typesetter);
    row.setWords(asWritten("Make $f(Q) = 0$."), later(""), later(""));
    const int alone = row.heightForWidth(400);
    row.setState(TaskState::HoldsAlready);
    QVERIFY(row.heightForWidth(400) >= alone + row.fontMetrics().height());
    QVERIFY(row.spokenDescription().contains("already"));
    QCOMPARE(row.spokenName(), QString("To do: Make f(Q) = 0."));
    row.setState(TaskState::Done);
    QCOMPARE(row.heightForWidth(400), alone);
    QCOMPARE(row.spokenDescription(), QString());
  }

  void row_ofATaskThatIsDone_tellsTheAnswerInALineOfItsOwn() {
    TaskRow row(m_typesetter);
    row.setWords(asWritten("Make $f(Q) = 0$. Where is $Q$?"), later(""), later("In the plane."));
    const int alone = row.heightForWidth(400);
    QCOMPARE(row.spokenDescription(), QString());
    row.setState(TaskState::Done);
    QVERIFY(row.heightForWidth(400) >= alone + row.fontMetrics().height());
    QCOMPARE(row.spokenDescription(), QString("In the plane."));
    row.setState(TaskState::Open);
    QCOMPARE(row.heightForWidth(400), alone);
  }

  void row_tellsHowFarTheLearnerIs_untilItIsDone() {
    TaskRow row(m_typesetter);
    row.setWords(asWritten("Make it 3."), later("Now it is 2."), later(""));
    QCOMPARE(row.spokenDescription(), QString("Now it is 2."));
    const int withNow = row.heightForWidth(400);
    row.setState(TaskState::Done);
    QCOMPARE(row.spokenDescription(), QString());
    QVERIFY(row.heightForWidth(400) < withNow);
  }

  void hints_areToldOneByOne_whileTheTaskIsDue() {
    TaskRow row(m_typesetter);
    row.setWords(asWritten("Make $f(Q) = 0$."), later(""), later("There."));
    row.setHints({later("Look at $n$."), later("Drag $Q$ along it.")});
    row.show();
    auto *button = row.findChild<QToolButton *>("hint");
    QVERIFY(button->isVisible());
    QSignalSpy told(&row, &TaskRow::hintTold);
    QCOMPARE(hintsIn(row), QStringList());
    button->click();
    QCOMPARE(hintsIn(row), QStringList{"Look at n."});
    row.setHints({later("Look at $n$."), later("Drag $Q$ up.")}); // its live values may have changed
    button->click();
    QCOMPARE(hintsIn(row), (QStringList{"Look at n.", "Drag Q up."}));
    QCOMPARE(told.size(), 2);
    QVERIFY(!button->isVisible());
    row.setState(TaskState::Done);
    QCOMPARE(hintsIn(row), QStringList());
  }

  void lastHint_keepsTheKeysAwayFromWhatFollows_andIsSpoken() {
    QWidget window;
    auto *row = new TaskRow(m_typesetter);
    auto *number = new QLineEdit; // the next key there would change the scene
    auto *layout = new QVBoxLayout(&window);
    layout->addWidget(row);
    layout->addWidget(number);
    row->setWords(asWritten("Make it 3."), later(""), later(""));
    row->setHints({later("Drag $Q$ up.")});
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    auto *button = row->findChild<QToolButton *>("hint");
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Space);
    QVERIFY(!button->isVisible());
    auto *hints = row->findChild<HintColumn *>();
    QCOMPARE(window.focusWidget(), static_cast<QWidget *>(hints));
    QCOMPARE(hints->accessibleDescription(), QString("Drag Q up."));
  }

  void row_withoutHints_offersNone() {
    TaskRow row(m_typesetter);
    row.setWords(asWritten("Make $f(Q) = 0$."), later(""), later(""));
    row.setHints({});
    row.show();
    QVERIFY(!row.findChild<QToolButton *>("hint")->isVisible());
  }

  void row_ofATaskThatWaits_isPalerAndSaysWhy() {
    TaskRow row(m_typesetter);
    row.setWords(asWritten("Make $f(Q) = 0$."), later(""), later(""));
    row.resize(300, 40);
    const QColor ink = toQColor(theme().ink);
    const int before = pixelsOf(row.grab().toImage(), ink);
    QVERIFY(before > 0);
    row.setState(TaskState::Waiting);
    QVERIFY(pixelsOf(row.grab().toImage(), ink) < before);
    QVERIFY(!row.toolTip().isEmpty());
    row.setState(TaskState::Open);
    QCOMPARE(pixelsOf(row.grab().toImage(), ink), before);
    QVERIFY(row.toolTip().isEmpty());
  }

  void mark_besideAnyType_leavesTheWordsTheirRoom() {
    TaskRow row(m_typesetter);
    row.setWords(asWritten("Drag Q."), later(""), later(""));
    for (const double textScale : {1.0, 2.0}) {
      Theme large = theme();
      large.textScale = textScale;
      row.setTheme(large);
      row.resize(400, 60);
      row.setState(TaskState::Done);
      row.grab(); // lays it out
      const QImage image = row.grab().toImage();
      const auto *words = row.findChild<RichLabel *>();
      const QImage mark = image.copy(0, 0, words->x(), image.height());
      QVERIFY(pixelsOf(mark, rightInk()) > 40 * textScale * textScale);
      QCOMPARE(pixelsOf(image, rightInk()), pixelsOf(mark, rightInk()));
    }
  }
};

QTEST_MAIN(TaskRowTest)
#include "task_row_test.moc"
