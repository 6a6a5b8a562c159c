// The page of a step: its blocks in their order, the way on, and what it asks.
#include "widgets/lesson/lesson_page.h"

#include "tests/widgets/working/working_block_fixture.h"
#include "widgets/lesson/note_fold.h"
#include "widgets/lesson/step_dots.h"
#include "widgets/working/working_practice.h"

#include <QHelpEvent>
#include <QImage>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>

#include <algorithm>
#include <cstdlib>

using namespace halfspace;

namespace {

Prediction someQuestion() {
  return {"On which side is $Q$?",
          "side",
          {{"positive", "The side that $\\vec n$ points to"}, {"negative", "The other side"}},
          "The sign of $f(Q)$ tells."};
}

Lesson lessonOf(std::vector<LessonStep> steps) {
  Lesson lesson;
  lesson.title = "How far is a point from a plane?";
  lesson.steps = std::move(steps);
  return lesson;
}

/// Words, tasks, and a question.
Lesson someLesson() {
  return lessonOf(
      {{"The side", {StepWords{"About $Q$."}, StepLines()}},
       {"The distance", {StepLines(), Task{"Drag $Q$ to the other side.", {}}, Task{"Make $f(Q) = 0$.", {}}}},
       {"Predict", {someQuestion(), StepLines()}}});
}

/// A page as high as it must be to be scrolled.
constexpr QSize smallPage(300, 240);

/// A shown page of a lesson.
class ShownPage {
public:
  explicit ShownPage(const Lesson &lesson = someLesson(), int step = 0, QSize size = {420, 700}) {
    page.resize(size);
    setLesson(lesson, step);
    page.show();
    ready = QTest::qWaitForWindowExposed(&page);
    fill();
  }

  void setLesson(const Lesson &lesson, int step = 0) {
    m_lesson = lesson;
    page.setLesson(lesson);
    setStep(step);
  }
  void setStep(int step) { page.showStep(stepOf(m_lesson, step), step, {}); }

  /// Words with a value in place of each live one.
  void fill(const LiveValue &value = {}) {
    page.showWords([value](const std::string &) { return value; });
    QCoreApplication::processEvents(); // new blocks are shown by their layout
  }
  void setWorking(const Working &working, const std::vector<std::size_t> &linesIn) {
    practice.setWorking(working, linesIn, false);
    QCoreApplication::processEvents(); // the layout
  }
  [[nodiscard]] QPushButton *button(const QString &text) const {
    for (QPushButton *found : page.findChildren<QPushButton *>())
      if (found->text() == text)
        return found;
    return nullptr;
  }
  [[nodiscard]] QPushButton *next() const { return page.findChild<QPushButton *>("next"); }
  template <class Widget> [[nodiscard]] QList<Widget *> shown() const {
    QList<Widget *> found;
    for (Widget *widget : page.findChildren<Widget *>())
      if (widget->isVisibleTo(&page))
        found << widget;
    return found;
  }
  /// The label of these words.
  [[nodiscard]] RichLabel *words(const QString &beginning) const {
    for (RichLabel *label : shown<RichLabel>())
      if (label->plain().startsWith(beginning))
        return label;
    return nullptr;
  }
  [[nodiscard]] int topOf(const QWidget *widget) const { return widget->mapTo(&page, QPoint(0, 0)).y(); }

private:
  Typesetter m_typesetter;
  Lesson m_lesson;

public:
  WorkingPractice &practice = *new WorkingPractice(m_typesetter); // becomes the page's own
  LessonPage page{m_typesetter, practice};
  bool ready = false;
};

} // namespace

class LessonPageTest : public QObject {
  Q_OBJECT

private slots:
  void steps_areWalkedByTheButtons_andEndAtBothEnds() {
    ShownPage shown;
    QSignalSpy requested(&shown.page, &LessonPage::stepRequested);
    QVERIFY(!shown.button("Back")->isEnabled());
    shown.button("Next")->click();
    QCOMPARE(requested.takeFirst().at(0).toInt(), 1);
    shown.setStep(2);
    QVERIFY(!shown.next()->isEnabled());
    shown.button("Back")->click();
    QCOMPARE(requested.takeFirst().at(0).toInt(), 1);
  }

