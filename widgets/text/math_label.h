// A label that shows one typeset formula.
#pragma once

#include "widgets/picture/theme.h"
#include "widgets/typeset/typesetter.h"

#include <QWidget>

namespace halfspace {

/// Shows a formula in the widget's text colour.
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

protected:
  void paintEvent(QPaintEvent *event) override;

private:
  [[nodiscard]] double emPixels() const;

  const Typesetter &m_typesetter;
  Typesetter::Picture m_picture; ///< null before the first `setFormula`
  MathPicture::InkOf m_inkOf;
};

} // namespace halfspace
