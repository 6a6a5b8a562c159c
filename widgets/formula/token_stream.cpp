#include "widgets/formula/token_stream.h"

#include "lessons/words.h"

#include <algorithm>
#include <utility>

namespace halfspace::math {
namespace {

/// `#1` in a macro's body is the first argument.
std::size_t parameterAt(const std::vector<Token> &body, std::size_t at) {
  const bool isOne = body[at].is('#') && at + 1 < body.size() &&
                     body[at + 1].kind == Token::Kind::Character && isAsciiDigit(body[at + 1].character);
  return isOne ? body[at + 1].character - '0' : 0;
}

} // namespace

TokenStream::TokenStream(std::string_view latex, const Macros &macros)
    : m_macros(macros), m_upcoming(tokenize(latex)) {
  m_end.column = m_upcoming.empty() ? 1 : m_upcoming.back().column + 1;
  std::reverse(m_upcoming.begin(), m_upcoming.end());
}

const Token &TokenStream::peek() {
  expandNext();
  return m_upcoming.empty() ? m_end : m_upcoming.back();
}

const Token &TokenStream::peekMath() {
  while (peek().kind == Token::Kind::Space)
    m_upcoming.pop_back();
  return peek();
}

Token TokenStream::take() {
  const Token token = peek();
  if (!m_upcoming.empty())
    m_upcoming.pop_back();
  return token;
}

Token TokenStream::takeMath() {
  (void)peekMath();
  return take();
}

bool TokenStream::takeIf(char32_t character) {
  if (!peekMath().is(character))
    return false;
  m_upcoming.pop_back();
  return true;
}

Token TokenStream::takeRaw() {
  if (m_upcoming.empty())
    return m_end;
  const Token token = m_upcoming.back();
  m_upcoming.pop_back();
  return token;
}

std::vector<Token> TokenStream::takeBetween(char32_t open, char32_t close) {
  const Token first = takeRaw();
  std::vector<Token> inside;
  int braces = 0;
  for (Token token = takeRaw();; token = takeRaw()) {
    if (token.isEnd())
      throw ReadError{first.column,
                      halfspace::words("A `{closer}` is missing for this `{opener}`.",
                                       {{"closer", sourceOf({Token::Kind::Character, close, {}, 0})},
                                        {"opener", sourceOf({Token::Kind::Character, open, {}, 0})}})};
    if (braces == 0 && token.is(close))
      return inside;
    braces += token.is('{') ? 1 : token.is('}') ? -1 : 0;
    inside.push_back(token);
  }
}

void TokenStream::prepend(const std::vector<Token> &tokens) {
  m_upcoming.insert(m_upcoming.end(), tokens.rbegin(), tokens.rend());
}

void TokenStream::expandNext() {
  while (!m_macros.empty() && !m_upcoming.empty() && m_upcoming.back().kind == Token::Kind::Command) {
    if (!m_macros.contains(m_upcoming.back().name))
      return;
    expand(takeRaw());
  }
}

const std::vector<Token> &TokenStream::bodyOf(const Token &call, std::string_view name) {
  const auto [body, isNew] = m_bodies.try_emplace(name);
  if (isNew) {
    try {
      body->second = tokenize(m_macros.find(name)->second.body);
    } catch (const ReadError &error) {
      throw ReadError{call.column,
                      halfspace::words("In the macro `\\{name}`: {sentence}",
                                       {{"name", std::string(name)}, {"sentence", error.sentence}})};
    }
  }
  return body->second;
}

void TokenStream::expand(const Token &call) {
  std::vector<std::vector<Token>> arguments;
  for (int i = 0; i < m_macros.find(call.name)->second.arguments; ++i)
    arguments.push_back(takeMacroArgument(call));
  const std::vector<Token> tokens = filled(call, arguments);
  // An empty body counts too, so that the work of many is bounded, and of one that uses itself.
  m_expanded += tokens.size() + 1;
  if (m_expanded > mostExpandedTokens)
    throw ReadError{call.column,
                    halfspace::words("`{command}` becomes too long.", {{"command", sourceOf(call)}})};
  prepend(tokens);
}

std::vector<Token> TokenStream::filled(const Token &call, const std::vector<std::vector<Token>> &arguments) {
  const std::vector<Token> &body = bodyOf(call, call.name);
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < body.size() && tokens.size() <= mostExpandedTokens; ++i) {
    const std::size_t parameter = parameterAt(body, i);
    if (parameter > 0 && parameter <= arguments.size()) {
      const std::vector<Token> &argument = arguments[parameter - 1];
      tokens.insert(tokens.end(), argument.begin(), argument.end());
      ++i;
    } else {
      tokens.push_back(body[i]);
      tokens.back().column = call.column;
    }
  }
  return tokens;
}

std::vector<Token> TokenStream::takeMacroArgument(const Token &call) {
  while (!m_upcoming.empty() && m_upcoming.back().kind == Token::Kind::Space)
    m_upcoming.pop_back();
  if (m_upcoming.empty() || m_upcoming.back().is('}'))
    throw ReadError{call.column,
                    halfspace::words("`{command}` lacks an argument.", {{"command", sourceOf(call)}})};
  if (m_upcoming.back().is('{'))
    return takeBetween('{', '}');
  return {takeRaw()};
}

} // namespace halfspace::math
