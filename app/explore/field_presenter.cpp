#include "app/explore/field_presenter.h"

#include "app/explore/command_finder.h"
#include "app/explore/go_on_in_explore.h"
#include "lessons/language.h"
#include "lessons/typed/complete_line.h"
#include "lessons/typed/line_with_name.h"
#include "lessons/typed/mend_line.h"
#include "lessons/typed/read_line.h"
#include "lessons/typed/typed_scene.h"
#include "lessons/typed/write_line.h"
#include "widgets/explore/entry_edits.h"
#include "widgets/scene_selection.h"

#include <QAction>
#include <QMenuBar>
#include <QPointer>
#include <QRegularExpression>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

constexpr std::size_t mostCompletions = 8;
constexpr std::size_t mostCommands = 6;
constexpr int longestLikelyName = 2;

/// The characters that some bytes of a line are.
EntryField::Part partOf(const std::string &line, std::size_t at, std::size_t length) {
  const auto characters = [](const std::string &bytes) {
    return static_cast<int>(QString::fromStdString(bytes).size());
  };
  const int begin = characters(line.substr(0, at));
  return {begin, characters(line.substr(0, at + length)) - begin};
}

/// Whether a text can only be a line: no command has such a sign.
bool isLine(const QString &text) {
  static const QRegularExpression signs("[=:(,;+*/^·×]");
  return text.contains(signs);
}

} // namespace

FieldPresenter::FieldPresenter(SessionModel &model, GoOnInExplore &goOn, EntryBar &bar, EntryEdits &edits,
                               SceneSelection &selection, const QMenuBar &menus, QObject *parent)
    : QObject(parent), m_model(model), m_goOn(goOn), m_bar(bar), m_edits(edits), m_selection(selection),
      m_menus(menus) {
  connect(&bar, &EntryBar::edited, this, &FieldPresenter::suggest);
  connect(&bar, &EntryBar::entered, this, &FieldPresenter::enter);
  connect(&bar, &EntryBar::recalled, this, &FieldPresenter::recall);
  connect(&bar, &EntryBar::left, this, &FieldPresenter::leave);
  connect(&bar, &EntryBar::linesPasted, this, &FieldPresenter::enterAll);
  connect(&bar, &EntryBar::taken, this, [this](int offer) {
    if (offer < static_cast<int>(m_offers.size()))
      std::function<void()>(m_offers[static_cast<std::size_t>(offer)].take)(); // it may bring others
  });
  connect(&bar, &EntryBar::completed, this, [this](int offer) {
    if (offer < static_cast<int>(m_offers.size()))
      if (const QString line = m_offers[static_cast<std::size_t>(offer)].line; !line.isEmpty())
        putLine(line);
  });
  connect(&model, &SessionModel::outcomeChanged, this, [this] {
    if (m_edited.empty() || m_model.session().scene.entries.find(m_edited))
      return;
    remember(); // the line is of nothing any more: the up key brings it back
    show();
  });
  connect(&model, &SessionModel::lessonChanged, this, [this] {
    m_isOpen = false;
    show();
  });
  show();
}

void FieldPresenter::show() {
  m_edited.clear();
  m_bar.setText({});
  m_bar.say({});
  offer({}, false);
  emit openChanged(m_isOpen || isExplore(m_model));
}

void FieldPresenter::open() {
  m_isOpen = true;
  emit openChanged(true);
  m_bar.takeFocus();
  suggest();
}

void FieldPresenter::begin(const QString &key) {
  m_edited.clear();
  open();
  m_bar.setText(key);
  suggest();
}

void FieldPresenter::propose(const QString &line) {
  m_edited.clear();
  open();
  m_bar.setText(line);
  m_bar.say(tr("Change it as you like: Enter adds it."));
  offer({}, false);
}

void FieldPresenter::edit(const QString &name) {
  const Entry *entry = m_model.session().scene.entries.find(name.toStdString());
  if (!entry)
    return;
  const std::string line = lineFor(*entry, language().decimalMark);
  if (line.empty())
    return m_bar.say(tr("%1 comes out of a file: it has no line.").arg(name));
  open();
  m_edited = entry->name;
  m_bar.setText(QString::fromStdString(line));
  m_bar.say(tr("Enter changes %1, Escape leaves it as it is.").arg(name));
  offer({}, false);
}

Scene FieldPresenter::above() const {
  const Scene &scene = m_model.session().scene;
  const auto place = scene.entries.placeOf(m_edited);
  if (!place)
    return scene;
  Scene above;
  for (std::size_t i = 0; i < *place; ++i)
    above.entries.push_back(scene.entries[i]);
  return above;
}

LineWithName FieldPresenter::namedLine() const {
  const std::string line = m_bar.text().toStdString();
  return m_edited.empty() ? withName(line, above(), language().decimalMark) : withName(line, m_edited);
}

void FieldPresenter::putLine(const QString &line) {
  m_bar.setText(line);
  suggest();
}

void FieldPresenter::suggest() {
  if (m_edited.empty())
    m_bar.say({});
  std::vector<Offer> offers;
  if (!isLine(m_bar.text()))
    addCommands(offers);
  // Several words without a sign of a line are a command; one can be both.
  if (offers.empty() || !m_bar.text().trimmed().contains(' '))
    addCompletions(offers);
  offer(std::move(offers), !isLine(m_bar.text()) && !m_bar.text().trimmed().isEmpty());
}

