// What a line may become that somebody is typing.
#pragma once

#include "lessons/scene/scene.h"

namespace halfspace {

/// A line with more in it.
struct LineCompletion {
  std::string line; ///< the whole of it
  /// What is selected then, in bytes: what was filled in without being asked for. Of no length where there
  /// is nothing of that sort: the cursor.
  std::size_t selectedAt = 0;
  std::size_t selectedLength = 0;
  std::string description; ///< what is completed, for people: “a plane”, “a plane, a point”
  bool isWhole = false;    ///< `readLine` reads the line
};

/// Completions at a cursor, the best first, at most so many.
///
/// - In an empty line, and behind a name, whole statements with numbers and objects to be changed; behind the
///   beginning of a word those that call such a word, under a free name where none is typed yet.
/// - Between the brackets of a call the names of what fits there, the newest first, each with the newest
///   objects that fit in all other places.
/// - Elsewhere in a formula the names of points, vectors and numbers.
///
/// What stands behind the cursor stays, and only names are completed in front of it. The cursor is a byte of
/// the line, or its end.
[[nodiscard]] std::vector<LineCompletion> completionsOf(std::string_view line, std::size_t cursor,
                                                        const Scene &above, char decimalMark = '.',
                                                        std::size_t most = 12);

} // namespace halfspace
