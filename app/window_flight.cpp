// The torpedo's flight on the page, and the triangles that it may hit.
#include "app/main_window.h"
#include "lessons/lesson/live_values.h"
#include "lessons/object/kinds/mesh.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/ray.h"
#include "widgets/lesson/lesson_page.h"

#include <QMenu>

#include <algorithm>

namespace halfspace {
namespace {

/// What an entry that looks at a ray and meshes aims at; nothing where the ray leads nowhere.
std::optional<Aim> aimOf(const Evaluation &evaluation, const std::string &entry) {
  const EvaluatedEntry *found = evaluation.find(entry);
  if (!found)
    return {};
  Aim aim;
  for (const auto &given : found->looksAt) {
    if (const auto ray = objectAs<RayObject>(given->object))
      aim.ray = {ray->origin, ray->direction};
    if (const auto mesh = objectAs<MeshObject>(given->object))
      aim.meshes.push_back(*mesh);
  }
  return isZero(aim.ray.direction) ? std::nullopt : std::optional(aim);
}

/// The marks of the fragment with this number; none for 0.
std::set<std::string> marksOf(const Crossings &crossings, std::size_t number) {
  for (const Crossing &crossing : crossings.all)
    if (crossing.number == number)
      return {crossing.marks.begin(), crossing.marks.end()};
  return {};
}

/// The number of the fragment that alone has a mark; 0 where none or several have it.
std::size_t fragmentWith(const Crossings &crossings, const std::string &mark) {
  std::size_t number = 0;
  for (const Crossing &crossing : crossings.all)
    if (std::find(crossing.marks.begin(), crossing.marks.end(), mark) != crossing.marks.end()) {
      if (number != 0)
        return 0;
      number = crossing.number;
    }
  return number;
}

} // namespace

void MainWindow::connectFlight() {
  connect(&m_page->flight(), &FlightBlocks::barMade, this, [this](FlightBar *bar) {
    m_player.serve(*bar);
    for (const FlightControl control :
         {FlightControl::Fire, FlightControl::Play, FlightControl::StepBack, FlightControl::StepForward})
      bar->setKeys(control, keysOf(control));
  });
  connect(&m_player, &FlightPlayer::stateChanged, this, &MainWindow::showFlight);
  connect(&m_page->flight(), &FlightBlocks::fragmentChosen, this,
          [this](const QString &entry, std::size_t number) { chooseFragment(entry.toStdString(), number); });
  connect(&m_page->flight(), &FlightBlocks::fragmentHovered, this,
          [this](const QString &entry, std::size_t number) {
            m_hoveredFragment = marksOf(crossingsOf(m_model.evaluation(), entry.toStdString()), number);
            m_page->flight().setHovered(number);
            showHighlights();
          });
}

QKeySequence MainWindow::keysOf(FlightControl control) {
  switch (control) {
  case FlightControl::Fire:
    return QKeySequence("T");
  case FlightControl::Play:
    return QKeySequence("P");
  case FlightControl::StepBack:
    return QKeySequence(",");
  case FlightControl::StepForward:
    return QKeySequence(".");
  case FlightControl::Automatic:
  case FlightControl::Speed:
    break;
  }
  return {};
}

void MainWindow::showFlight() {
  if (hidesNumbers())
    m_player.play(false); // nobody could end it
  FlightState state = m_player.state();
  state.hidden = hidesNumbers();
  m_flightMenu->menuAction()->setVisible(state.canFire && !state.hidden);
  m_page->flight().showState(state);
  m_page->flight().showCrossings(
      [this](const std::string &entry) { return crossingsOf(m_model.evaluation(), entry); },
      state.hidden ? LiveValues::Hidden : LiveValues::Shown);
  m_page->flight().showAims([this](const std::string &entry) { return aimOf(m_model.evaluation(), entry); });
}

void MainWindow::showHoveredFragment() {
  std::size_t number = 0;
  for (const EvaluatedEntry &entry : m_model.evaluation().entries)
    number = std::max(number, fragmentWith(*entry.outcome->crossings, m_hoveredMark.toStdString()));
  m_page->flight().setHovered(number);
}

void MainWindow::chooseFragment(const std::string &entry, std::size_t number) {
  const std::string &choice = crossingsOf(m_model.evaluation(), entry).choice;
  const Object *object = findObject(m_model.session().scene, choice);
  auto chosen = object ? objectAs<NumberObject>(*object) : std::nullopt;
  if (!chosen)
    return;
  chosen->value = Rational(static_cast<std::int64_t>(number));
  if (const QString refused = m_model.edit(ChangeObject{choice, *chosen}, tr("Look at a triangle"));
      !refused.isEmpty())
    m_messages.say(refused);
}

} // namespace halfspace
