// A label that shows one typeset formula.
#pragma once

#include "widgets/scene/theme.h"
#include "widgets/typeset/typesetter.h"

#include <QWidget>

namespace halfspace {

/// Shows LaTeX in the widget's text colour.
class MathLabel : public QWidget {
  Q_OBJECT

public:
  /// The typesetter must outlive the label.
  explicit MathLabel(const Typesetter &typesetter, QWidget *parent = nullptr);

  void setLatex(const QString &latex);
  [[nodiscard]] const QString &latex() const { return m_latex; }
  void setInkOf(MathPicture::InkOf inkOf);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent *event) override;

private:
  [[nodiscard]] double emPixels() const;

  const Typesetter &m_typesetter;
  QString m_latex;
  Typesetter::Picture m_picture; ///< null before the first `setLatex`
  MathPicture::InkOf m_inkOf;
};

} // namespace halfspace
