// A row: which signs combine, what stands between the atoms, where tags begin and end.
#include "widgets/formula/row_atoms.h"
#include "widgets/formula/set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace halfspace::math {
namespace {

constexpr double mu = 1.0 / 18;

/// TeX's table of spaces between atoms (The TeXbook, p. 170): 1 thin, 2 medium, 3 thick; negative: not in
/// scripts.
constexpr std::array<std::array<int, 8>, 8> spaces{{{0, 1, -2, -3, 0, 0, 0, -1},
                                                    {1, 1, 0, -3, 0, 0, 0, -1},
                                                    {-2, -2, 0, 0, -2, 0, 0, -2},
                                                    {-3, -3, 0, 0, -3, 0, 0, -3},
                                                    {0, 0, 0, 0, 0, 0, 0, 0},
                                                    {0, 1, -2, -3, 0, 0, 0, -1},
                                                    {-1, -1, 0, -1, -1, -1, -1, -1},
                                                    {-1, 1, -2, -3, -1, 0, -1, -1}}};
/// Of the three spaces.
constexpr std::array<double, 4> widths{0, 3 * mu, 4 * mu, 5 * mu};

/// A space as wide as a quad sets statements apart: a line can end there.
constexpr double spaceBetweenStatements = 1;

double spaceBetween(AtomClass left, AtomClass right, SetStyle style) {
  const int kind = spaces[static_cast<std::size_t>(left)][static_cast<std::size_t>(right)];
  return kind < 0 && style.isScript() ? 0 : widths[static_cast<std::size_t>(std::abs(kind))];
}

/// One thing of a row, with tags and colours opened up.
struct Entry {
  enum class Kind : std::uint8_t { Atom, Space, TagBegin, TagEnd };
  Kind kind = Kind::Atom;
  std::size_t atom = 0; ///< index of an Atom
  SetStyle style;
  Ink ink;
  Box box;                ///< of an Atom
  double width = 0;       ///< of a Space
  std::size_t tagBox = 0; ///< of a tag's two ends
};

/// A box around nothing yet.
constexpr double nothing = -std::numeric_limits<double>::infinity();

class RowSetter {
public:
  RowSetter(Sheet &sheet, const RowPlan &plan) : m_sheet(sheet), m_plan(plan), m_all(sheet.begin()) {}

  Box set(const Row &row, SetStyle style) {
    const Ink around = m_sheet.ink();
    m_entries.reserve(row.size());
    collect(row, style);
    settle(m_atoms, m_plan.before);
    setMiddleFences(style);
    place();
    m_sheet.setInk(around);
    m_sheet.close(m_all);
    return m_all;
  }

private:
  void collect(const Row &row, SetStyle style);
  void collectTagged(const Tagged &tagged, SetStyle style);
  void collectColored(const Colored &colored, SetStyle style);
  void collectAtom(const Node &node, SetStyle style);
  void setMiddleFences(SetStyle style);
  [[nodiscard]] double fenceHeight(SetStyle style) const;
  void place();
  void placeAtom(const Entry &entry);
  [[nodiscard]] const Entry *onlyAtom() const;
  void addPiece(const Entry &entry);
  void closeTag(const Entry &entry);

  /// A tag that is open while the row is placed: the room of its atoms so far, without spaces at its ends.
  struct OpenTag {
    double left;
    double right;
    double ascent = nothing;
    double depth = nothing;
    std::size_t piece = 0;
  };

