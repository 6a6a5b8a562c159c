// Pictures to look into.
#pragma once

#include "widgets/scene/offscreen.h"

#include <cmath>

namespace halfspace {

struct Rgba {
  int red = 0;
  int green = 0;
  int blue = 0;
  int alpha = 0;
  bool operator==(const Rgba &) const = default;
};

inline Rgba pixelAt(const RgbaImage &picture, int x, int y) {
  const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                             static_cast<std::size_t>(x));
  return {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2], picture.rgba[i + 3]};
}

inline Rgba pixelAt(const RgbaImage &picture, glm::dvec3 pixel) {
  return pixelAt(picture, static_cast<int>(std::floor(pixel.x)), static_cast<int>(std::floor(pixel.y)));
}

/// Who makes the labels of a picture.
struct Labels {
  LabelSetter set;
  LabelPainter paint;
};

/// Labels are off in these pictures.
inline const Labels noLabels{[](const std::string &) { return std::make_shared<const math::Layout>(); }, {}};

/// By a painter of its own.
inline Result<DrawnPicture> drawOffscreen(const PictureRequest &request, const Labels &labels) {
  return OffscreenPainter(labels.set, labels.paint).draw(request);
}

inline PictureRequest requestFor(Figure figure) {
  PictureRequest request;
  request.content.figure = std::move(figure);
  request.theme = *findTheme("light");
  request.size = {640, 400};
  CameraView view;
  view.from = {1, 0.6, 0.5};
  view.at = {6, 8, 4};
  request.camera = Camera(view);
  return request;
}

} // namespace halfspace
