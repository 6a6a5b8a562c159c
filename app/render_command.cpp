// Pictures of a figure in files, one or as many as a flight has frames.
#include "app/commands.h"
#include "app/standard_streams.h"
#include "lessons/files/write_file.h"
#include "lessons/lesson/nearest_step.h"
#include "lessons/lesson/shown.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/words.h"
#include "widgets/carriers/carrier.h"
#include "widgets/exports/draw_flat.h"
#include "widgets/exports/draw_shapes.h"
#include "widgets/exports/format.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/composer.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/flat_picture.h"
#include "widgets/picture/lesson_picture.h"
#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/scene/offscreen.h"
#include "widgets/scene/png.h"
#include "widgets/typeset/flat_painter.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace halfspace {
namespace {

/// The last step that shows the lesson's flight; null where it has none.
const LessonStep *stepOfFlight(const OpenedSession &opened) {
  const LessonStep *last = nullptr;
  if (opened.lesson)
    for (const LessonStep &step : opened.lesson->steps)
      if (flightOf(step))
        last = &step;
  return last;
}

/// The step that the pictures show, null for the whole figure; or that the lesson does not have it.
Result<const LessonStep *> stepToShow(const RenderCommand &command, const OpenedSession &opened) {
  const Lesson *lesson = opened.lesson;
  const std::size_t steps = lesson ? lesson->steps.size() : 0;
  if (command.step && static_cast<std::size_t>(*command.step) > steps)
    return Problem{words("The lesson has {count} steps.", {{"count", std::to_string(steps)}}), "", 0,
                   "--step"};
  if (command.step)
    return &stepOf(*lesson, *command.step - 1);
  if (const LessonStep *step = command.frames ? stepOfFlight(opened) : nullptr)
    return step;
  const bool isSession = opened.origin != OpenedSession::Origin::Lesson;
  return lesson && isSession ? &stepOf(*lesson, nearestStep(*lesson, opened.session.step)) : nullptr;
}

/// What the pictures of a command are of.
struct Motif {
  const RenderCommand &command;
  const OpenedSession &opened; ///< with the scene of the picture that comes next
  const LessonStep *step;      ///< that they show; null: the whole figure
  Stage stage;
};

/// What is to be seen when a picture is opened again: its scene, at its step.
Session sessionOf(const Motif &motif) {
  Session session = motif.opened.session;
  const std::size_t steps = motif.step ? motif.opened.lesson->steps.size() : 0;
  for (std::size_t i = 0; i < steps; ++i)
    if (&motif.opened.lesson->steps[i] == motif.step)
      session.step = static_cast<int>(i);
  return session;
}

/// A picture as its file holds it: with its session, unless that is to be left out.
std::string fileContent(std::string picture, const Motif &motif) {
  if (motif.command.anonymous)
    return picture;
  return withSession(std::move(picture), writeSession(sessionOf(motif)));
}

/// The pictures of a command, which are drawn one after the other.
class Pictures {
public:
  virtual ~Pictures() = default;
  /// From now on they show what came after this.
  virtual void begin(const Evaluation &evaluation) = 0;
  /// Draws one into a file.
  [[nodiscard]] virtual std::optional<Problem> write(const Evaluation &evaluation,
                                                     const std::string &file) = 0;

protected:
  explicit Pictures(Motif motif) : m_motif(std::move(motif)) {}
  [[nodiscard]] const Motif &motif() const { return m_motif; }
  [[nodiscard]] SceneContent content(const Evaluation &evaluation) const {
    return contentOf(m_motif.opened.lesson, m_motif.step, evaluation, m_motif.stage);
  }
  /// A picture leaves out surfaces, or not. It is told once: of a flight many would.
  void tellWhatIsLeftOut(bool leavesOutSurfaces) {
    if (leavesOutSurfaces && !std::exchange(m_hasToldOfOverfull, true))
      printError(overfullWords());
  }

private:
  Motif m_motif;
  bool m_hasToldOfOverfull = false;
};

/// Pictures of pixels.
class PixelPictures : public Pictures {
public:
  [[nodiscard]] std::optional<Problem> write(const Evaluation &evaluation, const std::string &file) override {
    const auto picture = draw(evaluation);
    if (!picture)
      return picture.problem();
    auto png = pngOf(*picture);
    return png ? writeFile(file, fileContent(std::move(*png), motif())) : png.problem();
  }

protected:
  using Pictures::Pictures;

private:
  [[nodiscard]] virtual Result<RgbaImage> draw(const Evaluation &evaluation) = 0;
};

/// Flat pictures are each laid on their page by themselves.
Result<FlatPicture> flatPictureOf(const Motif &motif, const Evaluation &evaluation) {
  const auto &[command, opened, step, stage] = motif;
  const auto frame = opened.lesson ? flatFrame(opened.lesson->flat, opened.session.scene) : std::nullopt;
  if (!frame)
    return Problem{words("Here is no flat picture: the lesson has none, or not of this scene."), "", 0,
                   "--flat"};
  return FlatPicture(*frame, stage, figureOf(evaluation), figureShown(step, evaluation));
}

class FlatPictures : public PixelPictures {
public:
  explicit FlatPictures(const Motif &motif) : PixelPictures(motif) {}
  void begin(const Evaluation &) override {}

private:
  [[nodiscard]] Result<RgbaImage> draw(const Evaluation &evaluation) override {
    const RenderCommand &command = motif().command;
    const auto picture = flatPictureOf(motif(), evaluation);
    if (!picture)
      return picture.problem();
    const View view = picture->fitted({{}, command.size, ownPixelRatio(command.size)});
    return drawFlat(picture->seenFrom(view), command.theme, view, command.transparent, m_typesetter);
  }

