#include "lessons/scene/scene_looks.h"

#include "lessons/object/kind.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

/// What further objects take, those first that are best told from one another and from the blue of planes.
constexpr std::array furtherHues{Hue::Green, Hue::Pink, Hue::Purple, Hue::Orange, Hue::Yellow, Hue::Blue};

std::optional<Subject> subjectOf(const Entry &entry) {
  const Kind *kind = kindOf(entry);
  return kind ? kind->subject : std::nullopt;
}

/// How many objects have a hue.
class HueCounts {
public:
  void add(Hue hue) { ++m_counts.at(static_cast<std::size_t>(hue)); }
  [[nodiscard]] Hue rarest() const {
    return *std::min_element(furtherHues.begin(), furtherHues.end(),
                             [&](Hue a, Hue b) { return count(a) < count(b); });
  }

private:
  [[nodiscard]] std::size_t count(Hue hue) const { return m_counts.at(static_cast<std::size_t>(hue)); }

  std::array<std::size_t, hueCount> m_counts{};
};

} // namespace

std::vector<Look> looksOf(const Scene &scene) {
  std::vector<Look> looks;
  std::map<Subject, std::size_t> objects;
  HueCounts counts;
  for (const Entry &entry : scene.entries) {
    Look look{entry.color, entry.line};
    if (look.hue)
      counts.add(*look.hue);
    if (const auto subject = subjectOf(entry)) {
      look.rank = objects[*subject]++;
      if (!look.hue && look.rank == 0)
        counts.add(hueOf(*subject));
    }
    looks.push_back(look);
  }
  for (Look &look : looks)
    if (look.rank > 0 && !look.hue) {
      look.hue = counts.rarest();
      counts.add(*look.hue);
    }
  return looks;
}

} // namespace halfspace
