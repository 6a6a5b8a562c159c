// The terms that lessons teach, as one list.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// A term with the step that introduces it. Both belong to the library.
struct GlossaryEntry {
  const TaughtTerm *term;
  const Lesson *lesson;
  int step;
};

/// All terms of a library, by their names as a dictionary sorts them; of those that several lessons teach,
/// the first. The library must outlive them.
[[nodiscard]] std::vector<GlossaryEntry> glossaryOf(const LessonLibrary &library);

/// A place in a text where a term stands.
struct TermUse {
  std::size_t begin; ///< in bytes
  std::size_t size;
  const GlossaryEntry *entry;
};

/// Where terms of a glossary stand in a text, as whole words in any case, the longest where several begin at
/// one place: “signed distance” is no “distance”. From the beginning to the end; none overlap.
[[nodiscard]] std::vector<TermUse> termsIn(std::string_view text, const std::vector<GlossaryEntry> &glossary);

} // namespace halfspace
