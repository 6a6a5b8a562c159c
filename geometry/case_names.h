// The names by which programs know the cases of queries, in answers and in files of lessons: hit, in-plane,
// zero-normal … They are no words for people, and never change.
#pragma once

#include <string_view>

namespace halfspace {

enum class BisectPlanesCase;
enum class FacePart;
enum class LineLineCase;
enum class LinePlaneCase;
enum class PlanePlaneCase;
enum class PlaneSphereCase;
enum class PointLineCase;
enum class PointPlaneCase;
enum class RayPlaneCase;
enum class RayPolygonCase;
enum class RaySolidCase;
enum class RaySphereCase;
enum class RayTriangleCase;
enum class SegmentPlaneCase;
enum class SolidContacts;
enum class SolidLocation;
enum class SphereContacts;
enum class ThreePlanesCase;

[[nodiscard]] std::string_view nameOf(BisectPlanesCase which);
[[nodiscard]] std::string_view nameOf(FacePart location);
[[nodiscard]] std::string_view nameOf(LineLineCase which);
[[nodiscard]] std::string_view nameOf(LinePlaneCase which);
[[nodiscard]] std::string_view nameOf(PlanePlaneCase which);
[[nodiscard]] std::string_view nameOf(PlaneSphereCase which);
[[nodiscard]] std::string_view nameOf(PointLineCase which);
[[nodiscard]] std::string_view nameOf(PointPlaneCase which);
[[nodiscard]] std::string_view nameOf(RayPlaneCase which);
[[nodiscard]] std::string_view nameOf(RayPolygonCase which);
[[nodiscard]] std::string_view nameOf(RaySolidCase which);
[[nodiscard]] std::string_view nameOf(RaySphereCase which);
[[nodiscard]] std::string_view nameOf(RayTriangleCase which);
[[nodiscard]] std::string_view nameOf(SegmentPlaneCase which);
[[nodiscard]] std::string_view nameOf(SolidContacts contacts);
[[nodiscard]] std::string_view nameOf(SolidLocation location);
[[nodiscard]] std::string_view nameOf(SphereContacts contacts);
[[nodiscard]] std::string_view nameOf(ThreePlanesCase which);

} // namespace halfspace
