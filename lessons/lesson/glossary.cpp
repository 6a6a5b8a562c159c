#include "lessons/lesson/glossary.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace halfspace {
namespace {

/// Terms are English words: their letters are those of ASCII, and others stay as they are.
char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::string lowered(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), lower);
  return small;
}

/// Whether a word goes on through the place: a letter, a digit or a byte of a sign beyond ASCII stands there.
bool isOfWord(std::string_view text, std::size_t place) {
  return place < text.size() && (std::isalnum(static_cast<unsigned char>(text[place])) != 0 ||
                                 static_cast<unsigned char>(text[place]) >= 0x80);
}

bool beginsWord(std::string_view text, std::size_t place) {
  return isOfWord(text, place) && (place == 0 || !isOfWord(text, place - 1));
}

/// The first of each name, sorted.
std::vector<GlossaryEntry> entriesOf(const LessonLibrary &library) {
  std::vector<GlossaryEntry> glossary;
  std::set<std::string> names;
  for (const Lesson &lesson : library.lessons)
    for (std::size_t step = 0; step < lesson.steps.size(); ++step)
      for (const TaughtTerm &term : lesson.steps[step].terms)
        if (names.insert(lowered(term.name)).second)
          glossary.push_back({&term, &lesson, static_cast<int>(step)});
  std::stable_sort(glossary.begin(), glossary.end(), [](const GlossaryEntry &a, const GlossaryEntry &b) {
    return lowered(a.term->name) < lowered(b.term->name);
  });
  return glossary;
}

} // namespace

Glossary::Glossary(const LessonLibrary &library) : m_entries(entriesOf(library)) {
  for (std::size_t entry = 0; entry < m_entries.size(); ++entry) {
    const TaughtTerm &term = *m_entries[entry].term;
    m_forms.push_back({lowered(term.name), entry});
    for (const std::string &form : term.also)
      m_forms.push_back({lowered(form), entry});
  }
  std::stable_sort(m_forms.begin(), m_forms.end(),
                   [](const Form &a, const Form &b) { return a.text.size() > b.text.size(); });
}

std::vector<TermUse> Glossary::usesIn(std::string_view text) const {
  const std::string small = lowered(text);
  std::vector<TermUse> uses;
  for (std::size_t place = 0; place < small.size(); ++place) {
    if (!beginsWord(small, place))
      continue;
    const auto found = std::find_if(m_forms.begin(), m_forms.end(), [&](const Form &form) {
      return small.compare(place, form.text.size(), form.text) == 0 &&
             !isOfWord(small, place + form.text.size());
    });
    if (found == m_forms.end())
      continue;
    uses.push_back({place, found->text.size(), &m_entries[found->entry]});
    place += found->text.size() - 1;
  }
  return uses;
}

} // namespace halfspace
