// GIF, which every program shows: one palette for all pictures, of which each holds what has changed.
#include "lessons/files/write_file.h"
#include "lessons/words.h"
#include "widgets/animation/animation_format.h"
#include "widgets/animation/palette.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace {
namespace {

/// Delays are told in these parts of a second.
constexpr int delaysPerSecond = 100;
/// Viewers take shorter delays for a mistake, and wait for a tenth of a second.
constexpr int shortestDelay = 2;

/// As many as a number of a pixel can tell; the last one stands for what is seen through.
constexpr int paletteSize = 256;
constexpr GifPixelType clear = paletteSize - 1;

constexpr int previews = 16;

/// The numbers of a picture's colours, by rows.
using Indices = std::vector<GifPixelType>;

/// The part of a picture that changes.
struct Part {
  int left = 0;
  int top = 0;
  int width = 1; ///< no picture is empty
  int height = 1;
};

/// Around all pixels that are not the same.
Part changedPart(const Indices &before, const Indices &now, PixelSize size) {
  int left = size.width;
  int right = -1;
  int top = size.height;
  int bottom = -1;
  for (int y = 0; y < size.height; ++y) {
    const auto row = static_cast<std::ptrdiff_t>(y) * size.width;
    for (int x = 0; x < size.width; ++x)
      if (before[static_cast<std::size_t>(row + x)] != now[static_cast<std::size_t>(row + x)]) {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = y;
      }
  }
  return right < 0 ? Part{} : Part{left, top, right - left + 1, bottom - top + 1};
}

class GifEncoder : public Encoder {
public:
  GifEncoder(const EncodingRequest &request, UnfinishedFile file)
      : m_request(request), m_file(std::move(file)), m_samples(previews) {}
  ~GifEncoder() override { static_cast<void>(close()); }

  void preview(const RgbaImage &picture) override { m_samples.add(picture); }

  [[nodiscard]] std::optional<Problem> add(const RgbaImage &picture) override {
    if (!m_gif && !open())
      return problem();
    Indices now = indicesOf(picture);
    // What was drawn before stays, unless what is seen through it is to be seen.
    const bool isWhole = m_shown.empty() || m_request.isTransparent;
    const Part part = isWhole ? Part{0, 0, m_request.size.width, m_request.size.height}
                              : changedPart(m_shown, now, m_request.size);
    const bool isWritten = writeDelay() && writePart(part, now, isWhole);
    m_shown = std::move(now);
    if (!isWritten || m_problem)
      return problem();
    return {};
  }

  [[nodiscard]] std::optional<Problem> finish() override {
    if (!close() || m_problem)
      return problem();
    return m_file.finish();
  }

private:
  static int writeBytes(GifFileType *gif, const GifByteType *bytes, int count) {
    auto &self = *static_cast<GifEncoder *>(gif->UserData);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): files are chars.
    const std::string_view part(reinterpret_cast<const char *>(bytes), static_cast<std::size_t>(count));
    if (!self.m_problem) // the library does not ask each time whether all was written
      self.m_problem = self.m_file.write(part);
    return self.m_problem ? 0 : count;
  }

