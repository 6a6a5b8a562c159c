#include "app/library/glossary_presenter.h"

#include "app/panels/window_look.h"
#include "app/step/step_turner.h"
#include "lessons/lesson/shown.h"
#include "lessons/lesson/term_links.h"
#include "widgets/lesson/glossary_dialog.h"
#include "widgets/picture/camera_views.h"
#include "widgets/scene/offscreen.h"
#include "widgets/session_model.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"
#include "widgets/view/scene_view.h"

#include <QDesktopServices>
#include <QImage>
#include <QPixmap>
#include <QUrl>

namespace halfspace {
namespace {

/// A figure is small: its type and lines are a little smaller than in the scene.
constexpr double smallness = 0.8;

} // namespace

GlossaryPresenter::GlossaryPresenter(SessionModel &model, StepTurner &turner, SceneView &scene,
                                     const WindowLook &look, const Typesetter &typesetter, QObject *parent)
    : QObject(parent), m_model(model), m_turner(turner), m_scene(scene), m_look(look),
      m_typesetter(typesetter) {
  QDesktopServices::setUrlHandler(termScheme, this, "showTermAt");
  connect(&model, &SessionModel::lessonChanged, this, [this] {
    if (m_dialog)
      fill(); // the library may be another one
  });
  connect(&look, &WindowLook::changed, this, [this] {
    if (m_dialog)
      m_dialog->setTheme(m_look.panelTheme());
  });
}

GlossaryPresenter::~GlossaryPresenter() { QDesktopServices::unsetUrlHandler(termScheme); }

void GlossaryPresenter::show() { dialog().open(); }

void GlossaryPresenter::showTermAt(const QUrl &address) {
  const std::string text = address.toString(QUrl::FullyDecoded).toStdString();
  dialog().open(QString::fromStdString(std::string(termAt(text))));
}

GlossaryDialog &GlossaryPresenter::dialog() {
  if (m_dialog)
    return *m_dialog;
  m_dialog = new GlossaryDialog(m_typesetter, m_scene.window());
  connect(m_dialog, &GlossaryDialog::lessonWanted, this,
          [this](std::size_t entry) { goTo(m_entries.at(entry)); });
  connect(m_dialog, &QDialog::finished, this, [this] { m_painter.reset(); });
  m_dialog->setTheme(m_look.panelTheme());
  fill();
  return *m_dialog;
}

void GlossaryPresenter::fill() {
  m_entries = glossaryOf(m_model.library());
  std::vector<GlossaryDialog::Entry> entries;
  entries.reserve(m_entries.size());
  for (const auto &[term, lesson, step] : m_entries) {
    QStringList also;
    for (const std::string &form : term->also)
      also << QString::fromStdString(form);
    entries.push_back({QString::fromStdString(term->name), also.join(tr(", ")), term->meaning,
                       QString::fromStdString(lesson->title)});
  }
  m_dialog->setEntries(std::move(entries), [this](std::size_t entry, const QSize &room) {
    return figureOf(m_entries.at(entry), room);
  });
}

QPixmap GlossaryPresenter::figureOf(const GlossaryEntry &entry, const QSize &room) {
  const Evaluation evaluation = evaluate(entry.lesson->scene);
  const double finer = m_scene.devicePixelRatioF();
  PictureRequest request;
  request.size = {qRound(room.width() * finer), qRound(room.height() * finer)};
  request.pixelRatio = smallness * finer;
  request.theme = m_look.theme();
  SceneContent &content = request.content;
  content.stage = stageOf(entry.lesson->scene, boundObjectsOf(entry.lesson->scene, evaluation));
  content.hasShadows = entry.lesson->hasShadows;
  content.figure = toStage(shownIn(stepOf(*entry.lesson, entry.step), evaluation).figure, content.stage);
  request.camera = homeView(entry.lesson->camera, toStage(halfspace::figureOf(evaluation), content.stage),
                            content.stage.hasAxes(), request.size, *request.pixelRatio);
  m_scene.doneCurrent(); // two current contexts in a thread clash
  if (!m_painter)
    m_painter =
        std::make_unique<OffscreenPainter>(labelSetter(m_typesetter.fonts()), labelPainter(m_typesetter));
  const auto picture = m_painter->draw(request);
  if (!picture)
    return {}; // the words are there all the same
  const QImage image(picture->rgba.data(), picture->width, picture->height, picture->width * 4,
                     QImage::Format_RGBA8888);
  QPixmap pixmap = QPixmap::fromImage(image.copy());
  pixmap.setDevicePixelRatio(finer);
  return pixmap;
}

void GlossaryPresenter::goTo(const GlossaryEntry &entry) {
  const std::string lesson = entry.lesson->id; // opening one fills the glossary anew
  const int step = entry.step;
  m_model.openLesson(lesson);
  m_turner.turnTo(step);
  m_scene.window()->activateWindow();
}

} // namespace halfspace
