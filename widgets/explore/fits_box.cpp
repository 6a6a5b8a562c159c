#include "widgets/explore/fits_box.h"

#include "lessons/construction/construction.h"
#include "lessons/language.h"
#include "lessons/object/kind.h"
#include "lessons/scene/offered_objects.h"
#include "lessons/typed/write_line.h"
#include "widgets/explore/entry_edits.h"
#include "widgets/explore/fit_button.h"
#include "widgets/flow_layout.h"
#include "widgets/scene_selection.h"

#include <QCursor>
#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <QVariant>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

constexpr int gap = 4;
/// A button knows by this its place among the fits.
constexpr const char *placeProperty = "fit";

QString inWords(std::string_view name) {
  return QString::fromUtf8(name.data(), static_cast<int>(name.size())).replace('-', ' ');
}

/// What an entry would be, in words: “triangle”, “distance of the points”; of several of a kind their lines,
/// “plane(A, B, C)”.
QString titleOf(const Fit &fit, const std::vector<Fit> &all) {
  if (const Kind *kind = kindOf(fit.entry)) {
    const auto ofItsKind =
        std::count_if(all.begin(), all.end(), [kind](const Fit &each) { return kindOf(each.entry) == kind; });
    const QString line = QString::fromStdString(lineFor(fit.entry, language().decimalMark));
    return ofItsKind == 1 ? inWords(kind->word) : line.section(" = ", 1);
  }
  return QString::fromStdString(findConstruction(std::get<ConstructionUse>(fit.entry.content).id)->title());
}

QString nounFor(const WantedObject &wanted) { return QString::fromStdString(nounOf(wanted.kind)); }

} // namespace

FitsBox::FitsBox(SessionModel &model, SceneSelection &selection, EntryEdits &edits, QWidget *parent)
    : QWidget(parent), m_model(model), m_selection(selection), m_edits(edits), m_heading(new QLabel) {
  setObjectName("fitsBox");
  m_heading->setObjectName("heading");
  m_heading->setTextFormat(Qt::PlainText);
  m_heading->setWordWrap(true);
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(gap);
  column->addWidget(m_heading);
  connect(&selection, &SceneSelection::changed, this, &FitsBox::takeSelection);
  connect(&model, &SessionModel::outcomeChanged, this, &FitsBox::showFits);
  showFits();
}

void FitsBox::takeSelection() {
  const auto wanting = std::exchange(m_wanting, {});
  const auto entry = wanting ? completed(*wanting) : std::nullopt;
  showFits();
  if (entry) // behind all others that are told of the selection
    QMetaObject::invokeMethod(
        this, [this, entry] { add(*entry); }, Qt::QueuedConnection);
}

std::optional<Entry> FitsBox::completed(const Fit &wanting) const {
  const auto &ids = m_selection.ids();
  std::vector<std::string> all = m_asked.ids;
  if (ids.empty() || std::find(all.begin(), all.end(), ids.back()) != all.end())
    return {};
  all.push_back(ids.back());
  const auto &wanted = std::get<ConstructionUse>(wanting.entry.content).id;
  for (const Fit &fit : fitsFor(m_model.session().scene, all))
    if (const auto *use = std::get_if<ConstructionUse>(&fit.entry.content);
        use && !fit.wanted && use->id == wanted)
      return fit.entry;
  return {};
}

