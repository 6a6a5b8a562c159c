// Runs a fuzzer's entry on the files of the folders named, as they are and damaged in a fixed series of ways.
#include "tests/effort.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);

namespace {

constexpr int mutationsPerFile = halfspace::test::effort(200);
constexpr std::size_t largestMutant = 20000;

/// What a damaged file may suddenly hold.
constexpr std::array<std::string_view, 18> scraps{"{",     "}",     "[",    "]",       "\"",    "\n",
                                                  "---\n", "```\n", "*a",   "&a ",     "1e999", "-1/0",
                                                  ": ",    "null",  "\xFF", "\\u0000", "## ",   "~"};

void run(const std::string &text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(text.data()), text.size());
}

/// Always the same numbers from the same seed, on every platform.
class Dice {
public:
  explicit Dice(unsigned seed) : m_engine(seed) {}
  std::size_t below(std::size_t end) { return end == 0 ? 0 : m_engine() % end; }

private:
  std::mt19937 m_engine;
};

/// Cuts, copies, puts in or changes a little.
void damage(std::string &text, Dice &dice) {
  const std::size_t at = dice.below(text.size() + 1);
  const std::size_t length = dice.below(40);
  switch (dice.below(5)) {
  case 0:
    text.erase(at, length);
    break;
  case 1:
    text.insert(at, scraps[dice.below(scraps.size())]);
    break;
  case 2:
    text.insert(dice.below(text.size() + 1), text.substr(at, length));
    break;
  case 3:
    if (at < text.size())
      text[at] = static_cast<char>(dice.below(256));
    break;
  default:
    for (std::size_t i = 0; i < length; ++i)
      text.insert(at, scraps[2]);
  }
  text.resize(std::min(text.size(), largestMutant));
}

std::string contentOf(const std::filesystem::path &file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::filesystem::path> filesOf(const std::filesystem::path &folder) {
  std::vector<std::filesystem::path> files;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

int main(int count, char **arguments) {
  int inputs = 0;
  for (int i = 1; i < count; ++i)
    for (const auto &file : filesOf(arguments[i])) {
      const std::string original = contentOf(file);
      run(original);
      Dice dice(static_cast<unsigned>(original.size()));
      for (int mutation = 0; mutation < mutationsPerFile; ++mutation, ++inputs) {
        std::string text = original;
        for (std::size_t left = 1 + dice.below(4); left > 0; --left)
          damage(text, dice);
        run(text);
      }
    }
  std::cout << inputs << " damaged files read\n";
  return inputs > 0 ? 0 : 1;
}
