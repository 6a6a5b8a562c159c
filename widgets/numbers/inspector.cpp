#include "widgets/numbers/inspector.h"

#include "lessons/object/number.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/written.h"
#include "widgets/mark_ink.h"
#include "widgets/numbers/named_value_row.h"
#include "widgets/numbers/number_field.h"
#include "widgets/picture/term_formula.h"

#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {
namespace {

/// A slider's steps from one bound to the other, and how many of them the value is above the lower one.
struct SliderRange {
  int steps;
  int position;
};

/// More steps than this cannot be told apart on a slider.
constexpr int mostSliderSteps = 10000;

/// Of a number with bounds and a step; nothing for what has none.
std::optional<SliderRange> rangeOf(const Object &object) {
  const auto number = objectAs<NumberObject>(object);
  if (!number || number->step == 0)
    return {};
  const auto stepsTo = [&](const Rational &end) {
    return static_cast<int>(
        std::min(toDouble(Rational((end - number->from) / number->step)), double(mostSliderSteps)));
  };
  return SliderRange{stepsTo(number->to), stepsTo(number->value)};
}

// More rows than this nobody looks through, and each costs time and memory.
constexpr std::size_t mostGivenRows = 60;
constexpr std::size_t mostResultRows = 60; ///< and those of the entry that is begun

/// A value with the name of the entry that it is of.
struct ShownValue {
  std::string entry;
  const NamedValue *value;

