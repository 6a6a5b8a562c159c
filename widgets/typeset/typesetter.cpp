#include "widgets/typeset/typesetter.h"

#include "widgets/typeset/math_typeface.h"

namespace halfspace {

Typesetter::Typesetter() : m_typeface(std::make_shared<const MathTypeface>()) {}

Typesetter Typesetter::with(Macros macros) const {
  Typesetter other = *this;
  other.m_macros = std::move(macros);
  return other;
}

Typesetter::Picture Typesetter::picture(const QString &latex) const {
  return std::make_shared<const MathPicture>(latex, m_typeface, m_macros);
}

Typesetter::Picture Typesetter::picture(const math::Row &formula) const {
  return std::make_shared<const MathPicture>(formula, m_typeface);
}

} // namespace halfspace
