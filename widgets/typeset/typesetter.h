// Formulas to pictures.
#pragma once

#include "lessons/lesson/macros.h"
#include "widgets/typeset/math_picture.h"

namespace halfspace {

/// Makes the pictures of formulas, in microseconds each: nothing is kept and nothing waited for. One for the
/// program; it and its pictures are for one thread at a time.
class Typesetter {
public:
  using Picture = std::shared_ptr<const MathPicture>;

  Typesetter();
  /// The same for LaTeX with abbreviations.
  [[nodiscard]] Typesetter with(Macros macros) const;
  [[nodiscard]] const Macros &macros() const { return m_macros; }
  /// Those that formulas are set in, for as long as it or one of its pictures lives.
  [[nodiscard]] const math::MathFonts &fonts() const;

  /// The formula, never null: LaTeX that cannot be read gives a picture of its source, with an error.
  [[nodiscard]] Picture picture(const QString &latex) const;
  /// A formula that did not come from LaTeX; never null.
  [[nodiscard]] Picture picture(const math::Row &formula) const;
  /// A formula that is set in this typesetter's type; never null.
  [[nodiscard]] Picture picture(std::shared_ptr<const math::Layout> layout) const;

private:
  std::shared_ptr<const MathTypeface> m_typeface;
  Macros m_macros;
};

} // namespace halfspace
