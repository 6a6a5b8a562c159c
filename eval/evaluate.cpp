#include "eval/evaluate.h"

#include "eval/line_reader.h"
#include "eval/queries.h"

#include <ostream>

namespace halfspace {
namespace {

void appendFault(std::string &text, std::string_view id, const Fault &fault) {
  text += R"({"id":)";
  text += id;
  text += R"(,"ok":false,"error":{"code":")";
  text += nameOf(fault.code);
  text += R"(","message":)";
  appendQuoted(text, fault.message);
  text += "}}\n";
}

} // namespace

bool Evaluator::answer(std::string_view line, std::string &answers) {
  constexpr std::string_view noId = "null";
  const auto refuse = [&](std::string_view id, const Fault &fault) {
    appendFault(answers, id, fault);
    return false;
  };
  if (line.size() > maxLineLength)
    return refuse(noId, {FaultCode::TooLarge, "The line is longer than 64 MiB."});
  if (const auto fault = m_line.read(line))
    return refuse(noId, {FaultCode::BadJson, "The line is not one JSON object: " + fault->words +
                                                 " at byte " + std::to_string(fault->place) + "."});
  const JsonValue question = m_line.root();
  const auto idGiven = question.find("id");
  const std::string_view id = idGiven ? idGiven->spelling() : noId;
  const auto name = question.find("query");
  const Query query = name && name->kind() == JsonKind::String ? findQuery(name->text()) : nullptr;
  if (query == nullptr)
    return refuse(id, {FaultCode::UnknownQuery, name ? "There is no such query." : "There is no query."});

  const std::size_t start = answers.size();
  answers += R"({"id":)";
  answers += id;
  answers += R"(,"ok":true,"query":)";
  appendQuoted(answers, name->text());
  answers += R"(,"result":{)";
  Operands operands(question);
  Answer answer(answers);
  query(operands, answer);
  if (operands.fault()) {
    answers.resize(start);
    return refuse(id, *operands.fault());
  }
  answers += "}}\n";
  return true;
}

StreamOutcome evaluateLines(std::istream &questions, std::ostream &answers) {
  // Answers are handed on when so much has come together, or when more input must be waited for.
  constexpr std::size_t enough = std::size_t{1} << 16U;
  std::string ready;
  const auto handOn = [&] {
    answers.write(ready.data(), static_cast<std::streamsize>(ready.size()));
    answers.flush();
    ready.clear();
  };
  Evaluator evaluator;
  LineReader reader(questions, handOn);
  bool allAnswered = true;
  while (const auto line = reader.next()) {
    allAnswered = evaluator.answer(*line, ready) && allAnswered;
    if (ready.size() >= enough)
      handOn();
    if (!answers)
      return StreamOutcome::CannotWrite;
  }
  handOn();
  if (!answers)
    return StreamOutcome::CannotWrite;
  if (reader.failed())
    return StreamOutcome::CannotRead;
  return allAnswered ? StreamOutcome::AllAnswered : StreamOutcome::SomeFaults;
}

} // namespace halfspace
