#include "lessons/object/bound_point.h"

namespace halfspace {
namespace {

enum Lambda : std::uint8_t { LambdaItself };
enum Host : std::uint8_t { Start, Direction };

std::optional<ExactVec3> placeByLambda(const Object &bound, const Object &host) {
  return host[Start] + host[Direction] * bound[LambdaItself].x;
}

Object nearestByLambda(Object bound, const Object &host, const ExactVec3 &place) {
  const ExactVec3 &direction = host[Direction];
  if (!isZero(direction))
    bound[LambdaItself].x = dot(place - host[Start], direction) / dot(direction, direction);
  return bound;
}

Object lambdaOnGrid(Object bound, const Object &host, const Rational &step) {
  const Rational squaredLength = dot(host[Direction], host[Direction]);
  bound[LambdaItself].x = roundToMultiple(bound[LambdaItself].x, freedomStep(step, squaredLength));
  return bound;
}

void guideAlong(const Object &host, Handle &handle) { handle.axis = host[Direction]; }

} // namespace

Kind boundPoint(std::string_view word, std::string (*noun)(), std::string_view meaning,
                std::vector<CoordinateSpec> freedoms, void (*settle)(Object &), const Binding &binding) {
  return {.word = word,
          .noun = noun,
          .meaning = meaning,
          .subject = Subject::Point,
          .coordinates = std::move(freedoms),
          .leavableVertices = 0,
          .shape = {},
          .binding = binding,
          .settle = settle,
          .draw = drawNothing, // what looks at it looks at a point, and draws that
          .ownHandles = noHandles,
          .offer = offerNothing,
          .aim = aimAtNothing};
}

Binding bindingByLambda(std::string_view host) {
  return {.host = host,
          .placeOf = placeByLambda,
          .nearest = nearestByLambda,
          .onGrid = lambdaOnGrid,
          .guide = guideAlong};
}

Handle boundHandle(const std::string &name, const Object &bound, const Object &host, const ExactVec3 &at) {
  Handle handle;
  handle.id = name;
  handle.object = name;
  handle.motion = Handle::Motion::OnHost;
  handle.at = at;
  handle.host = std::make_shared<const Object>(host);
  bound.kind().binding->guide(host, handle);
  return handle;
}

Rational freedomStep(const Rational &gridStep, const Rational &squaredLength) {
  const auto isFineEnough = [&](const Rational &step) {
    return step * step * squaredLength <= gridStep * gridStep * 4;
  };
  for (Rational decimal = 1; decimal > finestFreedom; decimal /= 10)
    for (const Rational &step : {decimal, Rational(decimal / 2), Rational(decimal / 4)})
      if (isFineEnough(step))
        return step;
  return finestFreedom;
}

} // namespace halfspace
