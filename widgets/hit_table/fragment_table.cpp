#include "widgets/hit_table/fragment_table.h"

#include "lessons/term/plain_text.h"
#include "widgets/colors.h"
#include "widgets/flight/short_decimal.h"
#include "widgets/formula/term_formula.h"
#include "widgets/speak_by.h"
#include "widgets/text/figures.h"

#include <QAccessibleWidget>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace halfspace {
namespace {

/// The type's size of formulas, as part of the height of the words' line.
constexpr double typeSize = 0.8;
/// A number that is too wide is drawn smaller, but not below this part of its size.
constexpr double smallestScale = 0.5;
/// Q at the rule, in the type of formulas.
constexpr double startSize = 0.72;
// In heights of a line.
constexpr double markRadius = 0.26;
constexpr double smallestWidthInLines = 10;
constexpr double usualWidthInLines = 24;

constexpr double chosenTint = 0.13;
constexpr double hoverTint = 0.06;
constexpr double cornerRadius = 4;

constexpr std::array<Subject, 3> headSubjects{Subject::Ray, Subject::EdgeU, Subject::EdgeV};

constexpr std::array<Standing, 11> allStandings{
    Standing::First,      Standing::FirstToo,    Standing::FirstSoFar, Standing::Hit,
    Standing::Outside,    Standing::Behind,      Standing::Parallel,   Standing::InPlane,
    Standing::NoTriangle, Standing::NoDirection, Standing::NotAsked};

int verdictFlags(const FragmentColumns &columns) {
  return int(Qt::AlignVCenter) | int(columns.isStacked ? Qt::AlignRight : Qt::AlignLeft);
}

QFont bold(QFont font) {
  font.setBold(true);
  return font;
}

/// So many letters stand exactly in a list: 0.6875, 12/175.
constexpr std::size_t longestExact = 6;

/// As wide as they get.
WrittenNumber widestNumber() { return written(Rational(-88, 875)); }

bool isLong(const WrittenNumber &number) {
  const std::string text = plainText(number.term);
  return !number.exact ||
         text.size() - (text.starts_with("−") ? std::string_view("−").size() : 0) > longestExact;
}

/// As it stands among words: a fraction has a slash, and its digits are as large as others.
math::Row formulaOfNumber(const WrittenNumber &number) { return formulaOf(number.term, Fractions::Flat); }

/// In a column whose head says that its numbers are rounded.
WrittenNumber roundedInColumn(const Rational &number) {
  const int places = abs(number) < 10 ? 2 : 1;
  return shortDecimal(number, places);
}

math::Row roundedHead(char32_t letter) {
  return math::row(math::letter(letter), math::symbol(U'≈', math::AtomClass::Rel));
}

std::array<Rational, 3> numbersAt(const Crossing::Parameters &at) { return {at.t, at.s, at.tTriangle}; }

/// What a screen reader is told, made when it asks.
class SpokenTable : public QAccessibleWidget {
public:
  explicit SpokenTable(FragmentTable &table) : QAccessibleWidget(&table, QAccessible::List), m_table(table) {}

  [[nodiscard]] QString text(QAccessible::Text text) const override {
    if (text != QAccessible::Description)
      return QAccessibleWidget::text(text);
    QStringList rows;
    for (std::size_t row = 0; row < m_table.rows().size(); ++row)
      rows << m_table.spoken(row);
    if (const QString more = m_table.leftOutWords(); !more.isEmpty())
      rows << more;
    return rows.join("; ");
  }

private:
  const FragmentTable &m_table;
};

QString spokenNumber(const char *name, const Rational &value) {
  return QString::fromUtf8(name) + QString::fromStdString(relatedText(written(value)));
}

} // namespace

FragmentTable::FragmentTable(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter), m_heads{typesetter.picture(math::row(math::letter(U'λ'))),
                                                         typesetter.picture(math::row(math::letter('s'))),
                                                         typesetter.picture(math::row(math::letter('t')))},
      m_roundedHeads{typesetter.picture(roundedHead(U'λ')), typesetter.picture(roundedHead('s')),
                     typesetter.picture(roundedHead('t'))},
      m_start(typesetter.picture(math::row(math::letter('Q')))),
      m_unknown(typesetter.picture(math::row(math::symbol('?')))),
      m_none(typesetter.picture(math::row(math::symbol(U'–')))),
      m_widest(typesetter.picture(formulaOfNumber(widestNumber()))), m_theme(themes().front()) {
  speakBy<FragmentTable, SpokenTable>();
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Fragments"));
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  measure();
}

