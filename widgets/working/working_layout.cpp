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

/// Lays out one line at a time below the last.
class LinePlacer {
public:
  LinePlacer(SentenceBreaker &sentences, const QFont &font, double width)
      : m_sentences(sentences), m_font(font), m_em(emPixelsOf(font)), m_width(width),
        m_left(sideMargin * m_em), m_right(width - sideMargin * m_em) {}

  /// `held`: what stands there; may be null.
  PlacedLine place(const TypesetLine &line, const QString &remark, const QString &heading,
                   const PlacedLine *held) {
    m_placed = {};
    const double top = m_y;
    m_placed.heading = placeText(heading, m_left);
    m_y += lineMargin * m_em;
    if (!held || !placeInRowsOf(*held, line))
      placeFormulas(line, emFor(line));
    m_y = std::max(m_y, top + (held ? held->formulasBottom : 0)); // what is said below stays where it is
    m_placed.formulasBottom = m_y - top;
    const double markRoom = remarkIndent * QFontMetricsF(m_font).height();
    m_placed.remark = placeText(remark, m_left + markRoom);
    if (!line.isPartial)
      m_placed.sentence = placeText(QString::fromStdString(line.source.sentence), m_left);
    m_y += lineMargin * m_em;
    m_y = std::max(m_y, top + (held ? held->box.height() : 0));
    m_placed.box = QRectF(0, top, m_width, m_y - top);
    return std::move(m_placed);
  }

  [[nodiscard]] double bottom() const { return m_y; }
  /// Beyond the width where a formula does not fit.
  [[nodiscard]] double right() const { return std::max(m_width, m_widest + sideMargin * m_em); }

private:
  void placeFormulas(const TypesetLine &line, double em) {
    m_placed.formulas.clear();
    m_placed.blank = {};
    m_x = m_left;
    m_rowIsEmpty = true;
    m_lineEm = em;
    startRow();
    for (std::size_t piece = 0; piece < line.pieces.size(); ++piece)
      placePiece(line.pieces[piece], static_cast<LinePiece>(piece));
    if (line.told) {
      breakRow();
      placePiece(line.told);
    }
    endRow();
  }

  /// False, and nothing is placed, where the line fits into no such rows with type that can be read.
  bool placeInRowsOf(const PlacedLine &held, const TypesetLine &line) {
    const double top = m_y;
    const double widest = m_widest;
    const double usualRight = m_right;
    const double usualEm = emFor(line);
    const double smallestEm = std::max(smallestHeldScale * usualEm, smallestScale * m_em);
    m_held = &held;
    const auto fits = [&](double em) {
      m_y = top;
      m_widest = widest;
      placeFormulas(line, em);
      return hasRowsOf(held);
    };
    bool isPlaced = fits(usualEm);
    m_right = m_width - heldSideMargin * m_em;
    for (double em = usualEm; !isPlaced && em >= smallestEm; em *= heldScaleStep)
      isPlaced = fits(em);
    m_held = nullptr;
    m_right = usualRight;
    if (!isPlaced) {
      m_y = top;
      m_widest = widest;
    }
    return isPlaced;
  }

  /// Whether the formulas fit as they are placed and are broken no more often than those that stood there.
  [[nodiscard]] bool hasRowsOf(const PlacedLine &held) const {
    return m_placed.formulas.size() == held.formulas.size() &&
           std::equal(m_placed.formulas.begin(), m_placed.formulas.end(), held.formulas.begin(),
                      [&](const PlacedFormula &now, const PlacedFormula &before) {
                        return now.box().right() <= m_right && now.beginsRow == before.beginsRow &&
                               now.picture->lineCount() <= before.picture->lineCount();
                      });
  }

