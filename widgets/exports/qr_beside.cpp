#include "widgets/exports/qr_beside.h"

#include "lessons/words.h"
#include "widgets/exports/append.h"
#include "widgets/exports/lengths.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace halfspace {
namespace {

constexpr Color black{0, 0, 0};
constexpr Color white{0xFF, 0xFF, 0xFF};

/// Where a square of some side goes beside a figure, and how large both are together, y down.
template <class Vector> struct Layout {
  Vector corner{}; ///< the square's, at the top left
  Vector size{};
};

template <class Vector, class Number> Layout<Vector> layOut(Vector figure, Number side) {
  const Number height = std::max(figure.y, side);
  return {{figure.x, height - side}, {figure.x + side, height}};
}

/// Dark modules that fill a rectangle, in modules.
struct Block {
  int left = 0;
  int right = 0; ///< behind its last column
  int top = 0;
  int bottom = 0; ///< behind its last row
};

/// The dark modules of a row in its order, as blocks that are one row high.
std::vector<Block> blocksOfRow(const QrCode &code, int row) {
  std::vector<Block> blocks;
  for (int column = 0; column < code.side; ++column) {
    if (!code.isDark(column, row))
      continue;
    if (!blocks.empty() && blocks.back().right == column)
      ++blocks.back().right;
    else
      blocks.push_back({column, column + 1, row, row + 1});
  }
  return blocks;
}

/// All dark modules, each in one block. Blocks of two rows are one where they have the same columns.
std::vector<Block> blocksOf(const QrCode &code) {
  std::vector<Block> blocks;
  for (int row = 0; row < code.side; ++row)
    for (const Block &block : blocksOfRow(code, row)) {
      const auto above = std::find_if(blocks.begin(), blocks.end(), [&](const Block &other) {
        return other.bottom == row && other.left == block.left && other.right == block.right;
      });
      if (above == blocks.end())
        blocks.push_back(block);
      else
        ++above->bottom;
    }
  return blocks;
}

void appendRectangle(PagePath &path, glm::dvec2 from, glm::dvec2 to) {
  path.append(straightPath({from, {to.x, from.y}, to, {from.x, to.y}}, true));
}

/// A code with its quiet zone from a corner, of modules of a size.
std::vector<DrawingPart> partsOf(const QrCode &code, glm::dvec2 corner, double module) {
  PathPart zone;
  zone.fill = Fill{white};
  appendRectangle(zone.path, corner, corner + module * (code.side + 2 * quietModules));
  PathPart dark;
  dark.fill = Fill{black};
  const glm::dvec2 start = corner + module * quietModules;
  for (const Block &block : blocksOf(code))
    appendRectangle(dark.path, start + module * glm::dvec2(block.left, block.top),
                    start + module * glm::dvec2(block.right, block.bottom));
  return {zone, dark};
}

std::string withSentence(const std::string &description, const std::string &sentence) {
  return description.empty() ? sentence : description + " " + sentence;
}

/// The bytes of a pixel in an image.
std::span<std::uint8_t, 4> pixelOf(RgbaImage &image, int column, int row) {
  constexpr std::size_t bytes = 4;
  const auto width = static_cast<std::size_t>(image.width);
  const std::size_t index = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
  return std::span<std::uint8_t, bytes>(image.rgba.data() + bytes * index, bytes);
}

void paint(std::span<std::uint8_t, 4> pixel, Color color) {
  constexpr std::uint8_t opaque = 0xFF;
  pixel[0] = color.red;
  pixel[1] = color.green;
  pixel[2] = color.blue;
  pixel[3] = opaque;
}

/// An image of one colour, or a clear one.
RgbaImage plainImage(glm::ivec2 size, std::optional<Color> ground) {
  RgbaImage image{size.x, size.y, {}};
  image.rgba.resize(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (int row = 0; ground && row < size.y; ++row)
    for (int column = 0; column < size.x; ++column)
      paint(pixelOf(image, column, row), *ground);
  return image;
}

} // namespace

Drawing withQrCode(Drawing drawing, const QrCode &code) {
  const double module = moduleMillimetres * pointsPerMillimetre;
  const auto [corner, size] = layOut(drawing.size, module * (code.side + 2 * quietModules));
  append(drawing.parts, partsOf(code, corner, module));
  drawing.size = size;
  drawing.description = withSentence(drawing.description,
                                     words("The QR code beside the figure holds its scene for Halfspace."));
  return drawing;
}

int modulePixels(double pixelsPerInch) {
  return static_cast<int>(std::ceil(moduleMillimetres * pointsPerMillimetre / pointsPerInch * pixelsPerInch));
}

RgbaImage withQrCode(const RgbaImage &image, const QrCode &code, double pixelsPerInch,
                     std::optional<Color> ground) {
  const int module = modulePixels(pixelsPerInch);
  const int side = module * (code.side + 2 * quietModules);
  const auto [corner, size] = layOut(glm::ivec2(image.width, image.height), side);
  RgbaImage together = plainImage(size, ground);
  for (int row = 0; row < image.height; ++row)
    std::copy_n(image.rgba.data() + 4 * static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width),
                4 * static_cast<std::size_t>(image.width), pixelOf(together, 0, row).data());
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const int x = column / module - quietModules;
      const int y = row / module - quietModules;
      const bool isInside = x >= 0 && y >= 0 && x < code.side && y < code.side;
      paint(pixelOf(together, corner.x + column, corner.y + row),
            isInside && code.isDark(x, y) ? black : white);
    }
  return together;
}

} // namespace halfspace