void FragmentTable::setCrossings(const Crossings &crossings, LiveValues values) {
  m_values = values;
  m_shown = rowsOf(crossings, values, mostRows);
  if (std::exchange(m_chosen, crossings.chosen) != m_chosen && hasFocus())
    sayChosen();
  m_names.clear();
  for (const Crossing &crossing : crossings.all)
    m_names << QString::fromStdString(crossing.name);
  m_numbers.clear();
  for (const FragmentRow &row : m_shown.rows)
    m_numbers.emplace_back().fill(placeholderOf(row));
  for (std::size_t column = 0; column < m_areRounded.size(); ++column)
    writeColumn(column);
  measure();
  settleHeight();
  update();
}

void FragmentTable::sayChosen() {
  const std::optional<std::size_t> row = chosenRow();
  setAccessibleName(row ? tr("Fragments: %1", "a row").arg(spoken(*row)) : tr("Fragments"));
}

void FragmentTable::setHovered(std::size_t number) {
  if (std::exchange(m_hovered, number) != number)
    update();
}

void FragmentTable::setHeld(bool held) {
  m_held = held;
  settleHeight();
}

void FragmentTable::setTheme(const Theme &theme) {
  m_theme = theme;
  update();
}

void FragmentTable::measure() {
  const QFontMetricsF usual(font());
  const QFontMetricsF emphasised(bold(font()));
  FragmentNeeds needs;
  needs.line = usual.height();
  needs.name = usual.horizontalAdvance(tr("fragment"));
  for (const QString &name : m_names)
    needs.name = std::max(needs.name, emphasised.horizontalAdvance(name));
  for (const Standing standing : allStandings)
    needs.verdict = std::max(
        needs.verdict, (isNearest(standing) ? emphasised : usual).horizontalAdvance(shortWordsOf(standing)));
  needs.number = m_widest->width() * emPixels();
  // Room for what the painter rounds up.
  needs.name = std::ceil(needs.name) + 1;
  needs.verdict = std::ceil(needs.verdict) + 1;
  if (m_held)
    needs.name = std::max(needs.name, m_needs.name);
  if (std::exchange(m_needs, needs) != needs)
    updateGeometry();
}

void FragmentTable::settleHeight() {
  const double lines = static_cast<double>(m_shown.rows.size()) + (m_shown.leftOut > 0 ? 1 : 0);
  const double settled = m_held ? std::max(m_lineCount, lines) : lines;
  if (std::exchange(m_lineCount, settled) != settled)
    updateGeometry();
}

double FragmentTable::emPixels() const { return QFontMetricsF(font()).height() * typeSize; }

bool FragmentTable::isHidden(const FragmentRow &row) const {
  return m_values == LiveValues::Hidden || row.standing == Standing::NotAsked;
}

bool FragmentTable::hasNumbers(const FragmentRow &row) const { return row.crossing.at && !isHidden(row); }

Typesetter::Picture FragmentTable::placeholderOf(const FragmentRow &row) const {
  if (m_values == LiveValues::Hidden)
    return m_unknown;
  return row.standing == Standing::NotAsked ? nullptr : m_none;
}

void FragmentTable::writeColumn(std::size_t column) {
  std::vector<Real> numbers;
  for (const FragmentRow &row : m_shown.rows)
    if (hasNumbers(row))
      numbers.emplace_back(Surd(numbersAt(*row.crossing.at)[column]));
  const std::vector<WrittenNumber> alike = writtenAlike(numbers);
  const bool isRounded = std::any_of(alike.begin(), alike.end(), isLong);
  m_areRounded[column] = isRounded;
  auto next = alike.begin();
  for (std::size_t i = 0; i < m_shown.rows.size(); ++i)
    if (const FragmentRow &row = m_shown.rows[i]; hasNumbers(row)) {
      const WrittenNumber &exact = *next++;
      m_numbers[i][column] = m_typesetter.picture(
          formulaOfNumber(isRounded ? roundedInColumn(numbersAt(*row.crossing.at)[column]) : exact));
    }
}

QString FragmentTable::verdictOf(const FragmentRow &row) const {
  return m_values == LiveValues::Hidden ? QStringLiteral("?") : wordsOf(row.standing);
}

QColor FragmentTable::inkOf(const FragmentRow &row) const {
  if (isHidden(row))
    return toQColor(m_theme.mutedInk);
  return toQColor(halfspace::inkOf(row.standing, isBehindStart(row.crossing), m_theme));
}

QString FragmentTable::leftOutWords() const {
  if (m_shown.leftOut == 0)
    return {};
  const QString count = counted(m_shown.leftOut);
  return m_shown.leftOutAreOutside ? tr("and %1 more outside").arg(count) : tr("and %1 more").arg(count);
}