void FitsBox::showFits() {
  const Scene &scene = m_model.session().scene;
  Asked asked{m_selection.ids(), m_model.evaluation().plan, missingOf(m_selection.ids())};
  if (asked == m_asked && m_buttons)
    return;          // a drag changes numbers, not what fits
  m_wanting.reset(); // it was about another scene, or another selection
  m_asked = std::move(asked);
  const bool areAll = isExplore(m_model) && !m_asked.ids.empty() && m_asked.missing.isEmpty();
  m_fits = areAll ? fitsFor(scene, m_asked.ids) : std::vector<Fit>();
  m_pointer = QCursor::pos();
  m_previewed = nullptr;
  delete m_buttons;
  m_buttons = new QWidget;
  auto *flow = new FlowLayout(m_buttons);
  flow->setSpacing(gap);
  flow->setContentsMargins(0, 0, 0, 0);
  layout()->addWidget(m_buttons);
  for (const Fit &fit : m_fits)
    addButton(fit);
  QStringList names;
  for (const std::string &id : m_asked.ids)
    names << QString::fromStdString(id);
  m_heading->setText(m_asked.ids.empty()
                         ? tr("Select objects here or in the picture (Ctrl for several): what can be made of "
                              "them is offered here.")
                     : !m_asked.missing.isEmpty() ? m_asked.missing
                     : m_fits.empty() ? tr("There is nothing to be made of %1.").arg(names.join(", "))
                                      : tr("Of %1 can be made:").arg(names.join(", ")));
  preview({});
}

QString FitsBox::missingOf(const std::vector<std::string> &ids) const {
  for (const std::string &id : ids)
    if (const OfferedObject *object = findOffered(m_model.evaluation(), id);
        object && !object->whyNot.empty())
      return QString::fromStdString(object->whyNot);
  return {};
}

void FitsBox::preview(const Figure &ghost) {
  const bool isNothing = ghost.marks.size() == 0;
  if (isNothing && !m_isPreviewing)
    return; // what somebody else shows stays
  m_isPreviewing = !isNothing;
  emit previewed(ghost);
}

void FitsBox::addButton(const Fit &fit) {
  const QString title = titleOf(fit, m_fits);
  auto *button = new FitButton(fit.wanted ? tr("%1 … and %2").arg(title, nounFor(*fit.wanted)) : title);
  button->setObjectName("fit");
  button->setProperty(placeProperty, static_cast<int>(m_buttons->layout()->count()));
  button->setProperty("lacking", fit.wanted.has_value());
  button->setToolTip(fit.wanted ? button->text()
                                : QString::fromStdString(lineFor(fit.entry, language().decimalMark)));
  button->installEventFilter(this);
  connect(
      button, &QPushButton::clicked, this, [this, fit] { take(fit); }, Qt::QueuedConnection);
  m_buttons->layout()->addWidget(button);
}

void FitsBox::take(const Fit &fit) {
  if (!fit.wanted)
    return add(fit.entry);
  m_wanting = fit;
  m_heading->setText(tr("Now click %1, in the picture or in the list.").arg(nounFor(*fit.wanted)));
}

void FitsBox::add(const Entry &entry) {
  if (m_edits.add(entry))
    m_selection.set({entry.name});
}

Figure FitsBox::ghostOf(const Entry &entry) const {
  Scene scene = m_model.session().scene;
  scene.entries.push_back(entry);
  const Evaluation evaluation = evaluate(scene, m_model.evaluation());
  const EvaluatedEntry *added = evaluation.find(entry.name);
  Figure ghost = added ? *added->outcome->figure : Figure();
  for (std::size_t place = 0; place < ghost.marks.size(); ++place)
    ghost.marks.change(place, [](Mark &mark) { baseOf(mark).role = Role::Ghost; });
  return toStage(ghost, m_model.stage());
}

bool FitsBox::eventFilter(QObject *watched, QEvent *event) {
  // A button that comes to a pointer at rest was not pointed at.
  const bool isPointedAt = (event->type() == QEvent::Enter || event->type() == QEvent::HoverMove) &&
                           QCursor::pos() != m_pointer && watched != m_previewed;
  if (isPointedAt || event->type() == QEvent::FocusIn) {
    const Fit &fit = m_fits.at(static_cast<std::size_t>(watched->property(placeProperty).toInt()));
    preview(fit.wanted ? Figure() : ghostOf(fit.entry));
    m_previewed = watched;
  } else if (event->type() == QEvent::Leave || event->type() == QEvent::FocusOut) {
    preview({});
    m_previewed = nullptr;
  }
  return QWidget::eventFilter(watched, event);
}

void FitsBox::hideEvent(QHideEvent *event) {
  QWidget::hideEvent(event);
  preview({});
}

} // namespace halfspace