  void lastStep_leadsToTheNextLesson_whereThereIsOne() {
    ShownPage shown(someLesson(), 1);
    QSignalSpy next(&shown.page, &LessonPage::nextLessonRequested);
    QSignalSpy step(&shown.page, &LessonPage::stepRequested);
    shown.page.setNextLesson("Where does a ray meet a plane?");
    QCOMPARE(shown.next()->text(), QString("Next"));
    shown.setStep(2);
    QCOMPARE(shown.next()->text(), QString("Next lesson"));
    QCOMPARE(shown.next()->toolTip(), QString("Where does a ray meet a plane?"));
    shown.next()->click();
    QCOMPARE(next.count(), 1);
    QVERIFY(step.isEmpty());
    shown.page.setNextLesson({});
    QVERIFY(!shown.next()->isEnabled());
    QCOMPARE(shown.next()->text(), QString("Next"));
    QCOMPARE(shown.next()->toolTip(), QString());
  }

  void blocks_standInTheOrderOfTheLesson() {
    const Lesson lesson = lessonOf({{"All",
                                     {Task{"A task.", {}}, StepLines(), StepWords{"Some words."},
                                      someQuestion(), StepLines(), StepNote{"A note", {"More words."}}}}});
    ShownPage shown(lesson);
    shown.page.setAnswer(GivenAnswer{"positive", "positive"});
    shown.setWorking(test::tracedWorking(), {1, 2});
    const auto blocks = shown.shown<WorkingBlock>();
    QCOMPARE(blocks.size(), 2);
    QVERIFY(blocks[0]->spoken().startsWith("u"));
    QVERIFY(blocks[1]->spoken().startsWith("a"));
    const std::vector<QWidget *> expected{
        shown.shown<TaskRow>().first(),       blocks[0], shown.words("Some words"),
        shown.shown<PredictionBox>().first(), blocks[1], shown.shown<NoteFold>().first()};
    int bottom = 0;
    for (const QWidget *block : expected) {
      QVERIFY2(shown.topOf(block) >= bottom, block->metaObject()->className());
      bottom = shown.topOf(block) + block->height();
    }
  }

  void note_isFoldedAway_andOpenedByAClick() {
    ShownPage shown(lessonOf({{"All", {StepLines(), StepNote{"For readers", {"More words."}}}}}));
    NoteFold *note = shown.shown<NoteFold>().first();
    QVERIFY(!note->isOpen());
    QVERIFY(!shown.words("More words"));
    QToolButton *title = note->findChild<QToolButton *>();
    QCOMPARE(title->text(), QString("For readers"));
    QTest::mouseClick(title, Qt::LeftButton);
    QVERIFY(shown.words("More words"));
    QTest::keyClick(title, Qt::Key_Space);
    QVERIFY(!shown.words("More words"));
  }

  void wordsThatNobodySees_askForNoValues() {
    ShownPage shown(lessonOf({{"All", {StepWords{"Here {a}."}, StepNote{"For readers", {"Folded {b}."}}}}}));
    QStringList asked;
    const auto value = [&asked](const std::string &name) {
      asked << QString::fromStdString(name);
      return LiveValue(name);
    };
    shown.page.showWords(value);
    QCOMPARE(asked, QStringList("a"));
    shown.shown<NoteFold>().first()->findChild<QToolButton *>()->click();
    QVERIFY(shown.words("Folded b."));
    StepBlocks *all = shown.shown<StepBlocks>().first();
    all->hide();
    asked.clear();
    shown.page.showWords(value);
    QCOMPARE(asked, QStringList());
    all->show();
    QCOMPARE(asked, (QStringList{"a", "b"}));
  }

