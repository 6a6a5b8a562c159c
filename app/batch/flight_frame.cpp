#include "app/batch/flight_frame.h"

#include "lessons/lesson/step_of_flight.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/words.h"

#include <string>
#include <utility>

namespace halfspace {
namespace {

/// The name of the scene's number that counts the frames.
const std::string &frameNumberOf(const OpenedSession &opened) {
  return flightOf(*stepOfFlight(opened))->frame;
}

Rational goTo(const Rational &wanted, OpenedSession &opened) {
  Scene &scene = opened.session.scene;
  const std::string &name = frameNumberOf(opened);
  Object number = *findObject(scene, name);
  number[0].x = wanted;
  number.kind().settle(number);
  const Rational frame = number[0].x;
  setObject(scene, name, std::move(number));
  return frame;
}

} // namespace

const LessonStep *stepOfFlight(const OpenedSession &opened) {
  return opened.lesson ? stepOfFlight(*opened.lesson) : nullptr;
}

void goToFirstFrame(OpenedSession &opened) {
  goTo(objectAs<NumberObject>(*findObject(opened.session.scene, frameNumberOf(opened)))->from, opened);
}

Rational goToFrame(int wanted, OpenedSession &opened) { return goTo(wanted, opened); }

std::optional<Problem> refuseFrame(int frame, OpenedSession opened) {
  if (!stepOfFlight(opened))
    return Problem{words("This lesson has no flight whose frames could be drawn."), "", 0, "--frame"};
  const Rational nearest = goToFrame(frame, opened);
  if (nearest == frame)
    return {};
  return Problem{words("The flight has no frame {frame}: the nearest is {nearest}.",
                       {{"frame", std::to_string(frame)}, {"nearest", toText(nearest)}}),
                 "", 0, "--frame"};
}

} // namespace halfspace
