#include "lessons/object/object_marks.h"

#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/term/latex.h"

namespace halfspace {
namespace {

/// Makes what the marks of one object have in common.
class ObjectMarks {
public:
  explicit ObjectMarks(const Given<Object> &given) : m_given(given) {}

  std::vector<Mark> operator()(const PointObject &point) const {
    return {PointMark{part(0, Subject::Point), place(point.at)}};
  }

  std::vector<Mark> operator()(const PlaneObject &plane) const {
    std::vector<Mark> marks;
    if (!isZero(plane.normal)) {
      MarkBase patch = whole(Subject::Plane);
      const PlaneTerms terms = termsOf(as<PlaneObject>(m_given));
      patch.label = latexOf(m_given.symbol);
      patch.numbers = "\\colon\\ {" + latexOf(equationOf(terms)) + "}";
      marks.push_back(PlanePatchMark{std::move(patch), place(plane.point), place(plane.normal), {}});
      marks.push_back(ArrowMark{part(1, Subject::Plane), place(plane.point), place(plane.normal), true});
    }
    marks.push_back(PointMark{part(0, Subject::Plane), place(plane.point)});
    return marks;
  }

  std::vector<Mark> operator()(const RayObject &ray) const {
    std::vector<Mark> marks;
    if (!isZero(ray.direction)) {
      marks.push_back(RayMark{whole(Subject::Ray), place(ray.origin), unitOf(ray.direction)});
      marks.push_back(ArrowMark{part(1, Subject::Ray), place(ray.origin), place(ray.direction), true});
    }
    marks.push_back(PointMark{part(0, Subject::Point), place(ray.origin)});
    return marks;
  }

  std::vector<Mark> operator()(const TriangleObject &triangle) const {
    std::vector<Mark> marks;
    if (!isZero(cross(triangle.p1 - triangle.p0, triangle.p2 - triangle.p0)))
      marks.push_back(PolygonMark{whole(Subject::Triangle),
                                  {place(triangle.p0), place(triangle.p1), place(triangle.p2)}});
    marks.push_back(PointMark{part(0, Subject::Triangle), place(triangle.p0)});
    marks.push_back(PointMark{part(1, Subject::Triangle), place(triangle.p1)});
    marks.push_back(PointMark{part(2, Subject::Triangle), place(triangle.p2)});
    return marks;
  }

private:
  [[nodiscard]] MarkBase whole(Subject subject) const { return {m_given.id, Role::Given, subject}; }
  [[nodiscard]] MarkBase part(std::size_t index, Subject subject) const {
    return {coordinateId(m_given.id, coordinatesOf(m_given.object)[index]), Role::Given, subject,
            latexOf(m_given.letters[index])};
  }

  const Given<Object> &m_given;
};

} // namespace

std::vector<Mark> marksOf(const Given<Object> &given) { return std::visit(ObjectMarks(given), given.object); }

} // namespace halfspace
