#include "lessons/term/mathml.h"

#include "lessons/term/prime.h"

#include "tests/lessons/term/term_samples.h"

#include "lessons/term/rewrite.h"
#include "tests/lessons/spoken_to_in.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace halfspace {
namespace {

using namespace test;

const NoteTerms at;
const Term a = unknown("a");
const Term b = unknown("b");

/// Reads tags, attributes in quotes and text; complains of what is not well-formed, and of elements that have
/// not as many children as MathML gives them.
class XmlReader {
public:
  explicit XmlReader(std::string_view text) : m_text(text) {}

  /// What is wrong; empty where nothing is.
  std::string complaint() {
    const bool read = element();
    return m_complaint.empty() && (!read || m_at != m_text.size()) ? "more than one element" : m_complaint;
  }

private:
  bool take(std::string_view expected) {
    if (m_text.substr(m_at, expected.size()) != expected)
      return false;
    m_at += expected.size();
    return true;
  }
  bool fail(const std::string &complaint) {
    if (m_complaint.empty())
      m_complaint = complaint + " at " + std::string(m_text.substr(m_at, 40));
    return false;
  }
  std::string_view word() {
    const auto end = std::min(m_text.find_first_of(" =<>/\"", m_at), m_text.size());
    const std::string_view word = m_text.substr(m_at, end - m_at);
    m_at = end;
    return word;
  }

  bool attributes() {
    while (take(" ")) {
      if (word().empty() || !take("=\""))
        return fail("no attribute");
      const auto end = m_text.find('"', m_at);
      if (end == std::string_view::npos ||
          m_text.substr(m_at, end - m_at).find('<') != std::string_view::npos)
        return fail("no value");
      m_at = end + 1;
    }
    return true;
  }

  bool characters() {
    const auto end = std::min(m_text.find('<', m_at), m_text.size());
    const std::string_view text = m_text.substr(m_at, end - m_at);
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '>' || (text[i] == '&' && text.substr(i).find(';') > 5))
        return fail("a character that must be written otherwise");
    m_at = end;
    return true;
  }

  bool element() {
    static const std::map<std::string_view, int> childrenOf{
        {"mfrac", 2}, {"msup", 2}, {"msub", 2}, {"mover", 2}, {"mi", 0}, {"mn", 0}, {"mo", 0}};
    if (!take("<"))
      return fail("no element");
    const std::string_view name = word();
    if (!attributes())
      return false;
    if (take("/>"))
      return true;
    if (!take(">"))
      return fail("no end of a tag");
    int children = 0;
    while (m_at < m_text.size() && characters() && m_text.substr(m_at, 2) != "</") {
      if (!element())
        return false;
      ++children;
    }
    if (!take("</" + std::string(name) + ">"))
      return fail(std::string(name) + " is not closed");
    const auto expected = childrenOf.find(name);
    return expected == childrenOf.end() || expected->second == children ||
           fail(std::string(name) + " has " + std::to_string(children) + " children");
  }

  std::string_view m_text;
  std::size_t m_at = 0;
  std::string m_complaint;
};

/// What stands in the `<math>` element.
std::string inside(const std::string &text) {
  const auto begin = text.find('>') + 1;
  return text.substr(begin, text.rfind("</math>") - begin);
}

TEST(MathMl, OfNumbersAndNames_HasTheirElements) {
  EXPECT_EQ(inside(mathMl(a + 2)), "<mrow><mi>a</mi><mo>+</mo><mn>2</mn></mrow>");
  EXPECT_EQ(inside(mathMl(name(letter("P", "0"), std::nullopt))), "<msub><mi>P</mi><mn>0</mn></msub>");
  EXPECT_EQ(inside(mathMl(name(vectorLetter("n"), std::nullopt))),
            "<mover accent=\"true\"><mi>n</mi><mo>→</mo></mover>");
  EXPECT_EQ(inside(mathMl(a / b)), "<mfrac><mi>a</mi><mi>b</mi></mfrac>");
  EXPECT_EQ(inside(mathMl(a / Rational(1, 2))),
            "<mfrac><mi>a</mi><mrow><mn>1</mn><mo>/</mo><mn>2</mn></mrow></mfrac>");
  EXPECT_EQ(inside(mathMl(power(-a, 2))),
            "<msup><mrow><mo>(</mo><mrow><mo form=\"prefix\">−</mo><mi>a</mi></mrow><mo>)</mo></mrow>"
            "<mn>2</mn></msup>");
}

TEST(MathMl, OfAMark_CarriesItsId) {
  EXPECT_EQ(inside(mathMl(at.Q)), "<mrow data-mark=\"Q\"><mi>Q</mi></mrow>");
  EXPECT_EQ(inside(mathMl(a.marked("a\"<b>&"))),
            "<mrow data-mark=\"a&quot;&lt;b&gt;&amp;\"><mi>a</mi></mrow>");
}

TEST(MathMl, OfComparisons_EscapesTheirSigns) {
  EXPECT_NE(mathMl(compared(-1, 0)).find("<mo>&lt;</mo>"), std::string::npos);
  EXPECT_NE(mathMl(compared(1, 0)).find("<mo>&gt;</mo>"), std::string::npos);
}

TEST(MathMl, WithADecimalComma_PartsListsBySemicolons) {
  const test::SpokenToIn language(test::withDecimalComma());
  EXPECT_EQ(inside(mathMl(list({Rational(637, 100), 2}))),
            "<mrow><mo>(</mo><mn>6,37</mn><mo>;</mo><mn>2</mn><mo>)</mo></mrow>");
}

TEST(MathMl, OfAnyTerm_IsWellFormed) {
  RandomTerms random(5, true);
  for (int i = 0; i < 500 && !HasFailure(); ++i) {
    const Term term = i % 2 == 0 ? random.number(4) : random.vector(4);
    const std::string text = mathMl(withNumbers(term == term));
    EXPECT_EQ(XmlReader(text).complaint(), "") << text;
  }
}

TEST(MathMl, OfEveryOtherKind_IsWellFormed) {
  const Term theta = name(letter("θ"), std::nullopt);
  for (const Term &term : {determinant(2, {a, b, 1, 2}), matrix(1, {a, b / 2}), permuted(a, b, a, b),
                           applied(word("cos"), theta, Real(1)), at.f, name(perpLetter("u"), std::nullopt),
                           name(primed(vectorLetter("v")), std::nullopt), name(word("dist"), std::nullopt),
                           Term(powerOfTen(40))})
    EXPECT_EQ(XmlReader(mathMl(term)).complaint(), "") << mathMl(term);
}

TEST(XmlReader, OfWhatIsNotWellFormed_Complains) {
  for (const char *text :
       {"<a>", "<a></b>", "<a/><b/>", "<a b=c/>", "<a>x > y</a>", "<a>&</a>", "<mfrac><mi/></mfrac>"})
    EXPECT_NE(XmlReader(text).complaint(), "") << text;
}

} // namespace
} // namespace halfspace
