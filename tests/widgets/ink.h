// What is seen of a label, and where the ink of a picture is.
#pragma once

#include <QImage>
#include <QWidget>

namespace halfspace::test {

inline QImage painted(QWidget &label, const QSize &size) {
  label.resize(size);
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  label.render(&image, {}, {}, QWidget::DrawChildren);
  return image;
}

/// The box around all pixels that are darker than a gray.
inline QRect inkBox(const QImage &image, int gray = 200) {
  QRect box;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (qGray(image.pixel(x, y)) < gray)
        box |= QRect(x, y, 1, 1);
  return box;
}

} // namespace halfspace::test
