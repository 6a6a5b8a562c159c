#include "app/commands.h"
#include "app/eval_command.h"
#include "app/last_words.h"
#include "app/standard_streams.h"
#include "app/user_language.h"
#include "app/window_command.h"

#include <csignal>

namespace {

using namespace halfspace;

int run(const Command &command, int argc, char **argv) {
  return std::visit(Overloaded{[&](const WindowCommand &window) { return runWindow(window, argc, argv); },
                               [](const LessonsCommand &lessons) { return runLessons(lessons); },
                               [](const NewLessonCommand &lesson) { return runNewLesson(lesson); },
                               [](const ConstructionsCommand &) { return runConstructions(); },
                               [](const CheckCommand &check) { return runCheck(check); },
                               [](const ExplainCommand &explain) { return runExplain(explain); },
                               [](const RenderCommand &render) { return runRender(render); },
                               [](const HandoutCommand &handout) { return runHandout(handout); },
                               [](const AnimateCommand &animate) { return runAnimate(animate); },
                               [](const ReadMeshCommand &mesh) { return runReadMesh(mesh); },
                               [](const CompleteCommand &complete) { return runComplete(complete); },
                               [](const EvalCommand &eval) { return runEval(eval); },
                               [](const PrintCommand &print) {
                                 return print.refused ? fail({print.text, "", 0, ""}) : printOut(print.text);
                               }},
                    command);
}

} // namespace

int main(int argc, char **argv) {
  halfspace::holdStandardStreams();
  halfspace::setUserLanguage();
  std::signal(SIGXFSZ, SIG_IGN); // a file that would be larger than it may be is a failure to be told
  try {
    return run(halfspace::parseCommandLine(argc, argv), argc, argv);
  } catch (const std::exception &exception) {
    halfspace::printError(halfspace::lastWordsOn(exception));
    return halfspace::exitRefused;
  }
}
