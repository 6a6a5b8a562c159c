#include "widgets/scene/offscreen.h"

#include "lessons/words.h"
#include "widgets/picture/design_scale.h"
#include "widgets/scene/egl_context.h"
#include "widgets/scene/render_window.h"
#include "widgets/scene/vtk_image.h"

#include <vtkNew.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <new>
#include <thread>

namespace halfspace {
namespace {

constexpr int samplesPerPixel = 4;

/// Larger pictures are drawn in strips: a driver answers buffers beyond its limits with an empty picture, not
/// an error.
constexpr int mostPixelsAtOnce = 4096 * 4096;

Problem problem(std::string sentence) { return {std::move(sentence), {}, 0, {}}; }

std::string inWords(PixelSize size) {
  return std::to_string(size.width) + " × " + std::to_string(size.height);
}

/// On a black background with alpha 0 what is drawn comes out multiplied by its alpha: this divides it again.
void divideByAlpha(std::vector<std::uint8_t> &rgba) {
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const unsigned alpha = rgba[i + 3];
    if (alpha == 0 || alpha == 255)
      continue;
    for (std::size_t c = i; c < i + 3; ++c)
      rgba[c] = static_cast<std::uint8_t>(std::min(255U, (rgba[c] * 255U + alpha / 2) / alpha));
  }
}

/// Copies what the window shows into the rows of a picture from `top` on.
void readStrip(vtkRenderWindow *window, LabelPicture &picture, int top, int height) {
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, picture.width - 1, height - 1, 0, pixels);
  const auto bytesAbove = static_cast<std::ptrdiff_t>(top) * picture.width * 4;
  copyUpsideDown(pixels->GetPointer(0), picture.rgba.data() + bytesAbove, picture.width, height);
}

void finishAlpha(std::vector<std::uint8_t> &rgba, bool transparent) {
  if (transparent)
    return divideByAlpha(rgba);
  for (std::size_t i = 3; i < rgba.size(); i += 4)
    rgba[i] = 255;
}

/// Draws a scene strip by strip, in a context of its own that is current in this thread.
Result<LabelPicture> render(FigureScene &scene, const PictureRequest &request) {
  EglContext context;
  if (!context.failure().empty())
    return problem(context.failure());
  vtkNew<RenderWindow> window;
  context.serve(window);
  if (!window->isReady())
    return problem(words("Pictures cannot be drawn here: the graphics driver offers less than OpenGL 3.2."));
  window->GetState()->Reset();
  window->SetAlphaBitPlanes(1);
  window->SetMultiSamples(samplesPerPixel);
  window->AddRenderer(scene.renderer());

  const auto [width, height] = request.size;
  LabelPicture picture{width, height, {}};
  picture.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  const int highestStrip = std::max(1, mostPixelsAtOnce / width);
  for (int top = 0; top < height; top += highestStrip) {
    const int stripHeight = std::min(highestStrip, height - top);
    scene.showStrip(top, stripHeight);
    window->SetSize(width, stripHeight);
    window->Render();
    readStrip(window, picture, top, stripHeight);
  }
  window->RemoveRenderer(scene.renderer());
  window->Finalize();
  finishAlpha(picture.rgba, request.transparent);
  return picture;
}

} // namespace

Result<LabelPicture> drawOffscreen(const PictureRequest &request, const LabelPainter &labels) {
  const auto [width, height] = request.size;
  if (width < 1 || height < 1 || width > maxPictureSide || height > maxPictureSide)
    return problem(words("A picture of {size} pixels cannot be drawn: each side must be 1 to {most} pixels.",
                         {{"size", inWords(request.size)}, {"most", std::to_string(maxPictureSide)}}));
  FigureScene scene(labels);
  scene.setTheme(request.theme);
  scene.setBackgroundVisible(!request.transparent);
  scene.setView({request.camera, request.size, request.pixelRatio.value_or(height / designHeight)});
  if (request.labelledLike) {
    scene.setContent(*request.labelledLike);
    scene.prepare();
  }
  scene.setContent(request.content);
  scene.prepare();

  // A thread of its own: a context that a live window has current in this one would be in the way.
  Result<LabelPicture> result = problem("");
  std::thread([&] {
    try {
      result = render(scene, request);
    } catch (const std::bad_alloc &) {
      result = problem(words("There is not enough memory for a picture of {size} pixels.",
                             {{"size", inWords(request.size)}}));
    }
  }).join();
  return result;
}

} // namespace halfspace
