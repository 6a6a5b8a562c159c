#include "tests/lessons/construction/claims/said.h"
#include "lessons/language.h"

#include <stdexcept>
#include <utility>

namespace halfspace::test {
namespace {

// Control characters, which no sentence has: \1 English \2 sentence \3, and at each place \4 text \5.
constexpr char beginsEnglish = '\1';
constexpr char endsEnglish = '\2';
constexpr char endsSentence = '\3';
constexpr char beginsPlace = '\4';
constexpr char endsPlace = '\5';
constexpr char shieldedOpen = '\6';
constexpr char shieldedClose = '\7';

/// With other brackets, so that its places are not filled in.
std::string shielded(std::string english) {
  for (char &letter : english)
    letter = letter == '{' ? shieldedOpen : letter == '}' ? shieldedClose : letter;
  return english;
}

std::string unshielded(std::string english) {
  for (char &letter : english)
    letter = letter == shieldedOpen ? '{' : letter == shieldedClose ? '}' : letter;
  return english;
}

std::string marked(const char *english) {
  std::string text = beginsEnglish + shielded(english) + endsEnglish;
  for (const char letter : std::string_view(english)) {
    if (letter == '{')
      text += beginsPlace; // the name is read off the English sentence
    text += letter;
    if (letter == '}')
      text += endsPlace;
  }
  return text + endsSentence;
}

/// The names of a sentence's places, in their order.
std::vector<std::string> placesOf(const std::string &english) {
  std::vector<std::string> names;
  for (auto open = english.find('{'); open != std::string::npos; open = english.find('{', open + 1))
    names.push_back(english.substr(open + 1, english.find('}', open) - open - 1));
  return names;
}

/// Reads marked text from left to right.
class Reader {
public:
  explicit Reader(std::string_view text) : m_rest(text) {}

  /// The text up to a mark that ends it, or to the end; the sentences in it are kept.
  std::string readUntil(char end) {
    std::string text;
    while (!m_rest.empty() && m_rest.front() != end) {
      if (m_rest.front() == beginsEnglish)
        text += readSentence();
      else
        text += take();
    }
    if (!m_rest.empty())
      take();
    return text;
  }

  std::vector<Said> &&sentences() && { return std::move(m_sentences); }

private:
  char take() {
    const char letter = m_rest.front();
    m_rest.remove_prefix(1);
    return letter;
  }

  std::string readSentence() {
    take();
    const auto length = m_rest.find(endsEnglish);
    if (length == std::string_view::npos)
      throw std::invalid_argument("a sentence was cut in two");
    Said said{unshielded(std::string(m_rest.substr(0, length)))};
    m_rest.remove_prefix(length + 1);
    std::string text;
    for (const std::string &place : placesOf(said.english)) {
      text += readUntil(beginsPlace);
      text += said.texts[place] = readUntil(endsPlace);
    }
    text += readUntil(endsSentence);
    said.text = text;
    m_sentences.push_back(std::move(said));
    return text;
  }

  std::string_view m_rest;
  std::vector<Said> m_sentences;
};

} // namespace

std::string Said::at(const std::string &place) const {
  const auto found = texts.find(place);
  return found == texts.end() ? std::string() : found->second;
}

MarkedSentences::MarkedSentences() { setLanguage({marked}); }

MarkedSentences::~MarkedSentences() { setLanguage({}); }

std::vector<Said> sentencesIn(std::string_view marked) {
  Reader reader(marked);
  reader.readUntil('\0');
  return std::move(reader).sentences();
}

std::string withoutMarks(std::string_view marked) { return Reader(marked).readUntil('\0'); }

} // namespace halfspace::test
