#include "app/last_words.h"

#include "lessons/words.h"

#include <new>

namespace halfspace {

std::string lastWordsOn(const std::exception &exception) {
  if (dynamic_cast<const std::bad_alloc *>(&exception))
    return words("There is not enough memory to go on.");
  return words("Something went wrong in the program itself: {reason}.", {{"reason", exception.what()}});
}

} // namespace halfspace
