#include "app/step/flight_presenter.h"

#include "app/step/flight_keys.h"
#include "lessons/lesson/live_values.h"
#include "lessons/object/kinds/mesh.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/ray.h"
#include "widgets/lesson/flight_blocks.h"

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

FlightPresenter::FlightPresenter(SessionModel &model, FlightBlocks &blocks, Messages messages)
    : m_model(model), m_blocks(blocks), m_messages(messages), m_player(model) {
  connect(&blocks, &FlightBlocks::barMade, this, [this](FlightBar *bar) { serve(*bar); });
  connect(&m_player, &FlightPlayer::stateChanged, this, &FlightPresenter::show);
  connect(&blocks, &FlightBlocks::fragmentChosen, this,
          [this](const QString &entry, std::size_t number) { choose(entry.toStdString(), number); });
  connect(&blocks, &FlightBlocks::fragmentHovered, this,
          [this](const QString &entry, std::size_t number) { hover(entry.toStdString(), number); });
}

void FlightPresenter::serve(FlightBar &bar) {
  m_player.serve(bar);
  for (const FlightControl control :
       {FlightControl::Fire, FlightControl::Play, FlightControl::StepBack, FlightControl::StepForward})
    bar.setKeys(control, keysOf(control));
}

void FlightPresenter::setNumbersHidden(bool hidden) {
  m_areNumbersHidden = hidden;
  if (hidden)
    m_player.play(false); // nobody could end it
}

void FlightPresenter::show() {
  FlightState state = m_player.state();
  state.hidden = m_areNumbersHidden;
  emit controllable(state.canFire && !state.hidden);
  m_blocks.showState(state);
  m_blocks.showCrossings(
      [this](const std::string &entry) { return crossingsOf(m_model.evaluation(), entry); },
      state.hidden ? LiveValues::Hidden : LiveValues::Shown);
  m_blocks.showAims([this](const std::string &entry) { return aimOf(m_model.evaluation(), entry); });
}

void FlightPresenter::showHovered(const QString &markId) {
  std::size_t number = 0;
  for (const EvaluatedEntry &entry : m_model.evaluation().entries)
    number = std::max(number, fragmentWith(*entry.outcome->crossings, markId.toStdString()));
  m_blocks.setHovered(number);
}

void FlightPresenter::hover(const std::string &entry, std::size_t number) {
  m_blocks.setHovered(number);
  emit fragmentHovered(marksOf(crossingsOf(m_model.evaluation(), entry), number));
}

void FlightPresenter::choose(const std::string &entry, std::size_t number) {
  const std::string &choice = crossingsOf(m_model.evaluation(), entry).choice;
  const Object *object = findObject(m_model.session().scene, choice);
  auto chosen = object ? objectAs<NumberObject>(*object) : std::nullopt;
  if (!chosen)
    return;
  chosen->value = Rational(static_cast<std::int64_t>(number));
  if (const QString refused = m_model.history().edit(ChangeObject{choice, *chosen}, tr("Look at a triangle"));
      !refused.isEmpty())
    m_messages.say(refused);
}

} // namespace halfspace
