#include "widgets/hit_table/paint_fragments.h"

#include "widgets/colors.h"
#include "widgets/hit_table/fragment_words.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// The type's size of formulas, as part of the height of the words' line.
constexpr double typeSize = 0.8;
/// A number that is too wide is drawn smaller, but not below this part of its size.
constexpr double smallestScale = 0.5;
/// Q at the rule, in the type of formulas.
constexpr double startSize = 0.72;
/// In heights of a line.
constexpr double markRadius = 0.26;

constexpr double chosenTint = 0.13;
constexpr double hoverTint = 0.06;
constexpr double cornerRadius = 4;

constexpr std::array<Subject, 3> headSubjects{Subject::Ray, Subject::EdgeU, Subject::EdgeV};

constexpr std::array<Standing, 11> allStandings{
    Standing::First,      Standing::FirstToo,    Standing::FirstSoFar, Standing::Hit,
    Standing::Outside,    Standing::Behind,      Standing::Parallel,   Standing::InPlane,
    Standing::NoTriangle, Standing::NoDirection, Standing::NotAsked};

QFont bold(QFont font) {
  font.setBold(true);
  return font;
}

double emPixelsIn(const QFont &words) { return QFontMetricsF(words).height() * typeSize; }

class FragmentsPainter {
public:
  FragmentsPainter(QPainter &painter, const PaintedFragments &fragments, const FragmentColumns &columns)
      : m_painter(painter), m_fragments(fragments), m_theme(fragments.theme), m_columns(columns),
        m_font(painter.font()), m_line(QFontMetricsF(m_font).height()) {}

  void paintHead() const;
  void paintRow(std::size_t row) const;
  void paintLeftOut() const;

private:
  void paintBackground(const FragmentRow &row, const QRectF &place) const;
  /// The rule, with the letter of the ray's start.
  void paintStart(double y) const;
  void paintWords(const FragmentRow &row, double middle) const;
  void paintNumber(const MathPicture &picture, const FragmentColumns::Column &column, double middle,
                   const QColor &ink) const;
  [[nodiscard]] bool isHidden(const FragmentRow &row) const { return hidesNumbers(row, m_fragments.values); }
  [[nodiscard]] QColor inkOf(const FragmentRow &row) const;
  [[nodiscard]] int verdictFlags() const {
    return int(Qt::AlignVCenter) | int(m_columns.isStacked ? Qt::AlignRight : Qt::AlignLeft);
  }
  /// Below the head.
  [[nodiscard]] double topOf(std::size_t row) const {
    return m_columns.rowHeight * static_cast<double>(row + 1);
  }

  QPainter &m_painter;
  const PaintedFragments &m_fragments;
  const Theme &m_theme;
  const FragmentColumns &m_columns;
  QFont m_font;  ///< of words
  double m_line; ///< the height of a line of them
};

void FragmentsPainter::paintHead() const {
  const QColor muted = toQColor(m_theme.mutedInk);
  m_painter.setPen(muted);
  const double top = m_columns.wordsMiddle() - m_line / 2;
  m_painter.drawText(QRectF(m_columns.name.left, top, m_columns.name.width, m_line), Qt::AlignVCenter,
                     headOfNames());
  m_painter.drawText(QRectF(m_columns.verdict.left, top, m_columns.verdict.width, m_line), verdictFlags(),
                     headOfVerdicts());
  for (std::size_t i = 0; i < headSubjects.size(); ++i)
    paintNumber(m_fragments.numbers.head(i), m_columns.numbers[i], m_columns.numbersMiddle(),
                toQColor(m_theme.inkOf(headSubjects[i])));
  m_painter.fillRect(QRectF(0, std::floor(m_columns.rowHeight) - 1, m_columns.width, 1), muted);
}

void FragmentsPainter::paintRow(std::size_t row) const {
  const FragmentRow &shown = m_fragments.shown.rows[row];
  const QRectF place(0, topOf(row), m_columns.width, m_columns.rowHeight);
  paintBackground(shown, place);
  if (shown.beginsRay)
    paintStart(place.top());
  paintWords(shown, place.top() + m_columns.wordsMiddle());
  const FragmentNumbers::OfRow &numbers = m_fragments.numbers.ofRow(row);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i])
      paintNumber(*numbers[i], m_columns.numbers[i], place.top() + m_columns.numbersMiddle(), inkOf(shown));
}

void FragmentsPainter::paintLeftOut() const {
  m_painter.setFont(m_font);
  m_painter.setPen(toQColor(m_theme.mutedInk));
  m_painter.drawText(QRectF(m_columns.name.left, topOf(m_fragments.shown.rows.size()),
                            m_columns.width - m_columns.name.left, m_columns.rowHeight),
                     Qt::AlignVCenter, leftOutWords(m_fragments.shown));
}

