// The words of a lesson: steps, tasks and questions.
#include "widgets/lesson/lesson_page.h"

#include <QHelpEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolTip>
#include <QVBoxLayout>
#include <QtTest>

using namespace halfspace;

namespace {

Lesson someLesson() {
  Lesson lesson;
  lesson.title = "How far is a point from a plane?";
  LessonStep words{"The side", "", {}, {}, {}};
  LessonStep tasks{
      "The distance", "", {}, {{"Drag $Q$ to the other side.", {}}, {"Make $f(Q) = 0$.", {}}}, {}};
  LessonStep question{
      "Predict",
      "",
      {},
      {},
      Prediction{"On which side is $Q$?",
                 "side",
                 {{"positive", "The side that $\\vec n$ points to"}, {"negative", "The other side"}},
                 "The sign of $f(Q)$ tells."}};
  lesson.steps = {words, tasks, question};
  return lesson;
}

QPushButton *button(const LessonPage &panel, const QString &text) {
  for (QPushButton *found : panel.findChildren<QPushButton *>())
    if (found->text() == text)
      return found;
  return nullptr;
}

template <class Widget> QList<Widget *> shown(const LessonPage &panel) {
  QList<Widget *> found;
  for (Widget *widget : panel.findChildren<Widget *>())
    if (widget->isVisibleTo(&panel))
      found << widget;
  return found;
}

} // namespace

class LessonPageTest : public QObject {
  Q_OBJECT

private:
  Typesetter m_typesetter;

private slots:
  void stepsAreWalkedByTheButtonsAndEndAtBothEnds() {
    LessonPage panel(m_typesetter);
    panel.setLesson(someLesson());
    QSignalSpy requested(&panel, &LessonPage::stepRequested);
    QVERIFY(!button(panel, "Back")->isEnabled());
    button(panel, "Next")->click();
    QCOMPARE(requested.takeFirst().at(0).toInt(), 1);
    panel.setStep(2);
    QVERIFY(!button(panel, "Next")->isEnabled());
    button(panel, "Back")->click();
    QCOMPARE(requested.takeFirst().at(0).toInt(), 1);
    panel.setStep(99);
    QVERIFY(!button(panel, "Next")->isEnabled());
  }

  void doneTasksAreTold() {
    LessonPage panel(m_typesetter);
    panel.setLesson(someLesson());
    panel.setStep(1);
    panel.setTasksDone({false, true});
    const auto rows = shown<TaskRow>(panel);
    QCOMPARE(rows.size(), 2);
    QVERIFY(!rows[0]->isDone());
    QVERIFY(rows[1]->isDone());
    QVERIFY(rows[0]->accessibleName().contains("To do"));
    QVERIFY(rows[1]->accessibleName().contains("Done"));
  }

  void macrosOfTheLessonAreKnownInAllItsWords() {
    LessonPage panel(m_typesetter);
    Lesson lesson = someLesson();
    lesson.steps[1].tasks[0].instruction = "Make $\\it = 0$.";
    lesson.steps[2].prediction->choices[0].text = "$\\it > 0$";
    for (const std::string meaning : {"f(Q)", "g(Q)"}) { // the next lesson may mean something else
      const QString read = QString::fromStdString(meaning);
      lesson.macros = {{"it", {0, meaning}}};
      panel.setLesson(lesson);
      panel.setMarkdown("Here $\\it$ is.");
      QVERIFY(!shown<RichLabel>(panel).empty());
      QCOMPARE(shown<RichLabel>(panel).first()->accessibleName(), "Here " + read + " is.");
      panel.setStep(1);
      QCOMPARE(shown<TaskRow>(panel).first()->accessibleName(), "To do: Make " + read + " = 0.");
      panel.setStep(2);
      QCOMPARE(shown<ChoiceButton>(panel).first()->accessibleName(), read + " > 0");
    }
  }

  void choiceShowsWhyItsFormulaCannotBeRead() {
    LessonPage panel(m_typesetter);
    Lesson lesson = someLesson();
    lesson.steps[2].prediction->choices[0].text = "$\\foo$";
    panel.setLesson(lesson);
    panel.setStep(2);
    panel.resize(500, 400);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    auto *choice = shown<ChoiceButton>(panel).first();
    const QPoint place = choice->findChild<RichLabel *>()->geometry().topLeft() + QPoint(10, 8);
    QHelpEvent help(QEvent::ToolTip, place, choice->mapToGlobal(place));
    QCoreApplication::sendEvent(choice, &help);
    QCOMPARE(QToolTip::text().remove(QRegularExpression("<[^>]*>")),
             QString("Column 1: `\\foo` is unknown."));
  }

  void chosenAnswerIsToldByItsWordAndThenJudged() {
    LessonPage panel(m_typesetter);
    panel.resize(420, 500);
    panel.show();
    panel.setLesson(someLesson());
    panel.setStep(2);
    QSignalSpy chosen(&panel, &LessonPage::predictionChosen);
    QTRY_COMPARE(shown<ChoiceButton>(panel).size(), 2); // layouts show their widgets later
    const auto choices = shown<ChoiceButton>(panel);
    QTest::mouseClick(choices[1], Qt::LeftButton);
    QCOMPARE(chosen.takeFirst().at(0).toString(), QString("negative"));
    panel.setPredictionAnswer("negative", "positive");
    QCOMPARE(choices[0]->verdict(), Verdict::Right);
    QCOMPARE(choices[1]->verdict(), Verdict::Wrong);
    QTest::mouseClick(choices[0], Qt::LeftButton); // answered once
    QVERIFY(chosen.isEmpty());
    panel.setPredictionAnswer({}, "positive"); // asked again: nothing is given away
    QCOMPARE(choices[0]->verdict(), Verdict::Open);
    QVERIFY(choices[0]->isEnabled());
  }