  void picturesOfAStep_shareTheRoomOfItsPage_inHoweverManyPieces() {
    const QTemporaryDir folder;
    QImage(4096, 4096, QImage::Format_Mono).save(folder.filePath("large.png"));
    const StepWords four{"![a](large.png) ![b](large.png) ![c](large.png) ![d](large.png)"};
    Lesson lesson =
        lessonOf({{"One", {four, StepNote{"A note", four}, StepLines(), four, four}}, {"Two", {four}}});
    lesson.file = folder.filePath("lesson.md").toStdString();
    ShownPage shown(lesson);
    auto *note = shown.shown<NoteFold>().first();
    note->findChild<QToolButton *>()->click(); // nothing is set in type while it is folded
    const auto told = [&] {
      QStringList names;
      for (const auto *label : shown.page.findChildren<RichLabel *>())
        if (label->plain().startsWith('a'))
          names << label->plain();
      return names;
    };
    QCOMPARE(told().size(), 4);
    QCOMPARE(told().filter("no room for it").size(), 3);
    QCOMPARE(told().first(), QString("a b c d"));
    shown.setStep(1);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the step before is gone
    shown.fill();
    QCOMPARE(told().filter("a b c d").size(), 1);
  }

  void note_opened_isScrolledTo_andBreaksNoLineAnew() {
    const std::string many =
        "Some words and some more of them, so that there are several lines of these words.";
    ShownPage shown(lessonOf({{"All", {StepWords{many}, StepNote{"A note", {many + "\n\n" + many}}}}}), 0,
                    smallPage);
    NoteFold *note = shown.shown<NoteFold>().first();
    const auto *words = shown.words("Some words");
    const int width = words->width();
    note->findChild<QToolButton *>()->click();
    QCoreApplication::processEvents();
    QVERIFY(shown.page.findChild<QScrollArea *>()->verticalScrollBar()->maximum() > 0);
    QCOMPARE(words->width(), width);
    const int top = shown.topOf(note);
    QVERIFY2(top >= 0 && top < smallPage.height() / 2, qPrintable(QString::number(top)));
  }

  void noteWithALongTitle_showsAllOfIt_onSeveralLines() {
    const std::string title =
        "A slip in the lecture notes about the coordinates of lines, as a title that is too long";
    ShownPage shown(lessonOf({{"All", {StepNote{title, {"Words."}}}}}), 0, smallPage);
    const auto *button = shown.shown<NoteFold>().first()->findChild<QToolButton *>();
    QVERIFY(button->text().contains('\n'));
    QCOMPARE(button->text().replace('\n', ' ').toStdString(), title);
    QVERIFY(button->width() >= button->sizeHint().width() && button->height() >= button->sizeHint().height());
  }

