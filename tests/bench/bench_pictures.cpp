// Pictures for files: those of one lesson with other and other numbers, evaluated, drawn and written by a
// painter that lives for all of them, and by bare VTK, in turns. What is opened first (context, window,
// shaders) counts. Then the whole command makes as many, from its start to its end. Takes the number of
// pictures.
#include "lessons/lesson/lesson_start.h"
#include "lessons/scene/file/session_file.h"
#include "tests/bench/durations.h"
#include "tests/bench/figure_to_bare.h"
#include "tests/bench/timed_command.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/design_scale.h"
#include "widgets/scene/egl_context.h"
#include "widgets/scene/offscreen.h"
#include "widgets/scene/png.h"
#include "widgets/scene/render_window.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numeric>

namespace halfspace::bench {
namespace {

constexpr int usualPictures = 50;
constexpr PixelSize size{1600, 1000};
constexpr double pixelRatio = size.height / designHeight;
constexpr int samplesPerPixel = 4;
constexpr double goal = 1.2; ///< times bare VTK

/// The usual way to pictures without a window.
class BarePainter {
public:
  BarePainter() {
    m_context.serve(m_window);
    m_window->SetMultiSamples(samplesPerPixel);
    m_window->SetSize(size.width, size.height);
    m_window->AddRenderer(m_scene.renderer());
  }
  ~BarePainter() {
    m_window->RemoveRenderer(m_scene.renderer());
    m_window->Finalize();
  }
  BarePainter(const BarePainter &) = delete;
  BarePainter &operator=(const BarePainter &) = delete;

  void write(const BarePicture &picture, const Camera &camera, const std::string &file) {
    m_scene.setCamera({camera.eye(), camera.target, Camera::viewAngle});
    m_scene.show(picture);
    m_scene.fitClippingRange();
    m_window->Render();
    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput(m_window);
    image->SetInputBufferTypeToRGBA(); // as ours are
    image->ReadFrontBufferOff();
    image->ShouldRerenderOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(image->GetOutputPort());
    writer->SetFileName(file.c_str());
    writer->Write();
  }

private:
  EglContext m_context;
  vtkNew<RenderWindow> m_window;
  BareScene m_scene;
};

/// One picture of the lesson, seen as it is when a lesson begins.
struct Taken {
  SceneContent content;
  Camera camera;
};

Taken takenOf(const Lesson &lesson, const Scene &scene) {
  const Evaluation evaluation = evaluate(scene);
  Taken taken;
  taken.content.stage = stageOf(scene, boundObjectsOf(scene, evaluation));
  taken.content.figure = toStage(figureOf(evaluation), taken.content.stage);
  taken.camera =
      homeView(lesson.camera, taken.content.figure, taken.content.stage.hasAxes(), size, pixelRatio);
  return taken;
}

/// As the command line gives them.
std::string assignmentOf(int picture) {
  return "Q=" + std::to_string(5 + picture % 7) + "." + std::to_string(picture % 10) + "," +
         std::to_string(8 + picture % 5) + "," + std::to_string(4 + picture % 6);
}

void printLine(const char *what, const Durations &durations) {
  std::printf("  %-52s %8.0f %8.0f %8.0f\n", what, durations.all.front(), durations.median(),
              std::accumulate(durations.all.begin(), durations.all.end(), 0.0));
}

/// What a batch of such pictures takes; nothing where it fails.
std::optional<double> timeOfBatch(const Lesson &lesson, int pictures) {
  const BenchFolder folder("pictures");
  std::ofstream rows(folder.path() / "rows.csv");
  rows << "Q\n";
  for (int i = 0; i < pictures; ++i)
    rows << '"' << assignmentOf(i).substr(2) << "\"\n"; // without its name
  rows.close();
  return timeOfCommand("render " + lesson.id + " --rows rows.csv -o '{row}.png' --size 1600x1000",
                       folder.path());
}

void printRatio(const char *what, double ratio) {
  std::printf("  %-60s %8.2f  %s\n", what, ratio, ratio <= goal ? "met" : "missed");
}

int measure(int pictures) {
  const Lesson lesson = *readLesson(std::filesystem::path(TEST_LESSONS_FOLDER) / "signed-distance.md");
  const Typesetter typesetter;
  const LabelSetter set = labelSetter(typesetter.fonts());
  const LabelPainter paint = labelPainter(typesetter);
  const std::string file = std::filesystem::temp_directory_path() / "halfspace-bench.png";
  std::optional<OffscreenPainter> painter;
  std::optional<BarePainter> bare;
  Durations ours;
  Durations bares;
  for (int i = 0; i < pictures; ++i) {
    auto start = Clock::now();
    if (!painter)
      painter.emplace(set, paint);
    const auto session = withValue(startOf(lesson), assignmentOf(i));
    PictureRequest request;
    const auto [content, camera] = takenOf(lesson, session->scene);
    request.content = content;
    request.camera = camera;
    request.theme = themes().front();
    request.size = size;
    const auto picture = painter->draw(request);
    if (!picture || writePng(*picture, file)) {
      std::puts("a picture could not be drawn and written");
      return 1;
    }
    ours.add(millisecondsSince(start));

    const BarePicture same = bareOf(content, request.theme, {camera, size, pixelRatio}, set, paint);
    start = Clock::now();
    if (!bare)
      bare.emplace();
    bare->write(same, camera, file);
    bares.add(millisecondsSince(start));
  }
  std::filesystem::remove(file);
  std::printf("\n%d pictures of %s, %d x %d pixels\n", pictures, lesson.id.c_str(), size.width, size.height);
  std::printf("  %-52s %8s %8s %8s\n", "milliseconds", "first", "median", "all");
  printLine("evaluated, drawn and written", ours);
  printLine("drawn and written by bare VTK", bares);
  const auto all = [](const Durations &times) {
    return std::accumulate(times.all.begin(), times.all.end(), 0.0);
  };
  const auto batch = timeOfBatch(lesson, pictures);
  if (!batch) {
    std::puts("the command could not make its pictures");
    return 1;
  }
  std::printf("  %-52s %8s %8s %8.0f\n", "by `halfspace render --rows`, start to end", "", "", *batch);
  printRatio("all pictures at most 1.2 x bare VTK", all(ours) / all(bares));
  printRatio("the whole command at most 1.2 x bare VTK", *batch / all(bares));
  return 0;
}

} // namespace
} // namespace halfspace::bench

int main(int argc, char **argv) {
  return halfspace::bench::measure(argc > 1 ? std::max(1, std::atoi(argv[1]))
                                            : halfspace::bench::usualPictures);
}
