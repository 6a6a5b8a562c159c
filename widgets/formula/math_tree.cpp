#include "widgets/formula/math_tree.h"

#include <iterator>

namespace halfspace::math {
namespace {

constexpr char32_t minus = 0x2212;
constexpr char32_t braceAbove = 0x23DE;
constexpr char32_t braceBelow = 0x23DF;
constexpr char32_t vectorArrow = 0x20D7;

} // namespace

void detail::append(Row &row, Row more) {
  row.insert(row.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

const Node *onlyAtom(const Row &row) {
  if (row.size() != 1)
    return nullptr;
  const Node &node = row.front();
  if (const auto *tagged = std::get_if<Tagged>(&node.content))
    return onlyAtom(tagged->row);
  if (const auto *colored = std::get_if<Colored>(&node.content))
    return onlyAtom(colored->row);
  return &node;
}

AtomClass classOf(const Row &row) {
  const Node *atom = onlyAtom(row);
  return atom ? atom->atomClass : AtomClass::Ord;
}

ScriptPlace scriptPlaceOf(const Row &row) {
  const Node *atom = onlyAtom(row);
  return atom ? atom->scriptPlace : ScriptPlace::Beside;
}

Node symbol(char32_t character, AtomClass atomClass) { return {Symbol{character}, atomClass}; }

Node letter(char32_t character, Alphabet alphabet) { return symbol(inAlphabet(character, alphabet)); }

Row number(std::string_view digits) {
  Row row;
  for (const char digit : digits)
    row.push_back(digit == '-' ? symbol(minus, AtomClass::Bin) : symbol(static_cast<unsigned char>(digit)));
  return row;
}

Node largeOperator(char32_t character, ScriptPlace scriptPlace) {
  return {Symbol{character, true}, AtomClass::Op, scriptPlace};
}

Node words(std::string text, Alphabet alphabet) { return {Words{std::move(text), alphabet}}; }

Node function(std::string name, ScriptPlace scriptPlace) {
  return {Words{std::move(name)}, AtomClass::Op, scriptPlace};
}

Node group(Row content) { return {Group{std::move(content)}}; }

Node tagged(TagId tag, Row content) { return {Tagged{std::move(tag), std::move(content)}}; }

Node colored(Color color, Row content) { return {Colored{color, std::move(content)}}; }

Node space(double em) { return {Space{em}}; }

Node styleSwitch(Style style) { return {StyleSwitch{style}}; }

Node scripts(Row base, Row above, Row below) {
  const AtomClass atomClass = classOf(base);
  return {Scripts{std::move(base), std::move(above), std::move(below)}, atomClass};
}

Node scripts(Node base, Row above, Row below) {
  return scripts(row(std::move(base)), std::move(above), std::move(below));
}

Node fraction(Row numerator, Row denominator, std::optional<Style> style) {
  return {Fraction{std::move(numerator), std::move(denominator), true, style}};
}

Node root(Row radicand, Row degree) { return {Root{std::move(radicand), std::move(degree)}}; }

Node fenced(char32_t open, Row content, char32_t close) {
  return {Fenced{open, close, std::move(content)}, AtomClass::Inner};
}

Node accent(char32_t character, Row base) { return {Accent{character, false, std::move(base)}}; }

Node wideAccent(char32_t character, Row base) { return {Accent{character, true, std::move(base)}}; }

Node vector(Row base) { return accent(vectorArrow, std::move(base)); }

Node bar(Side side, Row base) { return {Bar{side, std::move(base)}}; }

Node brace(Side side, Row base) {
  return {Brace{side == Side::Above ? braceAbove : braceBelow, side, std::move(base)}, AtomClass::Op,
          ScriptPlace::Limits};
}

Node stack(Row base, Row above, Row below) {
  const AtomClass atomClass = classOf(base);
  return {Stack{std::move(base), std::move(above), std::move(below)}, atomClass};
}

Node boxed(Row content) { return {Boxed{std::move(content)}}; }

Node table(Table content) { return {std::move(content)}; }

Node matrix(char32_t open, std::vector<std::vector<Row>> rows, char32_t close) {
  Table content;
  content.columns = {Align::Center};
  for (std::vector<Row> &cells : rows)
    content.rows.push_back({std::move(cells)});
  if (open == 0 && close == 0)
    return table(std::move(content));
  return fenced(open, row(table(std::move(content))), close);
}

} // namespace halfspace::math
