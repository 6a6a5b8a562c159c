#include "lessons/object/object_marks.h"

#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/term/latex.h"

namespace halfspace {
namespace {

/// Makes what the marks of one object have in common.
class ObjectMarks {
public:
  explicit ObjectMarks(const std::string &name) : m_name(name) {}

  std::vector<Mark> operator()(const PointObject &point) const {
    return {PointMark{whole(Subject::Point, latexOf(symbolOf(m_name))), place(point.at)}};
  }

  std::vector<Mark> operator()(const PlaneObject &plane) const {
    std::vector<Mark> marks{PointMark{part("P0", "P_0", Subject::Plane), place(plane.point)}};
    if (isZero(plane.normal))
      return marks;
    marks.push_back(PlanePatchMark{
        whole(Subject::Plane, latexOf(symbolOf(m_name))), place(plane.point), place(plane.normal), {}});
    marks.push_back(
        ArrowMark{part("n", "\\vec n", Subject::Plane), place(plane.point), place(plane.normal), true});
    return marks;
  }

  std::vector<Mark> operator()(const RayObject &ray) const {
    std::vector<Mark> marks{PointMark{part("Q", "Q", Subject::Ray), place(ray.origin)}};
    if (isZero(ray.direction))
      return marks;
    marks.push_back(RayMark{whole(Subject::Ray, ""), place(ray.origin), unitOf(ray.direction)});
    marks.push_back(
        ArrowMark{part("r", "\\vec r", Subject::Ray), place(ray.origin), place(ray.direction), true});
    return marks;
  }

  std::vector<Mark> operator()(const TriangleObject &triangle) const {
    return {PolygonMark{whole(Subject::Triangle, latexOf(symbolOf(m_name))),
                        {place(triangle.p0), place(triangle.p1), place(triangle.p2)}},
            PointMark{part("P0", "P_0", Subject::Triangle), place(triangle.p0)},
            PointMark{part("P1", "P_1", Subject::Triangle), place(triangle.p1)},
            PointMark{part("P2", "P_2", Subject::Triangle), place(triangle.p2)}};
  }

private:
  std::string id() const { return "object:" + m_name; }
  MarkBase whole(Subject subject, std::string label) const {
    return {id(), Role::Given, subject, std::move(label)};
  }
  MarkBase part(const char *coordinate, std::string label, Subject subject) const {
    return {id() + "." + coordinate, Role::Given, subject, std::move(label)};
  }

  const std::string &m_name;
};

} // namespace

std::vector<Mark> marksOf(const std::string &name, const Object &object) {
  return std::visit(ObjectMarks(name), object);
}

} // namespace halfspace
