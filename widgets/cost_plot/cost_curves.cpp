#include "widgets/cost_plot/cost_curves.h"

#include "widgets/colors.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

// In heights of a line.
constexpr double smallestWidth = 10;
constexpr double usualWidth = 24;
constexpr double lowestHeight = 10;
constexpr double highestHeight = 15;
constexpr double dotRadius = 0.2;
constexpr double diamondReach = 0.3; ///< of what is measured in the scene
constexpr double curveWidth = 0.1;
constexpr double gap = 0.35;
/// Room above the highest decade, for the name of the curve that ends there.
constexpr double headroom = 1.2;
/// Numbers below the axis are so far apart at least, in their own width.
constexpr double tickDistance = 1.5;

constexpr double heightOfWidth = 0.72;

/// 10⁶
QString countWords(int decade) {
  static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString power = QStringLiteral("10");
  for (const QChar digit : QString::number(decade))
    power += digits[digit.digitValue()];
  return power;
}

/// 100 µs: a power of ten, of microseconds.
QString timeWords(int decade) {
  constexpr int fewest = -3;
  static const QStringList units{QStringLiteral("ns"), QStringLiteral("µs"), QStringLiteral("ms"),
                                 QStringLiteral("s")};
  const int above = std::max(decade - fewest, 0);
  const int unit = std::min(above / 3, int(units.size()) - 1);
  return QString::number(std::pow(10, above - 3 * unit)) + QChar(QChar::Nbsp) + units[unit];
}

/// In microseconds, the least that is shown: a coarse clock may tell of no time at all, which has no
/// logarithm.
constexpr double shortestTime = 1e-3;

/// At least 1, for the logarithm: where no triangle has an area nothing is looked at.
double sum(const SearchCost &cost) { return std::max(1.0, static_cast<double>(cost.boxes + cost.triangles)); }

int floorDecade(double value) { return static_cast<int>(std::floor(std::log10(value))); }
int ceilDecade(double value) { return static_cast<int>(std::ceil(std::log10(value))); }

} // namespace

/// Where the plot stands in the widget, and what is where in it.
class CostCurves::Axes {
public:
  Axes(const QRectF &plot, Decades heights, double line) : m_plot(plot), m_heights(heights), m_line(line) {}

  static constexpr Decades widths{0, 6};

  [[nodiscard]] const QRectF &plot() const { return m_plot; }
  [[nodiscard]] Decades heights() const { return m_heights; }
  [[nodiscard]] double line() const { return m_line; }
  [[nodiscard]] double xOf(double decade) const {
    // The last dot stands whole within the plot.
    const double right = m_plot.right() - 2 * dotRadius * m_line;
    return m_plot.left() + (right - m_plot.left()) * (decade - widths.low) / (widths.high - widths.low);
  }
  [[nodiscard]] double yOf(double decade) const {
    const double top = m_plot.top() + headroom * m_line;
    return m_plot.bottom() -
           (m_plot.bottom() - top) * (decade - m_heights.low) / (m_heights.high - m_heights.low);
  }
  [[nodiscard]] QPointF placeOf(const Dot &dot) const {
    return {xOf(std::log10(dot.triangles)), yOf(std::log10(dot.cost))};
  }

private:
  QRectF m_plot;
  Decades m_heights;
  double m_line;
};

CostCurves::CostCurves(QWidget *parent) : QWidget(parent), m_theme(themes().front()) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void CostCurves::setPoints(const std::vector<CostPoint> &points, const std::optional<CostPoint> &inScene) {
  m_points = points;
  m_inScene = inScene;
  update();
}

void CostCurves::setQuantity(CostQuantity quantity) {
  m_quantity = quantity;
  update();
}

void CostCurves::setTheme(const Theme &theme) {
  m_theme = theme;
  update();
}