  /// The file's head: size, palette, and that it begins anew behind its end.
  [[nodiscard]] bool open() {
    m_palette.emplace(m_samples, paletteSize - 1);
    m_gif = EGifOpen(this, writeBytes, nullptr);
    if (!m_gif)
      return false;
    std::array<GifColorType, paletteSize> colors{};
    const std::vector<Color> &chosen = m_palette->colors();
    std::transform(chosen.begin(), chosen.end(), colors.begin(), [](Color color) {
      return GifColorType{color.red, color.green, color.blue};
    });
    ColorMapObject *map = GifMakeMapObject(paletteSize, colors.data());
    EGifSetGifVersion(m_gif, true);
    const bool isWritten = map && EGifPutScreenDesc(m_gif, m_request.size.width, m_request.size.height,
                                                    map->BitsPerPixel, clear, map) == GIF_OK;
    GifFreeMapObject(map);
    constexpr std::string_view application = "NETSCAPE2.0";
    constexpr std::array<GifByteType, 3> forEver{1, 0, 0};
    return isWritten && EGifPutExtensionLeader(m_gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
           EGifPutExtensionBlock(m_gif, static_cast<int>(application.size()), application.data()) == GIF_OK &&
           EGifPutExtensionBlock(m_gif, static_cast<int>(forEver.size()), forEver.data()) == GIF_OK &&
           EGifPutExtensionTrailer(m_gif) == GIF_OK;
  }

  [[nodiscard]] Indices indicesOf(const RgbaImage &picture) {
    Indices indices(picture.rgba.size() / 4);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const std::uint8_t *pixel = picture.rgba.data() + 4 * i;
      indices[i] = pixel[3] < leastDrawnAlpha ? clear : m_palette->nearest({pixel[0], pixel[1], pixel[2]});
    }
    return indices;
  }

  [[nodiscard]] bool writeDelay() {
    const GraphicsControlBlock control{m_request.isTransparent ? DISPOSE_BACKGROUND : DISPOSE_DO_NOT, false,
                                       delaysPerSecond / m_request.framesPerSecond, clear};
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    return EGifPutExtension(m_gif, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(bytes.size()), bytes.data()) ==
           GIF_OK;
  }

  /// Pixels that are as they were are seen through, unless all of them are written.
  [[nodiscard]] bool writePart(const Part &part, const Indices &now, bool isWhole) {
    if (EGifPutImageDesc(m_gif, part.left, part.top, part.width, part.height, false, nullptr) != GIF_OK)
      return false;
    Indices row(static_cast<std::size_t>(part.width));
    for (int y = part.top; y < part.top + part.height; ++y) {
      const auto begin = static_cast<std::size_t>(y) * static_cast<std::size_t>(m_request.size.width) +
                         static_cast<std::size_t>(part.left);
      for (std::size_t x = 0; x < row.size(); ++x)
        row[x] = !isWhole && m_shown[begin + x] == now[begin + x] ? clear : now[begin + x];
      if (EGifPutLine(m_gif, row.data(), part.width) != GIF_OK)
        return false;
    }
    return true;
  }

  [[nodiscard]] bool close() {
    GifFileType *gif = std::exchange(m_gif, nullptr);
    return !gif || EGifCloseFile(gif, nullptr) == GIF_OK;
  }

  /// The file's, or what is left: the library needs memory.
  [[nodiscard]] Problem problem() const {
    return m_problem.value_or(
        Problem{words("There is not enough memory for this animation."), m_request.file, 0, ""});
  }

  EncodingRequest m_request;
  UnfinishedFile m_file;
  std::optional<Problem> m_problem; ///< of the file
  ColorSamples m_samples;
  std::optional<Palette> m_palette;
  Indices m_shown; ///< the picture before; empty: there is none
  GifFileType *m_gif = nullptr;
};

Result<std::unique_ptr<Encoder>> beginGif(const EncodingRequest &request) {
  const int delay = delaysPerSecond / request.framesPerSecond;
  if (delaysPerSecond % request.framesPerSecond != 0 || delay < shortestDelay)
    return Problem{words("GIF takes 1, 2, 4, 5, 10, 20, 25 or 50 pictures a second, not {count}.",
                         {{"count", std::to_string(request.framesPerSecond)}}),
                   "", 0, ""};
  auto file = UnfinishedFile::begin(request.file);
  if (!file)
    return file.problem();
  return std::unique_ptr<Encoder>(std::make_unique<GifEncoder>(request, std::move(*file)));
}

} // namespace

AnimationFormat gif() {
  AnimationFormat format;
  format.name = "GIF";
  format.ending = ".gif";
  format.mayBeTransparent = true;
  format.previews = previews;
  format.begin = beginGif;
  return format;
}

} // namespace halfspace