  Sheet &m_sheet;
  RowPlan m_plan;
  Box m_all;
  std::vector<Entry> m_entries;
  std::vector<RowAtom> m_atoms;
  double m_x = 0;
  std::optional<AtomClass> m_before;
  std::vector<OpenTag> m_openTags;
  int m_parentheses = 0;
  bool m_followsWideSpace = false;
};

void RowSetter::collect(const Row &row, SetStyle style) {
  if (!m_sheet.descend())
    return;
  for (const Node &node : row) {
    if (const auto *to = std::get_if<StyleSwitch>(&node.content)) {
      style = style.sized(to->style);
    } else if (const auto *space = std::get_if<Space>(&node.content)) {
      Entry &entry = m_entries.emplace_back();
      entry.kind = Entry::Kind::Space;
      entry.width = space->width * m_sheet.em(style);
    } else if (const auto *tagged = std::get_if<Tagged>(&node.content)) {
      collectTagged(*tagged, style);
    } else if (const auto *colored = std::get_if<Colored>(&node.content)) {
      collectColored(*colored, style);
    } else {
      collectAtom(node, style);
    }
  }
  m_sheet.ascend();
}

void RowSetter::collectTagged(const Tagged &tagged, SetStyle style) {
  const Ink around = m_sheet.ink();
  Entry entry;
  entry.kind = Entry::Kind::TagBegin;
  entry.tagBox = m_sheet.openTag(tagged.tag);
  m_entries.push_back(entry);
  collect(tagged.row, style);
  m_sheet.setInk(around);
  entry.kind = Entry::Kind::TagEnd;
  m_entries.push_back(entry);
}

void RowSetter::collectColored(const Colored &colored, SetStyle style) {
  const Ink around = m_sheet.ink();
  Ink inside = around;
  inside.color = colored.color;
  m_sheet.setInk(inside);
  collect(colored.row, style);
  m_sheet.setInk(around);
}

void RowSetter::collectAtom(const Node &node, SetStyle style) {
  Entry entry;
  entry.atom = m_atoms.size();
  entry.style = style;
  entry.ink = m_sheet.ink();
  // How tall a middle fence is, the other atoms say.
  if (!std::holds_alternative<MiddleFence>(node.content) || m_plan.fenceHeight == nullptr)
    entry.box = setNode(m_sheet, node, style);
  m_entries.push_back(entry);
  m_atoms.push_back({&node, node.atomClass});
}

/// Fences reach as far as what they enclose, but for a little that nobody sees. (TeX's lack up to 10 % of
/// it.)
double RowSetter::fenceHeight(SetStyle style) const {
  constexpr double shortfall = 0.1;
  const double axis = m_sheet.axis(style);
  double reach = 0;
  for (const Entry &entry : m_entries)
    if (entry.kind == Entry::Kind::Atom)
      reach = std::max({reach, entry.box.ascent - axis, entry.box.depth + axis});
  return 2 * reach - shortfall * m_sheet.em(style);
}

void RowSetter::setMiddleFences(SetStyle style) {
  if (m_plan.fenceHeight == nullptr)
    return;
  *m_plan.fenceHeight = fenceHeight(style);
  for (Entry &entry : m_entries) {
    if (entry.kind != Entry::Kind::Atom)
      continue;
    const auto *middle = std::get_if<MiddleFence>(&m_atoms[entry.atom].node->content);
    if (!middle)
      continue;
    m_sheet.setInk(entry.ink);
    entry.box = setFence(m_sheet, middle->character, *m_plan.fenceHeight, style);
  }
}

void RowSetter::place() {
  m_before = m_plan.before;
  if (!m_atoms.empty())
    m_all.ascent = m_all.depth = nothing;
  for (const Entry &entry : m_entries) {
    switch (entry.kind) {
    case Entry::Kind::Atom:
      placeAtom(entry);
      break;
    case Entry::Kind::Space:
      m_x += entry.width;
      m_followsWideSpace = m_followsWideSpace || entry.width >= spaceBetweenStatements;
      break;
    case Entry::Kind::TagBegin:
      m_openTags.push_back({.left = m_x, .right = m_x, .piece = m_sheet.layout().pieces.size()});
      break;
    case Entry::Kind::TagEnd:
      closeTag(entry);
      break;
    }
  }
  m_all.width = m_x;
  if (const Entry *only = onlyAtom()) {
    m_all.width = only->box.width;
    m_all.italics = only->box.italics;
    m_all.accentMiddle = only->box.accentMiddle;
    m_all.character = only->box.character;
  }
}

/// The row's only atom, when nothing else takes room in it.
const Entry *RowSetter::onlyAtom() const {
  if (m_atoms.size() != 1 || m_plan.before)
    return nullptr;
  const Entry *only = nullptr;
  for (const Entry &entry : m_entries) {
    if (entry.kind == Entry::Kind::Space)
      return nullptr;
    if (entry.kind == Entry::Kind::Atom)
      only = &entry;
  }
  return only;
}

void RowSetter::placeAtom(const Entry &entry) {
  if (m_before)
    m_x += spaceBetween(*m_before, m_atoms[entry.atom].atomClass, entry.style) * m_sheet.em(entry.style);
  if (m_plan.isOutermost)
    addPiece(entry);
  m_sheet.move(entry.box, m_x, 0);
  m_all.ascent = std::max(m_all.ascent, entry.box.ascent);
  m_all.depth = std::max(m_all.depth, entry.box.depth);
  for (OpenTag &tag : m_openTags) {
    if (tag.ascent == nothing)
      tag.left = m_x;
    tag.right = m_x + entry.box.fullWidth();
    tag.ascent = std::max(tag.ascent, entry.box.ascent);
    tag.depth = std::max(tag.depth, entry.box.depth);
  }
  m_x += entry.box.fullWidth();
  m_before = m_atoms[entry.atom].atomClass;
}

void RowSetter::addPiece(const Entry &entry) {
  Piece piece;
  piece.before = m_followsWideSpace && m_parentheses == 0
                     ? Break::Statement
                     : breakBefore(m_atoms[entry.atom], m_parentheses, m_before);
  m_followsWideSpace = false;
  piece.x = m_x;
  piece.right = m_x + entry.box.fullWidth();
  piece.ascent = entry.box.ascent;
  piece.depth = entry.box.depth;
  piece.glyphs = entry.box.begin.glyphs;
  piece.rules = entry.box.begin.rules;
  piece.tagBoxes = entry.box.begin.tagBoxes;
  m_sheet.layout().pieces.push_back(piece);
  m_parentheses = std::max(0, m_parentheses + m_atoms[entry.atom].nesting);
}

void RowSetter::closeTag(const Entry &entry) {
  OpenTag tag = m_openTags.back();
  m_openTags.pop_back();
  if (tag.ascent == nothing)
    tag.ascent = tag.depth = 0;
  m_sheet.setTagBox(entry.tagBox, {tag.left, -tag.ascent, tag.right - tag.left, tag.ascent + tag.depth});
  if (m_plan.isOutermost)
    m_sheet.layout().taggedPieces.push_back({entry.tagBox, tag.piece, m_sheet.layout().pieces.size()});
}

/// One level of nesting for as long as it lives.
class Level {
public:
  explicit Level(Sheet &sheet) : m_sheet(sheet), m_isAllowed(sheet.descend()) {}
  ~Level() {
    if (m_isAllowed)
      m_sheet.ascend();
  }
  Level(const Level &) = delete;
  Level &operator=(const Level &) = delete;
  Level(Level &&) = delete;
  Level &operator=(Level &&) = delete;

