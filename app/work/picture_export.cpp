#include "app/work/picture_export.h"

#include "app/memory.h"
#include "app/panels/window_look.h"
#include "app/work/save_dialog.h"
#include "lessons/files/write_file.h"
#include "lessons/scene/file/session_file.h"
#include "widgets/carriers/carrier.h"
#include "widgets/scene/offscreen.h"
#include "widgets/scene/png.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"
#include "widgets/view/scene_view.h"

#include <QApplication>
#include <QClipboard>
#include <QImage>
#include <QMimeData>

#include <algorithm>
#include <memory>
#include <utility>

namespace halfspace {
namespace {

/// Pictures are made this much finer than the screen shows them.
constexpr double pictureScale = 2;

} // namespace

PictureExport::PictureExport(const SessionModel &model, SceneView &scene, const WindowLook &look,
                             const Typesetter &typesetter, Messages messages, QObject *parent)
    : QObject(parent), m_model(model), m_scene(scene), m_look(look), m_typesetter(typesetter),
      m_messages(messages) {}

std::optional<RgbaImage> PictureExport::draw() {
  PictureRequest request;
  request.content = m_scene.drawn().pictureContent();
  request.camera = m_scene.viewpoint().camera();
  request.theme = m_look.theme();
  const PixelSize size = m_scene.screen().size();
  const double fitting = std::min(pictureScale, double(maxPictureSide) / std::max(size.width, size.height));
  request.pixelRatio = m_scene.screen().designRatio() * fitting;
  request.size = {static_cast<int>(size.width * fitting), static_cast<int>(size.height * fitting)};
  // The picture is drawn in a context of its own; two current ones in a thread clash.
  m_scene.doneCurrent();
  auto picture =
      OffscreenPainter(labelSetter(m_typesetter.fonts()), labelPainter(m_typesetter)).draw(request);
  returnFreeMemory(); // the context that has ended leaves a hundred megabytes
  if (!picture) {
    m_messages.complain(QString::fromStdString(picture.problem().text()));
    return {};
  }
  return std::move(*picture);
}

std::optional<std::string> PictureExport::fileOf(const RgbaImage &picture) {
  auto file = pngOf(picture);
  if (!file) {
    m_messages.complain(QString::fromStdString(file.problem().text()));
    return {};
  }
  return withSession(std::move(*file), writeSession(m_model.session()));
}

bool PictureExport::saveTo(const QString &file) {
  const auto picture = draw();
  const auto content = picture ? fileOf(*picture) : std::nullopt;
  if (!content)
    return false;
  if (const auto problem = writeFile(file.toStdString(), *content)) {
    m_messages.complain(QString::fromStdString(problem->text()));
    return false;
  }
  m_messages.say(tr("Picture saved."));
  return true;
}

void PictureExport::askAndSave() {
  const QString file = askWhereToSave(m_messages.window(), tr("Save picture"), tr("PNG pictures (*.png)"),
                                      QString::fromStdString(m_model.session().lesson), "png");
  if (!file.isEmpty())
    saveTo(file);
}

void PictureExport::copy() {
  const auto picture = draw();
  const auto content = picture ? fileOf(*picture) : std::nullopt;
  if (!content)
    return;
  auto copied = std::make_unique<QMimeData>();
  copied->setImageData(toImage(*picture));
  copied->setData("image/png", QByteArray::fromStdString(*content));
  QApplication::clipboard()->setMimeData(copied.release());
  m_messages.say(tr("Picture copied."));
}

} // namespace halfspace