  void doneTasks_areTold() {
    ShownPage shown(someLesson(), 1);
    shown.page.setTaskStates({TaskState::Open, TaskState::Done});
    const auto rows = shown.shown<TaskRow>();
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0]->state(), TaskState::Open);
    QCOMPARE(rows[1]->state(), TaskState::Done);
    shown.page.setTaskStates({TaskState::Done}); // of the second nothing is known
    QCOMPARE(rows[0]->state(), TaskState::Done);
    QCOMPARE(rows[1]->state(), TaskState::Open);
  }

  void whatATaskAsks_isAnsweredOnceItIsDone() {
    ShownPage shown(lessonOf({{"Do", {Task{"Turn it. What is it?", {}, {}, "It is {t}."}, StepLines()}}}));
    shown.fill("3");
    const auto isAnswered = [&] { return shown.words("It is 3."); };
    for (const TaskState state : {TaskState::Open, TaskState::HoldsAlready, TaskState::Waiting}) {
      shown.page.setTaskStates({state});
      QVERIFY(!isAnswered());
    }
    shown.page.setTaskStates({TaskState::Done});
    QVERIFY(isAnswered());
    QCOMPARE(shown.shown<TaskRow>().first()->spokenDescription(), QString("It is 3."));
    shown.page.setTaskStates({}); // a question is open
    QVERIFY(!isAnswered());
  }

  void liveValues_ofTasks_followTheScene() {
    ShownPage shown(lessonOf({{"Do", {Task{"Make it 3. Now it is {t}.", {}}, StepLines()}}}));
    for (const char *now : {"30", "3"}) {
      shown.fill(now);
      QCOMPARE(shown.shown<TaskRow>().first()->spokenName(),
               QString("To do: Make it 3. Now it is %1.").arg(now));
    }
  }

  void macros_ofTheLesson_areKnownInAllItsWords() {
    Lesson lesson = someLesson();
    lesson.steps[0].blocks[0] = StepWords{"Here $\\it$ is."};
    lesson.steps[1].blocks[1] = Task{"Make $\\it = 0$.", {}};
    Prediction question = someQuestion();
    question.choices[0].text = "$\\it > 0$";
    lesson.steps[2].blocks[0] = question;
    ShownPage shown;
    for (const std::string meaning : {"f(Q)", "g(Q)"}) { // the next lesson may mean something else
      const QString read = QString::fromStdString(meaning);
      lesson.macros = {{"it", {0, meaning}}};
      shown.setLesson(lesson);
      shown.fill();
      QVERIFY(shown.words("Here " + read + " is."));
      shown.setStep(1);
      shown.fill();
      QCOMPARE(shown.shown<TaskRow>().first()->spokenName(), "To do: Make " + read + " = 0.");
      shown.setStep(2);
      shown.fill();
      QCOMPARE(shown.shown<ChoiceButton>().first()->accessibleName(), read + " > 0");
    }
  }

  void choice_showsWhyItsFormulaCannotBeRead() {
    Prediction question = someQuestion();
    question.choices[0].text = "$\\foo$";
    ShownPage shown(lessonOf({{"Predict", {question, StepLines()}}}));
    auto *choice = shown.shown<ChoiceButton>().first();
    const QPoint place = choice->findChild<RichLabel *>()->geometry().topLeft() + QPoint(10, 8);
    QHelpEvent help(QEvent::ToolTip, place, choice->mapToGlobal(place));
    QCoreApplication::sendEvent(choice, &help);
    QCOMPARE(QToolTip::text().remove(QRegularExpression("<[^>]*>")),
             QString("Column 1: `\\foo` is unknown."));
  }

  void chosenAnswer_isToldByItsWord_andThenJudged() {
    ShownPage shown(someLesson(), 2);
    QSignalSpy chosen(&shown.page, &LessonPage::predictionChosen);
    const auto choices = shown.shown<ChoiceButton>();
    QCOMPARE(choices.size(), 2);
    QTest::mouseClick(choices[1], Qt::LeftButton);
    QCOMPARE(chosen.takeFirst().at(0).toString(), QString("negative"));
    shown.page.setAnswer(GivenAnswer{"negative", "positive"});
    QCOMPARE(choices[0]->verdict(), Verdict::Right);
    QCOMPARE(choices[1]->verdict(), Verdict::Wrong);
    QTest::mouseClick(choices[0], Qt::LeftButton); // answered once
    QVERIFY(chosen.isEmpty());
    shown.page.setAnswer({}); // asked again: nothing is given away
    QCOMPARE(choices[0]->verdict(), Verdict::Open);
    QVERIFY(choices[0]->isEnabled());
  }

  void whatStandsBehindAnOpenQuestion_isSeenOnceItIsAnswered() {
    ShownPage shown(lessonOf({{"All",
                               {StepWords{"Some words."}, StepLines(), someQuestion(), StepLines(),
                                StepWords{"The answer."}, Task{"A task.", {}}}}}));
    shown.setWorking(test::tracedWorking(), {1, 2});
    const auto isBehindSeen = [&] {
      return shown.words("The answer") && shown.shown<TaskRow>().size() == 1 &&
             shown.shown<WorkingBlock>().size() == 2;
    };
    QVERIFY(shown.words("Some words") && shown.shown<WorkingBlock>().size() == 1);
    QVERIFY(!shown.words("The answer") && shown.shown<TaskRow>().isEmpty());
    shown.page.setAnswer(GivenAnswer{"negative", "positive"});
    QVERIFY(isBehindSeen());
    shown.page.setAnswer({});
    QVERIFY(!isBehindSeen());
  }

  void answeredQuestion_ofAnotherScene_canBeTriedAgain() {
    ShownPage shown(someLesson(), 2);
    QSignalSpy reopened(&shown.page, &LessonPage::predictionReopened);
    QToolButton *again = shown.page.findChild<QToolButton *>("again");
    QVERIFY(!again->isVisible());
    shown.page.setAnswer(GivenAnswer{"negative", "positive", false});
    QVERIFY(again->isVisible());
    QTest::mouseClick(again, Qt::LeftButton);
    QCOMPARE(reopened.count(), 1);
    shown.page.setAnswer({});
    QVERIFY(!again->isVisible());
  }

  void reasonOfAnAnswer_isScrolledTo() {
    ShownPage shown(someLesson(), 2, smallPage);
    connect(&shown.page, &LessonPage::predictionChosen, &shown.page, [&](const QString &word) {
      shown.page.setAnswer(GivenAnswer{word.toStdString(), "positive"});
    });
    QTest::mouseClick(shown.shown<ChoiceButton>()[1], Qt::LeftButton);
    const RichLabel *reason = shown.page.findChild<PredictionBox *>()->reason();
    QCOMPARE(reason->visibleRegion().boundingRect(), reason->rect());
  }

  void lineThatTheKeysReach_isScrolledTo() {
    const std::string longWords = QString("So many words. ").repeated(60).toStdString();
    ShownPage shown(
        lessonOf({{"All", {StepWords{longWords}, StepLines(), StepWords{longWords}, StepLines()}}}), 0,
        smallPage);
    shown.setWorking(test::tracedWorking(), {1, 2});
    const auto blocks = shown.shown<WorkingBlock>();
    const auto isInView = [](const WorkingBlock &block, std::size_t line) {
      return block.visibleRegion().contains(block.placed().lines[line].box.center().toPoint());
    };
    QVERIFY(!isInView(*blocks[0], 0));
    QTest::keyClick(blocks[0], Qt::Key_Down);
    QVERIFY(isInView(*blocks[0], 0));
    QVERIFY(!isInView(*blocks[1], 0));
    QTest::keyClick(blocks[0], Qt::Key_Down);
    QVERIFY(isInView(*blocks[1], 0));
    QTest::keyClick(blocks[1], Qt::Key_Up);
    QVERIFY(isInView(*blocks[0], 0));
  }

  void anotherStep_isSeenFromItsTop_withoutTheExercisesOfTheLast() {
    Lesson lesson = someLesson();
    for (LessonStep &step : lesson.steps) {
      step.blocks.emplace_back(StepWords{QString("Words. ").repeated(200).toStdString()});
      std::rotate(step.blocks.begin(), step.blocks.end() - 1, step.blocks.end());
    }
    ShownPage shown(lesson, 2, smallPage);
    QScrollBar *bar = shown.page.findChild<QScrollArea *>()->verticalScrollBar();
    QTRY_VERIFY(bar->maximum() > 100); // layouts take their time
    bar->setValue(90);
    shown.setStep(0);
    QCOMPARE(bar->value(), 0);
    QVERIFY(shown.shown<ChoiceButton>().isEmpty());
    QVERIFY(shown.shown<TaskRow>().isEmpty());
    QCOMPARE(shown.practice.working().blocks().size(), std::size_t(1));
  }

  void dotsOfTheSteps_clicked_askForTheirStep() {
    ShownPage shown;
    QSignalSpy requested(&shown.page, &LessonPage::stepRequested);
    auto *dots = shown.page.findChild<StepDots *>();
    QTest::mouseClick(dots, Qt::LeftButton, {}, {dots->width() - 2, dots->height() / 2});
    QCOMPARE(requested.takeFirst().at(0).toInt(), 2);
  }

  void answeredQuestion_handsTheFocusToTheWayOn_orToNobody_data() {
    QTest::addColumn<bool>("isLast");
    QTest::newRow("a step follows") << false;
    QTest::newRow("the last step of all") << true;
  }
  void answeredQuestion_handsTheFocusToTheWayOn_orToNobody() {
    QFETCH(bool, isLast);
    QWidget window;
    ShownPage shown(someLesson(), 2);
    shown.page.setNextLesson(isLast ? "" : "Another");
    auto *number = new QLineEdit; // the next key there would change the scene
    auto *layout = new QVBoxLayout(&window);
    layout->addWidget(&shown.page);
    layout->addWidget(number);
    window.show();
    connect(&shown.page, &LessonPage::predictionChosen, &shown.page, [&](const QString &word) {
      shown.page.setAnswer(GivenAnswer{word.toStdString(), "positive"});
    });
    ChoiceButton *choice = shown.shown<ChoiceButton>().last();
    choice->setFocus();
    QTest::mouseClick(choice, Qt::LeftButton);
    if (isLast)
      QVERIFY(window.focusWidget() != number);
    else
      QCOMPARE(window.focusWidget(), shown.next());
    shown.page.setNextLesson({}); // its way on is disabled
    shown.setStep(1);
    shown.setStep(2);
    QVERIFY(window.focusWidget() != number);
    shown.page.setParent(nullptr);
  }

  void lessonWithoutSteps_showsAllLines_andNoWayAnywhere() {
    ShownPage shown;
    shown.setLesson({});
    QVERIFY(!shown.button("Back")->isEnabled() && !shown.next()->isEnabled());
    QVERIFY(shown.shown<TaskRow>().isEmpty());
    shown.page.setTaskStates({TaskState::Done});
    shown.page.setAnswer(GivenAnswer{"negative", "positive"});
    shown.setWorking(test::tracedWorking(), {3});
    QCOMPARE(shown.practice.working().blocks().size(), std::size_t(1));
    QCOMPARE(shown.practice.working().blocks()[0]->placed().lines.size(), std::size_t(3));
  }

  void newValues_keepThePlaceThatWasScrolledTo() {
    const QString words = QString("Some words with $Q$ = {t} in them, and again. ").repeated(30);
    ShownPage shown(lessonOf({{"All", {StepWords{words.toStdString()}, StepLines()}}}), 0, smallPage);
    shown.fill(LiveNumber{number(1)});
    QScrollBar *bar = shown.page.findChild<QScrollArea *>()->verticalScrollBar();
    QTRY_VERIFY(bar->maximum() > 100); // layouts take their time
    bar->setValue(90);
    shown.fill(LiveNumber{number(2)});
    QTest::qWait(200);
    QCOMPARE(bar->value(), 90);
  }

  void heldPage_becomesHigherButNeverLessHigh_untilItIsLetGo() {
    ShownPage shown(lessonOf({{"All", {StepWords{"Words: {t}."}, StepLines()}}}));
    const auto lines = [&] { return shown.topOf(shown.practice.working().blocks().front()); };
    const auto fill = [&](int words) {
      shown.fill(QString("so many words ").repeated(words).toStdString());
      QCoreApplication::processEvents();
    };
    shown.setWorking(test::tracedWorking(), {3});
    fill(20);
    const int usual = lines();
    shown.page.setHeld(true);
    fill(1);
    QCOMPARE(lines(), usual);
    fill(40);
    const int grown = lines();
    QVERIFY(grown > usual);
    fill(1);
    QCOMPARE(lines(), grown);
    const int high = shown.practice.working().blocks().front()->height();
    shown.setWorking({{test::tracedWorking().lines[0]}}, {1});
    shown.setWorking(test::tracedWorking(), {3});
    QCOMPARE(shown.practice.working().blocks().front()->height(), high);
    shown.page.setHeld(false);
    QTRY_VERIFY(lines() < usual);
  }

  void costs_ofAStep_areMeasuredOneAtATime() {
    ShownPage shown(lessonOf({{"Costs", {StepCost{"one"}, StepCost{"other"}}}}));
    shown.page.flight().showAims([](const std::string &) { return Aim{{{6, 7, 14}, {2, 1, -2}}, {}}; });
    const auto plots = shown.shown<CostPlot>();
    QCOMPARE(plots.size(), 2);
    for (CostPlot *plot : plots)
      plot->findChild<QPushButton *>("measure")->click();
    QVERIFY(!plots[0]->isMeasuring());
    QVERIFY(plots[1]->isMeasuring());
  }

  void pageThatIsVeryWide_hasLinesThatCanStillBeFollowed() {
    ShownPage shown(someLesson(), 0, {1800, 600});
    const RichLabel *words = shown.words("About");
    const int letter = shown.page.fontMetrics().averageCharWidth();
    QVERIFY(words->width() < 90 * letter);
    QVERIFY(std::abs(words->mapTo(&shown.page, words->rect().center()).x() - 900) < 20); // in the middle
  }

  void taskThatIsDueNext_comesIntoView_butNotOnArrival() {
    std::string many;
    for (int i = 0; i < 60; ++i)
      many += "Many words stand between the two of them. ";
    const StepWords words{many};
    Lesson lesson = lessonOf({{"Tasks", {StepLines(), Task{"First.", {}}, words, Task{"Second.", {}}}}});
    ShownPage shown(lesson, 0, smallPage);
    QVERIFY(shown.ready);
    QScrollBar &bar = *shown.page.findChild<QScrollArea *>()->verticalScrollBar();
    QTRY_VERIFY(bar.maximum() > 0);
    const TaskRow &second = *shown.shown<TaskRow>().at(1);
    const auto isInView = [&] {
      const int top = shown.topOf(&second);
      return top >= 0 && top + second.height() <= shown.page.findChild<QScrollArea *>()->height();
    };
    shown.page.setTaskStates({TaskState::Open, TaskState::Waiting});
    QCOMPARE(bar.value(), 0);
    QVERIFY(!isInView());
    shown.page.setTaskStates({TaskState::Done, TaskState::Open});
    QVERIFY(isInView());
    bar.setValue(0);
    shown.page.setTaskStates({TaskState::Done, TaskState::Open}); // nothing new
    QCOMPARE(bar.value(), 0);
  }

  void buttonsOfTheFoot_areWholeBesideManySteps() {
    Lesson lesson = lessonOf(std::vector<LessonStep>(12, {"Step", {StepLines()}}));
    ShownPage shown(lesson, 11, {460, 600});
    shown.page.setNextLesson("What does a dot product tell?");
    for (const double scale : {1.0, 1.5}) {
      Theme theme = themes().front();
      theme.textScale = scale;
      QFont type = shown.page.font();
      type.setPointSizeF(10 * scale);
      shown.page.setFont(type);
      shown.page.setTheme(theme);
      QCoreApplication::processEvents();
      QVERIFY(shown.next()->width() >= shown.next()->sizeHint().width());
      QVERIFY(!shown.next()->geometry().intersects(shown.page.findChild<StepDots *>()->geometry()));
    }
  }

  void answerOfTheLastTask_comesIntoView() {
    std::string many;
    for (int i = 0; i < 60; ++i)
      many += "Many words stand above it. ";
    ShownPage shown(lessonOf({{"Tasks", {StepLines(), StepWords{many}, Task{"What?", {}, {}, "This."}}}}), 0,
                    smallPage);
    QVERIFY(shown.ready);
    shown.fill();
    const QScrollBar &bar = *shown.page.findChild<QScrollArea *>()->verticalScrollBar();
    QTRY_VERIFY(bar.maximum() > 0);
    shown.page.setTaskStates({TaskState::Open});
    QCOMPARE(bar.value(), 0);
    shown.page.setTaskStates({TaskState::Done});
    const TaskRow &task = *shown.shown<TaskRow>().first();
    QVERIFY(shown.topOf(&task) + task.height() <= shown.page.findChild<QScrollArea *>()->height());
  }
};

QTEST_MAIN(LessonPageTest)
#include "lesson_page_test.moc"
