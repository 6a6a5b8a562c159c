#include "widgets/numbers/inspector.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/written.h"
#include "widgets/formula/term_formula.h"
#include "widgets/mark_ink.h"
#include "widgets/numbers/named_value_row.h"
#include "widgets/numbers/number_field.h"

#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {
namespace {

/// It is so wide, in letters, unless the user makes it wider.
constexpr int usualLetters = 42;
// More rows than this nobody looks through, and each costs time and memory.
constexpr std::size_t mostGivenRows = 60;
constexpr std::size_t mostResultRows = 60; ///< and those of the entry that is begun

/// A value with the name of the entry that it is of.
struct ShownValue {
  std::string entry;
  const NamedValue *value;

  /// What its row is made for.
  [[nodiscard]] std::string id() const { return entry + "." + value->name + " " + readName(*value); }
};

/// Adds the values that a learner sees, groups opened.
void addShown(const std::string &entry, const std::vector<NamedValue> &values,
              std::vector<ShownValue> &shown) {
  for (const NamedValue &value : values)
    if (const auto *group = std::get_if<std::vector<NamedValue>>(&value.value))
      addShown(entry, *group, shown);
    else if (!std::holds_alternative<std::monostate>(value.label))
      shown.push_back({entry, &value});
}

std::vector<ShownValue> shownValues(const Evaluation &evaluation) {
  std::vector<ShownValue> shown;
  for (const EvaluatedEntry &entry : evaluation.entries)
    if (shown.size() < mostResultRows)
      addShown(entry.name, *entry.outcome->values, shown);
  return shown;
}

void showName(MathLabel &label, const NamedValue &value) {
  const auto *term = std::get_if<Term>(&value.label);
  const std::string read = readName(value);
  label.setFormula(term ? formulaOf(*term) : math::Row{math::words(read)}, QString::fromStdString(read));
}

/// A single number's decimal, where it is written otherwise.
std::optional<WrittenNumber> otherDecimal(const Value &value) {
  const auto *number = std::get_if<Surd>(&value);
  if (!number)
    return {};
  const WrittenNumber shown = written(*number);
  const WrittenNumber decimal = decimalOf(*number);
  return shown.exact && !readAlike(shown.term, decimal.term) ? std::optional(decimal) : std::nullopt;
}

/// = 10, ≈ 3.16228, = 1/3 ≈ 0.333333; a word as it is. In one formula, so that the exact form and its decimal
/// are always of the same number.
void showValue(MathLabel &label, const Value &value) {
  const auto term = termOf(value);
  if (!term) {
    const auto *word = std::get_if<Word>(&value);
    const std::string text = word ? word->read : "";
    return label.setFormula({math::words(text)}, QString::fromStdString(text));
  }
  math::Row formula = relatedFormula(*term);
  std::string text = relatedText(*term);
  if (const auto decimal = otherDecimal(value)) {
    const char32_t relation = decimal->exact ? U'=' : U'≈';
    formula =
        math::row(std::move(formula), math::symbol(relation, math::AtomClass::Rel), formulaOf(decimal->term));
    text += relatedText(*decimal);
  }
  label.setFormula(formula, QString::fromStdString(text).trimmed());
}

QLabel *heading(const QString &text) {
  auto *label = new QLabel(text);
  label->setObjectName("heading");
  label->setWordWrap(true);
  return label;
}

} // namespace

Inspector::Inspector(SessionModel &model, const Typesetter &typesetter, QWidget *parent)
    : QScrollArea(parent), m_model(model), m_typesetter(typesetter), m_given(model, typesetter),
      m_theme(themes().front()) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  connect(&m_given, &CoordinateRows::refused, this, [this](const QString &sentence) {
    m_complaint->setText(sentence);
    m_complaint->setVisible(!sentence.isEmpty());
  });
}

Inspector::~Inspector() = default;

QSize Inspector::sizeHint() const {
  return {usualLetters * fontMetrics().averageCharWidth(), QScrollArea::sizeHint().height()};
}

