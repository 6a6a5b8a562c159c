// The lessons that come with the program, checked as their readers will meet them.
#include "lessons/lesson/condition.h"
#include "lessons/lesson/lesson_words.h"
#include "lessons/object/kinds/mesh.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/polygon.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/ufo.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/scene/session.h"

#include "lessons/lesson/shown.h"
#include "tests/lessons/lesson/filled_text.h"
#include "tests/lessons/objects.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>

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

Object onTrianglePlane(const Rational &s, const Rational &t) {
  return test::withNumbers("point-on-triangle-plane", {s, t});
}

Object box(const ExactVec3 &lowest, const ExactVec3 &lengths) {
  return test::objectOf("box", {lowest, {lengths.x, 0, 0}, {lengths.y, 0, 0}, {lengths.z, 0, 0}});
}

Object house(const ExactVec3 &ridge, const ExactVec3 &depth) {
  return test::objectOf("prism", {{8, 2, 0}, depth, {8, 2, 4}, ridge, {2, 2, 4}, {2, 2, 0}});
}

/// The saucer of the photon torpedo, with its barrel turned.
Object aimed(const ExactVec3 &barrel) { return UfoObject{{5, 1, 14}, {4, 2, 0}, barrel, 20}; }

/// A mesh of that lesson elsewhere.
Object movedTo(const ExactVec3 &place, const char *name) {
  MeshObject mesh = objectAs<MeshObject>(*findObject(library().find("photon-torpedo")->scene, name)).value();
  mesh.place = place;
  return mesh;
}

