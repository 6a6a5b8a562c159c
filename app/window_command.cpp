#include "app/window_command.h"

#include "app/commands.h"
#include "app/lesson_files.h"
#include "app/main_window.h"
#include "app/subject.h"

#include <QApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QScreen>
#include <QSettings>
#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace halfspace {
namespace {

constexpr int exitNoDisplay = 2;

/// Screens higher than this at the usual dot density are made for larger type and lines.
constexpr double usualScreenHeight = 1080;
constexpr double largestScale = 2.5;

/// Qt ends the program by itself when the display cannot be reached; this says why, and ends it in order.
void sayWhyQtGivesUp(QtMsgType type, const QMessageLogContext &, const QString &message) {
  if (type != QtFatalMsg)
    return;
  std::cerr << "halfspace: The window needs a display, and none could be opened (DISPLAY or "
               "WAYLAND_DISPLAY). The commands lessons, explain and render work without one.\n";
  static_cast<void>(message);
  std::_Exit(exitNoDisplay);
}

bool displayNamed() {
  return qEnvironmentVariableIsSet("QT_QPA_PLATFORM") || !qEnvironmentVariableIsEmpty("DISPLAY") ||
         !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
}

/// Large screens that do not say so themselves (many dots, usual density) get a scale, found once and
/// remembered.
void chooseScale(int argc, char **argv) {
  if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR"))
    return;
  QSettings settings;
  if (!settings.contains("scale")) {
    const QGuiApplication probe(argc, argv);
    const QScreen *screen = QGuiApplication::primaryScreen();
    const bool plain = screen->devicePixelRatio() == 1 && screen->logicalDotsPerInch() < 120;
    const double scale = plain ? screen->size().height() / usualScreenHeight : 1;
    settings.setValue("scale", std::clamp(std::floor(scale * 4) / 4, 1.0, largestScale));
  }
  const double scale = settings.value("scale").toDouble();
  if (scale > 1)
    qputenv("QT_SCALE_FACTOR", QByteArray::number(std::clamp(scale, 1.0, largestScale)));
}

std::optional<Problem> checkOpenGL() {
  QOpenGLContext context;
  context.setFormat(QSurfaceFormat::defaultFormat());
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  const bool created = context.create();
  surface.create();
  if (!created || !context.makeCurrent(&surface))
    return Problem{"The window needs OpenGL 3.2, and this display offers none.", "", 0, ""};
  const auto version = context.format().version();
  if (version < qMakePair(3, 2))
    return Problem{"The window needs OpenGL 3.2; this display offers " + std::to_string(version.first) + "." +
                       std::to_string(version.second) + ".",
                   "", 0, ""};
  return {};
}

} // namespace

int runWindow(const WindowCommand &command, int argc, char **argv) {
  LessonLibrary library = readLessons(lessonsFolder());
  for (const Problem &problem : library.problems)
    std::cerr << "halfspace: " << problem.text() << "\n";
  const auto subject = openSubject(library, command.subject);
  if (!subject)
    return fail(subject.problem());
  if (!displayNamed())
    return fail({"The window needs a display, and none is named (DISPLAY or WAYLAND_DISPLAY). The commands "
                 "lessons, explain and render work without one.",
                 "", 0, ""});

  const bool isFile = namesFile(library, command.subject);
  const Session session = subject->session;
  QCoreApplication::setApplicationName("halfspace");
  QCoreApplication::setApplicationVersion(HALFSPACE_VERSION);
  QCoreApplication::setOrganizationName("halfspace");
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0); // VTK smooths by itself
  QSurfaceFormat::setDefaultFormat(format);

  const auto usualHandler = qInstallMessageHandler(sayWhyQtGivesUp);
  chooseScale(argc, argv);
  const QApplication application(argc, argv);
  qInstallMessageHandler(usualHandler);
  if (const auto problem = checkOpenGL())
    return fail(*problem);

  MainWindow window(std::move(library));
  window.startWith(session, isFile ? QString::fromStdString(command.subject) : QString());
  if (command.subject.empty())
    window.restoreUnsaved();
  window.showFitting();
  return QApplication::exec();
}

} // namespace halfspace