void Inspector::buildGivenRows(const std::vector<CoordinateId> &ids) {
  m_results.clear();
  m_resultLabels.clear();
  auto *content = new QWidget;
  m_layout = new QVBoxLayout(content);
  m_layout->setContentsMargins(14, 4, 14, 10);
  m_layout->setSpacing(4);
  auto *given = new QGridLayout;
  given->setHorizontalSpacing(6);
  given->setVerticalSpacing(4);
  given->setColumnMinimumWidth(0, 34);
  for (int column = 1; column <= 3; ++column)
    given->setColumnStretch(column, 1);
  for (const auto &row : m_given.make(ids))
    addGivenRow(*given, *row);
  m_complaint = new QLabel;
  m_complaint->setObjectName("complaint");
  m_complaint->setWordWrap(true);
  m_complaint->setTextFormat(Qt::PlainText);
  m_complaint->hide();
  m_resultsBox = new QWidget;

  m_layout->addWidget(heading(tr("Given — type, step with ↑ ↓, or drag sideways")));
  m_layout->addLayout(given);
  if (const std::size_t all = coordinatesOf(m_model.session().scene).size(); all > ids.size())
    m_layout->addWidget(heading(tr("… and %n more, to be dragged or stepped in the scene.", nullptr,
                                   static_cast<int>(all - ids.size()))));
  m_layout->addWidget(m_complaint);
  m_layout->addSpacing(6);
  m_layout->addWidget(heading(tr("Results")));
  m_layout->addWidget(m_resultsBox);
  m_layout->addStretch(1);
  setWidget(content);
}

void Inspector::buildResultRows() {
  m_results.clear();
  m_resultLabels.clear();
  auto *box = new QWidget;
  auto *column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(1);
  const auto values = shownValues(m_model.evaluation());
  const bool isOfSeveral = !values.empty() && values.front().entry != values.back().entry;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (isOfSeveral && (i == 0 || values[i].entry != values[i - 1].entry))
      column->addWidget(heading(QString::fromStdString(values[i].entry)));
    addResultRow(*column, *values[i].value);
    m_results.back().id = values[i].id();
  }
  delete m_layout->replaceWidget(m_resultsBox, box);
  m_resultsBox->deleteLater();
  m_resultsBox = box;
}

void Inspector::addGivenRow(QGridLayout &grid, const CoordinateRow &row) {
  const int place = grid.rowCount();
  grid.addWidget(row.letter(), place, 0);
  int column = 1;
  for (NumberField *field : row.fields())
    grid.addWidget(field, place, column++);
  if (row.slider())
    grid.addWidget(row.slider(), place, 2, 1, 2);
}

void Inspector::addResultRow(QVBoxLayout &column, const NamedValue &value) {
  auto *row = new NamedValueRow(m_typesetter);
  showName(row->name(), value);
  column.addWidget(row);
  m_resultLabels.push_back(&row->name());
  m_results.push_back({{}, &row->value()});
}

void Inspector::showSession() { m_rows.renew(); }

void Inspector::writeRows() {
  auto ids = coordinatesOf(m_model.session().scene);
  ids.resize(std::min(ids.size(), mostGivenRows));
  if (!widget() || !m_given.areMadeFor(ids)) { // they stay while results come and go
    buildGivenRows(ids);
    applyInk();
  }
  m_given.showNumbers();
  if (!m_resultsHidden)
    writeResults();
  m_resultsBox->setVisible(!m_resultsHidden);
}

void Inspector::writeResults() {
  const auto values = shownValues(m_model.evaluation());
  const bool sameResults =
      std::equal(values.begin(), values.end(), m_results.begin(), m_results.end(),
                 [](const ShownValue &value, const ResultRow &row) { return value.id() == row.id; });
  if (!sameResults) {
    buildResultRows();
    applyInk();
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    showValue(*m_results[i].value, values[i].value->value);
}

void Inspector::setResultsHidden(bool hidden) { m_resultsHidden = hidden; }

void Inspector::setTheme(const Theme &theme) {
  m_theme = theme;
  applyInk();
}

void Inspector::applyInk() {
  const auto inkOf = markInk(m_model, m_theme);
  m_given.setTheme(m_theme);
  for (MathLabel *label : m_resultLabels)
    label->setInkOf(inkOf);
}

} // namespace halfspace
