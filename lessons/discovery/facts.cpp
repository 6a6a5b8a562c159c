#include "lessons/discovery/facts.h"

namespace halfspace {
namespace {

constexpr FormSet point = only(Form::Point);
constexpr FormSet line = only(Form::Line);
constexpr FormSet partOfLine = only(Form::Ray) | only(Form::Segment);
constexpr FormSet anyLine = line | partOfLine;
constexpr FormSet vector = only(Form::Vector);
constexpr FormSet plane = only(Form::Plane);
constexpr FormSet face = only(Form::Face);
constexpr FormSet anyPlane = plane | face;
constexpr FormSet sphere = only(Form::Sphere);
constexpr FormSet number = only(Form::Number);
constexpr FormSet directed = anyLine | vector | anyPlane;
constexpr FormSet withLength = only(Form::Segment) | vector;

bool liesOn(SpatialObjects o) { return contains(o[1], o[0].at); }
bool liesIn(SpatialObjects o) { return contains(o[1], o[0]); }

/// Whether one lies in the other. Vectors lie nowhere.
bool isPartOf(const SpatialObject &a, const SpatialObject &b) {
  return a.form != Form::Vector && b.form != Form::Vector && (contains(a, b) || contains(b, a));
}
bool areParallelApart(SpatialObjects o) { return areParallel(o[0], o[1]) && !isPartOf(o[0], o[1]); }
bool areAtRightAngles(SpatialObjects o) { return arePerpendicular(o[0], o[1]); }

bool meet(SpatialObjects o) { return meetingPoint(o[0], o[1]).has_value(); }
bool allMeet(SpatialObjects o) {
  const auto place = meetingPoint(o[0], o[1]);
  return place && meetingPoint(o[0], o[2]) && contains(o[2], *place);
}

bool areEquallyLong(SpatialObjects o) { return dot(o[0].way, o[0].way) == dot(o[1].way, o[1].way); }
bool areEqualNumbers(SpatialObjects o) { return o[0].number == o[1].number; }

bool touches(SpatialObjects o) { return squaredDistance(o[0].at, o[1]) == o[0].number * o[0].number; }
bool touchEachOther(SpatialObjects o) {
  const ExactVec3 between = o[1].at - o[0].at;
  const Rational square = dot(between, between);
  const Rational sum = o[0].number + o[1].number;
  const Rational difference = o[0].number - o[1].number;
  return square > 0 && (square == sum * sum || square == difference * difference);
}
bool haveOneCentre(SpatialObjects o) { return o[0].at == o[1].at; }

bool areApart(SpatialObjects o) { return o[0].at != o[1].at && o[0].at != o[2].at && o[1].at != o[2].at; }
bool areOnOneLine(SpatialObjects o) {
  return areApart(o) && isZero(cross(o[1].at - o[0].at, o[2].at - o[0].at));
}
bool areInOnePlane(SpatialObjects o) {
  return dot(cross(o[1].at - o[0].at, o[2].at - o[0].at), o[3].at - o[0].at) == 0;
}
bool isMidpoint(SpatialObjects o) { return areApart(o) && o[0].at + o[0].at == o[1].at + o[2].at; }

bool isRightAngle(SpatialObjects o) {
  const auto first = lineThrough(o[0], o[1]);
  const auto second = lineThrough(o[0], o[2]);
  return first && second && arePerpendicular(*first, *second);
}

/// The same distance ≠ 0.
bool isSameDistance(const Rational &a, const Rational &b) { return a == b && a != 0; }
bool isAsFarFromBoth(SpatialObjects o) {
  const bool arePoints = o[1].form == Form::Point && o[2].form == Form::Point;
  const bool isSaidOtherwise = arePoints && (isMidpoint(o) || o[1].at == o[2].at);
  return !isSaidOtherwise && isSameDistance(squaredDistance(o[0].at, o[1]), squaredDistance(o[0].at, o[2]));
}
bool areEquallyFar(SpatialObjects o) {
  return isSameDistance(squaredDistance(o[0].at, o[2]), squaredDistance(o[1].at, o[2]));
}
bool areTwiceAsFar(SpatialObjects o) {
  return isSameDistance(squaredDistance(o[0].at, o[1]), squaredDistance(o[2].at, o[3]));
}

bool isLineParallel(SpatialObjects o) {
  const auto through = lineThrough(o[0], o[1]);
  return through && areParallel(*through, o[2]) && !isPartOf(*through, o[2]);
}
bool isLinePerpendicular(SpatialObjects o) {
  const auto through = lineThrough(o[0], o[1]);
  return through && arePerpendicular(*through, o[2]);
}
bool areLinesParallel(SpatialObjects o) {
  const auto other = lineThrough(o[2], o[3]);
  const SpatialObject three[]{o[0], o[1], other.value_or(o[2])};
  return other && isLineParallel(three);
}
bool areLinesPerpendicular(SpatialObjects o) {
  const auto other = lineThrough(o[2], o[3]);
  const SpatialObject three[]{o[0], o[1], other.value_or(o[2])};
  return other && isLinePerpendicular(three);
}

std::vector<Fact> factsOfTwo() {
  const std::vector<std::pair<std::size_t, std::size_t>> either{{0, 1}};
  return {
      {{point, point}, either, liesOn, says("{a} and {b} are the same point.")},
      {{point, line}, {}, liesOn, says("{a} lies on the line {b}.")},
      {{point, partOfLine}, {}, liesOn, says("{a} lies on the line along {b}.")},
      {{point, plane}, {}, liesOn, says("{a} lies in the plane {b}.")},
      {{point, face}, {}, liesOn, says("{a} lies in the plane of {b}.")},
      {{point, sphere}, {}, liesOn, says("{a} lies on the sphere {b}.")},
      {{point, sphere}, {}, haveOneCentre, says("{a} is the centre of the sphere {b}.")},
      {{anyLine, plane}, {}, liesIn, says("{a} lies in the plane {b}.")},
      {{anyLine, face}, {}, liesIn, says("{a} lies in the plane of {b}.")},
      {{anyLine, anyLine}, either, liesIn, says("{a} and {b} lie on one line.")},
      {{anyPlane, anyPlane}, either, liesIn, says("{a} and {b} lie in one plane.")},
      {{line, line}, either, meet, says("{a} and {b} meet in one point.")},
      {{directed, directed}, either, areParallelApart, says("{a} and {b} are parallel.")},
      {{directed, directed}, either, areAtRightAngles, says("{a} and {b} are perpendicular.")},
      {{withLength, withLength}, either, areEquallyLong, says("{a} and {b} are equally long.")},
      {{sphere, line | plane}, {}, touches, says("{b} touches the sphere {a}.")},
      {{sphere, sphere}, either, touchEachOther, says("The spheres {a} and {b} touch each other.")},
      {{sphere, sphere}, either, haveOneCentre, says("The spheres {a} and {b} have the same centre.")},
      {{sphere, sphere}, either, areEqualNumbers, says("The spheres {a} and {b} have the same radius.")},
      {{number, number}, either, areEqualNumbers, says("{a} and {b} are the same number.")},
  };
}

std::vector<Fact> factsOfMore() {
  const std::vector<std::pair<std::size_t, std::size_t>> first{{0, 1}};
  const std::vector<std::pair<std::size_t, std::size_t>> last{{1, 2}};
  const std::vector<std::pair<std::size_t, std::size_t>> any{{0, 1}, {1, 2}};
  const std::vector<std::pair<std::size_t, std::size_t>> inPairs{{0, 1}, {2, 3}, {0, 2}};
  const std::vector<FormSet> points{point, point, point, point};
  return {
      {{line, line, line}, any, allMeet, says("{a}, {b} and {c} meet in one point.")},
      {{point, point, point}, any, areOnOneLine, says("{a}, {b} and {c} lie on one line.")},
      {{point, point, point}, last, isMidpoint, says("{a} is the midpoint of {b} and {c}.")},
      {{point, point, point}, last, isRightAngle, says("At {a} there is a right angle between {b} and {c}.")},
      {{point, point | line | plane, point | line | plane},
       last,
       isAsFarFromBoth,
       says("{a} is as far from {b} as from {c}.")},
      {{point, point, line | plane}, first, areEquallyFar, says("{a} and {b} are equally far from {c}.")},
      {{point, point, directed}, first, isLineParallel, says("The line {ab} is parallel to {c}.")},
      {{point, point, directed}, first, isLinePerpendicular, says("The line {ab} is perpendicular to {c}.")},
      {points, {{0, 1}, {1, 2}, {2, 3}}, areInOnePlane, says("{a}, {b}, {c} and {d} lie in one plane.")},
      {points, inPairs, areLinesParallel, says("The lines {ab} and {cd} are parallel.")},
      {points, inPairs, areLinesPerpendicular, says("The lines {ab} and {cd} are perpendicular.")},
      {points, inPairs, areTwiceAsFar, says("{a} is as far from {b} as {c} is from {d}.")},
  };
}

} // namespace

const std::vector<Fact> &facts() {
  static const std::vector<Fact> all = [] {
    std::vector<Fact> found = factsOfTwo();
    for (Fact &fact : factsOfMore())
      found.push_back(std::move(fact));
    return found;
  }();
  return all;
}

} // namespace halfspace