const std::vector<Solution> &solutions() {
  static const std::vector<Solution> all{
      {"plane-implicit", "Drag $P$ to", {"P", PointObject{{7, 7, 1}}}},
      {"plane-implicit", "Move $P$ into", {"P", PointObject{{3, 9, 3}}}},
      {"plane-implicit", "Turn $\\vec n$", {"E", PlaneObject{{5, 4, 7}, {0, 0, 2}}}},
      {"plane-implicit", "Slide the plane", {"E", PlaneObject{{2, -2, 1}, {1, 2, 2}}}},
      {"plane-implicit", "Make the constant", {"E", PlaneObject{{5, 4, 7}, {-1, -2, -2}}}},
      {"plane-implicit", "Let $\\vec n$ stand", {"E", PlaneObject{{5, 4, 7}, {0, 0, 1}}}},
      {"half-spaces", "Drag $B$ to", {"B", PointObject{{4, 6, 8}}}},
      {"half-spaces", "Bring $C$ to", {"C", PointObject{{10, 2, 3}}}},
      {"half-spaces", "Slide the plane", {"E", PlaneObject{{3, 8, 7}, {1, 2, 2}}}},
      {"half-spaces", "Slide it on", {"E", PlaneObject{{12, 8, 9}, {1, 2, 2}}}},
      {"half-spaces", "Turn $\\vec n$", {"E", PlaneObject{{5, 4, 7}, {-1, -2, -2}}}},
      {"plane-parametric", "Drag $P$ until", {"P", onTrianglePlane({1, 2}, {1, 2})}},
      {"plane-parametric", "Go backwards", {"P", onTrianglePlane({-1, 4}, {1, 2})}},
      {"plane-parametric", "Bring $P$ to the corner", {"P", onTrianglePlane(0, 1)}},
      {"plane-parametric", "Bring $P$ to the middle", {"P", onTrianglePlane({1, 2}, 0)}},
      {"plane-parametric", "Leave the triangle", {"P", onTrianglePlane(0, {3, 2})}},
      {"plane-parametric", "Now go onto", {"P", onTrianglePlane({1, 4}, {3, 4})}},
      {"plane-parametric", "Take $P$ out", {"P", onTrianglePlane({3, 4}, {1, 2})}},
      {"plane-parametric", "Bring $P$ to $P_3$", {"P", onTrianglePlane(1, 1)}},
      {"plane-parametric", "Put $P_0$", {"T", TriangleObject{{9, 9, 0}, {1, 9, 4}, {5, 9, 2}}}},
      {"line-ray-segment", "Slide $P$ along", {"P", test::withNumbers("point-on-line", {2})}},
      {"line-ray-segment", "Slide $P$ to the mark", {"P", test::withNumbers("point-on-line", {-1})}},
      {"line-ray-segment", "Slide $P$ to where the ray", {"P", test::withNumbers("point-on-line", {2})}},
      {"line-ray-segment", "Now leave the ray", {"P", test::withNumbers("point-on-line", {-1})}},
      {"line-ray-segment", "Slide $P$ to the middle", {"P", test::withNumbers("point-on-line", {{1, 2}})}},
      {"line-ray-segment", "Slide $P$ to where it has", {"P", test::withNumbers("point-on-line", {{3, 4}})}},
      {"line-ray-segment", "Bring $Q$ onto", {"Q", PointObject{{7, 12, 6}}}},
      {"line-ray-segment", "Put $Q$ on the segment", {"Q", PointObject{{4, 6, 3}}}},
      {"line-ray-segment", "Put $Q$ on the line, but", {"Q", PointObject{{2, 2, 1}}}},
      {"line-ray-segment", "Turn $\\vec v$", {"g", LineObject{{3, 4, 2}, {0, 4, 2}}}},
      {"line-ray-segment", "Bring the tip", {"g", LineObject{{3, 4, 2}, {0, 0, 0}}}},
      {"dot-product-projection", "Turn $\\vec w$ until it", {"w", VectorObject{{4, 1, 1}, {-3, 3, 0}}}},
      {"dot-product-projection", "Make the dot", {"w", VectorObject{{4, 1, 1}, {-4, 1, 3}}}},
      {"dot-product-projection", "Make $\\vec v$ exactly", {"v", VectorObject{{4, 1, 1}, {1, 0, 0}}}},
      {"dot-product-projection", "Make $\\vec v$ longer", {"v", VectorObject{{4, 1, 1}, {4, 0, 0}}}},
      {"dot-product-projection", "Turn $\\vec w$ until nothing", {"w", VectorObject{{4, 1, 1}, {2, 2, 1}}}},
      {"dot-product-projection", "Turn $\\vec v$ until", {"v", VectorObject{{4, 1, 1}, {3, 0, 0}}}},
      {"determinant", "Drag the tip of $\\vec w$ until the box", {"w", VectorObject{{5, 1, 2}, {4, 2, 1}}}},
      {"determinant", "Drag the tip of $\\vec w$ until $D$", {"w", VectorObject{{5, 1, 2}, {1, 0, 5}}}},
      {"determinant", "Bring the tip", {"w", VectorObject{{5, 1, 2}, {2, 3, -1}}}},
      {"determinant", "Lay $\\vec w$", {"w", VectorObject{{5, 1, 2}, {2, 5, 0}}}},
      {"determinant", "Lay $\\vec v$", {"v", VectorObject{{5, 1, 2}, {8, 6, -2}}}},
      {"determinant", "Drag one of", {"w", VectorObject{{5, 1, 2}, {2, 0, 1}}}},
      {"determinant", "Drag the tip of $\\vec u$", {"u", VectorObject{{5, 1, 2}, {1, 2, -2}}}},
      {"determinant", "Drag the tip of $\\vec w$ until the tet", {"w", VectorObject{{5, 1, 2}, {0, 1, -2}}}},
      {"signed-distance", "Drag $Q$ on", {"Q", PointObject{{1, 1, 1}}}},
      {"signed-distance", "Move $Q$ exactly", {"Q", PointObject{{3, 4, 8}}}},
      {"signed-distance", "Drag $Q$ until $M$", {"Q", PointObject{{6, 6, 9}}}},
      {"signed-distance", "Bring $Q$ to", {"Q", PointObject{{10, 8, 8}}}},
      {"signed-distance", "Move $Q$ until", {"Q", PointObject{{3, 4, 8}}}},
      {"signed-distance", "Now make the angle", {"Q", PointObject{{1, 1, 1}}}},
      {"signed-distance", "Move $Q$ so", {"Q", PointObject{{12, 10, 2}}}},
      {"ray-plane-substitution", "Turn the ray round", {"L", RayObject{{11, 15, 8}, {1, -3, -2}}}},
      {"ray-plane-substitution", "Turn the ray until", {"L", RayObject{{11, 15, 8}, {-1, 3, -1}}}},
      {"ray-plane-substitution", "Now let it hit", {"L", RayObject{{11, 15, 8}, {1, -3, -2}}}},
      {"ray-plane-substitution", "Make the ray parallel", {"L", RayObject{{11, 15, 8}, {-1, 0, 2}}}},
      {"ray-plane-substitution", "Now move $Q$", {"L", RayObject{{11, 9, 8}, {-1, 0, 2}}}},
      {"ray-plane-substitution", "Turn the ray out", {"L", RayObject{{11, 9, 8}, {1, 2, 2}}}},
      {"ray-plane-dot", "Make $t$ positive", {"L", RayObject{{11, 15, 8}, {1, -3, -2}}}},
      {"ray-plane-dot", "Make $t$ exactly", {"L", RayObject{{11, 15, 8}, {-10, -10, 0}}}},
      {"ray-plane-dot", "Turn $\\vec r$ until exactly two", {"L", RayObject{{11, 15, 8}, {-5, -5, 0}}}},
      {"ray-plane-dot", "Make $t$ change", {"L", RayObject{{11, 15, 8}, {-1, 3, 2}}}},
      {"ray-plane-dot", "Make the ray parallel", {"L", RayObject{{11, 15, 8}, {-2, -1, 2}}}},
      {"ray-plane-dot", "Now put the whole", {"L", RayObject{{5, 4, 7}, {-2, -1, 2}}}},
      {"ray-plane-dot", "Turn the ray", {"L", RayObject{{5, 4, 7}, {1, 2, 2}}}},
      {"ray-plane-dot", "Let the ray hit", {"L", RayObject{{1, 1, 1}, {1, 2, 2}}}},
      {"ray-plane-picture", "Slide the plane", {"G", PlaneObject{{-3, -1, -2}, {{1, 3}, {2, 3}, {2, 3}}}}},
      {"ray-plane-picture", "Turn $\\vec r$ until $v_d$", {"L", RayObject{{5, 0, 2}, {3, 0, -3}}}},
      {"ray-plane-picture", "Move $Q$ into", {"L", RayObject{{7, 4, 6}, {3, 0, 3}}}},
      {"ray-plane-picture", "Make the two triangles", {"L", RayObject{{8, 0, 5}, {3, 0, 3}}}},
      {"ray-plane-picture", "Make $t$ negative", {"L", RayObject{{5, 0, 2}, {-3, 0, -3}}}},
      {"ray-plane-picture", "Move the plane", {"L", RayObject{{5, 0, 2}, {-3, 0, -3}}}},
      {"ray-plane-picture", "Make the ray parallel", {"L", RayObject{{5, 0, 2}, {2, -2, 1}}}},
      {"ray-plane-picture", "Now move $Q$", {"L", RayObject{{7, 4, 6}, {2, -2, 1}}}},
      {"ray-plane-picture", "Make $\\vec n$ longer", {"G", PlaneObject{{1, 7, 6}, {1, 2, 2}}}},
      {"ray-plane-picture", "Turn $\\vec n$ until", {"G", PlaneObject{{1, 7, 6}, {-1, -2, -2}}}},
      {"reflection", "Tilt the mirror", {"E", PlaneObject{{5, 8, 7}, {1, 0, 1}}}},
      {"reflection", "Turn $\\vec r$ until nothing", {"L", RayObject{{4, 4, 22}, {-4, -2, -4}}}},
      {"reflection", "Turn $\\vec n$ round", {"E", PlaneObject{{5, 8, 7}, {-2, -1, -2}}}},
      {"reflection", "Turn $\\vec r$ until $\\vec r$", {"L", RayObject{{4, 4, 22}, {-1, 1, -4}}}},
      {"reflection", "Turn $\\vec r$ until the brightness", {"L", RayObject{{4, 4, 22}, {0, -9, 0}}}},
      {"reflection", "Turn $\\vec r$ round", {"L", RayObject{{4, 4, 22}, {0, 0, 9}}}},
      {"shadow", "Move $A$ until $L(M)$", {"A", PointObject{{7, 5, 4}}}},
      {"shadow", "Bring $A$ to where", {"A", PointObject{{7, 8, 4}}}},
      {"shadow", "Turn $\\vec r$ until the sun", {"r", VectorObject{{12, 3, 10}, {-2, 2, -2}}}},
      {"shadow", "Bring $M$ into", {"B", PointObject{{5, 7, -1}}}},
      {"shadow", "Move the lamp", {"Q", PointObject{{5, 4, 11}}}},
      {"shadow", "Move $B$ until one piece", {"B", PointObject{{5, Rational(13, 2), Rational(17, 2)}}}},
      {"shadow", "Move $A$ until the ray", {"A", PointObject{{7, 5, 10}}}},
      {"shadow", "Bring $A$ exactly", {"A", PointObject{{7, 4, 8}}}},
      {"shadow", "Bring $A$ behind", {"A", PointObject{{7, 5, 1}}}},
      {"closest-points", "Move $A_g$ until", {"g", LineObject{{4, 2, 4}, {-3, 0, 3}}}},
      {"closest-points", "Turn $\\vec v_h$ until each", {"h", LineObject{{8, 1, 5}, {1, -2, 1}}}},
      {"closest-points", "Turn $\\vec v_h$ until $s$", {"h", LineObject{{8, 1, 5}, {-3, 0, 2}}}},
      {"closest-points", "Move $A_h$ until $F$", {"h", LineObject{{6, 0, 3}, {2, -2, -1}}}},
      {"closest-points", "Move $A_h$ until the", {"h", LineObject{{7, 0, 5}, {2, -2, -1}}}},
      {"closest-points", "Make $\\vec v_h$ longer", {"h", LineObject{{8, 1, 5}, {6, -6, -3}}}},
      {"closest-points", "Turn $\\vec v_h$ until the lines", {"h", LineObject{{8, 1, 5}, {-3, 0, 3}}}},
      {"closest-points", "Now move", {"h", LineObject{{6, 2, 2}, {-3, 0, 3}}}},
      {"camera", "Drag $X$ out of the image", {"X", PointObject{{14, 8, 5}}}},
      {"camera", "Choose the first pixel", {"X", PointObject{{-8, 16, 11}}}},
      {"camera", "Drag $X$ until the ray", {"X", PointObject{{16, 16, 3}}}},
      {"camera", "Drag $X$ until $k$", {"X", PointObject{{6, 4, 5}}}},
      {"camera", "Drag $X$ until its image", {"X", PointObject{{4, 16, 5}}}},
      {"camera", "Drag $X$ until $k = 1/2$", {"X", PointObject{{9, 8, 5}}}},
      {"camera", "Drag $X$ behind", {"X", PointObject{{14, -4, 5}}}},
      {"camera", "Drag $X$ beside", {"X", PointObject{{14, 0, 5}}}},
      {"clipping", "Drag $C$ through", {"C", PointObject{{1, 11, 0}}}},
      {"clipping", "Move $B$ until", {"B", PointObject{{5, 4, 1}}}},
      {"clipping", "Make $\\vec n$ longer", {"E", PlaneObject{{8, 4, 4}, {0, 4, 8}}}},
      {"clipping", "Turn $\\vec n$ to", {"E", PlaneObject{{8, 4, 4}, {0, -1, -2}}}},
      {"clipping", "Move $A$, and $B$ too", {"A", PointObject{{2, 4, 3}}}},
      {"clipping", "Slide the plane along", {"E", PlaneObject{{8, 6, 7}, {0, 1, 2}}}},
      {"clipping", "Put $B$ exactly", {"B", PointObject{{5, 10, 1}}}},
      {"clipping", "Slide the plane until only", {"E", PlaneObject{{8, 7, 7}, {0, 1, 2}}}},
      {"clipping", "Slide the plane until the whole", {"E", PlaneObject{{8, 1, 4}, {0, 1, 2}}}},
      {"ray-triangle-perp", "Drag the start", {"L", RayObject{{11, 13, 10}, {-4, -5, 3}}}},
      {"ray-triangle-perp", "Hit an edge", {"L", RayObject{{5, 9, 9}, {0, 0, -7}}}},
      {"ray-triangle-perp", "Hit a corner", {"L", RayObject{{11, 13, 10}, {-2, -4, -10}}}},
      {"ray-triangle-perp", "Put all three", {"T", TriangleObject{{9, 9, 0}, {1, 9, 4}, {5, 9, 2}}}},
      {"triangle-degenerate",
       "Drag $P_1$ onto $P_0$. Now",
       {"T", TriangleObject{{6, 5, 3}, {6, 5, 3}, {5, 3, 3}}}},
      {"triangle-degenerate",
       "Drag $P_1$ onto $P_2$",
       {"T", TriangleObject{{6, 5, 3}, {5, 3, 3}, {5, 3, 3}}}},
      {"triangle-degenerate", "Drag $P_1$ along", {"T", TriangleObject{{6, 5, 3}, {4, 1, 3}, {5, 3, 3}}}},
      {"triangle-degenerate",
       "Drag $P_1$ onto $P_0$. What",
       {"T", TriangleObject{{6, 5, 3}, {6, 5, 3}, {5, 3, 3}}}},
      {"triangle-degenerate",
       "Drag $P_1$ until the",
       {"T", TriangleObject{{6, 5, 3}, {10, 10, 3}, {5, 3, 3}}}},
      {"triangle-degenerate", "Make $G$ zero", {"T", TriangleObject{{6, 5, 3}, {10, 13, 3}, {10, 13, 3}}}},
      {"triangle-degenerate", "Drag $P_1$ until $", {"T", TriangleObject{{6, 5, 3}, {16, 5, 3}, {5, 3, 3}}}},
      {"triangle-degenerate", "Put the corners so", {"T", TriangleObject{{6, 5, 3}, {10, 13, 3}, {5, 3, 3}}}},
      {"triangle-degenerate", "Put two", {"T", TriangleObject{{6, 5, 3}, {5, 3, 3}, {5, 3, 3}}}},
      {"ray-sphere", "Move $Q$ sideways", {"L", RayObject{{15, 13, 9}, {-1, -2, -2}}}},
      {"ray-sphere", "Move $Q$ until the line", {"L", RayObject{{12, 15, 9}, {-1, -2, -2}}}},
      {"ray-sphere", "Let the line", {"L", RayObject{{8, 12, 11}, {-1, -2, -2}}}},
      {"ray-sphere", "Move $Q$ until $h$", {"L", RayObject{{11, 14, 9}, {-1, -2, -2}}}},
      {"ray-sphere", "Drag $Q$ into", {"L", RayObject{{5, 6, 6}, {-1, -2, -2}}}},
      {"ray-sphere", "Move $Q$ until its power", {"L", RayObject{{8, 10, 5}, {-1, -2, -2}}}},
      {"ray-sphere", "Put $Q$ outside", {"L", RayObject{{2, 1, 1}, {-1, -2, -2}}}},
      {"ray-box-slabs", "Move $Q$ until the line goes", {"L", RayObject{{-2, -3, 6}, {2, 2, -1}}}},
      {"ray-box-slabs", "Turn $\\vec r$ until the lower", {"L", RayObject{{0, -3, 6}, {2, 2, 1}}}},
      {"ray-box-slabs", "Move $Q$ until the line misses", {"L", RayObject{{3, -3, 6}, {2, 2, -1}}}},
      {"ray-box-slabs", "Make the line only", {"L", RayObject{{2, -3, 6}, {2, 2, -1}}}},
      {"ray-box-slabs", "Drag $Q$ into", {"L", RayObject{{4, 4, 2}, {2, 2, -1}}}},
      {"ray-box-slabs", "Let the ray come in", {"L", RayObject{{0, -1, 7}, {2, 2, -1}}}},
      {"ray-box-slabs", "Turn $\\vec r$ until the ray", {"L", RayObject{{0, -3, 6}, {0, 2, -1}}}},
      {"ray-box-slabs", "Now move $Q$", {"L", RayObject{{4, -3, 6}, {0, 2, -1}}}},
      {"barycentric", "Drag $Q$ out", {"Q", onTrianglePlane(1, 1)}},
      {"barycentric", "Bring $Q$ to where", {"Q", onTrianglePlane({1, 3}, {1, 3})}},
      {"barycentric", "Drag a corner", {"T", TriangleObject{{8, 5, 3}, {8, 8, 0}, {0, 8, 4}}}},
      {"barycentric", "Bring $Q$ onto", {"Q", onTrianglePlane({1, 4}, {1, 4})}},
      {"barycentric", "Keep $\\rho$", {"Q", onTrianglePlane({1, 2}, 0)}},
      {"barycentric", "Put $Q$ exactly", {"Q", onTrianglePlane(0, 1)}},
      {"barycentric", "Take $Q$ to", {"Q", onTrianglePlane({-1, 2}, 2)}},
      {"ray-triangle-cramer",
       "Drag $Q$ or the tip of $\\vec r$ until the line",
       {"L", RayObject{{6, 9, 5}, {1, 2, 4}}}},
      {"ray-triangle-cramer",
       "Drag $Q$ or the tip of $\\vec r$ until the ray",
       {"L", RayObject{{6, 9, 5}, {-1, -2, 1}}}},
      {"ray-triangle-cramer", "Drag $Q$ until both", {"L", RayObject{{3, 9, 8}, {1, 2, -1}}}},
      {"ray-triangle-cramer", "Turn the ray", {"L", RayObject{{6, 9, 5}, {-1, 0, 1}}}},
      {"plane-plane", "Turn the normal", {"E", PlaneObject{{4, 2, 3}, {0, 1, 1}}}},
      {"plane-plane", "Now slide", {"E", PlaneObject{{2, 6, 0}, {0, 1, 1}}}},
      {"plane-plane", "Make the two", {"F", PlaneObject{{2, 6, 0}, {0, 1, -1}}}},
      {"point-line", "Move $Q$ so", {"Q", PointObject{{3, -1, 3}}}},
      {"point-line", "Bring the foot", {"Q", PointObject{{0, 0, 0}}}},
      {"point-line", "Put $Q$ on", {"Q", PointObject{{4, 3, 2}}}},
      {"point-line", "Move $Q$ until", {"Q", PointObject{{5, 1, 4}}}},
      {"pluecker-lines", "Move $A_g$ until the line", {"g", LineObject{{-1, -2, 2}, {1, 2, -2}}}},
      {"pluecker-lines", "Move $A_g$ until the distance", {"g", LineObject{{3, 3, 0}, {1, 2, -2}}}},
      {"pluecker-lines", "Move $A_h$ or", {"h", LineObject{{3, 5, 8}, {-1, 2, 0}}}},
      {"pluecker-lines", "Move $A_h$ until the tetrahedron", {"h", LineObject{{2, 6, 7}, {1, -2, 0}}}},
      {"pluecker-lines", "Move $A_h$ until the lines meet", {"h", LineObject{{4, 2, 4}, {1, -2, 0}}}},
      {"pluecker-lines", "Move $A_h$ until the lines are", {"h", LineObject{{6, 5, 2}, {1, -2, 0}}}},
      {"pluecker-lines",
       "Turn $\\vec v_h$ until the lines are perp",
       {"h", LineObject{{3, 5, 8}, {2, -1, 0}}}},
      {"pluecker-lines",
       "Turn $\\vec v_h$ until the lines are par",
       {"h", LineObject{{3, 5, 8}, {1, 2, -2}}}},
      {"pluecker-planes", "Slide $G$ until the common", {"G", PlaneObject{{4, 4, 3}, {0, -1, 2}}}},
      {"pluecker-planes", "Turn $\\vec n_G$ until the weight", {"G", PlaneObject{{4, 4, 6}, {0, 1, 2}}}},
      {"pluecker-planes", "Turn $\\vec n_G$ until the line", {"G", PlaneObject{{4, 4, 6}, {-1, 0, 2}}}},
      {"pluecker-planes", "Slide $G$ until the line", {"G", PlaneObject{{3, 2, 5}, {-1, 0, 2}}}},
      {"ray-polygon-pluecker", "Drag $Q$ or", {"L", RayObject{{1, 8, 0}, {2, 1, 2}}}},
      {"ray-polygon-pluecker",
       "Let the ray go exactly through an edge",
       {"L", RayObject{{1, {-1, 2}, 0}, {2, 1, 2}}}},
      {"ray-polygon-pluecker", "Bring the ray to where", {"L", RayObject{{10, -2, 0}, {2, 1, 2}}}},
      {"ray-polygon-pluecker",
       "Let the ray go exactly through a corner",
       {"L", RayObject{{5, 4, 0}, {2, 1, 2}}}},
      {"ray-polygon-pluecker", "Turn $\\vec r$ until the polygon", {"L", RayObject{{1, 1, 0}, {-2, -1, -2}}}},
      {"ray-polygon-pluecker", "Turn $\\vec r$ until the ray", {"L", RayObject{{1, 1, 0}, {2, 1, 0}}}},
      {"ray-polygon-pluecker",
       "Drag the corner",
       {"W", PolygonObject{{{2, 2, 4}, {8, 1, 4}, {5, 3, 4}, {4, 7, 4}}}}},
      {"ray-triangle-pluecker", "Move $Q$", {"L", RayObject{{4, 5, 1}, {1, 2, 1}}}},
      {"ray-triangle-pluecker", "Bring the point", {"L", RayObject{{4, 2, 1}, {1, 2, 1}}}},
      {"ray-triangle-pluecker", "Let the ray go", {"L", RayObject{{0, -2, 2}, {1, 2, 1}}}},
      {"ray-solid-pluecker", "Move $Q$ sideways", {"L", RayObject{{1, 0, 3}, {2, 2, 1}}}},
      {"ray-solid-pluecker", "Turn $\\vec r$ until", {"L", RayObject{{1, 0, 2}, {1, 2, 0}}}},
      {"ray-solid-pluecker", "Let the ray come out", {"L", RayObject{{1, 0, 2}, {2, 2, 1}}}},
      {"ray-solid-pluecker", "Change a length", {"K", box({2, 3, 0}, {6, 5, 2})}},
      {"ray-solid-pluecker", "Move $Q$ until the ray goes in", {"L", RayObject{{1, 1, 2}, {2, 2, 1}}}},
      {"ray-solid-pluecker", "Move $Q$ until the ray comes", {"L", RayObject{{5, 1, 2}, {2, 2, 1}}}},
      {"ray-solid-pluecker", "Drag $Q$ into", {"L", RayObject{{3, 4, 2}, {2, 2, 1}}}},
      {"ray-solid-pluecker", "Drag $Q$ out", {"L", RayObject{{7, 9, 2}, {2, 2, 1}}}},
      {"ray-solid-pluecker", "Let the ray go into", {"L", RayObject{{1, 2, 2}, {2, 2, 1}}}},
      {"ray-solid-pluecker", "Let the ray go exactly", {"L", RayObject{{-2, -1, 2}, {2, 2, 1}}}},
      {"ray-solid-pluecker", "Make the box", {"K", box({2, 3, 0}, {6, 5, 0})}},
      {"ray-prism-pluecker", "Turn $\\vec r$", {"L", RayObject{{3, -2, 2}, {2, 2, 0}}}},
      {"ray-prism-pluecker", "Let it come", {"L", RayObject{{3, -2, 2}, {1, 2, 1}}}},
      {"ray-prism-pluecker", "Drag $\\vec h$", {"K", house({5, 2, 7}, {0, 0, 0})}},
      {"ray-prism-pluecker", "Drag $P_2$ straight", {"K", house({5, 2, 3}, {0, 6, 0})}},
      {"three-methods", "Drag $Q$ straight", {"L", RayObject{{3, 6, 3}, {1, -1, -2}}}},
      {"three-methods", "Turn $\\vec r$ until", {"L", RayObject{{3, 6, 9}, {0, -3, -2}}}},
      {"three-methods", "Move $Q$ down", {"L", RayObject{{3, 6, 4}, {0, -3, -2}}}},
      {"three-methods", "Put all three", {"T", TriangleObject{{2, 2, 1}, {8, 2, 3}, {5, 2, 2}}}},
      {"misprints", "Move $Q$", {"L", RayObject{{7, 8, 5}, {-1, -1, -1}}}},
      {"misprints", "Drag a corner", {"T", TriangleObject{{2, 0, 1}, {6, 4, 1}, {2, 9, 3}}}},
      {"misprints", "Put $P_0$", {"T", TriangleObject{{4, 6, 2}, {6, 4, 1}, {2, 8, 3}}}},
      {"misprints", "Drag $Q$", {"L", RayObject{{4, 2, 4}, {-1, -1, -1}}}},
      {"misprints", "Bring $I$", {"L", RayObject{{5, 3, 4}, {-1, -1, -1}}}},
      {"misprints", "Turn $\\vec r$ until the", {"L", RayObject{{6, 8, 5}, {1, 1, 1}}}},
      {"misprints", "Drag $P_1$", {"T", TriangleObject{{2, 0, 1}, {6, 4, 5}, {2, 8, 3}}}},
      {"misprints", "Turn $\\vec r$ until only", {"L", RayObject{{6, 8, 5}, {1, 1, 1}}}},
      {"cross-product", "Drag the tip", {"v", VectorObject{{6, 6, 1}, {2, -2, 0}}}},
      {"cross-product", "Drag $\\vec v$ until the first", {"v", VectorObject{{6, 6, 1}, {0, 1, 2}}}},
      {"cross-product", "Drag $\\vec v$ until the area", {"v", VectorObject{{6, 6, 1}, {0, 3, 3}}}},
      {"cross-product", "Make $\\vec v$ longer", {"v", VectorObject{{6, 6, 1}, {2, 4, 5}}}},
      {"cross-product", "Turn $\\vec v$ until nothing", {"v", VectorObject{{6, 6, 1}, {-2, 2, 1}}}},
      {"cross-product", "Turn $\\vec v$ until it points", {"v", VectorObject{{6, 6, 1}, {2, 1, 2}}}},
      {"cross-product", "Let $\\vec v$ point", {"v", VectorObject{{6, 6, 1}, {-2, -1, -2}}}},
      {"cross-product", "Drag $\\vec v$ until $\\vec u^\\perp$", {"v", VectorObject{{6, 6, 1}, {0, 1, 1}}}},
      {"cross-product", "Make a right angle", {"v", VectorObject{{6, 6, 1}, {-2, 2, 1}}}},
      {"photon-torpedo", "Turn the barrel", {"U", aimed({8, 6, -11})}},
      {"photon-torpedo", "Make the barrel shorter", {"U", UfoObject{{5, 1, 14}, {4, 2, 0}, {4, 2, -4}, 5}}},
      {"photon-torpedo", "Let the barrel point up", {"U", aimed({-2, -1, 2})}},
      {"photon-torpedo", "Find a fragment", {"i", NumberObject{3, 0, 40000000, 1}}},
      {"photon-torpedo", "Go on until", {"i", NumberObject{22, 0, 40000000, 1}}},
      {"photon-torpedo", "Hit two fragments", {"U", aimed({13, {7, 2}, -8})}},
      {"photon-torpedo", "Choose a piece", {"U", aimed({2, 1, 0})}},
      {"photon-torpedo", "Put the wall", {"wall", movedTo({14, 6, 0}, "wall")}},
      {"photon-torpedo", "Now let the torpedo", {"U", aimed({1, 0, -2})}},
  };
  return all;
}

