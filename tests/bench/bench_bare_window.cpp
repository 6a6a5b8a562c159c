// A window of bare VTK with a picture much like a lesson's, until its first frame is shown: ./bench_start
// runs it.
#include "tests/bench/bare_scene.h"
#include "tests/bench/first_frame.h"

#include <QApplication>
#include <QImage>
#include <QMainWindow>
#include <QPainter>
#include <QVTKOpenGLNativeWidget.h>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

using namespace halfspace::bench;

namespace {

constexpr int labelCount = 25;
constexpr int samples = 4;

BareImage imageOf(const QString &text) {
  auto image = std::make_shared<QImage>(48, 28, QImage::Format_RGBA8888);
  image->fill(Qt::transparent);
  QPainter painter(image.get());
  painter.drawText(image->rect(), Qt::AlignCenter, text);
  painter.end();
  return {image->width(), image->height(), image->constBits(), image};
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 2)
    return 1;
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  const QApplication application(argc, argv);
  std::vector<BareImage> labels;
  for (int i = 0; i < labelCount; ++i)
    labels.push_back(imageOf(QString::number(i)));
  BareScene scene;
  scene.setCamera({{30, -18, 18}, {7, 8, 4}, 0.4887});
  scene.show(samplePicture(labels));
  scene.fitClippingRange();

  QMainWindow window;
  auto *view = new QVTKOpenGLNativeWidget;
  vtkNew<vtkGenericOpenGLRenderWindow> renderWindow;
  renderWindow->SetMultiSamples(samples);
  view->setRenderWindow(renderWindow);
  renderWindow->AddRenderer(scene.renderer());
  reportFirstFrame(*view, argv[1]);
  window.setCentralWidget(view);
  window.resize(1280, 800);
  window.show();
  return QApplication::exec();
}
