#include "widgets/typeset/typesetter.h"

#include "widgets/typeset/math_typeface.h"

namespace halfspace {

Typesetter::Typesetter() : m_typeface(std::make_shared<const MathTypeface>()) {}

Typesetter Typesetter::with(Macros macros) const {
  Typesetter other = *this;
  other.m_macros = std::move(macros);
  return other;
}

const math::MathFonts &Typesetter::fonts() const { return m_typeface->fonts(); }

Typesetter::Picture Typesetter::picture(const QString &latex) const {
  return std::make_shared<const MathPicture>(
      math::setLatex(latex.toStdString(), m_typeface->fonts(), m_macros), m_typeface);
}

Typesetter::Picture Typesetter::picture(const math::Row &formula) const {
  return std::make_shared<const MathPicture>(math::setFormula(formula, m_typeface->fonts()), m_typeface);
}

Typesetter::Picture Typesetter::picture(std::shared_ptr<const math::Layout> layout) const {
  return std::make_shared<const MathPicture>(std::move(layout), m_typeface);
}

} // namespace halfspace
