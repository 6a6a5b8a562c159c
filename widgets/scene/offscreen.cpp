#include "widgets/scene/offscreen.h"

#include "lessons/words.h"
#include "widgets/picture/composer.h"
#include "widgets/picture/design_scale.h"
#include "widgets/scene/egl_context.h"
#include "widgets/scene/render_window.h"
#include "widgets/scene/shape_scene.h"
#include "widgets/scene/vtk_image.h"

#include <vtkNew.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <new>
#include <utility>

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
void readStrip(vtkRenderWindow *window, RgbaImage &picture, int top, int height) {
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

} // namespace

/// What draws, with the context that it draws in: current in the thread that made it.
class OffscreenPainter::Studio {
public:
  Studio(LabelSetter set, LabelPainter labels) : m_composer(std::move(set)), m_scene(std::move(labels)) {
    if (!m_context.failure().empty())
      return;
    m_context.serve(m_window);
    if (!m_window->isReady())
      return;
    m_window->GetState()->Reset();
    m_window->SetAlphaBitPlanes(1);
    m_window->SetMultiSamples(samplesPerPixel);
    m_window->AddRenderer(m_scene.renderer());
  }
  ~Studio() {
    if (!failure().empty())
      return; // nothing was opened
    m_window->RemoveRenderer(m_scene.renderer());
    m_window->Finalize();
  }
  Studio(const Studio &) = delete;
  Studio &operator=(const Studio &) = delete;

  /// A sentence that says why nothing can be drawn; empty where it can.
  [[nodiscard]] std::string failure() const {
    if (!m_context.failure().empty() || m_window->isReady())
      return m_context.failure();
    return words("Pictures cannot be drawn here: the graphics driver offers less than OpenGL 3.2.");
  }

  [[nodiscard]] DrawnPicture draw(const PictureRequest &request) {
    const ShapeList &shapes = compose(request);
    m_scene.show(shapes);
    const auto [width, height] = request.size;
    DrawnPicture picture{{width, height, {}}, shapes.leavesOutSurfaces};
    picture.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    const int highestStrip = std::max(1, mostPixelsAtOnce / width);
    for (int top = 0; top < height; top += highestStrip) {
      const int stripHeight = std::min(highestStrip, height - top);
      m_scene.showStrip(top, stripHeight);
      m_window->SetSize(width, stripHeight);
      m_window->Render();
      readStrip(m_window, picture, top, stripHeight);
    }
    finishAlpha(picture.rgba, request.transparent);
    return picture;
  }

  /// The shapes of a picture; valid until it is called again.
  const ShapeList &compose(const PictureRequest &request) {
    const double usualRatio = ownPixelRatio(request.size);
    if (!request.isLabelledLikeLast)
      m_composer.forgetLabels();
    m_composer.setTheme(request.theme);
    m_composer.setBackgroundVisible(!request.transparent);
    m_composer.setView({request.camera, request.size, request.pixelRatio.value_or(usualRatio)});
    if (request.labelledLike) {
      m_composer.setContent(*request.labelledLike);
      m_composer.compose();
    }
    m_composer.setContent(request.content);
    return m_composer.compose();
  }

private:
  EglContext m_context; // the first: the others end in it
  vtkNew<RenderWindow> m_window;
  Composer m_composer;
  ShapeScene m_scene;
};

OffscreenPainter::OffscreenPainter(LabelSetter set, LabelPainter labels)
    : m_set(std::move(set)), m_labels(std::move(labels)) {}

OffscreenPainter::~OffscreenPainter() {
  m_thread.run([this] { m_studio.reset(); });
}

Result<DrawnPicture> OffscreenPainter::draw(const PictureRequest &request) {
  const auto [width, height] = request.size;
  if (width < 1 || height < 1 || width > maxPictureSide || height > maxPictureSide)
    return problem(words("A picture of {size} pixels cannot be drawn: each side must be 1 to {most} pixels.",
                         {{"size", inWords(request.size)}, {"most", std::to_string(maxPictureSide)}}));
  Result<DrawnPicture> result = problem("");
  try {
    m_thread.run([&] {
      if (const auto lack = openStudio())
        result = *lack;
      else
        result = m_studio->draw(request);
    });
  } catch (const std::bad_alloc &) {
    m_thread.run([this] { m_studio.reset(); });
    return problem(words("There is not enough memory for a picture of {size} pixels.",
                         {{"size", inWords(request.size)}}));
  }
  return result;
}

void OffscreenPainter::arrange(const PictureRequest &request) {
  m_thread.run([&] {
    if (!openStudio())
      m_studio->compose(request);
  });
}

std::optional<Problem> OffscreenPainter::openStudio() {
  if (m_studio)
    return {};
  auto studio = std::make_unique<Studio>(m_set, m_labels);
  if (const std::string failure = studio->failure(); !failure.empty())
    return problem(failure);
  m_studio = std::move(studio);
  return {};
}

} // namespace halfspace
