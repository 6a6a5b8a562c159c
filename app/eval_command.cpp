#include "app/eval_command.h"

#include "app/descriptor_buffer.h"
#include "app/standard_streams.h"
#include "eval/evaluate.h"
#include "lessons/words.h"

#include <cerrno>
#include <istream>
#include <ostream>

namespace halfspace {
namespace {

constexpr int exitSomeFaults = 1;

} // namespace

int runEval(const EvalCommand &command) {
  const std::string name = command.file.value_or("-");
  const bool fromFile = name != "-";
  Descriptor file;
  if (fromFile) {
    file = Descriptor(::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
    if (!file.isOpen())
      return fail({whyNotOpened(errno), name, 0, ""});
  }
  DescriptorBuffer input(fromFile ? file.get() : STDIN_FILENO);
  DescriptorBuffer output(STDOUT_FILENO);
  std::istream questions(&input);
  std::ostream answers(&output);
  switch (evaluateLines(questions, answers)) {
  case StreamOutcome::AllAnswered:
    return 0;
  case StreamOutcome::SomeFaults:
    return exitSomeFaults;
  case StreamOutcome::CannotRead:
    return fail({words("The questions cannot be read."), fromFile ? name : "", 0, ""});
  case StreamOutcome::CannotWrite:
    return fail({words("The answers cannot be written."), "", 0, ""});
  }
  return 0;
}

} // namespace halfspace