int CostCurves::heightForWidth(int width) const {
  const double line = QFontMetricsF(font()).height();
  return static_cast<int>(std::clamp(width * heightOfWidth, lowestHeight * line, highestHeight * line));
}

QSize CostCurves::sizeHint() const {
  const int usual = static_cast<int>(usualWidth * QFontMetricsF(font()).height());
  return {usual, heightForWidth(usual)};
}

QSize CostCurves::minimumSizeHint() const {
  const int least = static_cast<int>(smallestWidth * QFontMetricsF(font()).height());
  return {least, 0};
}

std::vector<CostCurves::Curve> CostCurves::curves() const {
  const bool isTime = m_quantity == CostQuantity::Time;
  const auto dot = [isTime](const CostPoint &point, const SearchCost &cost, double microseconds) {
    return Dot{static_cast<double>(point.triangles),
               isTime ? std::max(microseconds, shortestTime) : sum(cost)};
  };
  const auto ofPlain = [&](const CostPoint &point) {
    return dot(point, point.plain, point.plainMicroseconds);
  };
  const auto ofTree = [&](const CostPoint &point) { return dot(point, point.tree, point.treeMicroseconds); };
  Curve plain{{}, {}, tr("plain loop"), Subject::Neutral, true};
  Curve tree{{}, {}, tr("tree of boxes"), Subject::Ray, false};
  for (const CostPoint &point : m_points) {
    plain.dots.push_back(ofPlain(point));
    tree.dots.push_back(ofTree(point));
  }
  if (m_inScene) {
    plain.inScene = ofPlain(*m_inScene);
    tree.inScene = ofTree(*m_inScene);
  }
  if (!m_points.empty() && plain.dots.back().cost < tree.dots.back().cost)
    std::swap(plain.isAbove, tree.isAbove);
  return {plain, tree};
}

CostCurves::Decades CostCurves::heights() const {
  Decades decades = m_quantity == CostQuantity::Time ? Decades{0, 5} : Decades{0, 6};
  const auto include = [&](const Dot &dot) {
    decades.low = std::min(decades.low, floorDecade(dot.cost));
    decades.high = std::max(decades.high, ceilDecade(dot.cost));
  };
  for (const Curve &curve : curves()) {
    std::for_each(curve.dots.begin(), curve.dots.end(), include);
    if (curve.inScene)
      include(*curve.inScene);
  }
  return decades;
}

QString CostCurves::heightWords(int decade) const {
  return m_quantity == CostQuantity::Time ? timeWords(decade) : countWords(decade);
}

QString CostCurves::title() const {
  return m_quantity == CostQuantity::Time ? tr("time of one search") : tr("boxes and triangles");
}

CostCurves::Axes CostCurves::axes() const {
  const QFontMetricsF metrics(font());
  const double line = metrics.height();
  const Decades decades = heights();
  double words = 0;
  for (int decade = decades.low; decade <= decades.high; ++decade)
    words = std::max(words, metrics.horizontalAdvance(heightWords(decade)));
  // Above it its title, below it numbers and what they count.
  return {QRectF(rect()).adjusted(std::ceil(words + gap * line), line, -1, -std::ceil((2 + gap) * line)),
          decades, line};
}

void CostCurves::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Axes placed = axes();
  paintAxes(painter, placed);
  const std::vector<Curve> all = curves();
  for (const Curve &curve : all) {
    paintCurve(painter, placed, curve);
    paintInScene(painter, placed, curve);
  }
  if (!m_points.empty())
    for (const Curve &curve : all)
      paintName(painter, placed, curve);
}

