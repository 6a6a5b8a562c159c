// What can stand between the brackets of a call in a typed line.
#pragma once

#include "lessons/scene/scene.h"

namespace halfspace {

struct Construction;

/// The place of an argument.
struct ArgumentPlace {
  std::string_view kind; ///< the word of the kind whose names can stand there, or of solids; empty: none can
  bool isList = false;   ///< several can
  /// What can stand there where there is no such object; nothing where a name is needed.
  std::optional<Formula> otherwise{};
};

/// A way to call a word.
struct Signature {
  std::string_view word;
  std::vector<ArgumentPlace> places;
  bool isInAnyOrder = false;                  ///< as far as kinds tell the arguments apart
  const Construction *construction = nullptr; ///< that is called; null for an object
  const Kind *kind = nullptr;                 ///< of the object that is called; null for a construction
};

/// The ways to call a kind of objects, with its coordinates first: none for one that has a shape.
[[nodiscard]] std::vector<Signature> signaturesOf(const Kind &kind);
/// The way to call a construction by its word, or by its id where it has none.
[[nodiscard]] Signature signatureOf(const Construction &construction);
/// All ways to call a word of `callWords`; none for another word.
[[nodiscard]] std::vector<Signature> signaturesOf(std::string_view word);

/// What is called, for people: “a plane”, or what the construction looks at: “a plane, a point”.
[[nodiscard]] std::string wordsFor(const Signature &signature);

} // namespace halfspace