  Typesetter m_typesetter;
};

/// Where a scene is looked at from: as somebody had put the camera when the session was saved, or as its
/// lesson begins.
Camera cameraFor(const Motif &motif, const Evaluation &evaluation, PixelSize size, double pixelRatio) {
  if (const auto &view = motif.opened.session.view)
    return cameraOf(*view);
  return homeOf(motif.opened.lesson, evaluation, motif.stage, size, pixelRatio);
}

/// Pictures in space: those of a flight are seen from one place, and their labels stand where they stand at
/// its beginning.
class SpacePictures : public PixelPictures {
public:
  SpacePictures(const Motif &motif, const Camera &camera) : PixelPictures(motif), m_camera(camera) {}

  void begin(const Evaluation &evaluation) override { m_beginning = content(evaluation); }

private:
  [[nodiscard]] Result<RgbaImage> draw(const Evaluation &evaluation) override {
    PictureRequest request;
    request.content = content(evaluation);
    request.labelledLike = m_beginning;
    request.camera = m_camera;
    request.theme = motif().command.theme;
    request.size = motif().command.size;
    request.transparent = motif().command.transparent;
    auto picture = m_painter.draw(request);
    if (!picture)
      return picture.problem();
    tellWhatIsLeftOut(picture->leavesOutSurfaces);
    return RgbaImage(std::move(*picture));
  }

  Camera m_camera;
  std::optional<SceneContent> m_beginning;
  Typesetter m_typesetter;
  OffscreenPainter m_painter{labelSetter(m_typesetter.fonts()), labelPainter(m_typesetter)};
};

/// Pictures of vectors, in a format.
class VectorPictures : public Pictures {
public:
  VectorPictures(const Motif &motif, const ExportFormat &format) : Pictures(motif), m_format(format) {}

  [[nodiscard]] std::optional<Problem> write(const Evaluation &evaluation, const std::string &file) override {
    auto drawing = draw(evaluation);
    if (!drawing)
      return drawing.problem();
    const auto &[command, opened, step, stage] = motif();
    drawing->title = opened.lesson ? opened.lesson->title : command.subject;
    drawing->description = shownIn(step ? *step : LessonStep(), evaluation).description;
    return writeFile(file, fileContent(m_format.write(*drawing, m_typesetter.fonts()), motif()));
  }

protected:
  [[nodiscard]] LabelSetter setter() const { return labelSetter(m_typesetter.fonts()); }
  [[nodiscard]] PaperLook look() const {
    const RenderCommand &command = motif().command;
    return {command.paper.width, command.paper.hidden, !command.transparent};
  }
  /// Still without its camera.
  [[nodiscard]] View view() const {
    const RenderCommand &command = motif().command;
    return viewOnPaper(command.size, command.paper.width, command.paper.typeSize, command.theme);
  }

private:
  [[nodiscard]] virtual Result<Drawing> draw(const Evaluation &evaluation) = 0;

  const ExportFormat &m_format;
  Typesetter m_typesetter;
};

class FlatDrawings : public VectorPictures {
public:
  using VectorPictures::VectorPictures;
  void begin(const Evaluation &) override {}

private:
  [[nodiscard]] Result<Drawing> draw(const Evaluation &evaluation) override {
    const auto picture = flatPictureOf(motif(), evaluation);
    if (!picture)
      return picture.problem();
    const View fitted = picture->fitted(view());
    return flatDrawingOf(picture->seenFrom(fitted), motif().command.theme, fitted, look(), setter());
  }
};

/// Seen from one place and labelled as its pictures of pixels are.
class SpaceDrawings : public VectorPictures {
public:
  SpaceDrawings(const Motif &motif, const ExportFormat &format, const Evaluation &evaluation)
      : VectorPictures(motif, format), m_composer(setter()) {
    View seen = view();
    seen.camera = cameraFor(motif, evaluation, seen.size, seen.pixelRatio);
    m_composer.setTheme(motif.command.theme);
    m_composer.setBackgroundVisible(!motif.command.transparent);
    m_composer.setView(std::move(seen));
  }

