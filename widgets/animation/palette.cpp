#include "widgets/animation/palette.h"

#include <vtkImageData.h>
#include <vtkImageQuantizeRGBToIndex.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace halfspace {
namespace {

/// As many as are looked through in a moment.
constexpr std::size_t mostSamples = 1U << 20U;

constexpr std::size_t knownColors = 1U << 16U;

std::size_t placeOf(Color color) {
  constexpr std::uint32_t spread = 2654435761U; // Knuth's multiplicative hash
  const std::uint32_t rgb =
      (std::uint32_t{color.red} << 16U) | (std::uint32_t{color.green} << 8U) | color.blue;
  return (rgb * spread) >> 16U;
}

int distanceBetween(Color a, Color b) {
  const int red = a.red - b.red;
  const int green = a.green - b.green;
  const int blue = a.blue - b.blue;
  return red * red + green * green + blue * blue;
}

std::uint8_t toByte(double part) { return static_cast<std::uint8_t>(std::lround(part * 255)); }

} // namespace

ColorSamples::ColorSamples(int pictures)
    : m_mostPixels(std::max<std::size_t>(1, mostSamples / static_cast<std::size_t>(std::max(1, pictures)))) {}

void ColorSamples::add(const RgbaImage &picture) {
  const std::size_t pixels = picture.rgba.size() / 4;
  const std::size_t step = std::max<std::size_t>(1, pixels / m_mostPixels);
  for (std::size_t pixel = 0; pixel < pixels; pixel += step) {
    const auto at = picture.rgba.begin() + static_cast<std::ptrdiff_t>(pixel * 4);
    if (at[3] >= leastDrawnAlpha)
      m_rgb.insert(m_rgb.end(), at, at + 3);
  }
}

Palette::Palette(const ColorSamples &samples, int mostColors) : m_known(knownColors) {
  const std::vector<std::uint8_t> &rgb = samples.rgb();
  if (rgb.empty()) {
    m_colors.emplace_back();
    return;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(rgb.size() / 3), 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(rgb.begin(), rgb.end(), static_cast<std::uint8_t *>(image->GetScalarPointer()));
  vtkNew<vtkImageQuantizeRGBToIndex> quantizer;
  quantizer->SetInputData(image);
  quantizer->SetNumberOfColors(mostColors);
  quantizer->SetSamplingRate(1, 1, 1);
  quantizer->Update();
  vtkLookupTable *table = quantizer->GetLookupTable();
  for (vtkIdType i = 0; i < table->GetNumberOfTableValues(); ++i) {
    const double *value = table->GetTableValue(i);
    const Color color{toByte(value[0]), toByte(value[1]), toByte(value[2])};
    if (std::find(m_colors.begin(), m_colors.end(), color) ==
        m_colors.end()) // of few, some stand there twice
      m_colors.push_back(color);
  }
}

std::uint8_t Palette::nearest(Color color) {
  Known &known = m_known[placeOf(color)];
  if (known.isThere && known.color == color)
    return known.nearest;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < m_colors.size(); ++i)
    if (const int distance = distanceBetween(m_colors[i], color); distance < least) {
      least = distance;
      known = {color, static_cast<std::uint8_t>(i), true};
    }
  return known.nearest;
}

} // namespace halfspace
