// The formats in which animations are written.
#pragma once

#include "lessons/result.h"
#include "widgets/picture/camera.h"
#include "widgets/picture/rgba_image.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace halfspace {

/// What is to be written, and where.
struct EncodingRequest {
  std::string file; ///< of a format of numbered pictures with a place for their number: frames/%04d.png
  PixelSize size;
  int framesPerSecond = 25;
  bool isTransparent = false;
  std::function<bool()> isCancelled; ///< asked while another program is waited for
};

/// Writes one picture after the other. What is not finished leaves nothing behind, but for pictures that have
/// files of their own. Once cancelled, its problems are for nobody.
class Encoder {
public:
  Encoder() = default;
  virtual ~Encoder() = default;
  Encoder(const Encoder &) = delete;
  Encoder &operator=(const Encoder &) = delete;

  /// Shows it one of the pictures before the first is added: see `AnimationFormat::previews`.
  virtual void preview(const RgbaImage & /*picture*/) {}
  /// Pictures have the size that was asked for.
  [[nodiscard]] virtual std::optional<Problem> add(const RgbaImage &picture) = 0;
  /// After the last one: the file is there, under its name.
  [[nodiscard]] virtual std::optional<Problem> finish() = 0;
};

/// One file in formats/, and a word in this room's CMakeLists.txt.
struct AnimationFormat {
  std::string name;              ///< for people
  std::string ending;            ///< of files, with its dot, in small letters
  bool isNumbered = false;       ///< each picture has a file of its own
  bool mayBeTransparent = false; ///< pictures may be without their background
  int previews = 0; ///< so many pictures, from all over the motion, it wants to see before the first
  /// Refuses with a sentence, before any picture is drawn, what this format has no place for.
  std::function<Result<std::unique_ptr<Encoder>>(const EncodingRequest &request)> begin;
};

[[nodiscard]] const std::vector<AnimationFormat> &animationFormats();

/// That of a file, by how its name ends; null for none of them.
[[nodiscard]] const AnimationFormat *animationFormatOf(const std::string &file);

} // namespace halfspace