  /// The size of a line's type: smaller where a piece of it fits into no row of its own, and then for all of
  /// its pieces.
  [[nodiscard]] double emFor(const TypesetLine &line) const {
    double em = m_em;
    double left = m_left;
    const auto fit = [&](const Typesetter::Picture &picture) {
      if (!picture)
        return;
      const double room = std::max(m_right - left, 1.0);
      if (picture->width() * em > room)
        em = std::min(em, room / std::max(picture->brokenTo(room / m_em).width(), room / em));
      left = m_left + indent * m_em;
    };
    for (const Typesetter::Picture &piece : line.pieces)
      fit(piece);
    fit(line.told);
    return std::max(em, smallestScale * m_em);
  }

  void startRow() {
    m_rowBegin = m_placed.formulas.size();
    m_ascent = leastAscent * m_em;
    m_depth = leastDepth * m_em;
    m_rowIsFull = false;
  }

  /// Now that the row's height is known, everything in it comes down to its baseline.
  void endRow() {
    const double baseline = m_y + m_ascent;
    for (std::size_t i = m_rowBegin; i < m_placed.formulas.size(); ++i) {
      PlacedFormula &formula = m_placed.formulas[i];
      formula.baseline.setY(baseline);
      if (const auto &leftOut = formula.picture->leftOut())
        m_placed.blank = formula.toWorking(*leftOut);
    }
    m_y = baseline + m_depth;
  }

  void breakRow() {
    endRow();
    m_y += rowGap * m_em;
    m_x = m_left + indent * m_em;
    m_rowIsEmpty = true;
    startRow();
  }

  /// Makes room for something of this width, in a new row if it must be.
  void makeRoom(double width) {
    if (m_rowIsEmpty)
      return;
    if (breaksBefore(width))
      breakRow();
    else
      m_x += relationGap * m_em;
  }

  [[nodiscard]] bool breaksBefore(double width) const {
    if (m_held && m_placed.formulas.size() < m_held->formulas.size())
      return m_held->formulas[m_placed.formulas.size()].beginsRow;
    // Beside a formula on several lines nothing could be read in its order.
    return m_rowIsFull || m_x + relationGap * m_em + width > m_right;
  }

  void advance(double width) {
    m_x += width;
    m_widest = std::max(m_widest, m_x);
    m_rowIsEmpty = false;
  }

  void placePiece(const Typesetter::Picture &picture, std::optional<LinePiece> piece = {}) {
    if (!picture)
      return;
    makeRoom(picture->width() * m_lineEm);
    const bool beginsRow = m_rowIsEmpty;
    const double room = std::max(m_right - m_x, 1.0);
    const Typesetter::Picture shown =
        picture->width() * m_lineEm > room
            ? std::make_shared<const MathPicture>(picture->brokenTo(room / m_lineEm))
            : picture;
    m_placed.formulas.push_back({shown, {m_x, 0}, m_lineEm, piece, beginsRow});
    m_ascent = std::max(m_ascent, shown->ascent() * m_lineEm);
    m_depth = std::max(m_depth, shown->depth() * m_lineEm);
    advance(shown->width() * m_lineEm);
    m_rowIsFull = shown->isBroken();
  }

  std::vector<PlacedText> placeText(const QString &words, double left) {
    std::vector<PlacedText> placed;
    if (words.isEmpty())
      return placed;
    m_y += sentenceGap * m_em;
    for (const SentenceBreaker::Line &line :
         m_sentences.lines(words, m_font, std::max(m_right - left, 1.0))) {
      placed.push_back({line.text, line.runs, {left, m_y + line.ascent}});
      m_y += sentenceLineHeight * line.height;
    }
    m_y -= (sentenceLineHeight - 1) * QFontMetricsF(m_font).height(); // nothing below the last
    return placed;
  }

  SentenceBreaker &m_sentences;
  QFont m_font;
  double m_em, m_width, m_left, m_right;
  double m_x = 0, m_y = 0, m_widest = 0;
  PlacedLine m_placed;
  const PlacedLine *m_held = nullptr; ///< whose rows the formulas are to have
  double m_lineEm = 0;                ///< of the line in work
  // The row in work.
  std::size_t m_rowBegin = 0;
  double m_ascent = 0, m_depth = 0;
  bool m_rowIsEmpty = true, m_rowIsFull = false;
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
