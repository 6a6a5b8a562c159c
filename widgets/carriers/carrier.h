// The formats of pictures that carry the session which they show, so that a picture can be opened again.
#pragma once

#include "lessons/result.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// One file, and a word in this room's CMakeLists.txt.
struct Carrier {
  std::string name;   ///< for people
  std::string ending; ///< of files, with its dot, in small letters
  /// Whether a file is of this format, by how it begins.
  std::function<bool(std::string_view file)> isOf;
  /// A picture of this program, which has none yet, with the text of a session in it; the same bytes for the
  /// same of both. What is no whole picture stays as it is.
  std::function<std::string(std::string picture, std::string_view session)> put;
  /// The text of the session in a picture from a stranger's hands: byte for byte what was put in, also after
  /// other programs have written the picture anew, where they keep it at all. Takes time and memory in
  /// proportion to the picture, and at most `maxSessionBytes` for what is unpacked. A sentence where there is
  /// none, or a damaged one. That it is a session is for its reader to say.
  std::function<Result<std::string>(std::string_view picture)> take;
  /// In a sentence, what is usually done with such pictures and loses the session.
  std::function<std::string()> lostBy;
};

[[nodiscard]] const std::vector<Carrier> &carriers();

/// That of a file, by how it begins, whatever it is called; null for none of them.
[[nodiscard]] const Carrier *carrierOf(std::string_view file);

/// That of files with such an ending; null where these carry none.
[[nodiscard]] const Carrier *carrierWith(const std::string &ending);

/// How the files end that may hold the session of a picture, with dots, in small letters: those of all
/// carriers, and photographs, in which a QR code is looked for.
[[nodiscard]] std::vector<std::string> pictureEndings();

/// Whether a file's name ends as one of these, whatever its case.
[[nodiscard]] bool namesPicture(const std::string &file);

/// A picture of this program with the text of a session in it; of a format that carries none it stays as it
/// is.
[[nodiscard]] std::string withSession(std::string picture, std::string_view session);

} // namespace halfspace
