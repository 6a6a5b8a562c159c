#include "widgets/formula/index_runs.h"

#include "lessons/text.h"

#include <hb.h>

#include <algorithm>

namespace halfspace::math {
namespace {

constexpr char32_t firstSmallDigit = U'₀';
constexpr char32_t lastSmallDigit = U'₉';
constexpr char32_t prime = U'′';

bool isSmallDigit(char32_t character) { return character >= firstSmallDigit && character <= lastSmallDigit; }

hb_unicode_general_category_t categoryOf(char32_t character) {
  return hb_unicode_general_category(hb_unicode_funcs_get_default(), character);
}

bool isUnicodeLetter(char32_t character) {
  switch (categoryOf(character)) {
  case HB_UNICODE_GENERAL_CATEGORY_LOWERCASE_LETTER:
  case HB_UNICODE_GENERAL_CATEGORY_MODIFIER_LETTER:
  case HB_UNICODE_GENERAL_CATEGORY_OTHER_LETTER:
  case HB_UNICODE_GENERAL_CATEGORY_TITLECASE_LETTER:
  case HB_UNICODE_GENERAL_CATEGORY_UPPERCASE_LETTER:
    return true;
  default:
    return false;
  }
}

bool isNumber(char32_t character) {
  switch (categoryOf(character)) {
  case HB_UNICODE_GENERAL_CATEGORY_DECIMAL_NUMBER:
  case HB_UNICODE_GENERAL_CATEGORY_LETTER_NUMBER:
  case HB_UNICODE_GENERAL_CATEGORY_OTHER_NUMBER:
    return true;
  default:
    return false;
  }
}

bool isMark(char32_t character) {
  switch (categoryOf(character)) {
  case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
  case HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK:
  case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
    return true;
  default:
    return false;
  }
}

/// Whether a character may have an index: a letter with its accents and small digits.
bool bearsIndex(char32_t character) {
  return isUnicodeLetter(character) || isMark(character) || character == prime ||
         categoryOf(character) == HB_UNICODE_GENERAL_CATEGORY_OTHER_NUMBER;
}

bool standsInIndex(char32_t character) { return isUnicodeLetter(character) || isNumber(character); }

/// A character of a text with the bytes that it has there.
struct Place {
  char32_t code;
  std::string_view bytes;
};

std::vector<Place> charactersOf(std::string_view text) {
  std::vector<Place> characters;
  while (!text.empty()) {
    const std::size_t length = lengthOfFirst(text);
    characters.push_back({firstCharacter(text).code, text.substr(0, length)});
    text.remove_prefix(length);
  }
  return characters;
}

/// Puts runs together.
class Runs {
public:
  explicit Runs(std::string_view plain) : m_characters(charactersOf(plain)) {}

  std::vector<IndexRun> make() {
    std::string run;
    std::size_t i = 0;
    while (i < m_characters.size()) {
      const std::size_t mark = markBehindDigits(i);
      if (mark == m_characters.size()) {
        run += m_characters[i++].bytes;
        continue;
      }
      m_runs.push_back({std::move(run)});
      run.clear();
      i = addIndex(i, mark);
    }
    if (!run.empty() || m_runs.empty())
      m_runs.push_back({std::move(run)});
    return std::move(m_runs);
  }

private:
  /// The place of the `_` of an index that begins here, with the small digits before it or with the mark
  /// itself; the end where none does.
  [[nodiscard]] std::size_t markBehindDigits(std::size_t begin) const {
    const std::size_t none = m_characters.size();
    if (begin == 0 || !bearsIndex(m_characters[begin - 1].code))
      return none;
    std::size_t mark = begin;
    while (mark < none && isSmallDigit(m_characters[mark].code))
      ++mark;
    const bool isIndex =
        mark + 1 < none && m_characters[mark].bytes == "_" && standsInIndex(m_characters[mark + 1].code);
    return isIndex ? mark : none;
  }

  /// Small digits ahead of a letter's index belong to it: P₀_E has the index 0,E, as in formulas. Where the
  /// index ends.
  std::size_t addIndex(std::size_t begin, std::size_t mark) {
    std::string index;
    for (std::size_t i = begin; i < mark; ++i)
      index += static_cast<char>('0' + (m_characters[i].code - firstSmallDigit));
    if (!index.empty())
      index += ',';
    std::size_t end = mark + 1;
    while (end < m_characters.size() && standsInIndex(m_characters[end].code))
      index += m_characters[end++].bytes;
    std::string written;
    for (std::size_t i = begin; i < end; ++i)
      written += m_characters[i].bytes;
    m_runs.push_back({std::move(index), true, std::move(written)});
    return end;
  }

  std::vector<Place> m_characters;
  std::vector<IndexRun> m_runs;
};

} // namespace

std::vector<IndexRun> indexRunsOf(std::string_view plain) {
  if (plain.find('_') == std::string_view::npos)
    return {{std::string(plain)}};
  return Runs(plain).make();
}

} // namespace halfspace::math
