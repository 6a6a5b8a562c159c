#include "widgets/animation/film.h"

#include "lessons/words.h"
#include "widgets/scene/offscreen.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfspace {
namespace {

/// Labels are led around a loop in so many steps before the first picture: then they have found their places.
constexpr int arranged = 240;

/// Of pictures that are too many; nobody needs to know how many more there are.
constexpr double mostCounted = 1e9;

Problem refused(const std::string &sentence) { return {sentence, "", 0, ""}; }

/// What no format has a place for.
std::optional<Problem> refusalOf(const AnimationFormat &format, const FilmRequest &request, double pictures) {
  const std::string count = std::to_string(std::llround(std::min(pictures, mostCounted)));
  const auto [width, height] = request.size;
  if (request.isTransparent && !format.mayBeTransparent)
    return refused(
        words("{format} has no transparent pictures: GIF and PNG have.", {{"format", format.name}}));
  if (pictures > mostPictures)
    return refused(words("An animation has at most {most} pictures, not {count}: let it be shorter, or have "
                         "fewer a second.",
                         {{"most", std::to_string(mostPictures)}, {"count", count}}));
  if (pictures * width * height > mostPixelsOfFilm)
    return refused(
        words("{count} pictures of {width} × {height} pixels are too much for an animation: let it be "
              "smaller or shorter.",
              {{"count", count}, {"width", std::to_string(width)}, {"height", std::to_string(height)}}));
  return {};
}

/// From picture to picture of a motion.
double stepsOf(const Motion &motion, int framesPerSecond) {
  return std::max(1.0, std::round(motion.seconds() * framesPerSecond));
}

/// A whole number, however large.
double picturesOf(const Motion &motion, int framesPerSecond) {
  return stepsOf(motion, framesPerSecond) + (motion.isLoop() ? 0 : 1);
}

/// So many of the moments, from all over them.
std::vector<double> someOf(const std::vector<double> &moments, int count) {
  std::vector<double> some;
  const auto all = static_cast<double>(moments.size());
  for (int i = 0; i < count; ++i)
    some.push_back(moments[static_cast<std::size_t>(all * i / count)]);
  some.erase(std::unique(some.begin(), some.end()), some.end());
  return some;
}

/// Draws a motion's pictures, and hands each to the encoder.
class Shooting {
public:
  Shooting(Motion &motion, const FilmRequest &request, const FilmWatch &watch, int all)
      : m_motion(motion), m_request(request), m_watch(watch), m_all(all) {}

  [[nodiscard]] const Filmed &filmed() const { return m_filmed; }

  [[nodiscard]] std::optional<Problem> preview(const std::vector<double> &moments, Encoder &encoder) {
    return shoot(moments, [&](const RgbaImage &picture) {
      encoder.preview(picture);
      return std::optional<Problem>();
    });
  }
  [[nodiscard]] std::optional<Problem> add(const std::vector<double> &moments, Encoder &encoder) {
    if (m_motion.isLoop()) // then labels come from its end to its beginning as from moment to moment
      for (const double time : someOf(moments, arranged))
        m_painter.arrange(requestFor(time));
    return shoot(moments, [&](const RgbaImage &picture) { return encoder.add(picture); });
  }

private:
  template <class Take>
  [[nodiscard]] std::optional<Problem> shoot(const std::vector<double> &moments, const Take &take) {
    for (const double time : moments) {
      if (m_watch.isCancelled())
        return Problem{};
      const auto picture = m_painter.draw(requestFor(time));
      if (!picture)
        return picture.problem();
      m_filmed.leavesOutSurfaces = m_filmed.leavesOutSurfaces || picture->leavesOutSurfaces;
      if (auto problem = take(*picture))
        return problem;
      m_watch.tell(++m_done, m_all);
    }
    return {};
  }

  [[nodiscard]] PictureRequest requestFor(double time) {
    Moment moment = m_motion.at(time);
    PictureRequest picture;
    picture.content = std::move(moment.content);
    picture.isLabelledLikeLast = !moment.labelledLike;
    picture.labelledLike = std::move(moment.labelledLike);
    picture.camera = moment.camera;
    picture.theme = m_request.theme;
    picture.size = m_request.size;
    picture.transparent = m_request.isTransparent;
    return picture;
  }

  Motion &m_motion;
  const FilmRequest &m_request;
  const FilmWatch &m_watch;
  int m_all;
  int m_done = 0;
  Filmed m_filmed;
  Typesetter m_typesetter;
  OffscreenPainter m_painter{labelSetter(m_typesetter.fonts()), labelPainter(m_typesetter)};
};

} // namespace

std::vector<double> momentsOf(const Motion &motion, int framesPerSecond) {
  const double seconds = motion.seconds();
  const double steps = stepsOf(motion, framesPerSecond);
  std::vector<double> moments;
  for (int i = 0; i < picturesOf(motion, framesPerSecond); ++i)
    moments.push_back(seconds * i / steps);
  return moments;
}

Result<Filmed> film(Motion &motion, const AnimationFormat &format, const FilmRequest &request,
                    const FilmWatch &watch) {
  if (const auto refusal = refusalOf(format, request, picturesOf(motion, request.framesPerSecond)))
    return *refusal;
  const auto encoder = format.begin(
      {request.file, request.size, request.framesPerSecond, request.isTransparent, watch.isCancelled});
  if (!encoder)
    return encoder.problem();
  const std::vector<double> moments = momentsOf(motion, request.framesPerSecond);
  const std::vector<double> previews = someOf(moments, format.previews);
  Shooting shooting(motion, request, watch, static_cast<int>(previews.size() + moments.size()));
  if (const auto problem = shooting.preview(previews, **encoder))
    return *problem;
  if (const auto problem = shooting.add(moments, **encoder))
    return *problem;
  if (const auto problem = (*encoder)->finish())
    return *problem;
  return shooting.filmed();
}

} // namespace halfspace
