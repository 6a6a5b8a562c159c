#include "lessons/construction/construction.h"

#include "lessons/words.h"

namespace halfspace {

CaseWords zeroNormalWords() {
  return {"zero-normal", words("The normal n is the zero vector: it points nowhere, so there is no plane."),
          true};
}

CaseWords zeroDirectionWords() {
  return {"zero-direction", words("The direction r is the zero vector: the ray goes nowhere."), true};
}

const Construction *findConstruction(std::string_view id) {
  for (const Construction &construction : constructions())
    if (construction.id == id)
      return &construction;
  return nullptr;
}

} // namespace halfspace
