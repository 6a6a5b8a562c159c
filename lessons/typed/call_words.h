// The words that can be called in a typed line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

struct Construction;

/// Those of the kinds of objects, and the ids and words of the constructions, each once.
[[nodiscard]] const std::vector<std::string> &callWords();

/// What a construction is called in a line that is written: its word, `intersect`, where whatever stands in
/// its roles leads to it and to none that is asked first; else its id. That goes for ids too that have the
/// word among their own, and so say more: `signed-distance`.
[[nodiscard]] std::string_view callOf(const Construction &construction);

} // namespace halfspace
