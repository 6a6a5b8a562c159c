// Whatever the bytes: for each line one answer, which another JSON library reads too, with the line's id and
// a result or a fault of the table.
#include "eval/evaluate.h"
#include "eval/line_reader.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <sstream>

namespace {

using Json = nlohmann::json;
using namespace halfspace;

void demand(bool holds) {
  if (!holds)
    std::abort();
}

bool isCode(const std::string &code) {
  constexpr std::array<std::string_view, 13> codes{
      "too-large",   "bad-json",    "unknown-query",    "missing-operand",     "bad-operand",
      "zero-vector", "zero-normal", "collinear-points", "degenerate-triangle", "not-planar",
      "not-convex",  "not-closed",  "not-a-line"};
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

/// The id as the line spells it; `null` where there is none, or the line cannot be read.
std::string idOf(std::string_view line) {
  JsonLine json;
  if (json.read(line))
    return "null";
  const auto id = json.root().find("id");
  return std::string(id ? id->spelling() : "null");
}

/// The other library refuses numbers beyond the range of doubles, which an id may hold: it is read without
/// its id.
Json withoutId(std::string answer, const std::string &id) {
  const std::string front = R"({"id":)" + id;
  demand(answer.starts_with(front));
  answer.replace(0, front.size(), R"({"id":0)");
  Json json = Json::parse(answer, nullptr, false);
  demand(!json.is_discarded());
  return json;
}

void checkAnswer(std::string_view line, const std::string &answer, bool answered) {
  demand(answer.find('\n') == answer.size() - 1);
  JsonLine own;
  demand(!own.read(answer));
  const Json json = withoutId(answer, idOf(line));
  demand(json.at("ok") == answered);
  if (answered) {
    demand(json.size() == 4 && json.at("query").is_string() && !json.at("result").empty());
  } else {
    const Json &error = json.at("error");
    demand(json.size() == 3 && error.size() == 2 && isCode(error.at("code")));
    demand(!error.at("message").get<std::string>().empty());
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  std::istringstream stream(std::string(reinterpret_cast<const char *>(data), size));
  LineReader reader(stream, [] {});
  Evaluator evaluator;
  while (const auto line = reader.next()) {
    std::string answer;
    const bool answered = evaluator.answer(*line, answer);
    checkAnswer(*line, answer, answered);
  }
  demand(!reader.failed());
  return 0;
}
