#include "widgets/hit_table/fragment_rows.h"

#include <algorithm>

namespace halfspace {
namespace {

/// The first is shown soonest.
enum class Rank : std::uint8_t { Needed, Hit, HitBehind, NoCrossing, Ahead, BehindStart, NotAsked };

Rank rankOf(const FragmentRow &row, const Crossings &crossings) {
  const bool isNext = row.standing == Standing::NotAsked && row.crossing.number == crossings.chosen + 1;
  if (row.crossing.number == crossings.chosen || isNearest(row.standing) || isNext)
    return Rank::Needed;
  if (isHit(row.standing))
    return Rank::Hit;
  if (row.standing == Standing::Behind)
    return Rank::HitBehind;
  if (row.standing == Standing::NotAsked)
    return Rank::NotAsked;
  if (!row.crossing.at)
    return Rank::NoCrossing;
  return isBehindStart(row.crossing) ? Rank::BehindStart : Rank::Ahead;
}

bool byNumber(const FragmentRow &a, const FragmentRow &b) { return a.crossing.number < b.crossing.number; }

/// Places in the rows, those first that are shown soonest.
std::vector<std::size_t> byRank(const std::vector<FragmentRow> &rows, const Crossings &crossings) {
  std::vector<std::size_t> places(rows.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = i;
  std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
    const Rank rank = rankOf(rows[a], crossings);
    if (const Rank other = rankOf(rows[b], crossings); rank != other)
      return rank < other;
    return rank == Rank::BehindStart ? a > b : a < b;
  });
  return places;
}

void keep(FragmentRows &shown, const Crossings &crossings, LiveValues values, std::size_t most) {
  std::vector<FragmentRow> &rows = shown.rows;
  if (rows.size() <= most)
    return;
  if (values == LiveValues::Hidden) {
    rows.resize(most);
    return;
  }
  std::vector<std::size_t> places = byRank(rows, crossings);
  shown.leftOutAreOutside = std::all_of(places.begin() + static_cast<std::ptrdiff_t>(most), places.end(),
                                        [&](std::size_t i) { return rows[i].standing == Standing::Outside; });
  places.resize(most);
  std::sort(places.begin(), places.end());
  std::vector<FragmentRow> kept;
  for (const std::size_t place : places)
    kept.push_back(std::move(rows[place]));
  rows = std::move(kept);
}

void partAtStart(std::vector<FragmentRow> &rows) {
  const auto isAsked = [](const FragmentRow &row) { return row.standing != Standing::NotAsked; };
  for (std::size_t i = 1; i < rows.size(); ++i)
    rows[i].beginsRay = isAsked(rows[i - 1]) && isBehindStart(rows[i - 1].crossing) &&
                        !(isAsked(rows[i]) && isBehindStart(rows[i].crossing));
}

} // namespace

FragmentRows rowsOf(const Crossings &crossings, LiveValues values, std::size_t most) {
  FragmentRows shown;
  const bool isHidden = values == LiveValues::Hidden;
  if (isHidden && crossings.all.size() < crossings.fragments) { // the nearest alone would be the answer
    shown.leftOut = crossings.fragments;
    return shown;
  }
  for (const Crossing &crossing : crossings.all)
    shown.rows.push_back({crossing, standingOf(crossing, crossings)});
  const auto notAsked =
      std::stable_partition(shown.rows.begin(), shown.rows.end(),
                            [](const FragmentRow &row) { return row.standing != Standing::NotAsked; });
  std::sort(isHidden ? shown.rows.begin() : notAsked, shown.rows.end(), byNumber);
  keep(shown, crossings, values, most);
  if (!isHidden)
    partAtStart(shown.rows);
  const std::size_t known = std::max(crossings.fragments, crossings.all.size());
  shown.leftOut = known - shown.rows.size();
  shown.leftOutAreOutside = shown.leftOutAreOutside && known == crossings.all.size();
  return shown;
}

std::optional<std::size_t> rowOf(const FragmentRows &shown, std::size_t number) {
  for (std::size_t i = 0; i < shown.rows.size(); ++i)
    if (shown.rows[i].crossing.number == number)
      return i;
  return {};
}

} // namespace halfspace
