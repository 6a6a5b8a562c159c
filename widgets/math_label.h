// A label that shows one typeset formula.
#pragma once

#include "widgets/scene/theme.h"
#include "widgets/typeset/typesetter.h"

#include <QWidget>

namespace halfspace {

/// Shows LaTeX in the widget's text colour. While a new formula is being typeset the last one stays.
class MathLabel : public QWidget {
  Q_OBJECT

public:
  explicit MathLabel(Typesetter &typesetter, QWidget *parent = nullptr);

  void setLatex(const QString &latex);
  [[nodiscard]] const QString &latex() const { return m_latex; }
  void setInkOf(MathPicture::InkOf inkOf);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent *event) override;

private:
  void takePicture();
  [[nodiscard]] double exPixels() const;

  Typesetter &m_typesetter;
  Typesetter::Request m_request;
  QString m_latex;
  Typesetter::Picture m_picture; ///< the last good one
  MathPicture::InkOf m_inkOf;
};

} // namespace halfspace