  void begin(const Evaluation &evaluation) override { m_beginning = content(evaluation); }

private:
  [[nodiscard]] Result<Drawing> draw(const Evaluation &evaluation) override {
    m_composer.forgetLabels();
    if (m_beginning) {
      m_composer.setContent(*m_beginning);
      m_composer.compose();
    }
    m_composer.setContent(content(evaluation));
    const ShapeList &shapes = m_composer.compose();
    tellWhatIsLeftOut(shapes.leavesOutSurfaces);
    return drawingOf(shapes, look());
  }

  std::optional<SceneContent> m_beginning;
  Composer m_composer;
};

std::unique_ptr<Pictures> picturesOf(const Motif &motif, const Evaluation &evaluation) {
  const RenderCommand &command = motif.command;
  if (const ExportFormat *format = formatOfFile(command.output)) {
    if (command.flat)
      return std::make_unique<FlatDrawings>(motif, *format);
    return std::make_unique<SpaceDrawings>(motif, *format, evaluation);
  }
  if (command.flat)
    return std::make_unique<FlatPictures>(motif);
  return std::make_unique<SpacePictures>(
      motif, cameraFor(motif, evaluation, command.size, ownPixelRatio(command.size)));
}

/// The name of the scene's number that counts the frames of the lesson's flight; nothing where there is none.
std::optional<std::string> frameNumberOf(const OpenedSession &opened) {
  const LessonStep *step = stepOfFlight(opened);
  return step ? std::optional(flightOf(*step)->frame) : std::nullopt;
}

/// The frame that is nearest to the wanted one, with which the scene is now.
Rational goToFrame(const Rational &wanted, const std::string &name, Scene &scene) {
  Object number = *findObject(scene, name);
  number[0].x = wanted;
  number.kind().settle(number);
  const Rational frame = number[0].x;
  setObject(scene, name, std::move(number));
  return frame;
}

/// frames/0007.png for the frame 7 of frames/%04d.png.
std::string fileOf(const NumberedFile &file, int frame) {
  std::string digits = std::to_string(frame);
  digits.insert(0, file.digits - std::min(file.digits, digits.size()), '0');
  return file.before + digits + file.behind;
}

/// Draws and writes one frame after the other.
std::optional<Problem> writeFrames(const RenderCommand &command, OpenedSession &opened, Evaluation evaluation,
                                   Pictures &pictures) {
  const auto number = frameNumberOf(opened);
  if (!number)
    return Problem{words("This lesson has no flight whose frames could be drawn."), "", 0, "--frame"};
  const auto [first, last] = *command.frames;
  Scene &scene = opened.session.scene;
  for (const int frame : {first, last}) // before any picture is written
    if (const Rational nearest = goToFrame(frame, *number, scene); nearest != frame)
      return Problem{words("The flight has no frame {frame}: the nearest is {nearest}.",
                           {{"frame", std::to_string(frame)}, {"nearest", toText(nearest)}}),
                     "", 0, "--frame"};
  goToFrame(objectAs<NumberObject>(*findObject(scene, *number))->from, *number, scene);
  evaluation = evaluate(scene, evaluation);
  pictures.begin(evaluation);
  for (int frame = first; frame <= last; ++frame) {
    goToFrame(frame, *number, scene);
    evaluation = evaluate(scene, evaluation);
    const std::string file = command.numbered ? fileOf(*command.numbered, frame) : command.output;
    if (auto problem = pictures.write(evaluation, file))
      return problem;
  }
  return {};
}

} // namespace

int runRender(const RenderCommand &command) {
  LessonLibrary library;
  auto opened = openSubject(library, command.subject, command.ownLessons, command.assignments);
  if (!opened)
    return fail(opened.problem());
  const auto step = stepToShow(command, *opened);
  if (!step)
    return fail(step.problem());
  const Scene &scene = opened->session.scene;
  Evaluation evaluation = evaluate(scene);
  const Stage stage = stageOf(scene, boundObjectsOf(scene, evaluation));
  const auto pictures = picturesOf({command, *opened, *step, stage}, evaluation);
  const auto problem = command.frames ? writeFrames(command, *opened, std::move(evaluation), *pictures)
                                      : pictures->write(evaluation, command.output);
  return problem ? fail(*problem) : 0;
}

} // namespace halfspace
