#include "widgets/typeset/svg_reader.h"

#include <QFont>

#include <algorithm>
#include <cmath>

namespace halfspace {

namespace {

/// MathJax's SVG has a thousand units an em.
constexpr double unitsPerEx = 1000 * exPerEm;
/// The width of a table's rules, which MathJax leaves to a style sheet.
constexpr double ruleWidth = 70;
/// The size of letters that its fonts do not have, where it names none.
constexpr double defaultFontSize = 884;

} // namespace

MathPicture SvgReader::read() {
  m_states = {State{}};
  while (!m_xml.atEnd() && m_picture.m_error.isEmpty()) {
    m_xml.readNext();
    if (m_xml.isStartElement())
      startElement();
    else if (m_xml.isEndElement())
      m_states.pop_back();
    else if (m_xml.isCharacters() && m_states.back().fontSize > 0)
      addText(m_states.back(), m_xml.text().toString());
  }
  if (m_picture.m_error.isEmpty() && (m_xml.hasError() || !m_hasRoot))
    m_picture.m_error = QStringLiteral("The formula cannot be drawn");
  return std::move(m_picture);
}

void SvgReader::startElement() {
  State state = m_states.back();
  state.fontSize = 0;
  const QXmlStreamAttributes attributes = m_xml.attributes();
  if (const QString error = attribute("data-mjx-error"); !error.isEmpty())
    m_picture.m_error = error;
  if (const QString fill = attribute("fill"); !fill.isEmpty())
    state.filled = fill != QLatin1String("none") && fill != QLatin1String("transparent");
  if (attributes.hasAttribute(QLatin1String("stroke-width")))
    state.strokeWidth = number("stroke-width");
  if (const QString transform = attribute("transform"); !transform.isEmpty())
    state.toPicture = transformFromSvg(transform) * state.toPicture;
  startMark(state, attribute("class"));

  const QString element = m_xml.name().toString();
  if (element == QLatin1String("svg"))
    m_hasRoot ? startViewport(state) : startRoot(state);
  else if (element == QLatin1String("text"))
    state.fontSize = number("font-size") > 0 ? number("font-size") : defaultFontSize;
  else if (const QPainterPath shape = shapeOf(element); !shape.isEmpty()) {
    if (attributes.hasAttribute(QLatin1String("data-line")) ||
        attributes.hasAttribute(QLatin1String("data-frame")))
      state.strokeWidth = ruleWidth;
    if (attributes.hasAttribute(QLatin1String("stroke-dasharray")) ||
        attribute("class") == QLatin1String("mjx-dashed"))
      state.dash = Qt::DashLine;
    addShape(state, shape, !state.filled || element == QLatin1String("line"));
  }
  m_states.push_back(state);
}

void SvgReader::startRoot(State &state) {
  m_hasRoot = true;
  const QVector<double> box = viewBox();
  if (box.size() != 4) { // a numbered equation, as wide as its page
    m_picture.m_error = QStringLiteral("Equation numbers cannot be drawn");
    return;
  }
  m_picture.m_width = box[2] / unitsPerEx;
  m_picture.m_ascent = -box[1] / unitsPerEx;
  m_picture.m_depth = (box[1] + box[3]) / unitsPerEx;
  const bool fits =
      m_picture.m_width < MathPicture::largestSide && m_picture.height() < MathPicture::largestSide;
  if (!fits) // said this way round, so that a size that is no number does not pass
    m_picture.m_error = QStringLiteral("The formula is too large");
  state.toPicture =
      QTransform::fromTranslate(-box[0], 0) * QTransform::fromScale(1 / unitsPerEx, 1 / unitsPerEx);
}

void SvgReader::startViewport(State &state) {
  const QRectF port(number("x"), number("y"), number("width"), number("height"));
  const QRectF clip = state.toPicture.mapRect(port);
  state.clip = state.clip.isNull() ? clip : state.clip.intersected(clip);
  QTransform transform = QTransform::fromTranslate(port.x(), port.y());
  if (const QVector<double> box = viewBox(); box.size() == 4 && box[2] > 0 && box[3] > 0) {
    double scaleX = port.width() / box[2];
    double scaleY = port.height() / box[3];
    if (attribute("preserveAspectRatio") != QLatin1String("none")) {
      scaleX = scaleY = std::min(scaleX, scaleY);
      transform.translate((port.width() - scaleX * box[2]) / 2, (port.height() - scaleY * box[3]) / 2);
    }
    transform.scale(scaleX, scaleY);
    transform.translate(-box[0], -box[1]);
  }
  state.toPicture = transform * state.toPicture;
}

void SvgReader::startMark(State &state, const QString &classes) {
  const QString prefix = QStringLiteral("mark-");
  for (const QString &word : classes.split(u' ', Qt::SkipEmptyParts)) {
    if (!word.startsWith(prefix))
      continue;
    state.mark = word.mid(prefix.size());
    m_boxAround.push_back(state.markBox);
    state.markBox = m_picture.m_markBoxes.size();
    m_picture.m_markBoxes.emplace_back(state.mark, QRectF());
  }
}

void SvgReader::addShape(const State &state, const QPainterPath &path, bool outline) {
  const double scale = std::sqrt(std::abs(state.toPicture.determinant()));
  MathPicture::Item item;
  item.path = state.toPicture.map(path);
  item.path.setFillRule(Qt::WindingFill);
  item.mark = state.mark;
  item.strokeWidth = outline ? state.strokeWidth * scale : 0;
  item.dash = state.dash;
  item.clip = state.clip;
  const QRectF box = item.path.boundingRect();
  grow(state.markBox, item.clip.isNull() ? box : box.intersected(item.clip));
  if (!outline || item.strokeWidth > 0)
    m_picture.m_items.push_back(std::move(item));
}

void SvgReader::addText(const State &state, const QString &text) {
  QFont font(QStringLiteral("STIX Two Text"));
  font.setStyleHint(QFont::Serif);
  font.setPixelSize(static_cast<int>(std::clamp(state.fontSize, 1.0, 10000.0)));
  QPainterPath letters;
  letters.addText({0, 0}, font, text);
  if (!letters.isEmpty())
    addShape(state, letters, false);
}

void SvgReader::grow(std::size_t box, const QRectF &shape) {
  for (; box != noBox; box = m_boxAround[box])
    m_picture.m_markBoxes[box].second |= shape;
}

QPainterPath SvgReader::shapeOf(const QString &element) const {
  QPainterPath shape;
  if (element == QLatin1String("path")) {
    shape = pathFromSvg(attribute("d"));
  } else if (element == QLatin1String("rect")) {
    shape.addRect(number("x"), number("y"), number("width"), number("height"));
  } else if (element == QLatin1String("line")) {
    shape.moveTo(number("x1"), number("y1"));
    shape.lineTo(number("x2"), number("y2"));
  } else if (element == QLatin1String("ellipse")) {
    shape.addEllipse(QPointF(number("cx"), number("cy")), number("rx"), number("ry"));
  } else if (element == QLatin1String("polygon")) {
    const QVector<double> numbers = numbersIn(attribute("points"));
    QPolygonF polygon;
    for (int i = 0; i + 1 < numbers.size(); i += 2)
      polygon << QPointF(numbers[i], numbers[i + 1]);
    shape.addPolygon(polygon);
    shape.closeSubpath();
  }
  return shape;
}

QString SvgReader::attribute(const char *name) const {
  return m_xml.attributes().value(QLatin1String(name)).toString();
}

double SvgReader::number(const char *name) const {
  const QVector<double> numbers = numbersIn(attribute(name));
  return numbers.isEmpty() ? 0 : numbers.front();
}

QVector<double> SvgReader::viewBox() const { return numbersIn(attribute("viewBox")); }

} // namespace halfspace
