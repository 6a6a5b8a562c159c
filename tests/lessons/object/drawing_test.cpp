#include "lessons/object/drawing.h"

#include "lessons/lesson/lesson.h"
#include "tests/lessons/scenes.h"
#include "tests/lessons/spoken_to_in.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

std::string written(const ExactVec3 &point) { return writtenCoordinates(name(letter("P"), point)); }

TEST(WrittenCoordinates, AreExact_AllFractionsOrAllDecimals) {
  EXPECT_EQ(written({11, 15, -8}), "{\\left(11,\\,15,\\,-8\\right)}");
  EXPECT_EQ(written({q(10, 3), 0, q(-1, 2)}), "{\\left(10/3,\\,0,\\,-1/2\\right)}");
  EXPECT_EQ(written({q(1, 1000), 0, q(-1, 2)}), "{\\left(0.001,\\,0,\\,-0.5\\right)}");
}

TEST(WrittenCoordinates, OfRoots_AreExact) {
  const Term point = name(letter("P"), TermValue(std::vector<Surd>{Surd(1), Surd::root(3, 2), Surd(0)}));
  EXPECT_EQ(writtenCoordinates(point), "{\\left(1,\\,2\\sqrt{3},\\,0\\right)}");
}

TEST(WrittenCoordinates, ThatAreTooLong_AreRoundedBehindASign) {
  EXPECT_EQ(written({q(1234567, 7654321), 2, q(22, 7)}), "\\approx {\\left(0.1613,\\,2,\\,3.143\\right)}");
}

TEST(WrittenCoordinates, WhereTheCommaIsADecimalMark_ArePartedBySemicolons) {
  const SpokenToIn comma(withDecimalComma());
  EXPECT_EQ(written({q(1, 1000), 2, 3}), "{\\left(0{,}001;\\,2;\\,3\\right)}");
}

TEST(PointMarks, OfFreeObjectsAndOfConstructions_HaveTheirCoordinates) {
  const Figure figure = figureOf(evaluate(distanceScene()));
  const auto coordinatesIn = [&](const std::string &id) {
    return std::get<PointMark>(*findMark(figure, id)).coordinates;
  };
  EXPECT_EQ(coordinatesIn("Q"), written({11, 15, 8}));
  EXPECT_EQ(coordinatesIn("E.P0"), written({5, 4, 7}));
  EXPECT_EQ(coordinatesIn("distance.F"), written({q(23, 3), q(25, 3), q(4, 3)}));
}

TEST(PointMarks, WithALetter_HaveCoordinates_InEveryLesson) {
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons)
    for (const Mark &mark : figureOf(evaluate(lesson.scene)).marks)
      if (const auto *point = std::get_if<PointMark>(&mark); point && !point->label.empty()) {
        EXPECT_NE(point->coordinates, "") << lesson.id << ", " << point->id;
      }
}

} // namespace
} // namespace halfspace