  void reasonOfAnAnswerIsScrolledTo() {
    LessonPage panel(m_typesetter);
    panel.resize(300, 160);
    panel.show();
    panel.setLesson(someLesson());
    panel.setStep(2);
    connect(&panel, &LessonPage::predictionChosen, &panel,
            [&](const QString &word) { panel.setPredictionAnswer(word.toStdString(), "positive"); });
    QTRY_COMPARE(shown<ChoiceButton>(panel).size(), 2);
    QTest::mouseClick(shown<ChoiceButton>(panel)[1], Qt::LeftButton);
    const RichLabel *reason = panel.findChild<PredictionBox *>()->reason();
    QCOMPARE(reason->visibleRegion().boundingRect(), reason->rect());
  }

  void exercisesOfTheLastStepAreGone() {
    LessonPage panel(m_typesetter);
    panel.setLesson(someLesson());
    panel.setStep(2);
    panel.setStep(0);
    QVERIFY(shown<ChoiceButton>(panel).isEmpty());
    QVERIFY(shown<TaskRow>(panel).isEmpty());
  }

  void widePanel_hasTheTasksBesideTheWords_andANarrowOneBelow() {
    LessonPage panel(m_typesetter);
    panel.setLesson(someLesson());
    panel.setStep(1);
    panel.setMarkdown("Some words about the distance.");
    panel.resize(1200, 500);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    const auto placeOf = [&](QWidget *widget) { return widget->mapTo(&panel, QPoint(0, 0)); };
    QWidget *task = panel.findChild<TaskRow *>();
    QWidget *words = nullptr;
    for (RichLabel *label : shown<RichLabel>(panel))
      if (label->accessibleName().startsWith("Some words"))
        words = label;
    QVERIFY(words);
    QTRY_VERIFY(placeOf(task).x() > placeOf(words).x() + words->width() / 2);
    panel.resize(400, 500);
    QTRY_VERIFY(placeOf(task).y() > placeOf(words).y());
    QVERIFY(placeOf(task).x() < placeOf(words).x() + words->width() / 2);
  }

  void dotsOfTheSteps_clicked_askForTheirStep() {
    LessonPage panel(m_typesetter);
    panel.setLesson(someLesson());
    panel.resize(420, 400);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    QSignalSpy requested(&panel, &LessonPage::stepRequested);
    auto *dots = panel.findChild<StepDots *>();
    QTest::mouseClick(dots, Qt::LeftButton, {}, {dots->width() - 2, dots->height() / 2});
    QCOMPARE(requested.takeFirst().at(0).toInt(), 2);
  }

  void answeredQuestion_handsTheFocusToTheWayOn_andThatToNoOther() {
    QWidget window;
    auto *panel = new LessonPage(m_typesetter);
    auto *number = new QLineEdit; // the next key there would change the scene
    auto *layout = new QVBoxLayout(&window);
    layout->addWidget(panel);
    layout->addWidget(number);
    window.resize(420, 600);
    window.show();
    Lesson lesson = someLesson();
    std::swap(lesson.steps[1], lesson.steps[2]);
    panel->setLesson(lesson);
    panel->setStep(1);
    QTRY_COMPARE(shown<ChoiceButton>(*panel).size(), 2);
    QTest::mouseClick(shown<ChoiceButton>(*panel)[0], Qt::LeftButton);
    QCOMPARE(window.focusWidget(), button(*panel, "Next"));
    panel->setStep(2); // the last: its way on is disabled
    QVERIFY(window.focusWidget() != number);
  }

  void lessonWithoutSteps_showsNoWayAnywhere() {
    LessonPage panel(m_typesetter);
    panel.setLesson(someLesson());
    panel.setLesson({});
    QVERIFY(!button(panel, "Back")->isEnabled() && !button(panel, "Next")->isEnabled());
    QVERIFY(shown<TaskRow>(panel).isEmpty());
    panel.setTasksDone({true});
    panel.setPredictionAnswer("negative", "positive");
  }

  void newValuesKeepThePlaceThatWasScrolledTo() {
    LessonPage panel(m_typesetter);
    panel.resize(300, 200);
    panel.show();
    panel.setLesson(someLesson());
    const QString words = QString("Some words with $Q = %1$ in them, and again. ").repeated(30);
    panel.setMarkdown(QString(words).replace("%1", "1"));
    QScrollBar *bar = panel.findChild<QScrollArea *>()->verticalScrollBar();
    QTRY_VERIFY(bar->maximum() > 100); // layouts take their time
    bar->setValue(90);
    panel.setMarkdown(QString(words).replace("%1", "2"));
    QTest::qWait(200);
    QCOMPARE(bar->value(), 90);
  }
};

QTEST_MAIN(LessonPageTest)
#include "lesson_page_test.moc"
