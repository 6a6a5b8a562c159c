// A typeset formula as vector paths: sharp at every size, on screens, in images and in PDF files.
#pragma once

#include <QColor>
#include <QPainterPath>
#include <QRectF>
#include <QString>

#include <functional>
#include <utility>
#include <vector>

class QPainter;

namespace halfspace {

/// The formula's height is counted in ex: an ex is the height of the letter x. The type's size (one em) is
/// 1 / `exPerEm` ex.
inline constexpr double exPerEm = 0.442;

/// A formula. Lengths are in ex, y points down, the origin is the left end of the baseline.
class MathPicture {
public:
  /// One filled or stroked shape.
  struct Item {
    QPainterPath path;
    QString mark;           ///< the id of the innermost `\mark{id}{…}` around it; empty for none
    double strokeWidth = 0; ///< 0: the path is filled
    Qt::PenStyle dash = Qt::SolidLine;
    QRectF clip; ///< null: not clipped
  };

  /// The colour of a mark's terms by its id; an empty id stands for everything else.
  using InkOf = std::function<QColor(const QString &markId)>;

  /// Larger formulas are refused: nobody could read them, and nothing could draw them.
  static constexpr double largestSide = 1000;

  /// An empty picture.
  MathPicture() = default;
  /// Reads what MathJax writes. When that is no formula, the picture is `failed`.
  [[nodiscard]] static MathPicture fromSvg(const QString &svg, const QString &latex);
  /// What stands in for a formula that cannot be typeset: its source. Needs a QGuiApplication (for a font).
  [[nodiscard]] static MathPicture failed(const QString &error, const QString &latex);

  /// Why there is no formula; empty when there is one.
  [[nodiscard]] const QString &error() const { return m_error; }
  [[nodiscard]] double width() const { return m_width; }
  [[nodiscard]] double ascent() const { return m_ascent; } ///< above the baseline
  [[nodiscard]] double depth() const {
    return m_depth;
  } ///< below the baseline; negative when all is above it
  [[nodiscard]] double height() const { return m_ascent + m_depth; }
  /// The whole formula, around its origin.
  [[nodiscard]] QRectF box() const { return {0, -m_ascent, m_width, height()}; }
  [[nodiscard]] const std::vector<Item> &items() const { return m_items; }

  /// The box of each marked term, in the order of reading; a term inside another comes after it.
  [[nodiscard]] const std::vector<std::pair<QString, QRectF>> &markBoxes() const { return m_markBoxes; }

  /// Paints with the origin at `baseline`, one ex being `exPixels` of the painter's units.
  void paint(QPainter &painter, QPointF baseline, double exPixels, const InkOf &inkOf) const;
  /// Paints the outlines of all shapes, `width` wide (in painter's units): a halo to paint the formula onto.
  void paintHalo(QPainter &painter, QPointF baseline, double exPixels, double width,
                 const QColor &color) const;

private:
  friend class SvgReader;

  std::vector<Item> m_items;
  std::vector<std::pair<QString, QRectF>> m_markBoxes;
  double m_width = 0;
  double m_ascent = 0;
  double m_depth = 0;
  QString m_error;
};

} // namespace halfspace
