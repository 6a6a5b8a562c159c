// The blocks of a step that are about a flight: its controls, tables of fragments, and what a search costs.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/lesson/live_values.h"
#include "widgets/cost_plot/cost_plot.h"
#include "widgets/flight/flight_bar.h"
#include "widgets/hit_table/fragment_table.h"

#include <functional>

namespace halfspace {

/// Makes the blocks, hands on what they are to show, and speaks for all of them. They belong to whoever puts
/// them on a page.
class FlightBlocks : public QObject {
  Q_OBJECT
public:
  /// The typesetter must outlive the blocks, and they are gone before this is.
  explicit FlightBlocks(const Typesetter &typesetter) : m_typesetter(typesetter) {}

  /// Forgets all blocks: the page is to show others.
  void dropBlocks();
  [[nodiscard]] QWidget *addBlock(const StepFlight &flight);
  [[nodiscard]] QWidget *addBlock(const StepFragments &fragments);
  [[nodiscard]] QWidget *addBlock(const StepCost &cost);

  /// What the step's flight and its tables show; hidden while its question is open.
  void showState(const FlightState &state);
  void showCrossings(const std::function<Crossings(const std::string &entry)> &of, LiveValues values);
  /// The shots whose cost is measured, by the entries that aim them; nothing where one aims at nothing.
  void showAims(const std::function<std::optional<Aim>(const std::string &entry)> &of);
  /// The pointer is on this fragment of an entry somewhere else; 0 for none.
  void setHovered(std::size_t number);
  /// While they are held none becomes less high.
  void setHeld(bool held);
  void setTheme(const Theme &theme);

signals:
  void barMade(FlightBar *bar); ///< for a step that has a flight; it lives as long as the step is shown
  void fragmentChosen(const QString &entry, std::size_t number);
  void fragmentHovered(const QString &entry, std::size_t number); ///< 0: none any more

private:
  /// Hands on what a widget says of the fragments of an entry.
  template <class Widget> void followFragments(Widget &widget, const std::string &entry);

  const Typesetter &m_typesetter;
  LatestJob m_measuring;                                   ///< of the costs; outlives their plots
  std::vector<std::pair<std::string, FlightBar *>> m_bars; ///< with the entry whose crossings they show
  std::vector<std::pair<StepFragments, FragmentTable *>> m_tables;
  std::vector<std::pair<std::string, CostPlot *>> m_plots; ///< with the entry that aims the shot
};

} // namespace halfspace