const Solution *solutionOf(const Lesson &lesson, const Task &task) {
  for (const Solution &solution : solutions())
    if (lesson.id == solution.lesson && task.instruction.written().starts_with(solution.instruction))
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
  EXPECT_EQ(library().lessons.front().id, "line-ray-segment");
  EXPECT_TRUE(std::is_sorted(library().lessons.begin(), library().lessons.end(),
                             [](const Lesson &a, const Lesson &b) { return a.order < b.order; }));
}

TEST(Content, TheStartOfTheTriangleLesson_HitsInsideWithShortFractions) {
  const Evaluation outcome = evaluate(library().find("ray-triangle-perp")->scene);
  EXPECT_EQ(std::get<Word>(*findValue(outcome, "case")).name, "hit");
  EXPECT_EQ(std::get<Surd>(*findValue(outcome, "s")), Surd(Rational(1, 4)));
  EXPECT_EQ(std::get<Surd>(*findValue(outcome, "t_triangle")), Surd(Rational(1, 2)));
  EXPECT_EQ(std::get<Surd>(*findValue(outcome, "t")), Surd(Rational(3, 2)));
  EXPECT_EQ(std::get<Word>(*findValue(outcome, "location")).name, "interior");
}

TEST(Content, EveryLineThatAStepNames_IsWorkedAtTheStart) {
  for (const Lesson &lesson : library().lessons)
    for (const LessonStep &step : lesson.steps) {
      std::vector<std::size_t> named;
      for (const StepBlock &block : step.blocks)
        if (const auto *lines = std::get_if<StepLines>(&block))
          named.push_back(lines->ids == std::vector<std::string>{"none"} ? 0 : lines->ids.size());
      EXPECT_EQ(shownIn(step, evaluate(lesson.scene)).linesIn, named) << lesson.id << ", " << step.title;
    }
}

