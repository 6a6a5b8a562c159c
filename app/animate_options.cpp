#include "app/animate_options.h"

#include "app/figure_options.h"
#include "app/option_text.h"
#include "lessons/words.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace halfspace {
namespace {

std::string motionNames(const std::string &separator) {
  return joinedNames(motionKinds(), &MotionKind::name, separator);
}

/// GIF, MP4 …, or .gif, .mp4 …: what animations can be written as.
std::string formats(std::string AnimationFormat::*part) {
  return joinedNames(animationFormats(), part, ", ");
}

Result<int> framesPerSecondOf(const std::string &text) {
  const auto count = parsePositive(text);
  if (!count || *count > mostFramesPerSecond || *count != std::floor(*count))
    return refused(words("--fps takes a whole number of pictures a second from 1 to {most}, not “{number}”.",
                         {{"most", std::to_string(mostFramesPerSecond)}, {"number", text}}));
  return static_cast<int>(*count);
}

Result<double> secondsOf(const std::string &text) {
  const auto seconds = parsePositive(text);
  if (!seconds || *seconds < shortestFilm || *seconds > longestFilm)
    return refused(words("--seconds takes a number from 0.1 to 600, not “{number}”.", {{"number", text}}));
  return *seconds;
}

} // namespace

void addAnimateOptions(CLI::App &command, AnimateOptions &options) {
  command
      .add_option("--motion", options.motion,
                  words("What moves: the lesson's torpedo, from step to step, or the camera once around"))
      ->type_name(motionNames("|"))
      ->required();
  command
      .add_option("-o,--output", options.output,
                  words("The file to write; its ending says how: {endings}. Pictures have a place for their "
                        "number: frames/%04d.png",
                        {{"endings", formats(&AnimationFormat::ending)}}))
      ->type_name("FILE")
      ->required();
  command
      .add_option("--seconds", options.seconds,
                  words("How long it takes; without it the flight as in the window, 2 seconds a step, and 8 "
                        "seconds a turn"))
      ->type_name("NUMBER");
  command.add_option("--fps", options.framesPerSecond, words("How many pictures a second has"))
      ->type_name("NUMBER")
      ->capture_default_str();
  command.add_option("--size", options.size, words("Its sides in pixels"))
      ->type_name("WIDTHxHEIGHT")
      ->capture_default_str();
  command.add_flag("--transparent", options.isTransparent, words("No background: GIF and PNG"));
  command.add_option("--theme", options.theme, words("The picture's colours"))
      ->type_name(themeNames("|"))
      ->capture_default_str();
  command
      .add_option("--step", options.step,
                  words("The lesson's step to show, counted from 1; without it that of a session, the whole "
                        "figure of a lesson, or the last step with the flight"))
      ->type_name("NUMBER");
}

Result<AnimateCommand> animateCommandOf(const AnimateOptions &options, const CLI::App &command) {
  AnimateCommand animate{options.subject, options.assignments};
  animate.motion = findMotionKind(options.motion);
  if (!animate.motion)
    return refused(words("There is no motion “{motion}”. The motions are {motions}.",
                         {{"motion", options.motion}, {"motions", motionNames(", ")}}));
  animate.format = animationFormatOf(options.output);
  if (!animate.format)
    return refused(
        words("Animations are written as {formats}: let the name end in {endings}, not as “{file}” does.",
              {{"formats", formats(&AnimationFormat::name)},
               {"endings", formats(&AnimationFormat::ending)},
               {"file", options.output}}));
  const auto size = sizeOf(options.size);
  if (!size)
    return size.problem();
  const auto theme = themeOf(options.theme);
  if (!theme)
    return theme.problem();
  const auto framesPerSecond = framesPerSecondOf(options.framesPerSecond);
  if (!framesPerSecond)
    return framesPerSecond.problem();
  animate.film = {options.output, *size, *framesPerSecond, options.isTransparent, *theme};
  if (command.count("--seconds") > 0) {
    const auto seconds = secondsOf(options.seconds);
    if (!seconds)
      return seconds.problem();
    animate.seconds = *seconds;
  }
  if (command.count("--step") > 0)
    animate.step = options.step;
  return animate;
}

} // namespace halfspace
