// Every question of every lesson, answered wrong and right as a learner does.
#include "tests/app/window_fixture.h"
#include "widgets/lesson/lesson_page.h"

#include <QLabel>

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
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
      {"line-ray-segment", 1, "no"},
      {"dot-product-projection", 1, "positive"},
      {"determinant", 1, "larger"},
      {"determinant", 3, "right-handed"},
      {"signed-distance", 1, "farther"},
      {"point-line", 1, "2"},
      {"closest-points", 1, "nearer"},
      {"ray-plane-substitution", 1, "behind"},
      {"ray-plane-substitution", 3, "plane2"},
      {"ray-plane-dot", 1, "behind"},
      {"ray-plane-picture", 1, "with-n"},
      {"ray-plane-picture", 8, "turned"},
      {"reflection", 1, "down"},
      {"shadow", 1, "B"},
      {"camera", 1, "seen"},
      {"clipping", 1, "4"},
      {"photon-torpedo", 1, "mesh2"},
      {"ray-triangle-perp", 1, "interior"},
      {"triangle-degenerate", 1, "no"},
      {"triangle-degenerate", 2, "no"},
      {"barycentric", 1, "P2"},
      {"ray-triangle-cramer", 1, "behind"},
      {"ray-sphere", 1, "two"},
      {"ray-box-slabs", 1, "hit"},
      {"pluecker-lines", 5, "skew"},
      {"pluecker-planes", 1, "point"},
      {"ray-polygon-pluecker", 1, "same"},
      {"ray-triangle-pluecker", 1, "0"},
      {"ray-solid-pluecker", 1, "two"},
      {"ray-prism-pluecker", 1, "hit"},
      {"three-methods", 1, "clockwise"},
      {"misprints", 1, "holds"},
      {"cross-product", 1, "up"},
  };
  return all;
}

} // namespace

class QuestionsTest : public QObject {
  Q_OBJECT

private:
  std::unique_ptr<WindowFixture> m_fixture; // one for all: opening it takes most of the time

  const PredictionBox &box() { return *m_fixture->window.findChild<PredictionBox *>(); }
  void open(const QString &lesson, int step) {
    m_fixture->model().openLesson(lesson.toStdString());
    m_fixture->model().setStep(step - 1);
    QTest::qWait(1); // what stood on the page before is gone
  }

private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName("halfspace-test");
    QCoreApplication::setApplicationName("questions");
    forgetStarts();
    m_fixture = std::make_unique<WindowFixture>("plane-implicit");
    QVERIFY(m_fixture->ready);
  }
  void cleanupTestCase() { m_fixture.reset(); }

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
    open(lesson, step);
    const Prediction question = *predictionOf(m_fixture->model().step());
    QVERIFY(question.choices.size() >= 2);
    const auto isRightOne = [&](int choice) {
      return question.choices[static_cast<std::size_t>(choice)].word == right.toStdString();
    };
    std::vector<int> order(question.choices.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_partition(order.begin(), order.end(), std::not_fn(isRightOne)); // there it ends
    for (const int choice : order) {
      const bool isRight = isRightOne(choice);
      QVERIFY(m_fixture->questionIsOpen());
      QVERIFY2(m_fixture->window.findChild<QLabel *>("nearby")->text().isEmpty(),
               "it would give the answer away");
      m_fixture->answer(choice);
      const QList<ChoiceButton *> choices = box().choices();
      QCOMPARE(choices[choice]->verdict(), isRight ? Verdict::Right : Verdict::Wrong);
      const auto told = std::count_if(choices.begin(), choices.end(), [](const ChoiceButton *each) {
        return each->verdict() == Verdict::Right;
      });
      QCOMPARE(int(told), 1);
      const QString reason = box().reason()->plain();
      QVERIFY2(reason.startsWith(isRight ? "Right." : "Not quite."), qPrintable(reason));
      QVERIFY2(!m_fixture->window.findChild<QToolButton *>("again")->isVisible(), "the right one is shown");
      if (!isRight)
        emit m_fixture->window.findChild<LessonPage *>()->predictionReopened();
    }
  }
};

QTEST_MAIN(QuestionsTest)
#include "questions_test.moc"