TEST(Content, EveryLiveValue_HasAValueAtTheStart) {
  for (const Lesson &lesson : library().lessons)
    for (const LessonWords &words : wordsOf(lesson)) {
      const std::string filled = test::filledText(words.text, lesson.scene, evaluate(lesson.scene));
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
    EXPECT_GE(questions, 1) << lesson.id;
  }
}

TEST(Content, AboveAQuestion_StandWordsWithoutTheValueThatDecides) {
  for (const Lesson &lesson : library().lessons)
    for (const LessonStep &step : lesson.steps)
      if (const Prediction *prediction = predictionOf(step)) {
        const std::string value = "{" + prediction->value.substr(0, prediction->value.find('.'));
        for (const StepBlock &block : step.blocks) {
          if (std::holds_alternative<Prediction>(block))
            break;
          if (std::holds_alternative<StepFlight>(block)) // it shows nothing while the question is open
            continue;
          const auto *words = std::get_if<StepWords>(&block);
          ASSERT_TRUE(words) << lesson.id << ", " << step.title
                             << ": what follows from the answer goes below";
          EXPECT_EQ(words->text.written().find(value), std::string::npos) << lesson.id << ", " << step.title;
        }
      }
}

/// A task of a lesson, and a scene in which it is done.
struct SolvedTask {
  Task task;
  Scene solved;
};

