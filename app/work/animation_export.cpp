#include "app/work/animation_export.h"

#include "app/memory.h"
#include "app/panels/window_look.h"
#include "app/work/save_dialog.h"
#include "lessons/files/numbered_file.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/session_model.h"
#include "widgets/view/scene_view.h"

#include <QFileInfo>

#include <new>
#include <utility>

namespace halfspace {
namespace {

/// A place for the number of each picture, behind the name of them all.
constexpr const char *numberPlace = "-%04d";

/// A file's name with such a place where a format needs one.
QString placed(const QString &file, const AnimationFormat &format) {
  if (!format.isNumbered || parseNumberedFile(file.toStdString()))
    return file;
  QString before = file;
  const QString ending = QString::fromStdString(format.ending);
  if (before.endsWith(ending, Qt::CaseInsensitive))
    before.chop(ending.size());
  return before + numberPlace + ending;
}

/// In the job's thread: made from copies alone.
Result<Filmed> filmOf(const AnimatedScene &scene, const AnimationChoices &choices, const FilmRequest &request,
                      const FilmWatch &watch) {
  try {
    const auto motion = choices.motion->make(scene, choices.seconds);
    return motion ? film(**motion, *choices.format, request, watch) : motion.problem();
  } catch (const std::bad_alloc &) {
    return Problem{AnimationExport::tr("There is not enough memory for this animation.").toStdString(), "", 0,
                   ""};
  }
}

} // namespace

AnimationExport::AnimationExport(const SessionModel &model, SceneView &scene, const WindowLook &look,
                                 Messages messages, QObject *parent)
    : QObject(parent), m_model(model), m_scene(scene), m_look(look), m_messages(messages),
      m_progress(messages.window(), "animationProgress", tr("Save animation"), [this] { cancel(); }) {}

void AnimationExport::askAndSave() {
  if (!m_dialog)
    m_dialog = new AnimationDialog(&m_messages.window());
  m_dialog->setScene(sceneFor(AnimationChoices().size));
  if (m_dialog->exec() != QDialog::Accepted)
    return;
  const AnimationChoices choices = m_dialog->choices();
  const AnimationFormat &format = *choices.format;
  const QString ending = QString::fromStdString(format.ending);
  const QString name =
      QString::fromStdString(m_model.session().lesson) + (format.isNumbered ? numberPlace : "");
  const QString file =
      askWhereToSave(m_messages.window(), tr("Save animation"),
                     tr("%1 files (*%2)", "of a format").arg(QString::fromStdString(format.name), ending),
                     name, ending.mid(1));
  if (!file.isEmpty())
    saveTo(placed(file, format), choices);
}

void AnimationExport::saveTo(const QString &file, const AnimationChoices &choices) {
  cancel();
  const FilmRequest request{file.toStdString(), choices.size, choices.framesPerSecond, choices.isTransparent,
                            m_look.theme()};
  m_job.start([this, request, choices, scene = sceneFor(choices.size)](
                  const std::atomic<bool> &cancelled, const LatestJob::Post &post) -> LatestJob::Message {
    const FilmWatch watch{[&] { return cancelled.load(); },
                          [&](int picture, int all) {
                            post([this, picture, all] {
                              m_progress.show(static_cast<double>(picture) / all,
                                              tr("Picture %1 of %2").arg(picture).arg(all));
                            });
                          }};
    return [this, filmed = filmOf(scene, choices, request, watch)] { end(filmed); };
  });
  m_progress.show(0, tr("The first picture is being drawn."));
}

void AnimationExport::cancel() {
  m_job.cancel();
  m_progress.end();
}

AnimatedScene AnimationExport::sceneFor(PixelSize size) const {
  AnimatedScene scene;
  scene.lesson = std::make_shared<const Lesson>(m_model.lesson());
  scene.scene = m_model.session().scene;
  scene.size = size;
  scene.shown = m_scene.drawn().pictureContent();
  if (const auto &view = m_model.session().view)
    scene.camera = keptBetweenSides(cameraOf(*view), m_scene.screen().size(), size);
  return scene;
}

void AnimationExport::end(const Result<Filmed> &filmed) {
  m_progress.end();
  returnFreeMemory(); // the context that has ended leaves a hundred megabytes
  if (!filmed)
    return m_messages.complain(QString::fromStdString(filmed.problem().text()));
  m_messages.say(filmed->leavesOutSurfaces ? QString::fromStdString(overfullWords())
                                           : tr("Animation saved."));
}

} // namespace halfspace
