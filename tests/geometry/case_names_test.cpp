#include "geometry/case_names.h"

#include "geometry/bisect_planes.h"
#include "geometry/intersect_line_plane.h"
#include "geometry/intersect_plane_sphere.h"
#include "geometry/intersect_planes.h"
#include "geometry/intersect_ray_polygon.h"
#include "geometry/intersect_ray_solid.h"
#include "geometry/intersect_ray_sphere.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/intersect_segment_plane.h"
#include "geometry/intersect_three_planes.h"
#include "geometry/relate_lines.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace halfspace {
namespace {

/// Whether the cases up to the last one have names of small letters and hyphens, each its own.
template <class Case> void expectNamesApart(Case last) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    const std::string_view name = nameOf(static_cast<Case>(i));
    EXPECT_FALSE(name.empty()) << i;
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos) << name;
    EXPECT_TRUE(names.insert(name).second) << name << " stands for two";
  }
}

TEST(CaseNames, OfEveryQuery_AreThereAndApart) {
  expectNamesApart(BisectPlanesCase::ZeroNormal);
  expectNamesApart(FacePart::Outside);
  expectNamesApart(LineLineCase::NotALine);
  expectNamesApart(LinePlaneCase::ZeroNormal);
  expectNamesApart(PlanePlaneCase::ZeroNormal);
  expectNamesApart(PlaneSphereCase::ZeroNormal);
  expectNamesApart(RayPlaneCase::ZeroDirection);
  expectNamesApart(RayPolygonCase::ZeroDirection);
  expectNamesApart(RaySolidCase::ZeroDirection);
  expectNamesApart(RaySphereCase::ZeroDirection);
  expectNamesApart(RayTriangleCase::ZeroDirection);
  expectNamesApart(SegmentPlaneCase::ZeroNormal);
  expectNamesApart(SolidContacts::Along);
  expectNamesApart(SolidLocation::Inside);
  expectNamesApart(SphereContacts::Two);
  expectNamesApart(ThreePlanesCase::ZeroNormal);
}

TEST(CaseNames, OfCasesThatSeveralQueriesHave_AreTheSame) {
  EXPECT_EQ(nameOf(RayPlaneCase::InPlane), nameOf(RayTriangleCase::InPlane));
  EXPECT_EQ(nameOf(RayPlaneCase::InPlane), nameOf(LinePlaneCase::InPlane));
  EXPECT_EQ(nameOf(RayPlaneCase::InPlane), nameOf(SegmentPlaneCase::InPlane));
  EXPECT_EQ(nameOf(RayPlaneCase::Behind), nameOf(RaySphereCase::Behind));
  EXPECT_EQ(nameOf(PlanePlaneCase::Coincident), nameOf(ThreePlanesCase::Coincident));
  EXPECT_EQ(nameOf(RayPlaneCase::ZeroDirection), nameOf(RaySolidCase::ZeroDirection));
}

} // namespace
} // namespace halfspace
