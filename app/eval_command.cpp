#include "app/eval_command.h"

#include "app/commands.h"
#include "eval/evaluate.h"
#include "lessons/words.h"

#include <fstream>
#include <iostream>

namespace halfspace {

int runEval(const EvalCommand &command) {
  std::ios::sync_with_stdio(false);
  const bool fromFile = !command.file.empty() && command.file != "-";
  std::ifstream file;
  if (fromFile) {
    file.open(command.file, std::ios::binary);
    if (!file)
      return fail({words("The file cannot be opened."), command.file, 0, ""});
  }
  switch (evaluateLines(fromFile ? file : std::cin, std::cout)) {
  case StreamOutcome::AllAnswered:
    return 0;
  case StreamOutcome::SomeFaults:
    return 1;
  case StreamOutcome::CannotRead:
    return fail({words("The questions cannot be read."), fromFile ? command.file : "", 0, ""});
  case StreamOutcome::CannotWrite:
    return fail({words("The answers cannot be written."), "", 0, ""});
  }
  return 0;
}

} // namespace halfspace
