// What is wrong with a question.
#pragma once

#include <string>
#include <string_view>

namespace halfspace {

/// The codes of error answers. Where several apply, the first of this list is given.
enum class FaultCode {
  TooLarge,
  BadJson,
  UnknownQuery,
  MissingOperand,
  BadOperand,
  ZeroVector,
  ZeroNormal,
  CollinearPoints,
  DegenerateTriangle,
  NotPlanar,
  NotConvex,
  NotClosed,
  NotALine,
};

/// As it is written in an answer: `bad-operand`.
[[nodiscard]] std::string_view nameOf(FaultCode code);

struct Fault {
  FaultCode code;
  std::string message; ///< for a person: what is wrong with which operand
};

} // namespace halfspace
