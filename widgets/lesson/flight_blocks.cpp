#include "widgets/lesson/flight_blocks.h"

#include <algorithm>

namespace halfspace {
namespace {

/// As a loop asks them: by their numbers, and 0 for no hit so far. Where not all are there none can be asked
/// after the other.
void askOneByOne(Crossings &crossings) {
  if (crossings.all.size() == crossings.fragments)
    crossings.nearestSoFar = crossings.nearestSoFar.value_or(0);
  std::sort(crossings.all.begin(), crossings.all.end(),
            [](const Crossing &a, const Crossing &b) { return a.number < b.number; });
}

} // namespace

void FlightBlocks::dropBlocks() {
  m_bars.clear();
  m_tables.clear();
  m_plots.clear();
}

template <class Widget> void FlightBlocks::followFragments(Widget &widget, const std::string &entry) {
  const QString name = QString::fromStdString(entry);
  connect(&widget, &Widget::chosen, this,
          [this, name](std::size_t number) { emit fragmentChosen(name, number); });
  connect(&widget, &Widget::hovered, this,
          [this, name](std::size_t number) { emit fragmentHovered(name, number); });
}

QWidget *FlightBlocks::addBlock(const StepFlight &flight) {
  auto *bar = new FlightBar(m_typesetter);
  m_bars.emplace_back(flight.hits, bar);
  followFragments(bar->axis(), flight.hits);
  emit barMade(bar);
  return bar;
}

QWidget *FlightBlocks::addBlock(const StepFragments &fragments) {
  auto *table = new FragmentTable(m_typesetter);
  m_tables.emplace_back(fragments, table);
  followFragments(*table, fragments.hits);
  return table;
}

QWidget *FlightBlocks::addBlock(const StepCost &cost) {
  auto *plot = new CostPlot(m_measuring);
  m_plots.emplace_back(cost.hits, plot);
  connect(plot, &CostPlot::started, this, [this, plot] {
    for (const auto &[entry, other] : m_plots)
      if (other != plot)
        other->stop();
  });
  return plot;
}

void FlightBlocks::showState(const FlightState &state) {
  for (const auto &[entry, bar] : m_bars)
    bar->setState(state);
}

void FlightBlocks::showCrossings(const std::function<Crossings(const std::string &entry)> &of,
                                 LiveValues values) {
  for (const auto &[entry, bar] : m_bars) {
    Crossings crossings = of(entry);
    crossings.nearestSoFar.reset();
    bar->axis().setCrossings(crossings);
  }
  for (const auto &[block, table] : m_tables) {
    Crossings crossings = of(block.hits);
    if (block.byNumber)
      askOneByOne(crossings);
    else
      crossings.nearestSoFar.reset();
    table->setCrossings(crossings, values);
  }
}

void FlightBlocks::showAims(const std::function<std::optional<Aim>(const std::string &entry)> &of) {
  for (const auto &[entry, plot] : m_plots)
    plot->setAim(of(entry));
}

void FlightBlocks::setHovered(std::size_t number) {
  for (const auto &[entry, bar] : m_bars)
    bar->axis().setHovered(number);
  for (const auto &[block, table] : m_tables)
    table->setHovered(number);
}

void FlightBlocks::setHeld(bool held) {
  for (const auto &[entry, bar] : m_bars)
    bar->axis().setHeld(held);
  for (const auto &[block, table] : m_tables)
    table->setHeld(held);
}

void FlightBlocks::setTheme(const Theme &theme) {
  for (const auto &[entry, bar] : m_bars)
    bar->setTheme(theme);
  for (const auto &[block, table] : m_tables)
    table->setTheme(theme);
  for (const auto &[entry, plot] : m_plots)
    plot->setTheme(theme);
}

} // namespace halfspace
