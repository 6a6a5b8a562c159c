#include "lessons/typed/complete_line.h"

#include "lessons/construction/construction.h"
#include "lessons/formula/read_formula.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/sphere.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/scene/fresh_names.h"
#include "lessons/text.h"
#include "lessons/typed/line_so_far.h"
#include "lessons/typed/object_supply.h"
#include "lessons/typed/open_places.h"
#include "lessons/typed/read_line.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace halfspace {
namespace {

/// The kinds that somebody wants first who has an empty line.
constexpr std::array usualKinds{PointObject::kind,  PlaneObject::kind,  LineObject::kind,
                                RayObject::kind,    VectorObject::kind, TriangleObject::kind,
                                SphereObject::kind, NumberObject::kind};
/// What stands for a new plane until somebody changes it.
constexpr const char *usualEquation = "x + 2y + 2z = 27";
const ExactVec3 usualTriple{1, 2, 3};
constexpr const char *usualNumber = "1";

bool beginsWith(std::string_view word, std::string_view beginning) {
  return beginning.size() <= word.size() &&
         std::equal(beginning.begin(), beginning.end(), word.begin(),
                    [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

/// A statement that can be made: the ways to call an object or a construction.
struct Statement {
  std::vector<Signature> signatures;
  int rank; ///< the lowest goes first

  [[nodiscard]] const Signature &first() const { return signatures.front(); }
};

int rankOf(const Signature &signature, std::string_view name) {
  const bool hasUsualName = !name.empty() && (signature.kind ? isUsualLetter(*signature.kind, name.front())
                                                             : signature.word.front() == name.front());
  if (hasUsualName)
    return 0;
  if (signature.construction)
    return 2;
  const bool isUsual = std::find(usualKinds.begin(), usualKinds.end(), signature.word) != usualKinds.end();
  return isUsual ? 1 : 3;
}

/// All statements, those first that a name suggests.
std::vector<Statement> statementsFor(std::string_view name) {
  std::vector<Statement> all;
  for (const Kind &kind : kinds())
    if (auto signatures = signaturesOf(kind); !signatures.empty())
      all.push_back({std::move(signatures), 0});
  for (const Construction &construction : constructions())
    all.push_back({{signatureOf(construction)}, 0});
  for (Statement &statement : all)
    statement.rank = rankOf(statement.first(), name);
  std::stable_sort(all.begin(), all.end(),
                   [](const Statement &a, const Statement &b) { return a.rank < b.rank; });
  return all;
}

/// The word by which a statement is called that begins so; empty where none does.
std::string_view wordBeginning(const Signature &signature, std::string_view beginning) {
  if (beginsWith(signature.word, beginning))
    return signature.word;
  return signature.construction && beginsWith(signature.construction->id, beginning)
             ? signature.construction->id
             : std::string_view();
}

class Completer {
public:
  Completer(std::string_view line, std::size_t cursor, const Scene &above, char decimalMark, std::size_t most)
      : m_line(line), m_above(above), m_mark(decimalMark), m_most(most),
        m_so(lineSoFar(line, cursor, decimalMark)), m_supply(above, decimalMark) {}

  std::vector<LineCompletion> complete() {
    if (!m_so.contentAt)
      completeName();
    else if (m_so.isAtContent())
      completeContent();
    else if (const auto signatures = signaturesOf(m_so.called); !signatures.empty())
      for (const SceneNames names(m_above); const Signature &signature : signatures)
        addArguments(signature, names);
    else
      addValues();
    return std::move(m_found);
  }

private:
  [[nodiscard]] bool isFull() const { return m_found.size() >= m_most; }
  [[nodiscard]] bool isAtEnd() const { return trimmed(m_line.substr(m_so.cursor)).empty(); }
  [[nodiscard]] std::string_view word() const {
    return m_line.substr(m_so.wordAt, m_so.cursor - m_so.wordAt);
  }
  /// What stands in front of the word at the cursor, with a space where one belongs.
  [[nodiscard]] std::string beforeWord() const {
    std::string before(m_line.substr(0, m_so.wordAt));
    if (!before.empty() && std::string_view("=:,;").find(before.back()) != std::string_view::npos)
      before += ' ';
    return before;
  }
  [[nodiscard]] std::string joined(const std::vector<std::string> &arguments) const {
    std::string text;
    for (const std::string &argument : arguments)
      text += (text.empty() ? "" : separator()) + argument;
    return text;
  }
  [[nodiscard]] std::string separator() const { return m_mark == ',' ? "; " : ", "; }

  /// A line that ends with `filled` and the rest behind it; it is left out where it has to be whole and
  /// cannot be read.
  void add(const std::string &before, const std::string &filled, const std::string &behind,
           std::string description, bool hasToBeWhole) {
    std::string line = before + filled + behind;
    if (isFull() || line == m_line || !m_lines.insert(line).second)
      return;
    const bool isWhole = std::holds_alternative<Entry>(readLine(line, m_above, m_mark));
    if (hasToBeWhole && !isWhole)
      return;
    m_found.push_back({std::move(line), before.size(), filled.size(), std::move(description), isWhole});
  }

  // --- statements

  void completeName() {
    if (!isAtEnd())
      return;
    addStatements("", m_so.name);
    if (!m_so.name.empty())
      addStatements(m_so.name, "");
  }

  void completeContent() {
    if (!word().empty())
      addValues();
    if (isAtEnd())
      addStatements(m_so.name, word());
  }

  /// Those that call a word with this beginning, or any.
  void addStatements(std::string_view name, std::string_view beginning) {
    if (m_above.entries.find(name))
      return;
    const FreshNames fresh(m_above);
    for (const Statement &statement : statementsFor(name)) {
      const Signature &first = statement.first();
      const std::string_view called = wordBeginning(first, beginning);
      if (isFull() || called.empty())
        continue;
      const std::string own = !name.empty()        ? std::string(name)
                              : first.construction ? fresh.ofUse(*first.construction)
                                                   : fresh.ofKind(*first.kind);
      if (!addOnPaper(first, own, beginning.empty()))
        addCall(statement, called, own);
    }
  }

  [[nodiscard]] std::string beforeContent(const std::string &name, bool isEquation) const {
    return m_so.contentAt ? beforeWord() : name + (isEquation ? ": " : " = ");
  }

  /// A statement that has no word: coordinates, an equation, a number. False where it has one.
  bool addOnPaper(const Signature &signature, const std::string &name, bool isAnyWord) {
    const std::string_view kind = signature.word;
    const bool isTriple = kind == (namesPoint(name) ? PointObject::kind : VectorObject::kind) &&
                          (isAnyWord || kind == PointObject::kind);
    const bool isPlane = kind == PlaneObject::kind && isAnyWord;
    if (!isTriple && !isPlane && kind != NumberObject::kind)
      return false;
    const std::string content = isPlane    ? usualEquation
                                : isTriple ? toText(formulaOf(usualTriple), m_mark)
                                           : usualNumber;
    add(beforeContent(name, isPlane), content, "", wordsFor(signature), true);
    return true;
  }

  /// The way to call it for which the fewest objects are missing.
  void addCall(const Statement &statement, std::string_view called, const std::string &name) {
    std::optional<FilledPlaces> best;
    for (const Signature &signature : statement.signatures)
      if (auto filled = m_supply.filled(signature.places, {});
          filled && (!best || filled->madeUp < best->madeUp))
        best = std::move(filled);
    if (best)
      add(beforeContent(name, false) + std::string(called) + "(", joined(best->arguments), ")",
          wordsFor(statement.first()), true);
  }

  // --- between the brackets of a call

  void addArguments(const Signature &signature, const SceneNames &names) {
    const auto open = openPlaces(signature, m_so.arguments, names);
    if (!open)
      return;
    if (word().empty() && isAtEnd() && !open->needed.empty())
      if (const auto filled = m_supply.filled(open->needed, open->used))
        add(beforeWord(), joined(filled->arguments), ")", wordsFor(signature), true);
    std::vector<ArgumentPlace> places = open->needed;
    if (signature.isInAnyOrder)
      places.insert(places.end(), open->possible.begin(), open->possible.end());
    else if (!places.empty())
      places.resize(1);
    for (std::size_t i = 0; i < places.size(); ++i)
      for (const SeenObject &object : m_supply.fitting(places[i], word(), open->used))
        if (!isFull())
          addArgument(object, *open, i);
  }

  /// An object in the open place of an index, with others in those that are needed besides.
  void addArgument(const SeenObject &object, const OpenPlaces &open, std::size_t place) {
    const std::string before = beforeWord() + object.id;
    if (!isAtEnd())
      return add(before, "", std::string(m_line.substr(m_so.cursor)), nounOf(object.kind), false);
    std::vector<ArgumentPlace> rest = open.needed;
    if (place < rest.size())
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place));
    if (rest.empty())
      return add(before + ")", "", "", nounOf(object.kind), true);
    std::set<std::string> used = open.used;
    used.insert(object.id);
    if (const auto filled = m_supply.filled(rest, std::move(used)))
      add(before + separator(), joined(filled->arguments), ")", nounOf(object.kind), true);
    else
      add(before + separator(), "", "", nounOf(object.kind), false);
  }

  // --- in formulas

  /// The names that a formula can have at the cursor, where one can stand there.
  void addValues() {
    if (word().empty() && endsFormula(trimmed(m_line.substr(0, m_so.cursor))))
      return;
    addValuesFrom(m_so.wordAt);
    if (const auto minus = word().rfind('-'); minus != std::string_view::npos)
      addValuesFrom(m_so.wordAt + minus + 1);
  }

  /// Whether an operator has to follow a text, and no name.
  static bool endsFormula(std::string_view text) {
    const char last = text.empty() ? '\0' : text.back();
    return isLetter(last) || (last >= '0' && last <= '9') || last == ')' || last == '_';
  }

  void addValuesFrom(std::size_t begin) {
    const std::string_view beginning = m_line.substr(begin, m_so.cursor - begin);
    const std::string before = begin == m_so.wordAt ? beforeWord() : std::string(m_line.substr(0, begin));
    for (const SeenObject &object : m_supply.all())
      if (!isFull() && object.id.starts_with(beginning) &&
          (object.kind == PointObject::kind || object.kind == VectorObject::kind ||
           object.kind == NumberObject::kind))
        add(before + object.id, "", std::string(m_line.substr(m_so.cursor)), nounOf(object.kind), false);
  }

  const std::string_view m_line;
  const Scene &m_above;
  char m_mark;
  std::size_t m_most;
  LineSoFar m_so;
  ObjectSupply m_supply;
  std::set<std::string> m_lines; ///< that were tried
  std::vector<LineCompletion> m_found;
};

} // namespace

std::vector<LineCompletion> completionsOf(std::string_view line, std::size_t cursor, const Scene &above,
                                          char decimalMark, std::size_t most) {
  return Completer(line, std::min(cursor, line.size()), above, decimalMark, most).complete();
}

} // namespace halfspace
