#include "lessons/scene/fresh_names.h"

#include "lessons/construction/construction.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/box.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/sphere.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/kinds/ufo.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/term/term.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

/// What the objects of a kind are usually called.
struct UsualLetters {
  std::string_view kind;
  std::string_view letters; ///< in the order in which they are taken
  char numbered;            ///< once all are taken
};

constexpr std::array usualLetters{
    UsualLetters{PointObject::kind, "ABCDPQR", 'P'}, UsualLetters{PlaneObject::kind, "EFGH", 'E'},
    UsualLetters{LineObject::kind, "gh", 'g'},       UsualLetters{VectorObject::kind, "uvw", 'v'},
    UsualLetters{NumberObject::kind, "km", 'k'},     UsualLetters{TriangleObject::kind, "T", 'T'},
    UsualLetters{SphereObject::kind, "S", 'S'},      UsualLetters{BoxObject::kind, "K", 'K'},
    UsualLetters{UfoObject::kind, "U", 'U'},         UsualLetters{"tetrahedron", "T", 'T'},
};

/// They stand for the unknowns of equations and for the parameter of a line.
constexpr std::string_view unknowns = "xyzt";

/// Of a kind that says nothing else the letter that its word begins with.
UsualLetters usualLettersOf(const Kind &kind) {
  const std::string_view word = kind.binding ? PointObject::kind : kind.word;
  const auto *usual = std::find_if(usualLetters.begin(), usualLetters.end(),
                                   [&](const UsualLetters &each) { return each.kind == word; });
  return usual != usualLetters.end() ? *usual : UsualLetters{word, word.substr(0, 1), word.front()};
}

} // namespace

bool isUsualLetter(const Kind &kind, char letter) {
  return usualLettersOf(kind).letters.find(letter) != std::string_view::npos;
}

FreshNames::FreshNames(const Scene &scene) {
  for (const Entry &entry : scene.entries) {
    m_written.insert(writtenName(entry.name));
    if (const auto *use = std::get_if<ConstructionUse>(&entry.content))
      if (const Construction *construction = findConstruction(use->id))
        for (const ConstructionRole &made : construction->makes)
          m_made.insert(made.name);
  }
}

bool FreshNames::isFree(const std::string &name) const {
  return !m_written.contains(writtenName(name)) && !m_made.contains(name) &&
         unknowns.find(name) == std::string::npos;
}

std::string FreshNames::firstFree(std::string_view letters, char numbered) const {
  for (const char letter : letters)
    if (std::string name(1, letter); isFree(name))
      return name;
  for (int number = 1;; ++number)
    if (std::string name = numbered + std::to_string(number); isFree(name))
      return name;
}

std::string FreshNames::ofKind(const Kind &kind) const {
  const UsualLetters usual = usualLettersOf(kind);
  return firstFree(usual.letters, usual.numbered);
}

std::string FreshNames::ofUse(const Construction &construction) const {
  const std::string_view word = construction.word.empty() ? construction.id : construction.word;
  return firstFree(word.substr(0, 1), word.front());
}

} // namespace halfspace
