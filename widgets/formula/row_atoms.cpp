#include "widgets/formula/row_atoms.h"

#include "widgets/formula/latex_symbols.h"

#include <string_view>

namespace halfspace::math {
namespace {

/// An atom without its scripts: the parenthesis of `)^2`.
const Node &withoutScripts(const Node &node) {
  const auto *scripts = std::get_if<Scripts>(&node.content);
  const Node *base = scripts ? onlyAtom(scripts->base) : nullptr;
  return base ? *base : node;
}

/// The character of a symbol or fence; 0 for all else.
char32_t characterOf(const Node &node) {
  const Content &content = withoutScripts(node).content;
  if (const auto *symbol = std::get_if<Symbol>(&content))
    return symbol->character;
  if (const auto *fence = std::get_if<TallFence>(&content))
    return fence->character;
  return 0;
}

/// Behind these a term is due: a sign there belongs to it.
bool leavesTermDue(AtomClass left) {
  return left == AtomClass::Bin || left == AtomClass::Op || left == AtomClass::Rel ||
         left == AtomClass::Open || left == AtomClass::Punct;
}

/// Before these no term can follow a sign.
bool endsTerm(AtomClass right) {
  return right == AtomClass::Rel || right == AtomClass::Close || right == AtomClass::Punct;
}

/// Follows the parentheses and bars of a row.
class Nesting {
public:
  /// 1 when an atom opens a parenthesis, −1 when it closes one.
  int of(const RowAtom &atom, AtomClass before) {
    const char32_t character = characterOf(*atom.node);
    if (atom.atomClass == AtomClass::Open)
      return 1;
    if (atom.atomClass == AtomClass::Close)
      return isFence(character) ? -1 : 0; // n! closes nothing
    if (atom.atomClass != AtomClass::Ord || (character != U'|' && character != U'‖'))
      return 0;
    const int step = leavesTermDue(before) || (m_bars == 0 && before == AtomClass::Close) ? 1
                     : m_bars > 0                                                         ? -1
                                                                                          : 0;
    m_bars += step;
    return step;
  }

private:
  int m_bars = 0;
};

} // namespace

void settle(std::vector<RowAtom> &atoms, std::optional<AtomClass> beforeRow) {
  AtomClass before = beforeRow.value_or(AtomClass::Open);
  Nesting nesting;
  RowAtom *last = nullptr;
  for (RowAtom &atom : atoms) {
    if (atom.atomClass == AtomClass::Bin && leavesTermDue(before))
      atom.atomClass = AtomClass::Ord;
    if (endsTerm(atom.atomClass) && before == AtomClass::Bin && last)
      last->atomClass = AtomClass::Ord;
    atom.nesting = nesting.of(atom, before);
    const bool isBar = atom.atomClass == AtomClass::Ord && atom.nesting != 0;
    before = !isBar ? atom.atomClass : atom.nesting > 0 ? AtomClass::Open : AtomClass::Close;
    last = &atom;
  }
  if (last && last->atomClass == AtomClass::Bin)
    last->atomClass = AtomClass::Ord;
}

Break breakBefore(const RowAtom &atom, int parentheses, std::optional<AtomClass> before) {
  constexpr std::u32string_view signs = U"+−±∓";
  if (before == AtomClass::Punct && parentheses > 0)
    return Break::Entry;
  if (atom.atomClass != AtomClass::Rel && atom.atomClass != AtomClass::Bin)
    return Break::Never;
  const bool isRelation = atom.atomClass == AtomClass::Rel;
  const bool isProduct = !isRelation && signs.find(characterOf(*atom.node)) == std::u32string_view::npos;
  if (parentheses > 0)
    return isProduct ? Break::InsideProduct : Break::Inside;
  return isRelation ? Break::Relation : isProduct ? Break::Product : Break::Sign;
}

} // namespace halfspace::math
