// Whatever the bytes: each line is an entry, whose own line is read as it again, or a fault within the line;
// and what it can be completed to is selected within itself.
#include "lessons/typed/complete_line.h"
#include "lessons/typed/read_line.h"
#include "lessons/typed/write_line.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  using namespace halfspace;
  const auto demand = [](bool holds) {
    if (!holds)
      std::abort();
  };
  constexpr std::size_t mostEntries = 30; // more take time and show nothing new
  std::string_view text(reinterpret_cast<const char *>(data), size);
  Scene scene;
  while (!text.empty() && scene.entries.size() < mostEntries) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    for (const LineCompletion &each : completionsOf(line, line.size() / 2, scene, '.', 2))
      demand(each.selectedAt + each.selectedLength <= each.line.size());
    auto read = readLine(line, scene, line.size() % 2 == 0 ? '.' : ',');
    if (const auto *fault = std::get_if<TypedFault>(&read)) {
      demand(!fault->sentence.empty() && fault->at <= line.size());
      continue;
    }
    const Entry &entry = std::get<Entry>(read);
    const auto again = readLine(lineFor(entry), scene);
    demand(std::holds_alternative<Entry>(again) && std::get<Entry>(again) == entry);
    scene.entries.push_back(entry);
  }
  return 0;
}
