// A label that shows one typeset formula.
#pragma once

#include "widgets/picture/theme.h"
#include "widgets/typeset/typesetter.h"

#include <QWidget>

namespace halfspace {

/// Shows a formula in the widget's text colour. One that is too wide is broken where there is height for its
/// lines, else drawn smaller, and stands in plain text where the pointer rests on it.
class MathLabel : public QWidget {
  Q_OBJECT

public:
  /// The typesetter must outlive the label.
  explicit MathLabel(const Typesetter &typesetter, QWidget *parent = nullptr);

  /// `plainText` is what a screen reader says.
  void setFormula(const math::Row &formula, const QString &plainText);
  void setInkOf(MathPicture::InkOf inkOf);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;
  /// For whoever has room for a formula that is broken.
  [[nodiscard]] int heightForWidth(int width) const override;
  /// Narrower it can be neither broken nor drawn smaller.
  [[nodiscard]] int narrowestWidth() const;

protected:
  bool event(QEvent *event) override;
  void paintEvent(QPaintEvent *event) override;

private:
  [[nodiscard]] double emPixels() const;
  [[nodiscard]] double roomIn(int width) const; ///< in em
  [[nodiscard]] int heightOf(const MathPicture &picture) const;

  const Typesetter &m_typesetter;
  Typesetter::Picture m_picture; ///< null before the first `setFormula`
  MathPicture::InkOf m_inkOf;
};

} // namespace halfspace
