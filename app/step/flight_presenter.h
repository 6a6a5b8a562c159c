// The torpedo's flight on the page, and the triangles that it may hit.
#pragma once

#include "app/panels/messages.h"
#include "widgets/flight/flight_player.h"

#include <set>
#include <string>

namespace halfspace {

class FlightBlocks;

/// Writes the blocks about a flight, and takes up what the learner does there.
class FlightPresenter : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  FlightPresenter(SessionModel &model, FlightBlocks &blocks, Messages messages);

  /// While numbers are hidden nothing can be controlled, and a flight that is played stops.
  void setNumbersHidden(bool hidden);
  void show();
  /// Lights up the fragment that alone has the mark that the pointer is on.
  void showHovered(const QString &markId);
  [[nodiscard]] FlightPlayer &player() { return m_player; }

signals:
  /// Whether the step has a flight that can be controlled; told as often as the flight is shown.
  void controllable(bool can);
  /// The pointer is on a fragment with these marks; none: on no fragment.
  void fragmentHovered(const std::set<std::string> &marks);

private:
  void serve(FlightBar &bar);
  void choose(const std::string &entry, std::size_t number);
  void hover(const std::string &entry, std::size_t number);

  SessionModel &m_model;
  FlightBlocks &m_blocks;
  Messages m_messages;
  FlightPlayer m_player;
  bool m_areNumbersHidden = false;
};

} // namespace halfspace