void CostCurves::paintAxes(QPainter &painter, const Axes &axes) const {
  const QRectF &plot = axes.plot();
  const double line = axes.line();
  const QFontMetricsF metrics(font());
  const QColor grid = toQColor(m_theme.grid);
  const QColor muted = toQColor(m_theme.mutedInk);
  painter.setPen(muted);
  painter.drawText(QRectF(0, 0, width(), line), Qt::AlignLeft | Qt::AlignVCenter, title());
  painter.drawText(QRectF(0, height() - line, width(), line), Qt::AlignRight | Qt::AlignVCenter,
                   tr("number of triangles"));
  double labelled = height(); // the top of the lowest number that is not yet written
  for (int decade = axes.heights().low; decade <= axes.heights().high; ++decade) {
    const double y = std::floor(axes.yOf(decade));
    painter.fillRect(QRectF(plot.left(), y, plot.width(), 1), grid);
    if (y + line / 2 > labelled)
      continue;
    painter.drawText(QRectF(0, y - line / 2, plot.left() - gap * line, line),
                     Qt::AlignRight | Qt::AlignVCenter, heightWords(decade));
    labelled = y - line / 2;
  }
  double free = 0; // from where the next number may stand
  for (int decade = Axes::widths.low; decade <= Axes::widths.high; ++decade) {
    const double x = std::floor(axes.xOf(decade));
    painter.fillRect(QRectF(x, plot.top(), 1, plot.height()), grid);
    const double wide = metrics.horizontalAdvance(countWords(decade));
    const double left = std::min(x - wide / 2, width() - wide);
    if (left < free)
      continue;
    painter.drawText(QRectF(left, plot.bottom() + gap * line, wide + 1, line), Qt::AlignVCenter,
                     countWords(decade));
    free = left + tickDistance * wide;
  }
  painter.fillRect(QRectF(plot.left(), plot.top(), 1, plot.height()), muted);
  painter.fillRect(QRectF(plot.left(), std::floor(plot.bottom()), plot.width(), 1), muted);
}

void CostCurves::paintCurve(QPainter &painter, const Axes &axes, const Curve &curve) const {
  const QColor color = toQColor(m_theme.colorOf(curve.subject));
  const double thickness = curveWidth * axes.line() * m_theme.lineScale;
  QPolygonF line;
  for (const Dot &dot : curve.dots)
    line << axes.placeOf(dot);
  painter.setPen(QPen(color, thickness, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
  // Hollow and filled ones: the curves differ without their colours, too.
  painter.setBrush(curve.subject == Subject::Neutral ? toQColor(m_theme.panel) : color);
  const double radius = dotRadius * axes.line();
  for (const QPointF &place : line)
    painter.drawEllipse(place, radius, radius);
}

void CostCurves::paintInScene(QPainter &painter, const Axes &axes, const Curve &curve) const {
  if (!curve.inScene)
    return;
  const QPointF middle = axes.placeOf(*curve.inScene);
  const double reach = diamondReach * axes.line();
  painter.drawPolygon(QPolygonF{{middle + QPointF(reach, 0), middle + QPointF(0, reach),
                                 middle - QPointF(reach, 0), middle - QPointF(0, reach)}});
  if (!curve.isAbove)
    return;
  const QString words = tr("scene");
  const double left = middle.x() - QFontMetricsF(font()).horizontalAdvance(words) / 2;
  painter.drawText(
      QPointF(std::max(left, axes.plot().left() + gap * axes.line()), middle.y() - reach - gap * axes.line()),
      words);
}

void CostCurves::paintName(QPainter &painter, const Axes &axes, const Curve &curve) const {
  const double line = axes.line();
  const QRectF &plot = axes.plot();
  const QPointF end = axes.placeOf(curve.dots.back());
  const double wide = QFontMetricsF(font()).horizontalAdvance(curve.name);
  const double away = dotRadius * line + 2;
  const double top = curve.isAbove ? end.y() - away - line : end.y() + away;
  const QRectF place(std::max(plot.left() + gap * line, end.x() + away - wide),
                     std::clamp(top, plot.top(), std::max(plot.top(), plot.bottom() - line)), wide + 1, line);
  painter.setPen(toQColor(m_theme.inkOf(curve.subject)));
  painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, curve.name);
}

} // namespace halfspace
