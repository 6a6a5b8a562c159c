// The commands that need no display.
#pragma once

#include "app/command_line.h"
#include "app/open_session.h"

namespace halfspace {

/// Each returns the program's exit status: 0, exitRefused after a sentence on standard error, or what it
/// says.
[[nodiscard]] int runLessons(const LessonsCommand &command);
[[nodiscard]] int runExplain(const ExplainCommand &command);
[[nodiscard]] int runRender(const RenderCommand &command);
/// A signal that comes meanwhile ends the program, once nothing unfinished is left.
[[nodiscard]] int runAnimate(const AnimateCommand &command);

[[nodiscard]] int runHandout(const HandoutCommand &command);

/// Writes a lesson file that `check` finds nothing wrong with; one that is there already stays as it is.
[[nodiscard]] int runNewLesson(const NewLessonCommand &command);

/// Prints what authors of lessons need to know of all constructions.
[[nodiscard]] int runConstructions();

/// Reads a stranger's mesh file with bounds on this process, and writes it to standard output as a
/// `MeshDecoder` takes it.
[[nodiscard]] int runReadMesh(const ReadMeshCommand &command);

/// Prints what kind of files may stand there as well, as bash's `compgen -A` calls it (an empty line: none),
/// and then a line for each word.
[[nodiscard]] int runComplete(const CompleteCommand &command);

/// Writes a line on standard output for each problem; the exit status is then exitProblems, where there is
/// none 0, and exitRefused after a sentence on standard error where the lines cannot be written.
[[nodiscard]] int runCheck(const CheckCommand &command);

/// Opens what a command names, with the one lesson that it needs, where that is one of the program's or a
/// file of its own, else among the program's lessons and a teacher's own; and gives coordinates their values.
/// What is wrong with some lessons is told on standard error; the others serve. `library` is empty before,
/// and has the lessons from then on.
[[nodiscard]] Result<OpenedSession> openSubject(LessonLibrary &library, const std::string &subject,
                                                const OwnLessons &own,
                                                const std::vector<std::string> &assignments);

} // namespace halfspace
