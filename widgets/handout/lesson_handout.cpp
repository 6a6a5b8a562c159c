#include "widgets/handout/lesson_handout.h"

#include "widgets/handout/handout_text.h"
#include "widgets/handout/write_handout.h"

namespace halfspace {

std::string handoutOf(const HandoutRequest &request, const HandoutFonts &fonts) {
  const HandoutLook look = handoutLook(request.paper, request.columns);
  return writeHandout(handoutText(request, look, fonts.formulas), look, fonts);
}

} // namespace halfspace