/// In the order of the lesson; the test fails for a task without a solution.
std::vector<SolvedTask> solvedTasks(const Lesson &lesson) {
  std::vector<SolvedTask> all;
  for (const LessonStep &step : lesson.steps)
    for (const Task &task : tasksOf(step)) {
      const Solution *solution = solutionOf(lesson, task);
      if (!solution)
        throw std::out_of_range("no solution for: " + task.instruction.written());
      all.push_back(
          {task, test::edited(lesson.scene, {ChangeObject{solution->entry.name,
                                                          std::get<Object>(solution->entry.content)}})});
    }
  return all;
}

TEST(Content, EveryTask_CanBeDone) {
  for (const Lesson &lesson : library().lessons) {
    const std::vector<SolvedTask> tasks = solvedTasks(lesson);
    for (const SolvedTask &each : tasks)
      EXPECT_TRUE(isDone(each.task, evaluate(each.solved)))
          << lesson.id << ": " << each.task.instruction.written();
    EXPECT_GE(tasks.size(), 2U) << lesson.id;
  }
}

TEST(Content, EveryTask_SaysWhatWasToBeSeenWhenItIsDone) {
  for (const Lesson &lesson : library().lessons)
    for (const LessonStep &step : lesson.steps)
      for (const Task &task : tasksOf(step))
        EXPECT_FALSE(task.answer.isEmpty()) << lesson.id << ": " << task.instruction.written();
}