void FragmentsPainter::paintBackground(const FragmentRow &row, const QRectF &place) const {
  const std::size_t number = row.crossing.number;
  const bool isChosen = number == m_fragments.chosen;
  const double tint = isChosen ? chosenTint : number == m_fragments.hovered ? hoverTint : 0;
  if (tint == 0)
    return;
  const QRectF inner = place.adjusted(0.5, 1, -0.5, -1);
  m_painter.setPen(isChosen && m_fragments.hasFocus ? QPen(toQColor(m_theme.accent), 1) : QPen(Qt::NoPen));
  m_painter.setBrush(toQColor(mix(m_theme.panel, m_theme.accent, tint)));
  m_painter.drawRoundedRect(inner, cornerRadius, cornerRadius);
}

void FragmentsPainter::paintStart(double y) const {
  const MathPicture &letter = m_fragments.start;
  const double em = startSize * emPixelsIn(m_font);
  const QRectF box(m_columns.mark - letter.width() * em / 2, y - letter.height() * em / 2,
                   letter.width() * em, letter.height() * em);
  const double gap = box.width() / 4;
  const QColor ink = toQColor(m_theme.inkOf(Subject::Point));
  const QColor rule = toQColor(m_theme.mutedInk);
  const double line = std::floor(y);
  m_painter.fillRect(QRectF(0, line, box.left() - gap, 1), rule);
  m_painter.fillRect(QRectF(box.right() + gap, line, m_columns.width - box.right() - gap, 1), rule);
  letter.paint(m_painter, {box.left(), box.top() + letter.ascent() * em}, em,
               [&ink](const QString &) { return ink; });
}

void FragmentsPainter::paintWords(const FragmentRow &row, double middle) const {
  const LiveValues values = m_fragments.values;
  if (values == LiveValues::Shown)
    paintMark(m_painter, {m_columns.mark, middle}, markRadius * m_line, row.standing, inkOf(row));
  m_painter.setFont(isNearest(row.standing) && !isHidden(row) ? bold(m_font) : m_font);
  m_painter.setPen(inkOf(row));
  const QFontMetricsF metrics(m_painter.font());
  const auto paint = [&](const FragmentColumns::Column &column, double room, const QString &words,
                         int flags) {
    m_painter.drawText(QRectF(column.left, middle - m_line / 2, column.width, m_line), flags,
                       metrics.elidedText(words, Qt::ElideRight, room));
  };
  const QString name = QString::fromStdString(row.crossing.name);
  QString verdict = verdictOf(row, values);
  const double wide = metrics.horizontalAdvance(m_columns.isStacked ? name + "  " + verdict : verdict);
  if (wide > m_columns.verdict.width)
    verdict = shortVerdictOf(row, values);
  paint(m_columns.verdict, m_columns.verdict.width, verdict, verdictFlags());
  const double taken = m_columns.isStacked ? metrics.horizontalAdvance(verdict + ' ') : 0;
  paint(m_columns.name, m_columns.name.width - taken, name, Qt::AlignVCenter);
}

void FragmentsPainter::paintNumber(const MathPicture &picture, const FragmentColumns::Column &column,
                                   double middle, const QColor &ink) const {
  const double usual = emPixelsIn(m_font);
  const double em = usual * std::min(1.0, std::max(smallestScale, column.width / (picture.width() * usual)));
  const QFontMetricsF metrics(m_font);
  const QPointF baseline(column.left + column.width - picture.width() * em,
                         middle + (metrics.ascent() - metrics.descent()) / 2); // the words' own
  picture.paint(m_painter, baseline, em, [&ink](const QString &) { return ink; });
}

QColor FragmentsPainter::inkOf(const FragmentRow &row) const {
  if (isHidden(row))
    return toQColor(m_theme.mutedInk);
  return toQColor(halfspace::inkOf(row.standing, isBehindStart(row.crossing), m_theme));
}

} // namespace

FragmentNeeds needsOf(const QStringList &names, const QFont &words, double widestNumber) {
  const QFontMetricsF usual(words);
  const QFontMetricsF emphasised(bold(words));
  FragmentNeeds needs;
  needs.line = usual.height();
  needs.name = usual.horizontalAdvance(headOfNames());
  for (const QString &name : names)
    needs.name = std::max(needs.name, emphasised.horizontalAdvance(name));
  for (const Standing standing : allStandings)
    needs.verdict = std::max(
        needs.verdict, (isNearest(standing) ? emphasised : usual).horizontalAdvance(shortWordsOf(standing)));
  needs.number = widestNumber * emPixelsIn(words);
  // Room for what the painter rounds up.
  needs.name = std::ceil(needs.name) + 1;
  needs.verdict = std::ceil(needs.verdict) + 1;
  return needs;
}

void paintFragments(QPainter &painter, const PaintedFragments &fragments, const FragmentColumns &columns) {
  painter.setRenderHint(QPainter::Antialiasing);
  const FragmentsPainter table(painter, fragments, columns);
  table.paintHead();
  for (std::size_t i = 0; i < fragments.shown.rows.size(); ++i)
    table.paintRow(i);
  table.paintLeftOut();
}

} // namespace halfspace
