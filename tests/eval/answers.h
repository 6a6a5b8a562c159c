// Asks an evaluator, and takes its answers apart with another JSON library.
#pragma once

#include "eval/evaluate.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace halfspace {

using Json = nlohmann::ordered_json;

/// The answer to one line as it is written, without its end.
inline std::string answerTo(std::string_view line) {
  Evaluator evaluator;
  std::string answer;
  evaluator.answer(line, answer);
  EXPECT_TRUE(answer.ends_with('\n')) << answer;
  answer.pop_back();
  return answer;
}

inline Json parsed(const std::string &answer) {
  Json json = Json::parse(answer, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << answer;
  return json;
}

/// The result that a question has.
inline Json resultOf(std::string_view line) {
  const Json answer = parsed(answerTo(line));
  EXPECT_EQ(answer.value("ok", false), true) << answer;
  return answer.value("result", Json());
}

/// The code of the fault that a question has.
inline std::string codeOf(std::string_view line) {
  const Json answer = parsed(answerTo(line));
  if (answer.value("ok", true) || answer["error"].value("message", "").empty())
    return "no fault with a message: " + answer.dump();
  return answer["error"].value("code", "");
}

} // namespace halfspace