TEST(Content, EveryLesson_HasFormulasToKeep) {
  const std::set<std::string> without{"photon-torpedo", "misprints"}; // which only use those of others
  for (const Lesson &lesson : library().lessons)
    EXPECT_EQ(std::any_of(lesson.steps.begin(), lesson.steps.end(),
                          [](const LessonStep &step) { return !step.formulas.empty(); }),
              !without.contains(lesson.id))
        << lesson.id;
}

TEST(Content, EveryTask_HasHints) {
  for (const Lesson &lesson : library().lessons)
    for (const LessonStep &step : lesson.steps)
      for (const Task &task : tasksOf(step))
        EXPECT_FALSE(task.hints.empty()) << lesson.id << ": " << task.instruction.written();
}

/// It is not done at the start, or no longer when the task before it is done.
TEST(Content, EveryTask_IsStillToDoWhenItsTurnComes) {
  for (const Lesson &lesson : library().lessons) {
    const Scene *before = &lesson.scene;
    const std::vector<SolvedTask> tasks = solvedTasks(lesson);
    for (const SolvedTask &each : tasks) {
      EXPECT_TRUE(!isDone(each.task, evaluate(lesson.scene)) || !isDone(each.task, evaluate(*before)))
          << lesson.id << ": " << each.task.instruction.written();
      before = &each.solved;
    }
  }
}

