#include "lessons/scene/scene_looks.h"

#include "lessons/object/kind.h"

#include <algorithm>
#include <array>
#include <map>

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

/// The colours in which objects are drawn, by the names of their entries.
std::map<std::string, Hue> huesOf(const Scene &scene) {
  std::map<std::string, Hue> hues;
  const std::vector<Look> looks = looksOf(scene);
  for (std::size_t i = 0; i < looks.size(); ++i)
    if (const auto subject = subjectOf(scene.entries[i]))
      hues.emplace(scene.entries[i].name, looks[i].hue.value_or(hueOf(*subject)));
  return hues;
}

/// Where more objects would need to be told their colours, none is: among so many the palette tells nothing
/// apart, and each colour is an edit.
constexpr std::size_t mostToldColors = 40;

/// Gives the objects of a scene the colours that are wanted where it would decide on others, one after the
/// other: a colour that is said leaves others to the rest. False where that takes too many.
bool giveColors(const std::map<std::string, Hue> &wanted, Scene &scene) {
  for (std::size_t told = 0; told <= mostToldColors; ++told) {
    const std::map<std::string, Hue> now = huesOf(scene);
    bool isAnyOther = false;
    for (std::size_t i = 0; i < scene.entries.size() && !isAnyOther; ++i) {
      const std::string &name = scene.entries[i].name;
      const auto had = wanted.find(name);
      const auto has = now.find(name);
      if (had == wanted.end() || has == now.end() || scene.entries[i].color || has->second == had->second)
        continue;
      scene.entries.change(i, [&](Entry &entry) { entry.color = had->second; });
      isAnyOther = true;
    }
    if (!isAnyOther)
      return true;
  }
  return false;
}

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

std::vector<Edit> keepingColors(const Scene &scene, std::vector<Edit> edits) {
  std::map<std::string, Hue> wanted = huesOf(scene);
  Scene after = scene;
  for (const Edit &edit : edits) {
    if (const auto *replaced = std::get_if<ReplaceEntry>(&edit))
      wanted.erase(replaced->name); // somebody says how it is to look
    auto next = apply(after, edit);
    if (!next)
      return edits; // it will be told why
    after = std::move(*next);
  }
  Scene colored = after;
  if (!giveColors(wanted, colored))
    return edits;
  for (std::size_t i = 0; i < after.entries.size(); ++i)
    if (colored.entries.shared(i) != after.entries.shared(i))
      edits.emplace_back(ReplaceEntry{after.entries[i].name, colored.entries[i]});
  return edits;
}

} // namespace halfspace