QString FragmentTable::spoken(std::size_t row) const {
  const FragmentRow &shown = m_shown.rows.at(row);
  if (m_values == LiveValues::Hidden)
    return tr("%1: hidden while the question is open").arg(QString::fromStdString(shown.crossing.name));
  QString sentence = sentenceOf(shown.crossing, shown.standing);
  if (!isHidden(shown) && shown.crossing.at)
    sentence += ", " + spokenNumber("s", shown.crossing.at->s) + ", " +
                spokenNumber("t", shown.crossing.at->tTriangle);
  return sentence;
}

FragmentColumns FragmentTable::columns() const { return columnsIn(width(), m_needs); }

QRect FragmentTable::rowRect(std::size_t row) const {
  const FragmentColumns placed = columns();
  const double top = placed.rowHeight * static_cast<double>(row + 1); // below the head
  return QRectF(0, top, placed.width, placed.rowHeight).toAlignedRect();
}

int FragmentTable::heightForWidth(int width) const {
  const FragmentColumns placed = columnsIn(width, m_needs);
  return static_cast<int>(std::ceil(placed.rowHeight * (m_lineCount + 1)));
}

QSize FragmentTable::sizeHint() const {
  const int usual = static_cast<int>(usualWidthInLines * m_needs.line);
  return {usual, heightForWidth(usual)};
}

QSize FragmentTable::minimumSizeHint() const {
  const int least = static_cast<int>(smallestWidthInLines * m_needs.line);
  return {least, 0};
}

std::size_t FragmentTable::numberAt(QPoint place) const {
  for (std::size_t i = 0; i < m_shown.rows.size(); ++i)
    if (rowRect(i).contains(place))
      return m_shown.rows[i].crossing.number;
  return 0;
}

std::optional<std::size_t> FragmentTable::chosenRow() const {
  for (std::size_t i = 0; i < m_shown.rows.size(); ++i)
    if (m_shown.rows[i].crossing.number == m_chosen)
      return i;
  return {};
}

void FragmentTable::pointAt(std::size_t number) {
  if (number == m_hovered)
    return;
  setHovered(number);
  if (number == 0)
    unsetCursor();
  else
    setCursor(Qt::PointingHandCursor);
  emit hovered(number);
}

void FragmentTable::mouseMoveEvent(QMouseEvent *event) { pointAt(numberAt(event->pos())); }

void FragmentTable::mousePressEvent(QMouseEvent *event) {
  const std::size_t number = event->button() == Qt::LeftButton ? numberAt(event->pos()) : 0;
  if (number == 0)
    return QWidget::mousePressEvent(event);
  emit chosen(number);
}

void FragmentTable::leaveEvent(QEvent *event) {
  pointAt(0);
  QWidget::leaveEvent(event);
}

void FragmentTable::chooseRow(std::size_t row) { emit chosen(m_shown.rows[row].crossing.number); }

void FragmentTable::keyPressEvent(QKeyEvent *event) {
  const std::size_t count = m_shown.rows.size();
  const std::optional<std::size_t> row = chosenRow();
  if (count == 0)
    return QWidget::keyPressEvent(event);
  switch (event->key()) {
  case Qt::Key_Down:
    return chooseRow(row ? std::min(*row + 1, count - 1) : 0);
  case Qt::Key_Up:
    return chooseRow(row ? *row - std::min<std::size_t>(*row, 1) : count - 1);
  case Qt::Key_Return:
  case Qt::Key_Enter:
    return chooseRow(row.value_or(0));
  default:
    QWidget::keyPressEvent(event);
  }
}

void FragmentTable::focusInEvent(QFocusEvent *event) {
  sayChosen();
  update();
  QWidget::focusInEvent(event);
}

void FragmentTable::focusOutEvent(QFocusEvent *event) {
  update();
  QWidget::focusOutEvent(event);
}

void FragmentTable::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange)
    measure();
  QWidget::changeEvent(event);
}

void FragmentTable::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const FragmentColumns placed = columns();
  paintHead(painter, placed);
  for (std::size_t i = 0; i < m_shown.rows.size(); ++i)
    paintRow(painter, placed, i);
  const double bottom = placed.rowHeight * static_cast<double>(m_shown.rows.size() + 1);
  painter.setFont(font());
  painter.setPen(toQColor(m_theme.mutedInk));
  painter.drawText(QRectF(placed.name.left, bottom, placed.width - placed.name.left, placed.rowHeight),
                   Qt::AlignVCenter, leftOutWords());
}

