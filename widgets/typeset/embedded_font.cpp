#include "widgets/typeset/embedded_font.h"

#include <QResource>
#include <QString>

// A resource of a static library is registered by hand; the macro wants to be outside of namespaces.
static void registerFonts() { Q_INIT_RESOURCE(math_fonts); }

namespace halfspace {

std::span<const std::byte> embeddedFont(const std::string &name) {
  registerFonts();
  const QResource font(QString::fromStdString(":/typeset/" + name));
  return std::as_bytes(std::span(font.data(), static_cast<std::size_t>(font.size())));
}

} // namespace halfspace