  [[nodiscard]] bool isAllowed() const { return m_isAllowed; }

private:
  Sheet &m_sheet;
  bool m_isAllowed;
};

} // namespace

Box setRow(Sheet &sheet, const Row &row, SetStyle style, const RowPlan &plan) {
  const Level level(sheet);
  return level.isAllowed() ? RowSetter(sheet, plan).set(row, style) : sheet.begin();
}

Box setWhole(Sheet &sheet, const Row &row, SetStyle style) {
  Box box = setRow(sheet, row, style);
  box.width = box.fullWidth();
  box.italics = 0;
  return box;
}

Box setNode(Sheet &sheet, const Node &node, SetStyle style) {
  return std::visit([&](const auto &content) { return set(sheet, content, style); }, node.content);
}

Box set(Sheet &sheet, const Group &group, SetStyle style) {
  return setRow(sheet, group.row, group.isInline && style.isDisplay() ? style.sized(Style::Text) : style);
}

// A row opens these up itself.
Box set(Sheet &sheet, const Tagged & /*tagged*/, SetStyle /*style*/) { return sheet.begin(); }
Box set(Sheet &sheet, const Colored & /*colored*/, SetStyle /*style*/) { return sheet.begin(); }
Box set(Sheet &sheet, const StyleSwitch & /*styleSwitch*/, SetStyle /*style*/) { return sheet.begin(); }
Box set(Sheet &sheet, const Space & /*space*/, SetStyle /*style*/) { return sheet.begin(); }

} // namespace halfspace::math
