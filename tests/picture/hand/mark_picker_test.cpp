#include "widgets/picture/hand/mark_picker.h"

#include "tests/picture/marks.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

constexpr PixelSize size{1280, 800};

/// A point at the end of a segment, before a triangle in a plane, looked at from +x.
struct MarkPicker : testing::Test {
  Camera camera;
  Figure figure{{withId(patchAt({0, 0, 0}, {1, 0, 0}), "E"),
                 withId(polygonOf({{0, -4, -3}, {0, 4, -3}, {0, 0, 3}}), "T"),
                 withId(segmentBetween({0, 0, 0}, {0, 2, 0}), "s"), withId(pointAt({0, 2, 0}), "Q")}};

  [[nodiscard]] std::string at(Place place, glm::dvec2 offset = {}) const {
    return markUnder(glm::dvec2(*camera.project(place, size)) + offset, figure, camera, size, 1);
  }
};

TEST_F(MarkPicker, OnAPointFindsIt) { EXPECT_EQ(at({0, 2, 0}), "Q"); }

TEST_F(MarkPicker, NearAPointItComesBeforeTheSegment) { EXPECT_EQ(at({0, 2, 0}, {-7, 0}), "Q"); }

TEST_F(MarkPicker, AlongASegmentFindsItBeforeTheFaces) { EXPECT_EQ(at({0, 0.8, 0}, {0, 5}), "s"); }

TEST_F(MarkPicker, InATriangleFindsItBeforeItsPlane) { EXPECT_EQ(at({0, 0, -2}), "T"); }

TEST_F(MarkPicker, BesideTheTriangleFindsThePlane) { EXPECT_EQ(at({0, 5, 4}), "E"); }

TEST_F(MarkPicker, BesideEverythingFindsNothing) { EXPECT_EQ(at({0, 9, 0}), ""); }

TEST_F(MarkPicker, OfTwoFacesFindsTheNearer) {
  figure.marks.push_back(withId(polygonOf({{2, -1, -2.5}, {2, 1, -2.5}, {2, 0, -1}}), "near"));
  EXPECT_EQ(at({2, 0, -2}), "near");
}

TEST_F(MarkPicker, WithTheCameraInsideAPatchStillFindsWhatLiesAhead) {
  camera.height = 1;
  figure.marks = {withId(patchAt({0, 0, -1}, {0, 0, 1}), "floor")};
  EXPECT_EQ(at({-5, 0, -1}), "floor");
}

} // namespace
} // namespace halfspace
