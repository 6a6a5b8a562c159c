// The program's window, started as the program starts it, until its first frame is shown: ./bench_start runs
// it.
#include "app/main_window.h"
#include "app/open_session.h"
#include "app/settings.h"
#include "tests/bench/first_frame.h"
#include "widgets/view/scene_view.h"

#include <QApplication>
#include <QStandardPaths>

using namespace halfspace;

int main(int argc, char **argv) {
  if (argc < 2)
    return 1;
  LessonLibrary library = readLessons(TEST_LESSONS_FOLDER);
  const auto opened = openSession(library, library.lessons.front().id);
  if (!opened)
    return 1;
  const Session session = opened->session;
  QStandardPaths::setTestModeEnabled(true);
#if QT_VERSION_MAJOR < 6 // which always does so
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  const QApplication application(argc, argv);
  MainWindow window(std::move(library), session, readSettings(settingsFile()));
  bench::reportFirstFrame(window.sceneView(), argv[1]);
  window.show();
  return QApplication::exec();
}
