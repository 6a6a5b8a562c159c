#include "app/window_command.h"

#include "app/application.h"
#include "app/lessons_folder.h"
#include "app/main_window.h"
#include "app/memory.h"
#include "app/open_session.h"
#include "app/settings.h"
#include "app/standard_streams.h"
#include "app/termination.h"
#include "app/user_language.h"
#include "lessons/words.h"
#include "widgets/view/scene_view.h"

#include <QIcon>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QTimer>

#include <csignal>
#include <cstdlib>

namespace halfspace {
namespace {

/// Qt ends the program by itself when the display cannot be reached; this says why, and ends it in order.
void sayWhyQtGivesUp(QtMsgType type, const QMessageLogContext &, const QString &) {
  if (type != QtFatalMsg)
    return;
  printError(words("The window needs a display, and none could be opened (DISPLAY or WAYLAND_DISPLAY). The "
                   "commands lessons, check, explain and render work without one."));
  std::_Exit(exitRefused);
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

QIcon programIcon() {
  QIcon icon;
  for (const int size : {32, 64, 128, 256})
    icon.addFile(QString(":/icon/halfspace-%1.png").arg(size));
  return icon;
}

/// The file that Save writes; null for a name that cannot be told, for a lesson and for a picture: Save asks.
std::shared_ptr<const KnownFile> fileOf(const OpenedSession &opened, const WindowCommand &command) {
  const bool isFiles = opened.origin == OpenedSession::Origin::SessionFile;
  const auto path = isFiles ? absolutePathOf(*command.subject) : std::nullopt;
  return path ? std::make_shared<KnownFile>(KnownFile{*path, opened.text, opened.session.lesson}) : nullptr;
}

/// The window on a session. A file that cannot be opened is told about in the window: who clicked on it sees
/// no terminal.
int showWindow(LessonLibrary library, const OpenedSession &opened, const std::optional<Problem> &problem,
               const Result<Settings> &settings, const WindowCommand &command, Application &application) {
  MainWindow window(std::move(library), opened.session, settings, fileOf(opened, command));
  application.setLastDeed([&] { window.endWithoutQuestions(); });
  const Termination termination(
      [&](int signal) {
        window.endWithoutQuestions();
        QApplication::exit(statusAfterSignal(signal));
      },
      [&](int signal) {
        window.endWhileBusy();
        std::_Exit(statusAfterSignal(signal)); // nothing else of the program can be relied on
      });
  // Not with the last window: a message that comes a moment later must not keep the program alone.
  QApplication::setQuitOnLastWindowClosed(false);
  QObject::connect(&window, &MainWindow::closed, &window, [] { QApplication::exit(); });
  window.showFitting();
  // Questions belong into the event loop: a signal that comes meanwhile ends the program all the same.
  QTimer::singleShot(0, &window, [&] {
    window.tellPutAside();
    if (problem)
      window.complain(QString::fromStdString(problem->text()));
    if (!command.subject)
      window.leftovers().restoreNewest();
    else
      window.leftovers().offer();
    if (command.mesh)
      window.meshes().open(QString::fromStdString(*command.mesh));
  });
  const int status = QApplication::exec();
  application.setLastDeed({});
  return status;
}

/// Those of the command line, and behind them those of the settings.
OwnLessons ownLessonsOf(const WindowCommand &command, const Result<Settings> &settings) {
  OwnLessons folders = command.ownLessons;
  if (settings)
    for (const QString &folder : settings->ownLessons)
      folders.push_back(folder.toStdString());
  return folders;
}

} // namespace

int runWindow(const WindowCommand &command, int argc, char **argv) {
  returnLargeBuffers();
  QCoreApplication::setApplicationName("halfspace");
  QCoreApplication::setApplicationVersion(HALFSPACE_VERSION);
  QCoreApplication::setOrganizationName("halfspace");
  const auto settings = readSettings(settingsFile());
  LessonLibrary library = allLessons(ownLessonsOf(command, settings));
  for (const Problem &problem : library.problems)
    printError(problem.text());
  const std::string firstLesson = library.lessons.empty() ? "" : library.lessons.front().id;
  auto opened = openSession(library, command.subject.value_or(firstLesson));
  std::optional<Problem> problem;
  if (!opened) {
    problem = opened.problem();
    printError(problem->text());
    if (!command.subject || !namesFile(library, *command.subject) || !displayNamed())
      return exitRefused;
    opened = openSession(library, firstLesson);
    if (!opened)
      return fail(opened.problem());
  }
  if (!displayNamed())
    return fail(
        {words("The window needs a display, and none is named (DISPLAY or WAYLAND_DISPLAY). The commands "
               "lessons, check, explain and render work without one."),
         "", 0, ""});

  // Writing to a pipe that nobody reads any more is a failure to be told, not the end of the window.
  std::signal(SIGPIPE, SIG_IGN);
#if QT_VERSION_MAJOR < 6 // which always does so
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  QSurfaceFormat::setDefaultFormat(SceneView::surfaceFormat());

  const auto usualHandler = qInstallMessageHandler(sayWhyQtGivesUp);
  Application application(argc, argv);
  qInstallMessageHandler(usualHandler);
  translateWindows(application);
  QApplication::setWindowIcon(programIcon());
  QGuiApplication::setDesktopFileName("halfspace");
  if (const auto missing = checkOpenGL())
    return fail(*missing);
  return showWindow(std::move(library), *opened, problem, settings, command, application);
}

} // namespace halfspace
