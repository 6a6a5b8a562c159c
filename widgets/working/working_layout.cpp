#include "widgets/working/working_layout.h"

#include "lessons/scene/evaluation.h"

#include <QFontInfo>
#include <QFontMetricsF>

#include <algorithm>
#include <utility>

namespace halfspace {

namespace {

/// The formulas' type is so much larger than the sentences': it has finer strokes.
constexpr double formulaScale = 1.28;
/// A formula that is too wide is not drawn smaller than this.
constexpr double smallestScale = 0.6;
/// The type of a held line becomes smaller in such steps, and not smaller than a part of its usual size.
constexpr double heldScaleStep = 0.95;
constexpr double smallestHeldScale = 0.7;
/// Narrower, in em, than any formula can be broken to: its second line begins further right.
constexpr double narrowestLine = 1;

// Space, in em of the formulas' type.
constexpr double sideMargin = 1.0;
constexpr double heldSideMargin = 0.35;    // on the right of a held line whose numbers became longer
constexpr double lineMargin = 0.45;        // above and below a line
constexpr double rowGap = 0.5;             // between the rows of a line
constexpr double sentenceGap = 0.5;        // between formulas and sentence
constexpr double relationGap = 0.28;       // before `=`: TeX's thick space
constexpr double indent = 1.6;             // of further rows
constexpr double sentenceLineHeight = 1.2; // as part of the font's
constexpr double remarkIndent = 0.95;      // for the mark before it, likewise
// Every row has at least the room of ordinary letters.
constexpr double leastAscent = 0.72;
constexpr double leastDepth = 0.22;

/// Where formulas may stand; in pixels. Gaps are in its em, whatever the type of a line is.
struct FormulaRoom {
  double em;
  double left;
  double right;
};

/// The formulas of one line, in rows below each other.
class FormulaRows {
public:
  /// Begins below `top`, in type of a size of its own. `held`: whose rows they are to have; may be null.
  FormulaRows(const FormulaRoom &room, double top, double typeEm, const PlacedLine *held)
      : m_room(room), m_typeEm(typeEm), m_held(held), m_x(room.left), m_y(top) {}

  void place(const TypesetLine &line) {
    startRow();
    for (std::size_t piece = 0; piece < line.pieces.size(); ++piece)
      placePiece(line.pieces[piece], static_cast<LinePiece>(piece));
    if (line.told) {
      breakRow();
      placePiece(line.told);
    }
    endRow();
  }

  /// Whether the formulas fit as they are placed and are broken no more often than those that stood there.
  [[nodiscard]] bool haveRowsOf(const PlacedLine &held) const {
    return m_formulas.size() == held.formulas.size() &&
           std::equal(m_formulas.begin(), m_formulas.end(), held.formulas.begin(),
                      [&](const PlacedFormula &now, const PlacedFormula &before) {
                        return now.box().right() <= m_room.right && now.beginsRow == before.beginsRow &&
                               now.picture->lineCount() <= before.picture->lineCount();
                      });
  }

  [[nodiscard]] double bottom() const { return m_y; }
  /// Of the widest of them.
  [[nodiscard]] double right() const { return m_widest; }
  /// Ends its work: a line has them now.
  void handTo(PlacedLine &line) {
    line.formulas = std::move(m_formulas);
    line.blank = m_blank;
  }

private:
  /// The row in work.
  struct Row {
    std::size_t begin; ///< its first formula
    double ascent, depth;
    bool isEmpty = true;
    bool isFull = false;
  };

  void startRow() { m_row = {m_formulas.size(), leastAscent * m_room.em, leastDepth * m_room.em}; }

  /// Now that the row's height is known, everything in it comes down to its baseline.
  void endRow() {
    const double baseline = m_y + m_row.ascent;
    for (std::size_t i = m_row.begin; i < m_formulas.size(); ++i) {
      PlacedFormula &formula = m_formulas[i];
      formula.baseline.setY(baseline);
      if (const auto &leftOut = formula.picture->leftOut())
        m_blank = formula.toWorking(*leftOut);
    }
    m_y = baseline + m_row.depth;
  }

  void breakRow() {
    endRow();
    m_y += rowGap * m_room.em;
    m_x = m_room.left + indent * m_room.em;
    startRow();
  }

