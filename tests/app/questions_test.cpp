// Every question of every lesson, answered wrong and right as a learner does.
#include "tests/app/window_fixture.h"
#include "widgets/lesson/lesson_page.h"

#include <QLabel>

#include <set>

using namespace halfspace;

namespace {

/// A question and the word of the choice that is right at the start.
struct RightAnswer {
  const char *lesson;
  int step;
  const char *right;
};

const std::vector<RightAnswer> &questions() {
  static const std::vector<RightAnswer> all{
      {"plane-implicit", 1, "on"},
      {"plane-parametric", 1, "s"},
      {"half-spaces", 1, "2"},
      {"plane-plane", 1, "line"},
      {"dot-product-projection", 1, "positive"},
      {"signed-distance", 1, "positive"},
      {"point-line", 1, "2"},
      {"ray-plane-substitution", 1, "behind"},
      {"ray-plane-substitution", 3, "plane2"},
      {"ray-plane-dot", 1, "behind"},
      {"ray-triangle-perp", 1, "interior"},
      {"barycentric", 1, "P2"},
      {"ray-triangle-cramer", 1, "interior"},
      {"ray-sphere", 1, "two"},
      {"pluecker-lines", 5, "skew"},
      {"ray-polygon-pluecker", 1, "same"},
      {"ray-triangle-pluecker", 1, "same"},
      {"three-methods", 1, "interior"},
      {"misprints", 1, "holds"},
  };
  return all;
}

} // namespace

class QuestionsTest : public QObject {
  Q_OBJECT

private:
  static QList<ChoiceButton *> choicesOf(WindowFixture &fixture) {
    return fixture.window.findChild<PredictionBox *>()->choices();
  }
  static QString reasonIn(WindowFixture &fixture) {
    return fixture.window.findChild<PredictionBox *>()->reason()->accessibleName();
  }

private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName("halfspace-test");
    QCoreApplication::setApplicationName("questions");
  }
  void init() { forgetStarts(); }

  void everyQuestion_hasARowHere() {
    std::set<std::pair<std::string, int>> rows;
    for (const RightAnswer &answer : questions())
      rows.emplace(answer.lesson, answer.step);
    std::set<std::pair<std::string, int>> inLessons;
    for (const Lesson &lesson : readLessons(TEST_LESSONS_FOLDER).lessons)
      for (std::size_t step = 0; step < lesson.steps.size(); ++step)
        if (predictionOf(lesson.steps[step]))
          inLessons.emplace(lesson.id, static_cast<int>(step) + 1);
    QCOMPARE(rows, inLessons);
  }

  void question_answeredWrong_andThenRight_isJudged_data() {
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<int>("step");
    QTest::addColumn<QString>("right");
    for (const RightAnswer &answer : questions())
      QTest::addRow("%s %d", answer.lesson, answer.step) << answer.lesson << answer.step << answer.right;
  }
  void question_answeredWrong_andThenRight_isJudged() {
    QFETCH(QString, lesson);
    QFETCH(int, step);
    QFETCH(QString, right);
    WindowFixture fixture(lesson.toStdString());
    QVERIFY(fixture.ready);
    fixture.model().setStep(step - 1);
    const Prediction question = *predictionOf(fixture.model().step());
    QVERIFY(question.choices.size() >= 2);
    for (int choice = static_cast<int>(question.choices.size()) - 1; choice >= 0; --choice) {
      const bool isRight = question.choices[static_cast<std::size_t>(choice)].word == right.toStdString();
      QVERIFY(fixture.questionIsOpen());
      QVERIFY2(fixture.window.findChild<QLabel *>("nearby")->text().isEmpty(),
               "it would give the answer away");
      fixture.answer(choice);
      QCOMPARE(choicesOf(fixture)[choice]->verdict(), isRight ? Verdict::Right : Verdict::Wrong);
      QCOMPARE(std::count_if(choicesOf(fixture).begin(), choicesOf(fixture).end(),
                             [](const ChoiceButton *each) { return each->verdict() == Verdict::Right; }),
               1);
      QVERIFY2(reasonIn(fixture).startsWith(isRight ? "Right." : "Not quite."),
               qPrintable(reasonIn(fixture)));
      QTest::mouseClick(fixture.window.findChild<QToolButton *>("again"), Qt::LeftButton);
    }
  }
};

QTEST_MAIN(QuestionsTest)
#include "questions_test.moc"
