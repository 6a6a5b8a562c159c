// The lessons that come with the program, checked as their readers will meet them.
#include "lessons/lesson/condition.h"
#include "lessons/scene/session.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace halfspace {
namespace {

const LessonLibrary &library() {
  static const LessonLibrary lessons = readLessons(LESSON_FOLDER);
  return lessons;
}

/// A scene in which a lesson's task is done; every task of the lessons has one here.
struct Solution {
  const char *lesson;
  const char *instruction; ///< its beginning
  Entry entry;
};

const std::vector<Solution> &solutions() {
  static const std::vector<Solution> all{
      {"plane-implicit", "Turn n until", {"E", PlaneObject{{5, 4, 7}, {0, 0, 2}}}},
      {"plane-implicit", "Slide the plane", {"E", PlaneObject{{2, -2, 1}, {1, 2, 2}}}},
      {"plane-implicit", "Bring the origin", {"E", PlaneObject{{5, 4, 7}, {-1, -2, -2}}}},
      {"signed-distance", "Drag Q through", {"Q", PointObject{{1, 1, 1}}}},
      {"signed-distance", "Let Q come", {"Q", PointObject{{3, 4, 8}}}},
      {"signed-distance", "Bring Q to", {"Q", PointObject{{10, 8, 8}}}},
      {"signed-distance", "Move Q so", {"Q", PointObject{{12, 10, 2}}}},
      {"ray-plane-dot", "Make t positive", {"L", RayObject{{11, 15, 8}, {1, -3, -2}}}},
      {"ray-plane-dot", "Make t exactly", {"L", RayObject{{11, 15, 8}, {-10, -10, 0}}}},
      {"ray-plane-dot", "Make t change", {"L", RayObject{{11, 15, 8}, {-1, 3, 2}}}},
      {"ray-plane-dot", "Make the ray parallel", {"L", RayObject{{11, 15, 8}, {-2, -1, 2}}}},
      {"ray-plane-dot", "Now put the whole", {"L", RayObject{{5, 4, 7}, {-2, -1, 2}}}},
      {"ray-triangle-perp", "Drag the start", {"L", RayObject{{11, 13, 10}, {-4, -5, 3}}}},
      {"ray-triangle-perp", "Hit an edge", {"L", RayObject{{5, 9, 9}, {0, 0, -7}}}},
      {"ray-triangle-perp", "Hit a corner", {"L", RayObject{{11, 13, 10}, {-2, -4, -10}}}},
      {"ray-triangle-perp", "Put all three", {"T", TriangleObject{{9, 9, 0}, {1, 9, 4}, {5, 9, 2}}}},
      {"ray-triangle-perp", "Bring the triangle", {"T", TriangleObject{{9, 9, 0}, {1, 9, 4}, {5, 2, 9}}}},
      {"plane-plane", "Turn one of", {"F", PlaneObject{{2, 6, 1}, {-1, -2, -2}}}},
      {"plane-plane", "Now move that", {"F", PlaneObject{{4, 2, 3}, {2, 4, 4}}}},
      {"plane-plane", "Make the two", {"F", PlaneObject{{2, 6, 0}, {0, 1, -1}}}},
      {"point-line", "Move Q so", {"Q", PointObject{{3, -1, 3}}}},
      {"point-line", "Bring the foot", {"Q", PointObject{{0, 0, 0}}}},
      {"point-line", "Put Q on", {"Q", PointObject{{4, 3, 2}}}},
      {"point-line", "Take Q away", {"Q", PointObject{{5, 1, 4}}}},
  };
  return all;
}

const Solution *solutionOf(const Lesson &lesson, const Task &task) {
  for (const Solution &solution : solutions())
    if (lesson.id == solution.lesson && task.instruction.starts_with(solution.instruction))
      return &solution;
  return nullptr;
}

TEST(Content, EveryFile_IsALessonOfItsNameInItsPlace) {
  for (const Problem &problem : library().problems)
    ADD_FAILURE() << problem.text();
  std::set<std::string> files;
  for (const auto &file : std::filesystem::directory_iterator(LESSON_FOLDER))
    files.insert(file.path().stem());
  std::set<std::string> ids;
  for (const Lesson &lesson : library().lessons)
    ids.insert(lesson.id);
  EXPECT_EQ(ids, files);
  EXPECT_EQ(library().lessons.front().id, "plane-implicit");
  EXPECT_TRUE(std::is_sorted(library().lessons.begin(), library().lessons.end(),
                             [](const Lesson &a, const Lesson &b) { return a.order < b.order; }));
}

TEST(Content, TheStartOfTheTriangleLesson_HitsInsideWithShortFractions) {
  const Evaluation outcome = evaluate(library().find("ray-triangle-perp")->scene);
  EXPECT_EQ(std::get<std::string>(*findValue(outcome, "case")), "hit");
  EXPECT_EQ(std::get<Surd>(*findValue(outcome, "s")), Surd(Rational(1, 4)));
  EXPECT_EQ(std::get<Surd>(*findValue(outcome, "t_triangle")), Surd(Rational(1, 2)));
  EXPECT_EQ(std::get<Surd>(*findValue(outcome, "t")), Surd(Rational(3, 2)));
  EXPECT_EQ(std::get<std::string>(*findValue(outcome, "location")), "interior");
}

TEST(Content, EveryLineThatAStepNames_IsWorkedAtTheStart) {
  for (const Lesson &lesson : library().lessons) {
    const Working working = test::ownLines(lesson.scene);
    for (const LessonStep &step : lesson.steps)
      for (const StepBlock &block : step.blocks) {
        const auto *lines = std::get_if<StepLines>(&block);
        for (const std::string &id : lines ? lines->ids : std::vector<std::string>())
          EXPECT_TRUE(findLine(working, id)) << lesson.id << ", " << step.title << ": " << id;
      }
  }
}

TEST(Content, EveryLiveValue_HasAValueAtTheStart) {
  for (const Lesson &lesson : library().lessons)
    for (const LessonWords &words : wordsOf(lesson)) {
      const std::string filled = withLiveValues(words.text, lesson.scene, evaluate(lesson.scene));
      EXPECT_EQ(filled.find("—"), std::string::npos) << lesson.id << ":\n" << filled;
    }
}

TEST(Content, EveryQuestion_HasExactlyOneRightChoiceAtTheStart) {
  for (const Lesson &lesson : library().lessons) {
    int questions = 0;
    for (const LessonStep &step : lesson.steps)
      if (const Prediction *prediction = predictionOf(step)) {
        ++questions;
        const Evaluation outcome = evaluate(lesson.scene);
        EXPECT_EQ(std::count_if(
                      prediction->choices.begin(), prediction->choices.end(),
                      [&](const Prediction::Choice &choice) {
                        return holds({prediction->value, Condition::Relation::Equal, choice.word}, outcome);
                      }),
                  1)
            << lesson.id << ", " << step.title;
      }
    EXPECT_EQ(questions, 1) << lesson.id;
  }
}

TEST(Content, EveryTask_CanBeDone) {
  for (const Lesson &lesson : library().lessons) {
    int tasks = 0;
    for (const LessonStep &step : lesson.steps)
      for (const Task &task : tasksOf(step)) {
        ++tasks;
        const Solution *solution = solutionOf(lesson, task);
        ASSERT_NE(solution, nullptr) << lesson.id << ": " << task.instruction;
        const Scene scene = test::edited(
            lesson.scene, {ChangeObject{solution->entry.name, std::get<Object>(solution->entry.content)}});
        EXPECT_TRUE(isDone(task, evaluate(scene))) << lesson.id << ": " << task.instruction;
      }
    EXPECT_GE(tasks, 2) << lesson.id;
  }
}

} // namespace
} // namespace halfspace
