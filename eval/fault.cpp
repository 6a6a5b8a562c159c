#include "eval/fault.h"

namespace halfspace {

std::string_view nameOf(FaultCode code) {
  switch (code) {
  case FaultCode::TooLarge:
    return "too-large";
  case FaultCode::BadJson:
    return "bad-json";
  case FaultCode::UnknownQuery:
    return "unknown-query";
  case FaultCode::MissingOperand:
    return "missing-operand";
  case FaultCode::BadOperand:
    return "bad-operand";
  case FaultCode::ZeroVector:
    return "zero-vector";
  case FaultCode::ZeroNormal:
    return "zero-normal";
  case FaultCode::CollinearPoints:
    return "collinear-points";
  case FaultCode::DegenerateTriangle:
    return "degenerate-triangle";
  case FaultCode::NotPlanar:
    return "not-planar";
  case FaultCode::NotConvex:
    return "not-convex";
  case FaultCode::NotClosed:
    return "not-closed";
  case FaultCode::NotALine:
    return "not-a-line";
  }
  return {};
}

} // namespace halfspace
