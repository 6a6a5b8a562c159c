// Words among the values of a construction, as programs and as learners read them.
#pragma once

#include "geometry/location.h"
#include "lessons/construction/outcome.h"

#include <string>

namespace halfspace {

enum class PointPlaneCase;
enum class RayPlaneCase;
enum class RayTriangleCase;
enum class SolidContacts;
enum class SphereContacts;

[[nodiscard]] Word yesOrNo(bool holds);
/// For programs `true` and `false`.
[[nodiscard]] Word trueOrFalse(bool holds);
[[nodiscard]] Word noneOfThem();
[[nodiscard]] Word severalOfThem();

/// The case of a geometry that is sound: with zero vectors there is no such value.
[[nodiscard]] Word wordOf(PointPlaneCase side);
[[nodiscard]] Word wordOf(RayPlaneCase which);
[[nodiscard]] Word wordOf(RayTriangleCase which);
[[nodiscard]] Word wordOf(FacePart part);
[[nodiscard]] Word wordOf(SolidLocation place);
[[nodiscard]] Word wordOf(SolidContacts contacts);
[[nodiscard]] Word wordOf(SphereContacts contacts);

} // namespace halfspace
