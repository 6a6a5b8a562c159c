// Reads the SVG that MathJax writes. QtSvg cannot: it ignores nested <svg>, which stretched brackets are made
// of.
#pragma once

#include "widgets/typeset/math_picture.h"

#include <QTransform>
#include <QVector>
#include <QXmlStreamReader>

#include <vector>

namespace halfspace {

/// Walks once through the document. Only shapes, transforms, viewports and marks are read; colours, styles,
/// links and everything else that SVG could hold is passed over.
class SvgReader {
public:
  explicit SvgReader(const QString &svg) : m_xml(svg) {}

  /// The picture, or an empty one with an error.
  [[nodiscard]] MathPicture read();

private:
  /// What the elements inside take over from the one around them.
  struct State {
    QTransform toPicture;
    double strokeWidth = 0;
    bool filled = true;
    QRectF clip;
    QString mark;
    std::size_t markBox = noBox; ///< which box of the picture's grows with every shape inside
    Qt::PenStyle dash = Qt::SolidLine;
    double fontSize = 0; ///< of a <text> element; 0 elsewhere
  };
  static constexpr std::size_t noBox = static_cast<std::size_t>(-1);

  void startElement();
  void startRoot(State &state);
  void startViewport(State &state);
  void startMark(State &state, const QString &classes);
  void addShape(const State &state, const QPainterPath &path, bool outline);
  void addText(const State &state, const QString &text);
  void grow(std::size_t box, const QRectF &shape);
  [[nodiscard]] QPainterPath shapeOf(const QString &element) const;
  [[nodiscard]] QString attribute(const char *name) const;
  [[nodiscard]] double number(const char *name) const;
  [[nodiscard]] QVector<double> viewBox() const;

  QXmlStreamReader m_xml;
  std::vector<State> m_states;
  std::vector<std::size_t> m_boxAround; ///< for each mark's box the one of the mark around it
  bool m_hasRoot = false;
  MathPicture m_picture;
};

/// The `d` attribute of an SVG path; without arcs, which MathJax's fonts do not have.
[[nodiscard]] QPainterPath pathFromSvg(const QString &data);

/// The `transform` attribute; of several functions the leftmost is applied last.
[[nodiscard]] QTransform transformFromSvg(const QString &text);

/// The numbers of a text, whatever stands between them.
[[nodiscard]] QVector<double> numbersIn(const QString &text);

} // namespace halfspace
