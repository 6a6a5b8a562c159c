#include "app/library/glossary_presenter.h"

#include "app/panels/window_look.h"
#include "app/step/step_turner.h"
#include "lessons/lesson/term_links.h"
#include "widgets/lesson/glossary_dialog.h"
#include "widgets/picture/lesson_picture.h"
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
  connect(&model, &SessionModel::lessonChanged, this, &GlossaryPresenter::fillIfOpen);
  connect(&look, &WindowLook::changed, this, &GlossaryPresenter::fillIfOpen);
}

GlossaryPresenter::~GlossaryPresenter() { QDesktopServices::unsetUrlHandler(termScheme); }

void GlossaryPresenter::show() { filled().open(); }

void GlossaryPresenter::showTermAt(const QUrl &address) {
  const std::string text = address.toString(QUrl::FullyDecoded).toStdString();
  filled().open(QString::fromStdString(std::string(termAt(text))));
}

GlossaryDialog &GlossaryPresenter::filled() {
  if (!m_dialog)
    makeDialog();
  if (!m_dialog->isVisible())
    fill();
  return *m_dialog;
}

void GlossaryPresenter::makeDialog() {
  m_dialog = new GlossaryDialog(m_typesetter, m_scene.window());
  connect(m_dialog, &GlossaryDialog::lessonWanted, this,
          [this](std::size_t entry) { goTo(m_glossary.entries().at(entry)); });
  connect(m_dialog, &QDialog::finished, this, [this] { m_painter.reset(); });
}

void GlossaryPresenter::fillIfOpen() {
  if (m_dialog && m_dialog->isVisible())
    fill();
}

void GlossaryPresenter::fill() {
  m_glossary = Glossary(m_model.library());
  m_dialog->setTheme(m_look.panelTheme());
  std::vector<GlossaryDialog::Entry> entries;
  entries.reserve(m_glossary.entries().size());
  for (const auto &[term, lesson, step] : m_glossary.entries()) {
    QStringList also;
    for (const std::string &form : term->also)
      also << QString::fromStdString(form);
    entries.push_back({QString::fromStdString(term->name), also.join(tr(", ")), term->meaning,
                       QString::fromStdString(lesson->title)});
  }
  m_dialog->setEntries(std::move(entries), [this](std::size_t entry, const QSize &room) {
    return figureOf(m_glossary.entries().at(entry), room);
  });
}

QPixmap GlossaryPresenter::figureOf(const GlossaryEntry &entry, const QSize &room) {
  const auto &[term, lesson, step] = entry;
  const Evaluation evaluation = evaluate(lesson->scene);
  const Stage stage = stageOf(lesson->scene, boundObjectsOf(lesson->scene, evaluation));
  const double finer = m_scene.devicePixelRatioF();
  PictureRequest request;
  request.size = {qRound(room.width() * finer), qRound(room.height() * finer)};
  request.pixelRatio = smallness * finer;
  request.theme = m_look.theme();
  request.content = contentOf(lesson, &stepOf(*lesson, step), evaluation, stage);
  request.camera = homeOf(lesson, evaluation, stage, request.size, *request.pixelRatio);
  m_scene.doneCurrent(); // two current contexts in a thread clash
  if (!m_painter)
    m_painter =
        std::make_unique<OffscreenPainter>(labelSetter(m_typesetter.fonts()), labelPainter(m_typesetter));
  const auto picture = m_painter->draw(request);
  if (!picture)
    return {}; // the words are there all the same
  QPixmap pixmap = QPixmap::fromImage(toImage(*picture));
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