  /// What its row is made for.
  [[nodiscard]] std::string id() const {
    const auto *term = std::get_if<Term>(&value->label);
    return entry + "." + value->name + " " + (term ? plainText(*term) : std::get<std::string>(value->label));
  }
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
  if (const auto *term = std::get_if<Term>(&value.label))
    return label.setFormula(formulaOf(*term), QString::fromStdString(plainText(*term)));
  const auto &words = std::get<std::string>(value.label);
  label.setFormula({math::words(words)}, QString::fromStdString(words));
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
    const auto *word = std::get_if<std::string>(&value);
    const std::string text = word ? *word : "";
    return label.setFormula({math::words(text)}, QString::fromStdString(text));
  }
  math::Row formula = relatedFormula(*term);
  std::string text = relatedText(*term);
  if (const auto decimal = otherDecimal(value)) {
    const char32_t relation = decimal->exact ? U'=' : U'≈';
    formula =
        math::row(std::move(formula), math::symbol(relation, math::AtomClass::Rel), formulaOf(decimal->term));
    text += (decimal->exact ? " = " : " ≈ ") + plainText(decimal->term);
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
    : QScrollArea(parent), m_model(model), m_editor(model), m_typesetter(typesetter),
      m_theme(themes().front()) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
}

Inspector::~Inspector() {
  // A field with a text that is no number complains when it loses the focus, as it does while it is deleted.
  for (const GivenRow &row : m_given)
    for (NumberField *field : row.fields)
      field->disconnect(this);
}

NumberField *Inspector::field(const std::string &coordinateName, int axis) const {
  for (const GivenRow &row : m_given)
    if (row.name == coordinateName)
      return row.fields.at(static_cast<std::size_t>(axis));
  return nullptr;
}

QString Inspector::enterTyped() {
  QString refused;
  for (const GivenRow &row : m_given)
    for (NumberField *field : row.fields)
      if (const QString why = field->enter(); refused.isEmpty())
        refused = why;
  return refused;
}

void Inspector::dropTyped() {
  for (const GivenRow &row : m_given)
    for (NumberField *field : row.fields)
      field->drop();
}

void Inspector::buildGivenRows() {
  m_given.clear();
  m_givenLabels.clear();
  m_results.clear();
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
  const auto ids = coordinatesOf(m_model.session().scene);
  for (std::size_t i = 0; i < std::min(ids.size(), mostGivenRows); ++i)
    addGivenRow(*given, ids[i]);
  m_complaint = new QLabel;
  m_complaint->setObjectName("complaint");
  m_complaint->setWordWrap(true);
  m_complaint->setTextFormat(Qt::PlainText);
  m_complaint->hide();
  m_resultsBox = new QWidget;

  m_layout->addWidget(heading(tr("Given — type, step with ↑ ↓, or drag sideways")));
  m_layout->addLayout(given);
  if (ids.size() > mostGivenRows)
    m_layout->addWidget(heading(tr("… and %n more, to be dragged or stepped in the scene.", nullptr,
                                   static_cast<int>(ids.size() - mostGivenRows))));
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

const Symbol &Inspector::letterOf(const CoordinateId &id) const {
  return m_model.evaluation().find(id.object)->own->letters[id.index];
}

bool Inspector::isShownIn(const GivenRow &row, const CoordinateId &id) const {
  const Object &object = *findObject(m_model.session().scene, id.object);
  const auto numbers = static_cast<std::size_t>(numbersIn(coordinatesOf(object)[id.index].role));
  return row.id == id && row.fields.size() == numbers && row.letter == letterOf(id);
}

void Inspector::addGivenRow(QGridLayout &grid, const CoordinateId &id) {
  static const char *const axes[3] = {"x", "y", "z"};
  const int row = grid.rowCount();
  GivenRow given;
  given.id = id;
  given.name = fullName(m_model.session().scene, id);
  auto *label = new MathLabel(m_typesetter);
  const Symbol &letter = letterOf(id);
  given.letter = letter;
  label->setFormula(formulaOf(letter), QString::fromStdString(plainText(letter)));
  m_givenLabels.push_back(label);
  grid.addWidget(label, row, 0);
  const Object &object = *findObject(m_model.session().scene, id.object);
  const int numbers = numbersIn(coordinatesOf(object)[id.index].role);
  for (int axis = 0; axis < numbers; ++axis) {
    auto *field = new NumberField;
    field->setAccessibleName(QString::fromStdString(given.name) +
                             (numbers > 1 ? QString(" ") + axes[axis] : ""));
    connectField(*field, {id, axis});
    grid.addWidget(field, row, axis + 1);
    given.fields.push_back(field);
  }
  if (const auto range = rangeOf(object); range && id.index == 0)
    given.slider = addSlider(grid, row, id);
  m_given.push_back(given);
}

QSlider *Inspector::addSlider(QGridLayout &grid, int row, const CoordinateId &id) {
  auto *slider = new QSlider(Qt::Horizontal);
  slider->setAccessibleName(QString::fromStdString(fullName(m_model.session().scene, id)));
  grid.addWidget(slider, row, 2, 1, 2);
  connect(slider, &QSlider::sliderPressed, this, [this, id, slider] {
    m_sliderStart = slider->value();
    m_editor.beginScrub({id, 0});
  });
  connect(slider, &QSlider::valueChanged, this, [this, id, slider](int position) {
    if (slider->isSliderDown())
      m_editor.scrub(position - m_sliderStart);
    else if (const auto range = rangeOf(*findObject(m_model.session().scene, id.object)))
      m_editor.step({id, 0}, position - range->position);
  });
  connect(slider, &QSlider::sliderReleased, this, [this] { m_editor.endScrub(true); });
  return slider;
}

void Inspector::showOnSlider(QSlider &slider, const CoordinateId &id) {
  const auto range = rangeOf(*findObject(m_model.session().scene, id.object));
  if (!range || slider.isSliderDown())
    return;
  const QSignalBlocker silent(slider);
  slider.setRange(0, range->steps);
  slider.setValue(range->position);
}

void Inspector::addResultRow(QVBoxLayout &column, const NamedValue &value) {
  auto *row = new NamedValueRow(m_typesetter);
  showName(row->name(), value);
  column.addWidget(row);
  m_resultLabels.push_back(&row->name());
  m_results.push_back({{}, &row->value()});
}

void Inspector::connectField(NumberField &field, const CoordinateNumber &number) {
  connect(&field, &NumberField::valueTyped, this,
          [=, this](const Rational &value) { m_editor.change(number, value); });
  connect(&field, &NumberField::stepped, this, [=, this](int steps) { m_editor.step(number, steps); });
  connect(&field, &NumberField::refused, this, [this](const QString &sentence) {
    m_complaint->setText(sentence);
    m_complaint->setVisible(!sentence.isEmpty());
  });
  connect(&field, &NumberField::scrubStarted, this, [=, this] { m_editor.beginScrub(number); });
  connect(&field, &NumberField::scrubbed, this, [this](int steps) { m_editor.scrub(steps); });
  connect(&field, &NumberField::scrubEnded, this, [this](bool keep) { m_editor.endScrub(keep); });
}

void Inspector::showSession() {
  const Scene &scene = m_model.session().scene;
  auto ids = coordinatesOf(scene);
  ids.resize(std::min(ids.size(), mostGivenRows));
  const auto values = shownValues(m_model.evaluation());
  // The given rows stay while results come and go: a field may be in use.
  const bool sameGiven = widget() && std::equal(ids.begin(), ids.end(), m_given.begin(), m_given.end(),
                                                [this](const CoordinateId &id, const GivenRow &row) {
                                                  return isShownIn(row, id);
                                                });
  if (!sameGiven)
    buildGivenRows();
  const bool sameResults =
      sameGiven &&
      std::equal(values.begin(), values.end(), m_results.begin(), m_results.end(),
                 [](const ShownValue &value, const ResultRow &row) { return value.id() == row.id; });
  if (!sameResults) {
    buildResultRows();
    applyInk();
  }
  for (const GivenRow &row : m_given) {
    const Object *object = findObject(scene, row.id.object);
    const ExactVec3 &value = coordinate(*object, row.id.index);
    for (std::size_t axis = 0; axis < row.fields.size(); ++axis)
      row.fields[axis]->setValue(value[static_cast<int>(axis)], lookOf(value));
    if (row.slider)
      showOnSlider(*row.slider, row.id);
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    showValue(*m_results[i].value, values[i].value->value);
  m_resultsBox->setVisible(!m_resultsHidden);
}

void Inspector::setResultsHidden(bool hidden) { m_resultsHidden = hidden; }

void Inspector::setTheme(const Theme &theme) {
  m_theme = theme;
  applyInk();
}

void Inspector::applyInk() {
  const auto inkOf = markInk(m_model, m_theme);
  for (const auto *labels : {&m_givenLabels, &m_resultLabels})
    for (MathLabel *label : *labels)
      label->setInkOf(inkOf);
}

} // namespace halfspace
