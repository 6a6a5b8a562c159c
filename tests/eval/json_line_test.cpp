#include "eval/json_line.h"
#include "tests/effort.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <random>
#include <set>

namespace halfspace {
namespace {

using Json = nlohmann::json;

bool isRead(std::string_view text) { return !JsonLine().read(text); }

/// Listens to another library's parser and adds our own rules: a key once in an object, bounded nesting.
class StrictListener : public nlohmann::json_sax<Json> {
public:
  bool key(string_t &key) override { return m_keys.back().insert(key).second; }
  bool start_object(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t &) override { return true; }
  bool string(string_t &) override { return true; }
  bool binary(binary_t &) override { return false; }
  bool parse_error(std::size_t, const std::string &, const nlohmann::detail::exception &fault) override {
    constexpr int outOfRange = 406;
    m_numberTooLarge = fault.id == outOfRange;
    return false;
  }

  /// The other library stops at 1e999, which is a number to us: then it has no verdict.
  [[nodiscard]] bool numberTooLarge() const { return m_numberTooLarge; }

private:
  bool enter() {
    m_keys.emplace_back();
    return m_keys.size() <= maxJsonDepth;
  }
  bool leave() {
    m_keys.pop_back();
    return true;
  }

  std::vector<std::set<std::string>> m_keys;
  bool m_numberTooLarge = false;
};

/// The other library ends a text at a zero byte, passes over a byte order mark, and takes any value.
std::optional<bool> verdictOfOther(const std::string &text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (text.find('\0') != std::string::npos || text.starts_with("\xEF"))
    return {};
  if (first == std::string::npos || text[first] != '{')
    return false;
  StrictListener listener;
  const bool accepted = Json::sax_parse(text, &listener);
  return listener.numberTooLarge() ? std::nullopt : std::optional(accepted);
}

/// Whether our tree holds what the other library reads.
bool holds(const JsonValue &ours, const Json &other) {
  switch (other.type()) {
  case Json::value_t::object: {
    bool same = ours.kind() == JsonKind::Map && ours.elements().size() == other.size();
    for (const auto &[key, value] : other.items()) {
      const auto found = same ? ours.find(key) : std::nullopt;
      same = found && holds(*found, value);
    }
    return same;
  }
  case Json::value_t::array: {
    const auto elements = ours.elements();
    return ours.kind() == JsonKind::List &&
           std::equal(elements.begin(), elements.end(), other.begin(), other.end(), holds);
  }
  case Json::value_t::string:
    return ours.kind() == JsonKind::String && ours.text() == other.get<std::string>();
  case Json::value_t::null:
    return ours.kind() == JsonKind::Null;
  case Json::value_t::boolean:
    return ours.kind() == (other.get<bool>() ? JsonKind::True : JsonKind::False);
  default:
    return ours.kind() == JsonKind::Number && Json::parse(ours.spelling()) == other;
  }
}

const std::vector<std::string> seeds{
    R"({"id":1,"query":"plane","plane":{"coefficients":[1,-2.5,3e2,"1/3"]}})",
    R"({"a":[true,false,null,[],{},[[]]],"b":{"c":{"d":"e"}}})",
    R"({"text":"\u00e9\ud83d\ude00\n\t\"\\\/\b\f\r","\u0061b":"ü€😀"})",
    R"( { "n" : [ 0 , -0 , 0.5 , 1E+2 , 1e-2 , 12345678901234567890 ] } )",
    R"({"k1":1,"k2":2,"k3":3,"k4":4,"k5":5,"k6":6,"k7":7,"k8":8,"k9":9,"k10":10})"};

const std::vector<std::string> scraps{
    "{",       "}",       "[",        "]",        ",",    ":",        "\"",       "\\",        "\\u",
    "\\ud83d", "\\udc00", "0",        "-",        ".",    "e",        "E+",       "null",      "true",
    " ",       "\t",      "\x1f",     "\x7f",     "\xff", "\xc3\xa9", "\xed\xa0", "\"a\":",    "1",
    "\"k1\"",  "é",       "\xf0\x9f", "\xc0\xaf", "//",   "NaN",      "[0,",      "{\"a\":{}}"};

class Mutations {
public:
  explicit Mutations(unsigned seed) : m_engine(seed) {}

  std::string next() {
    std::string text = seeds[below(seeds.size())];
    for (std::size_t left = 1 + below(3); left > 0; --left)
      damage(text);
    return text;
  }

private:
  std::size_t below(std::size_t end) { return end == 0 ? 0 : m_engine() % end; }

  void damage(std::string &text) {
    const std::size_t at = below(text.size() + 1);
    switch (below(4)) {
    case 0:
      text.erase(at, 1 + below(3));
      break;
    case 1:
      text.insert(at, scraps[below(scraps.size())]);
      break;
    case 2:
      text.insert(below(text.size() + 1), text.substr(at, below(12)));
      break;
    default:
      if (at < text.size())
        text[at] = static_cast<char>(1 + below(255));
    }
  }

  std::mt19937 m_engine;
};

