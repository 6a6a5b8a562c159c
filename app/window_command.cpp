#include "app/window_command.h"

#include "app/commands.h"
#include "app/lesson_files.h"
#include "app/main_window.h"
#include "app/memory.h"
#include "app/subject.h"
#include "lessons/words.h"

#include <QApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <cstdlib>
#include <iostream>

namespace halfspace {
namespace {

constexpr int exitNoDisplay = 2;

/// Qt ends the program by itself when the display cannot be reached; this says why, and ends it in order.
void sayWhyQtGivesUp(QtMsgType type, const QMessageLogContext &, const QString &) {
  if (type != QtFatalMsg)
    return;
  std::cerr << "halfspace: "
            << words("The window needs a display, and none could be opened (DISPLAY or WAYLAND_DISPLAY). The "
                     "commands lessons, explain and render work without one.")
            << "\n";
  std::_Exit(exitNoDisplay);
}

bool displayNamed() {
  return qEnvironmentVariableIsSet("QT_QPA_PLATFORM") || !qEnvironmentVariableIsEmpty("DISPLAY") ||
         !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
}

std::optional<Problem> checkOpenGL() {
  QOpenGLContext context;
  context.setFormat(QSurfaceFormat::defaultFormat());
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  const bool created = context.create();
  surface.create();
  if (!created || !context.makeCurrent(&surface))
    return Problem{words("The window needs OpenGL 3.2, and this display offers none."), "", 0, ""};
  const auto version = context.format().version();
  if (version < qMakePair(3, 2))
    return Problem{words("The window needs OpenGL 3.2; this display offers {version}.",
                         {{"version", std::to_string(version.first) + "." + std::to_string(version.second)}}),
                   "", 0, ""};
  return {};
}

} // namespace

int runWindow(const WindowCommand &command, int argc, char **argv) {
  returnLargeBuffers();
  LessonLibrary library = readLessons(lessonsFolder());
  for (const Problem &problem : library.problems)
    std::cerr << "halfspace: " << problem.text() << "\n";
  const auto subject = openSubject(library, command.subject);
  if (!subject)
    return fail(subject.problem());
  if (!displayNamed())
    return fail(
        {words("The window needs a display, and none is named (DISPLAY or WAYLAND_DISPLAY). The commands "
               "lessons, explain and render work without one."),
         "", 0, ""});

  const bool isFile = namesFile(library, command.subject);
  const Session session = subject->session;
  QCoreApplication::setApplicationName("halfspace");
  QCoreApplication::setApplicationVersion(HALFSPACE_VERSION);
  QCoreApplication::setOrganizationName("halfspace");
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QSurfaceFormat::setDefaultFormat(SceneView::surfaceFormat());

  const auto usualHandler = qInstallMessageHandler(sayWhyQtGivesUp);
  const QApplication application(argc, argv);
  qInstallMessageHandler(usualHandler);
  if (const auto problem = checkOpenGL())
    return fail(*problem);

  MainWindow window(std::move(library));
  window.startWith(session, isFile ? QString::fromStdString(command.subject) : QString());
  if (command.subject.empty())
    window.restoreUnsaved();
  else
    window.offerUnsaved();
  window.showFitting();
  return QApplication::exec();
}

} // namespace halfspace
