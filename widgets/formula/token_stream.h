// The tokens of a formula one after the other, with the macros replaced by their bodies.
#pragma once

#include "widgets/formula/latex_tokens.h"
#include "widgets/formula/read_latex.h"

#include <map>
#include <string_view>
#include <vector>

namespace halfspace::math {

/// All functions throw ReadError.
class TokenStream {
public:
  /// Source and macros must outlive it.
  TokenStream(std::string_view latex, const Macros &macros);

  /// The next token. Spaces are tokens too.
  [[nodiscard]] const Token &peek();
  /// The next token that is no Space; those before it are gone.
  [[nodiscard]] const Token &peekMath();
  Token take();
  /// The same, behind spaces.
  Token takeMath();
  /// Takes the next token if it is this character. Spaces before it are skipped.
  bool takeIf(char32_t character);
  /// What stands between `open` (which is next) and the `close` that belongs to it, not expanded.
  [[nodiscard]] std::vector<Token> takeBetween(char32_t open, char32_t close);
  /// Puts tokens before the next one.
  void prepend(const std::vector<Token> &tokens);

private:
  void expandNext();
  /// The tokens of a macro's body.
  const std::vector<Token> &bodyOf(const Token &call, std::string_view name);
  void expand(const Token &call);
  /// The body with the arguments in it.
  [[nodiscard]] std::vector<Token> filled(const Token &call,
                                          const std::vector<std::vector<Token>> &arguments);
  [[nodiscard]] std::vector<Token> takeMacroArgument(const Token &call);
  [[nodiscard]] Token takeRaw();

  const Macros &m_macros;
  std::vector<Token> m_upcoming; ///< the next one is the last
  Token m_end;
  std::size_t m_expanded = 0;
  std::map<std::string_view, std::vector<Token>> m_bodies;
};

} // namespace halfspace::math