void FragmentTable::paintHead(QPainter &painter, const FragmentColumns &columns) const {
  const QColor muted = toQColor(m_theme.mutedInk);
  painter.setPen(muted);
  const double line = m_needs.line;
  const double top = columns.wordsMiddle() - line / 2;
  painter.drawText(QRectF(columns.name.left, top, columns.name.width, line), Qt::AlignVCenter,
                   tr("fragment"));
  painter.drawText(QRectF(columns.verdict.left, top, columns.verdict.width, line), verdictFlags(columns),
                   tr("verdict"));
  for (std::size_t i = 0; i < m_heads.size(); ++i)
    paintNumber(painter, m_areRounded[i] ? *m_roundedHeads[i] : *m_heads[i], columns.numbers[i],
                columns.numbersMiddle(), toQColor(m_theme.inkOf(headSubjects[i])));
  painter.fillRect(QRectF(0, std::floor(columns.rowHeight) - 1, columns.width, 1), muted);
}

void FragmentTable::paintBackground(QPainter &painter, const FragmentRow &row, const QRectF &place) const {
  const bool isChosen = row.crossing.number == m_chosen;
  const double tint = isChosen ? chosenTint : row.crossing.number == m_hovered ? hoverTint : 0;
  if (tint == 0)
    return;
  const QRectF inner = place.adjusted(0.5, 1, -0.5, -1);
  painter.setPen(isChosen && hasFocus() ? QPen(toQColor(m_theme.accent), 1) : QPen(Qt::NoPen));
  painter.setBrush(toQColor(mix(m_theme.panel, m_theme.accent, tint)));
  painter.drawRoundedRect(inner, cornerRadius, cornerRadius);
}

void FragmentTable::paintRow(QPainter &painter, const FragmentColumns &columns, std::size_t row) const {
  const FragmentRow &shown = m_shown.rows[row];
  const QRectF place(0, columns.rowHeight * static_cast<double>(row + 1), columns.width, columns.rowHeight);
  paintBackground(painter, shown, place);
  if (shown.beginsRay)
    paintStart(painter, place.top(), columns);
  const QColor ink = inkOf(shown);
  const double middle = place.top() + columns.wordsMiddle();
  if (m_values == LiveValues::Shown)
    paintMark(painter, {columns.mark, middle}, markRadius * m_needs.line, shown.standing, ink);
  painter.setFont(isNearest(shown.standing) && !isHidden(shown) ? bold(font()) : font());
  painter.setPen(ink);
  const double top = middle - m_needs.line / 2;
  const QFontMetricsF metrics(painter.font());
  const auto paintWords = [&](const FragmentColumns::Column &column, double room, const QString &words,
                              int flags) {
    painter.drawText(QRectF(column.left, top, column.width, m_needs.line), flags,
                     metrics.elidedText(words, Qt::ElideRight, room));
  };
  const QString name = QString::fromStdString(shown.crossing.name);
  QString verdict = verdictOf(shown);
  const double wide = metrics.horizontalAdvance(columns.isStacked ? name + "  " + verdict : verdict);
  if (m_values == LiveValues::Shown && wide > columns.verdict.width)
    verdict = shortWordsOf(shown.standing);
  paintWords(columns.verdict, columns.verdict.width, verdict, verdictFlags(columns));
  const double taken = columns.isStacked ? metrics.horizontalAdvance(verdict + ' ') : 0;
  paintWords(columns.name, columns.name.width - taken, name, Qt::AlignVCenter);
  for (std::size_t i = 0; i < m_numbers[row].size(); ++i)
    if (m_numbers[row][i])
      paintNumber(painter, *m_numbers[row][i], columns.numbers[i], place.top() + columns.numbersMiddle(),
                  ink);
}

void FragmentTable::paintStart(QPainter &painter, double y, const FragmentColumns &columns) const {
  const double em = startSize * emPixels();
  const QRectF box(columns.mark - m_start->width() * em / 2, y - m_start->height() * em / 2,
                   m_start->width() * em, m_start->height() * em);
  const double gap = box.width() / 4;
  const QColor ink = toQColor(m_theme.inkOf(Subject::Point));
  const double line = std::floor(y);
  painter.fillRect(QRectF(0, line, box.left() - gap, 1), toQColor(m_theme.mutedInk));
  painter.fillRect(QRectF(box.right() + gap, line, columns.width - box.right() - gap, 1),
                   toQColor(m_theme.mutedInk));
  m_start->paint(painter, {box.left(), box.top() + m_start->ascent() * em}, em,
                 [&ink](const QString &) { return ink; });
}

void FragmentTable::paintNumber(QPainter &painter, const MathPicture &picture,
                                const FragmentColumns::Column &column, double middle,
                                const QColor &ink) const {
  const double wanted = picture.width() * emPixels();
  const double em = emPixels() * std::min(1.0, std::max(smallestScale, column.width / wanted));
  const QFontMetricsF metrics(font());
  const QPointF baseline(column.left + column.width - picture.width() * em,
                         middle + (metrics.ascent() - metrics.descent()) / 2); // the words' own
  picture.paint(painter, baseline, em, [&ink](const QString &) { return ink; });
}

} // namespace halfspace
