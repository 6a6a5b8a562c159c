#include "lessons/construction.h"

namespace halfspace {

const Construction *findConstruction(std::string_view id) {
  for (const Construction &construction : constructions())
    if (construction.id == id)
      return &construction;
  return nullptr;
}

} // namespace halfspace
