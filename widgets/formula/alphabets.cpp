#include "widgets/formula/alphabets.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace::math {
namespace {

/// Where an alphabet's letters begin; 0: it has none of these.
struct Starts {
  char32_t upper = 0;
  char32_t lower = 0;
  char32_t digit = 0;
  char32_t greekUpper = 0;
  char32_t greekLower = 0;
};

constexpr std::array<Starts, 9> starts{{{0x1D434, 0x1D44E, 0, 0x1D6E2, 0x1D6FC}, // italic
                                        {},                                      // upright
                                        {0x1D400, 0x1D41A, 0x1D7CE, 0x1D6A8, 0x1D6C2},
                                        {0x1D468, 0x1D482, 0x1D7CE, 0x1D71C, 0x1D736},
                                        {0x1D538, 0x1D552, 0x1D7D8, 0, 0},
                                        {0x1D49C, 0x1D4B6, 0, 0, 0},
                                        {0x1D504, 0x1D51E, 0, 0, 0},
                                        {0x1D5A0, 0x1D5BA, 0x1D7E2, 0, 0},
                                        {0x1D670, 0x1D68A, 0x1D7F6, 0, 0}}};

/// The Greek variants, which follow ω and ∂ in this order: ϵ ϑ ϰ ϕ ϱ ϖ.
constexpr std::array<char32_t, 6> greekVariants{0x3F5, 0x3D1, 0x3F0, 0x3D5, 0x3F1, 0x3D6};
constexpr char32_t variantsBehindAlpha = 26;

/// Letters that Unicode had before it took in the alphabets: their places there are empty.
constexpr std::array<std::pair<char32_t, char32_t>, 24> holes{
    {{0x1D455, 0x210E}, {0x1D49D, 0x212C}, {0x1D4A0, 0x2130}, {0x1D4A1, 0x2131}, {0x1D4A3, 0x210B},
     {0x1D4A4, 0x2110}, {0x1D4A7, 0x2112}, {0x1D4A8, 0x2133}, {0x1D4AD, 0x211B}, {0x1D4BA, 0x212F},
     {0x1D4BC, 0x210A}, {0x1D4C4, 0x2134}, {0x1D506, 0x212D}, {0x1D50B, 0x210C}, {0x1D50C, 0x2111},
     {0x1D515, 0x211C}, {0x1D51D, 0x2128}, {0x1D53A, 0x2102}, {0x1D53F, 0x210D}, {0x1D545, 0x2115},
     {0x1D547, 0x2119}, {0x1D548, 0x211A}, {0x1D549, 0x211D}, {0x1D551, 0x2124}}};

/// The character as far behind `start` as it is behind `first`; itself when it is not from `first` to `last`
/// or the alphabet has no such letters.
char32_t moved(char32_t character, char32_t first, char32_t last, char32_t start) {
  return start != 0 && character >= first && character <= last ? start + (character - first) : character;
}

char32_t movedVariant(char32_t character, char32_t greekLower) {
  const auto found = std::find(greekVariants.begin(), greekVariants.end(), character);
  if (greekLower == 0 || found == greekVariants.end())
    return character;
  return greekLower + variantsBehindAlpha + static_cast<char32_t>(found - greekVariants.begin());
}

char32_t withoutHole(char32_t character) {
  const auto found = std::find_if(holes.begin(), holes.end(),
                                  [character](const auto &hole) { return hole.first == character; });
  return found == holes.end() ? character : found->second;
}

} // namespace

char32_t inAlphabet(char32_t character, Alphabet alphabet) {
  const Starts &start = starts[static_cast<std::size_t>(alphabet)];
  char32_t to = moved(character, U'A', U'Z', start.upper);
  if (to == character)
    to = moved(character, U'a', U'z', start.lower);
  if (to == character)
    to = moved(character, U'0', U'9', start.digit);
  if (to == character)
    to = moved(character, 0x391, 0x3A9, start.greekUpper); // Α … Ω
  if (to == character)
    to = moved(character, 0x3B1, 0x3C9, start.greekLower); // α … ω
  if (to == character)
    to = movedVariant(character, start.greekLower);
  return withoutHole(to);
}

char32_t withoutAlphabet(char32_t character) {
  constexpr std::array<std::pair<char32_t, char32_t>, 5> ranges{
      {{U'A', U'Z'}, {U'a', U'z'}, {U'0', U'9'}, {0x391, 0x3A9}, {0x3B1, 0x3C9}}};
  for (std::size_t alphabet = 0; alphabet < starts.size(); ++alphabet)
    for (const auto &[first, last] : ranges)
      for (char32_t plain = first; plain <= last; ++plain)
        if (plain != character && inAlphabet(plain, static_cast<Alphabet>(alphabet)) == character)
          return plain;
  return 0;
}

} // namespace halfspace::math
