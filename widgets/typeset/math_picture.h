// A formula that is set, ready to be painted: sharp at every size, on screens, in images and in PDF files.
#pragma once

#include "widgets/formula/set_formula.h"

#include <QColor>
#include <QRectF>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QPainter;

namespace halfspace {

class MathTypeface;

/// Lengths are in em of the formula's type, y points down, the origin is the left end of the baseline.
class MathPicture {
public:
  /// The colour of a mark's terms by its id; an empty id stands for everything else.
  using InkOf = std::function<QColor(const QString &markId)>;

  MathPicture(math::SetFormula formula, std::shared_ptr<const MathTypeface> typeface);
  /// Of a formula that can be read.
  MathPicture(std::shared_ptr<const math::Layout> layout, std::shared_ptr<const MathTypeface> typeface);

  /// The formula on lines of at most this width, where it can be broken.
  [[nodiscard]] MathPicture brokenTo(double widthInEm) const;

  /// Whether it stands on several lines.
  [[nodiscard]] bool isBroken() const { return lineCount() > 1; }
  [[nodiscard]] std::size_t lineCount() const { return m_layout->lines.size(); }

  /// The shapes that are painted.
  [[nodiscard]] const std::shared_ptr<const math::Layout> &layout() const { return m_layout; }

  /// Why there is no formula; empty when there is one.
  [[nodiscard]] const QString &error() const { return m_error; }
  /// … and at which character of the LaTeX it shows, counted from 1; 0: at none.
  [[nodiscard]] int errorColumn() const { return m_errorColumn; }
  [[nodiscard]] double width() const { return m_layout->width; }
  [[nodiscard]] double ascent() const { return m_layout->ascent; } ///< above the baseline
  [[nodiscard]] double depth() const {
    return m_layout->depth;
  } ///< below the baseline; negative when all is above it
  [[nodiscard]] double height() const { return ascent() + depth(); }
  /// The whole formula, around its origin.
  [[nodiscard]] QRectF box() const { return {0, -ascent(), width(), height()}; }

  /// The box of each marked term, in the order of reading; a term inside another comes after it.
  [[nodiscard]] const std::vector<std::pair<QString, QRectF>> &markBoxes() const { return m_markBoxes; }
  /// The box of each piece that is tagged with an index, likewise.
  [[nodiscard]] const std::vector<std::pair<std::size_t, QRectF>> &indexBoxes() const { return m_indexBoxes; }

  /// The room of what is left out of the formula.
  [[nodiscard]] const std::optional<QRectF> &leftOut() const { return m_leftOut; }

  /// Paints with the origin at `baseline`, one em being `emPixels` of the painter's units.
  void paint(QPainter &painter, QPointF baseline, double emPixels, const InkOf &inkOf) const;
  /// Paints a rim around all shapes, `width` wide (in painter's units): a halo to paint the formula onto.
  void paintHalo(QPainter &painter, QPointF baseline, double emPixels, double width,
                 const QColor &color) const;

private:
  void takeTagBoxes();
  [[nodiscard]] std::vector<QColor> inksOfTags(const InkOf &inkOf, const QColor &plain) const;

  std::shared_ptr<const MathTypeface> m_typeface;
  std::shared_ptr<const math::Layout> m_layout;
  std::vector<std::pair<QString, QRectF>> m_markBoxes;
  std::vector<std::pair<std::size_t, QRectF>> m_indexBoxes;
  std::optional<QRectF> m_leftOut;
  QString m_error;
  int m_errorColumn = 0;
};

} // namespace halfspace