void FieldPresenter::addCompletions(std::vector<Offer> &offers) {
  const std::string line = m_bar.text().toStdString();
  const auto cursor = static_cast<std::size_t>(m_bar.text().left(m_bar.cursor()).toUtf8().size());
  std::vector<Offer> completions;
  for (const LineCompletion &completion :
       completionsOf(line, cursor, above(), language().decimalMark, mostCompletions)) {
    const QString whole = QString::fromStdString(completion.line);
    const EntryField::Part selected =
        partOf(completion.line, completion.selectedAt, completion.selectedLength);
    completions.push_back({{whole, QString::fromStdString(completion.description)},
                           [this, whole, selected] {
                             m_bar.setText(whole, selected);
                             offer({}, false);
                           },
                           whole});
  }
  // Names are short: a longer word that menus have means these.
  const bool isCommand = !offers.empty() && m_bar.text().trimmed().size() > longestLikelyName;
  offers.insert(isCommand ? offers.end() : offers.begin(), completions.begin(), completions.end());
}

void FieldPresenter::addCommands(std::vector<Offer> &offers) {
  std::vector<Command> commands = commandsMatching(m_menus, m_bar.text());
  commands.resize(std::min(commands.size(), mostCommands));
  for (const Command &command : commands)
    offers.push_back({{command.title, command.action->shortcut().toString(QKeySequence::NativeText), false},
                      [this, action = QPointer<QAction>(command.action)] {
                        leave();
                        if (action)
                          action->trigger();
                      }});
}

void FieldPresenter::offer(std::vector<Offer> offers, bool isFirstChosen) {
  m_offers = std::move(offers);
  std::vector<Suggestion> shown;
  for (const Offer &each : m_offers)
    shown.push_back(each.shown);
  m_bar.setSuggestions(shown, isFirstChosen);
}

void FieldPresenter::enter() {
  const std::string line = m_bar.text().toStdString();
  if (m_bar.text().trimmed().isEmpty())
    return;
  const LineWithName named = namedLine();
  const auto read = readLine(named.line, above(), language().decimalMark);
  if (const auto *entry = std::get_if<Entry>(&read))
    return accept(*entry);
  const auto &fault = std::get<TypedFault>(read);
  refuse(QString::fromStdString(fault.sentence),
         partOf(line, std::max(fault.at, named.added) - named.added, fault.length));
}

void FieldPresenter::accept(const Entry &entry) {
  if (!isExplore(m_model)) {
    const Scene &scene = m_model.session().scene;
    const auto grown = apply(scene, AddEntry{scene.entries.size(), entry});
    if (!grown)
      return m_bar.complain(QString::fromStdString(grown.problem().sentence), {});
    remember();
    m_goOn.with(*grown);
    return m_bar.say(tr("The lesson is as it was: this is Explore, where its scene can grow."));
  }
  const std::string edited = std::exchange(m_edited, {}); // it may have another name then
  const bool isDone = edited.empty() ? m_edits.add(entry) : m_edits.replace(edited, entry);
  if (!isDone) {
    m_edited = edited;
    return; // why is told already
  }
  remember();
  show();
  m_selection.set({entry.name});
}

void FieldPresenter::enterAll(const QString &lines) {
  const Scene &scene = m_model.session().scene;
  const auto grown = readTypedScene(lines.toStdString(), {}, language().decimalMark, scene);
  if (!grown)
    return m_bar.say(tr("Nothing was added. Line %1: %2")
                         .arg(grown.problem().line)
                         .arg(QString::fromStdString(grown.problem().sentence)));
  if (!isExplore(m_model))
    return m_goOn.with(*grown);
  if (grown->entries.size() == scene.entries.size())
    return m_bar.say(tr("There is no line in what was pasted."));
  std::vector<Entry> added;
  for (std::size_t place = scene.entries.size(); place < grown->entries.size(); ++place)
    added.push_back(grown->entries[place]);
  if (m_edits.addAll(added))
    m_bar.say(tr("%n lines were added.", nullptr, static_cast<int>(added.size())));
}

void FieldPresenter::refuse(const QString &sentence, EntryField::Part part) {
  m_bar.complain(sentence, part);
  offer(mends(), true);
}

std::vector<FieldPresenter::Offer> FieldPresenter::mends() {
  std::vector<Offer> offers;
  const char mark = language().decimalMark;
  const LineWithName named = namedLine();
  for (const std::string &mend : mendsOf(named.line, above(), mark)) {
    // A name that nobody has typed is given once the line can be read.
    const bool isOnlyAdded = mend.starts_with(named.line.substr(0, named.added));
    const QString line = QString::fromStdString(isOnlyAdded ? mend.substr(named.added) : mend);
    offers.push_back({{line, tr("Enter: take this instead")},
                      [this, line] {
                        m_bar.setText(line);
                        enter();
                      },
                      line});
  }
  return offers;
}

void FieldPresenter::recall(int lines) {
  const auto count = static_cast<int>(m_lines.size());
  const int wanted = static_cast<int>(m_recalled) + lines;
  if (count == 0 || wanted < 0 || wanted > count)
    return;
  m_edited.clear();
  m_recalled = static_cast<std::size_t>(wanted);
  m_bar.setText(wanted == count ? QString() : m_lines[m_recalled]);
  offer({}, false);
}

void FieldPresenter::remember() {
  if (!m_bar.text().trimmed().isEmpty())
    m_lines.push_back(m_bar.text());
  m_recalled = m_lines.size();
}

void FieldPresenter::leave() {
  remember(); // the up key brings back what Escape has put away
  m_isOpen = false;
  show();
  emit left();
}

} // namespace halfspace