TEST(JsonLine, DamagedTexts_AreReadExactlyWhereAnotherLibraryWithOurRulesReadsThem) {
  Mutations mutations(171);
  int valid = 0;
  int invalid = 0;
  for (int i = 0; i < test::effort(60'000); ++i) {
    const std::string text = mutations.next();
    const auto expected = verdictOfOther(text);
    if (!expected)
      continue;
    (*expected ? valid : invalid) += 1;
    JsonLine line;
    ASSERT_EQ(!line.read(text), *expected) << text;
    if (*expected) {
      ASSERT_TRUE(holds(line.root(), Json::parse(text))) << text;
    }
  }
  EXPECT_GT(valid, test::effort(5000));
  EXPECT_GT(invalid, test::effort(5000));
}

TEST(JsonLine, Seeds_HoldWhatTheySay) {
  for (const std::string &text : seeds) {
    JsonLine line;
    ASSERT_FALSE(line.read(text)) << text;
    EXPECT_TRUE(holds(line.root(), Json::parse(text))) << text;
    EXPECT_EQ(line.root().spelling(), text.substr(text.find('{'), text.rfind('}') - text.find('{') + 1));
  }
}

TEST(JsonLine, AnythingButOneObject_IsRefused) {
  for (const char *text : {"",
                           " ",
                           "[]",
                           "1",
                           "null",
                           "\"a\"",
                           "{}{}",
                           "{} {}",
                           "{},",
                           "{",
                           "}",
                           "{]",
                           "nul",
                           "{\"a\"}",
                           "{\"a\":}",
                           "{\"a\":1,}",
                           "{,}",
                           "{a:1}",
                           "{'a':1}",
                           "{\"a\":[1,]}",
                           "{\"a\":1 \"b\":2}",
                           "{1:2}",
                           "{\"a\":1}x",
                           "\xEF\xBB\xBF{}",
                           "{} // comment"})
    EXPECT_FALSE(isRead(text)) << text;
  EXPECT_FALSE(isRead(std::string_view("{}\0", 3)));
  EXPECT_FALSE(isRead(std::string_view("\0{}", 3)));
  EXPECT_TRUE(isRead(" \t\r\n{ } \r"));
}

TEST(JsonLine, KeyTwice_IsRefusedHoweverItIsSpelledAndWhereverItIs) {
  EXPECT_FALSE(isRead(R"({"a":1,"a":1})"));
  EXPECT_FALSE(isRead(R"({"a":1,"\u0061":2})"));
  EXPECT_FALSE(isRead(R"({"\u0061":1,"\u0061":2})"));
  EXPECT_FALSE(isRead(R"({"\/":1,"/":2})"));
  EXPECT_FALSE(isRead(R"({"😀":1,"\ud83d\uDE00":2})"));
  EXPECT_FALSE(isRead(R"({"x":[{"id":{"a":1,"b":2,"a":3}}]})"));
  EXPECT_FALSE(isRead(R"({"":1,"":2})"));
  EXPECT_TRUE(isRead(R"({"a":{"a":{"a":1}},"b":[{"a":1},{"a":2}],"A":"a"})"));
  EXPECT_TRUE(isRead(R"({"a":1,"\\u0061":2})"));
}

TEST(JsonLine, KeyTwiceAmongMany_IsRefusedWhereverTheTwoStand) {
  constexpr int keys = 20;
  const auto withKeys = [](int first, int second) {
    std::string text = "{";
    for (int key = 0; key < keys; ++key)
      text += (key == 0 ? "\"k" : ",\"k") + std::to_string(key == second ? first : key) + "\":[" +
              std::to_string(key) + "]";
    return text + "}";
  };
  for (int second = 0; second < keys; ++second)
    for (int first = 0; first <= second; ++first)
      EXPECT_EQ(isRead(withKeys(first, second)), first == second) << first << " " << second;
}

TEST(JsonLine, NestingOf64_IsReadAndOf65Refused) {
  const auto nested = [](int depth, const std::string &open, const std::string &close) {
    std::string text = "{\"a\":";
    for (int i = 1; i < depth; ++i)
      text += open;
    text += "1";
    for (int i = 1; i < depth; ++i)
      text += close;
    return text + "}";
  };
  EXPECT_TRUE(isRead(nested(64, "[", "]")));
  EXPECT_FALSE(isRead(nested(65, "[", "]")));
  EXPECT_TRUE(isRead(nested(64, "{\"b\":", "}")));
  EXPECT_FALSE(isRead(nested(65, "{\"b\":", "}")));
  EXPECT_FALSE(isRead(nested(1'000'000, "[", "]")));
}

TEST(JsonLine, EmptyContainerAtTheLimit_CountsAsALevel) {
  const std::string open(62, '[');
  const std::string close(62, ']');
  EXPECT_TRUE(isRead("{\"a\":" + open + "[]" + close + "}"));
  EXPECT_FALSE(isRead("{\"a\":" + open + "[[]]" + close + "}"));
  EXPECT_FALSE(isRead("{\"a\":" + open + "[{}]" + close + "}"));
}

TEST(JsonLine, HalfASurrogatePair_IsRefused) {
  for (const char *inside : {R"(\ud83d)", R"(\ude00)", R"(\ud83d\u0041)", R"(\ud83dx)", R"(\ud83d\ud83d)",
                             R"(\ude00\ud83d)", R"(\ud83d\\ude00)", R"(\uDBFF)", R"(\ud83d\ude0)"}) {
    EXPECT_FALSE(isRead("{\"a\":\"" + std::string(inside) + "\"}")) << inside;
    EXPECT_FALSE(isRead("{\"" + std::string(inside) + "\":0}")) << inside;
  }
  EXPECT_TRUE(isRead(R"({"a":"\ud83d\ude00\uFFFF\u0000"})"));
}

TEST(JsonLine, InvalidUtf8_IsRefusedInStrings) {
  for (const char *bytes :
       {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xC3", "\xC3(", "\xE0\x80\x80", "\xE0\x9F\xBF", "\xE2\x82",
        "\xED\xA0\x80", "\xED\xBF\xBF", "\xEF\xBF", "\xF0\x80\x80\x80", "\xF0\x8F\xBF\xBF", "\xF0\x9F\x98",
        "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFE", "\xFF"}) {
    EXPECT_FALSE(isRead("{\"a\":\"" + std::string(bytes) + "\"}")) << bytes;
    EXPECT_FALSE(isRead("{\"a\":\"" + std::string(bytes))) << bytes;
  }
  for (const char *text : {"\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
                           "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_TRUE(isRead("{\"a\":\"" + std::string(text) + "\"}")) << text;
}

TEST(JsonLine, ControlCharacters_AreRefusedInStringsAndReadAsEscapes) {
  for (int code = 0; code < 0x20; ++code) {
    const auto c = static_cast<char>(code);
    EXPECT_FALSE(isRead(std::string("{\"a\":\"") + c + "\"}")) << code;
    constexpr std::string_view digits = "0123456789abcdef";
    const std::string escape =
        std::string("\\u00") + (code < 16 ? '0' : '1') + digits[static_cast<std::size_t>(code % 16)];
    const std::string text = "{\"a\":\"" + escape + "\"}";
    JsonLine line;
    ASSERT_FALSE(line.read(text));
    EXPECT_EQ(line.root().find("a")->text(), std::string(1, c));
  }
}

TEST(JsonLine, Escapes_AreThoseOfJsonAndNoOthers) {
  for (const char *escape : {R"(\a)", R"(\')", R"(\x41)", R"(\0)", R"(\u12)", R"(\u12g4)", R"(\U0041)", "\\"})
    EXPECT_FALSE(isRead("{\"a\":\"" + std::string(escape) + "\"}")) << escape;
}

TEST(JsonLine, NumbersOfTheRightForm_KeepTheirSpellingHoweverLarge) {
  for (const char *number :
       {"0", "-0", "0.0", "-0.0e-0", "1E400", "1e99999999999999999999", "123456789012345678901234567890",
        "0.1", "1e+05", "-1.50E-007", "9007199254740993"}) {
    const std::string text = "{\"a\":" + std::string(number) + "}";
    JsonLine line;
    ASSERT_FALSE(line.read(text)) << number;
    EXPECT_EQ(line.root().find("a")->spelling(), number);
    EXPECT_EQ(line.root().find("a")->kind(), JsonKind::Number);
  }
}

TEST(JsonLine, NumbersOfAnotherForm_AreRefused) {
  for (const char *number :
       {"01",    "-01",  "00",    "+1",  ".5",       "1.",        "-",   "--1",  "1e", "1e+", "1.e3",
        "1.5.2", "0x10", "1_000", "NaN", "Infinity", "-Infinity", "1/2", "1,5e", "e5", "- 1", "1 e5"})
    EXPECT_FALSE(isRead("{\"a\":" + std::string(number) + "}")) << number;
}

TEST(JsonLine, HasExactly_WantsAllTheKeysAndNoOthers) {
  JsonLine line;
  ASSERT_FALSE(line.read(R"({"a":1,"\u0062":2})"));
  EXPECT_TRUE(line.root().hasExactly({"a", "b"}));
  EXPECT_TRUE(line.root().hasExactly({"b", "a"}));
  EXPECT_FALSE(line.root().hasExactly({"a"}));
  EXPECT_FALSE(line.root().hasExactly({"a", "c"}));
  EXPECT_FALSE(line.root().hasExactly({"a", "b", "c"}));
  EXPECT_FALSE(line.root().find("a")->hasExactly({}));
  EXPECT_FALSE(line.root().find("a")->find("b"));
  EXPECT_FALSE(line.root().find("c"));
}

TEST(JsonLine, Fault_TellsTheByte) {
  JsonLine line;
  EXPECT_EQ(line.read(R"({"a":01})")->place, 7U);
  EXPECT_EQ(line.read("[]")->place, 1U);
  EXPECT_FALSE(line.read("{}")) << "what was wrong before is forgotten";
}

} // namespace
} // namespace halfspace
