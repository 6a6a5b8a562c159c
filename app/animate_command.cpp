// A scene in motion, in a file.
#include "app/commands.h"
#include "app/progress_line.h"
#include "app/standard_streams.h"
#include "lessons/files/held_signals.h"
#include "lessons/lesson/nearest_step.h"
#include "lessons/words.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/shapes/surface_layers.h"

#include <memory>

namespace halfspace {
namespace {

/// The scene of a session, or that its lesson does not have the step that is asked for.
Result<AnimatedScene> sceneOf(const AnimateCommand &command, const OpenedSession &opened) {
  AnimatedScene scene;
  if (opened.lesson)
    scene.lesson = std::make_shared<const Lesson>(*opened.lesson);
  scene.scene = opened.session.scene;
  scene.size = command.film.size;
  if (opened.session.view)
    scene.camera = cameraOf(*opened.session.view);
  const int steps = opened.lesson ? static_cast<int>(opened.lesson->steps.size()) : 0;
  if (command.step && (*command.step < 1 || *command.step > steps))
    return Problem{words("The lesson has {count} steps.", {{"count", std::to_string(steps)}}), "", 0,
                   "--step"};
  if (command.step)
    scene.step = *command.step - 1;
  else if (opened.lesson && opened.origin != OpenedSession::Origin::Lesson && !command.motion->choosesSteps)
    scene.step = nearestStep(*opened.lesson, opened.session.step);
  return scene;
}

Result<Filmed> filmOf(Motion &motion, const AnimateCommand &command) {
  ProgressLine progress;
  return film(motion, *command.format, command.film,
              {[] { return HeldSignals::isOneWaiting(); },
               [&](int picture, int all) {
                 progress.say(words("Picture {number} of {count}",
                                    {{"number", std::to_string(picture)}, {"count", std::to_string(all)}}));
               }});
}

} // namespace

int runAnimate(const AnimateCommand &command) {
  LessonLibrary library;
  const auto opened = openSubject(library, command.subject, command.ownLessons, command.assignments);
  if (!opened)
    return fail(opened.problem());
  const auto scene = sceneOf(command, *opened);
  if (!scene)
    return fail(scene.problem());
  const auto motion = command.motion->make(*scene, command.seconds);
  if (!motion)
    return fail(motion.problem());
  const HeldSignals untilAllIsPutAway; // then one that came ends the program
  const auto filmed = filmOf(**motion, command);
  if (HeldSignals::isOneWaiting())
    return exitRefused;
  if (!filmed)
    return fail(filmed.problem());
  if (filmed->leavesOutSurfaces)
    printError(overfullWords());
  return 0;
}

} // namespace halfspace