  /// Makes room for something of this width, in a new row if it must be.
  void makeRoom(double width) {
    if (m_row.isEmpty)
      return;
    if (breaksBefore(width))
      breakRow();
    else
      m_x += relationGap * m_room.em;
  }

  [[nodiscard]] bool breaksBefore(double width) const {
    if (m_held && m_formulas.size() < m_held->formulas.size())
      return m_held->formulas[m_formulas.size()].beginsRow;
    // Beside a formula on several lines nothing could be read in its order.
    return m_row.isFull || m_x + relationGap * m_room.em + width > m_room.right;
  }

  void placePiece(const Typesetter::Picture &picture, std::optional<LinePiece> piece = {}) {
    if (!picture)
      return;
    makeRoom(picture->width() * m_typeEm);
    const double room = std::max(m_room.right - m_x, 1.0);
    const Typesetter::Picture shown =
        picture->width() * m_typeEm > room
            ? std::make_shared<const MathPicture>(picture->brokenTo(room / m_typeEm))
            : picture;
    m_formulas.push_back({shown, {m_x, 0}, m_typeEm, piece, m_row.isEmpty});
    m_row.ascent = std::max(m_row.ascent, shown->ascent() * m_typeEm);
    m_row.depth = std::max(m_row.depth, shown->depth() * m_typeEm);
    m_row.isEmpty = false;
    m_row.isFull = shown->isBroken();
    m_x += shown->width() * m_typeEm;
    m_widest = std::max(m_widest, m_x);
  }

  FormulaRoom m_room;
  double m_typeEm;
  const PlacedLine *m_held;
  double m_x, m_y;
  double m_widest = 0;
  Row m_row{};
  std::vector<PlacedFormula> m_formulas;
  QRectF m_blank; ///< null when nothing is left out
};

/// The size of a line's type: smaller where a piece of it fits into no row of its own, and then for all of
/// its pieces.
double typeEmFor(const TypesetLine &line, const FormulaRoom &room) {
  double em = room.em;
  double left = room.left;
  const auto fit = [&](const Typesetter::Picture &picture) {
    if (!picture)
      return;
    const double width = std::max(room.right - left, 1.0);
    if (picture->width() * em > width)
      em = std::min(em, width / std::max(picture->brokenTo(width / room.em).width(), width / em));
    left = room.left + indent * room.em;
  };
  for (const Typesetter::Picture &piece : line.pieces)
    fit(piece);
  fit(line.told);
  return std::max(em, smallestScale * room.em);
}

/// Lays out one line at a time below the last.
class LinePlacer {
public:
  LinePlacer(SentenceBreaker &sentences, const QFont &font, double width)
      : m_sentences(sentences), m_font(font), m_width(width) {
    const double em = emPixelsOf(font);
    m_room = {em, sideMargin * em, width - sideMargin * em};
  }

  /// `held`: what stands there; may be null.
  PlacedLine place(const TypesetLine &line, const QString &remark, const QString &heading,
                   const PlacedLine *held) {
    PlacedLine placed;
    const double top = m_y;
    placed.heading = placeText(heading, m_room.left);
    m_y += lineMargin * m_room.em;
    FormulaRows rows = rowsOf(line, held);
    rows.handTo(placed);
    m_widest = std::max(m_widest, rows.right());
    // What is said below stays where it is.
    m_y = std::max(rows.bottom(), top + (held ? held->formulasBottom : 0));
    placed.formulasBottom = m_y - top;
    const double markRoom = remarkIndent * QFontMetricsF(m_font).height();
    placed.remark = placeText(remark, m_room.left + markRoom);
    if (!line.isPartial)
      placed.sentence = placeText(QString::fromStdString(line.source.sentence), m_room.left);
    m_y += lineMargin * m_room.em;
    m_y = std::max(m_y, top + (held ? held->box.height() : 0));
    placed.box = QRectF(0, top, m_width, m_y - top);
    return placed;
  }

