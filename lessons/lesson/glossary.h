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

/// A place in a text where a term stands.
struct TermUse {
  std::size_t begin; ///< in bytes
  std::size_t size;
  const GlossaryEntry *entry;
};

/// All terms of a library, each once: of those that several lessons teach, the first. The library must
/// outlive it.
class Glossary {
public:
  /// Without terms.
  Glossary() = default;
  explicit Glossary(const LessonLibrary &library);

  /// By their names, as a dictionary sorts them.
  [[nodiscard]] const std::vector<GlossaryEntry> &entries() const { return m_entries; }
  /// Where terms stand in a text, as whole words in any case, the longest where several begin at one place:
  /// “signed distance” is no “distance”. From the beginning to the end; none overlap.
  [[nodiscard]] std::vector<TermUse> usesIn(std::string_view text) const;

private:
  /// A form of a term, in small letters.
  struct Form {
    std::string text;
    std::size_t entry;
  };

  std::vector<GlossaryEntry> m_entries;
  std::vector<Form> m_forms; ///< the longest first
};

} // namespace halfspace
