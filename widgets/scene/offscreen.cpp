#include "widgets/scene/offscreen.h"

#include "widgets/scene/design_scale.h"
#include "widgets/scene/egl_context.h"
#include "widgets/scene/render_window.h"

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

LabelPicture readPicture(vtkRenderWindow *window, const PictureRequest &request) {
  const auto [width, height] = request.size;
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels);
  LabelPicture picture{width, height, {}};
  const auto rowBytes = static_cast<std::ptrdiff_t>(width) * 4;
  picture.rgba.resize(static_cast<std::size_t>(rowBytes) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) // OpenGL's rows go from bottom to top
    std::copy_n(pixels->GetPointer(0) + (height - 1 - row) * rowBytes, rowBytes,
                picture.rgba.data() + row * rowBytes);
  if (request.transparent)
    divideByAlpha(picture.rgba);
  else
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
      picture.rgba[i] = 255;
  return picture;
}

/// Draws what a renderer shows, in a context of its own that is current in this thread.
Result<LabelPicture> render(vtkRenderer *renderer, const PictureRequest &request) {
  EglContext context;
  if (!context.failure().empty())
    return problem(context.failure());
  vtkNew<RenderWindow> window;
  context.serve(window);
  if (!window->isReady())
    return problem("Pictures cannot be drawn here: the graphics driver offers less than OpenGL 3.2.");
  window->GetState()->Reset();
  window->SetAlphaBitPlanes(1);
  window->SetMultiSamples(samplesPerPixel);
  window->SetSize(request.size.width, request.size.height);
  window->AddRenderer(renderer);
  window->Render();
  LabelPicture picture = readPicture(window, request);
  window->RemoveRenderer(renderer);
  window->Finalize();
  return picture;
}

} // namespace

Result<LabelPicture> drawOffscreen(const PictureRequest &request, const LabelPainter &labels) {
  const auto [width, height] = request.size;
  if (width < 1 || height < 1 || width > maxPictureSide || height > maxPictureSide)
    return problem("A picture of " + inWords(request.size) +
                   " pixels cannot be drawn: each side must be 1 to " + std::to_string(maxPictureSide) +
                   " pixels.");
  FigureScene scene(labels);
  scene.setTheme(request.theme);
  scene.setBackgroundVisible(!request.transparent);
  scene.setContent(request.content);
  scene.setView(request.camera, request.size, height / designHeight);
  scene.prepare();

  // A thread of its own: a context that a live window has current in this one would be in the way.
  Result<LabelPicture> result = problem("");
  std::thread([&] {
    try {
      result = render(scene.renderer(), request);
    } catch (const std::bad_alloc &) {
      result = problem("There is not enough memory for a picture of " + inWords(request.size) + " pixels.");
    }
  }).join();
  return result;
}

} // namespace halfspace
