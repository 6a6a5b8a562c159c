#include "widgets/typeset/math_typeface.h"

#include <QResource>

#include <span>

// A resource of a static library is registered by hand; the macro wants to be outside of namespaces.
static void registerFonts() { Q_INIT_RESOURCE(math_fonts); }

namespace halfspace {
namespace {

/// The bytes lie in the program itself, as they are.
std::span<const std::byte> bytesOf(const char *resource) {
  registerFonts();
  const QResource font(QString::fromLatin1(resource));
  return std::as_bytes(std::span(font.data(), static_cast<std::size_t>(font.size())));
}

} // namespace

MathTypeface::MathTypeface()
    : m_fonts{math::MathFont::from(math::FontFace::fromMemory(bytesOf(":/typeset/math.otf")).value()).value(),
              math::FontFace::fromMemory(bytesOf(":/typeset/text.ttf"))} {}

} // namespace halfspace
