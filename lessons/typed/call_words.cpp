#include "lessons/typed/call_words.h"

#include "lessons/construction/construction.h"
#include "lessons/object/kind.h"

#include <set>

namespace halfspace {

const std::vector<std::string> &callWords() {
  static const std::vector<std::string> all = [] {
    std::set<std::string> found;
    for (const Kind &kind : kinds())
      if (!kind.shape)
        found.emplace(kind.word);
    for (const Construction &construction : constructions()) {
      found.emplace(construction.id);
      if (!construction.word.empty())
        found.emplace(construction.word);
    }
    return std::vector<std::string>(found.begin(), found.end());
  }();
  return all;
}

} // namespace halfspace