  [[nodiscard]] double bottom() const { return m_y; }
  /// Beyond the width where a formula does not fit.
  [[nodiscard]] double right() const { return std::max(m_width, m_widest + sideMargin * m_room.em); }

private:
  [[nodiscard]] FormulaRows rowsOf(const TypesetLine &line, const PlacedLine *held) const {
    const double typeEm = typeEmFor(line, m_room);
    if (held)
      if (auto rows = rowsAsHeld(*held, line, typeEm))
        return std::move(*rows);
    FormulaRows rows(m_room, m_y, typeEm, nullptr);
    rows.place(line);
    return rows;
  }

  /// Nothing where the line fits into no such rows with type that can be read.
  [[nodiscard]] std::optional<FormulaRows> rowsAsHeld(const PlacedLine &held, const TypesetLine &line,
                                                      double usualEm) const {
    const auto rowsIn = [&](const FormulaRoom &room, double typeEm) {
      FormulaRows rows(room, m_y, typeEm, &held);
      rows.place(line);
      return rows.haveRowsOf(held) ? std::optional(std::move(rows)) : std::nullopt;
    };
    if (auto rows = rowsIn(m_room, usualEm))
      return rows;
    const FormulaRoom wider{m_room.em, m_room.left, m_width - heldSideMargin * m_room.em};
    const double smallestEm = std::max(smallestHeldScale * usualEm, smallestScale * m_room.em);
    for (double em = usualEm; em >= smallestEm; em *= heldScaleStep)
      if (auto rows = rowsIn(wider, em))
        return rows;
    return {};
  }

  std::vector<PlacedText> placeText(const QString &words, double left) {
    std::vector<PlacedText> placed;
    if (words.isEmpty())
      return placed;
    m_y += sentenceGap * m_room.em;
    for (const SentenceBreaker::Line &line :
         m_sentences.lines(words, m_font, std::max(m_room.right - left, 1.0))) {
      placed.push_back({line.text, line.runs, {left, m_y + line.ascent}});
      m_y += sentenceLineHeight * line.height;
    }
    m_y -= (sentenceLineHeight - 1) * QFontMetricsF(m_font).height(); // nothing below the last
    return placed;
  }

  SentenceBreaker &m_sentences;
  QFont m_font;
  double m_width;
  FormulaRoom m_room{};
  double m_y = 0, m_widest = 0;
};

/// Whether a line is the first of its construction's.
bool beginsWorking(const std::vector<TypesetLine> &lines, std::size_t index) {
  return index == 0 || entryOf(lines[index].source.id) != entryOf(lines[index - 1].source.id);
}

bool hasSeveralWorkings(const std::vector<TypesetLine> &lines) {
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (beginsWorking(lines, i))
      return true;
  return false;
}

} // namespace

double emPixelsOf(const QFont &font) { return formulaScale * QFontInfo(font).pixelSize(); }

QRectF PlacedFormula::toWorking(const QRectF &inPicture) const {
  return {baseline + inPicture.topLeft() * emPixels, inPicture.size() * emPixels};
}

double narrowestWidth(const std::vector<TypesetLine> &lines, const QFont &font) {
  double widest = 0;
  for (const TypesetLine &line : lines)
    for (const Typesetter::Picture &piece : line.pieces)
      if (piece)
        widest = std::max(widest, piece->brokenTo(narrowestLine).width());
  return (widest * smallestScale + indent + 2 * sideMargin) * emPixelsOf(font);
}

PlacedWorking placeWorking(const std::vector<TypesetLine> &lines,
                           const std::map<std::string, QString> &remarks, SentenceBreaker &sentences,
                           const QFont &font, double width, const HeldLines &held) {
  const bool hasHeadings = hasSeveralWorkings(lines);
  LinePlacer placer(sentences, font, width);
  PlacedWorking placed;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string &id = lines[i].source.id;
    const auto remark = remarks.find(id);
    const auto stood = held.find(id);
    const bool isHeaded = hasHeadings && beginsWorking(lines, i);
    placed.lines.push_back(placer.place(lines[i], remark == remarks.end() ? QString() : remark->second,
                                        isHeaded ? QString::fromStdString(entryOf(id)) : QString(),
                                        stood == held.end() ? nullptr : &stood->second));
  }
  placed.size = {placer.right(), placer.bottom()};
  return placed;
}

} // namespace halfspace