/// Words between spaces, of all that is not folded away.
std::size_t wordsOn(const LessonStep &step) {
  std::string text;
  const Overloaded add{[&](const StepWords &words) { text += words.text.written() + " "; },
                       [](const StepLines &) {},
                       [](const StepNote &) {},
                       [](const StepFlight &) {},
                       [](const StepFragments &) {},
                       [](const StepCost &) {},
                       [&](const Task &task) { text += task.instruction.written() + " "; },
                       [&](const Prediction &prediction) {
                         text += prediction.question.written() + " ";
                         for (const Prediction::Choice &choice : prediction.choices)
                           text += choice.text.written() + " ";
                         text += prediction.reason.written() + " ";
                       }};
  for (const StepBlock &block : step.blocks)
    std::visit(add, block);
  std::istringstream words(text);
  return static_cast<std::size_t>(
      std::distance(std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()));
}

/// A page beside the scene, at its usual size, holds about so much.
constexpr std::size_t wordsOnAPage = 175;
constexpr std::size_t linesOnAPage = 4;
constexpr std::size_t lettersOfATitle = 32;

TEST(Content, EveryStep_FitsOnAPage) {
  for (const Lesson &lesson : library().lessons)
    for (const LessonStep &step : lesson.steps) {
      EXPECT_LE(wordsOn(step), wordsOnAPage) << lesson.id << ", " << step.title;
      EXPECT_LE(shownIn(step, evaluate(lesson.scene)).working.lines.size(), linesOnAPage)
          << lesson.id << ", " << step.title;
      EXPECT_LE(step.title.size(), lettersOfATitle) << lesson.id << ", " << step.title;
    }
}

TEST(Content, SecondPointOfASphere_IsNamedOnlyWhereItIs) {
  const Lesson &lesson = *library().find("ray-sphere");
  for (const int height : {10, 12}) { // where the line touches, and where it misses
    Scene scene = lesson.scene;
    setObject(scene, "L", RayObject{{10, 6, height}, {-1, 0, 0}});
    for (const Mark &mark : figureOf(evaluate(scene)).marks)
      EXPECT_EQ(baseOf(mark).label.find("H_2"), std::string::npos) << height;
  }
  for (const LessonWords &words : wordsOf(lesson))
    EXPECT_EQ(words.text.written().find("H_2"), std::string::npos) << words.text.written();
}

} // namespace
} // namespace halfspace
