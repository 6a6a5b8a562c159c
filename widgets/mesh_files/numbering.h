// Numbers for keys in the order in which they first come.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace halfspace {

/// Gives equal keys the same number. A key is a row of 64-bit words. Keys cannot be chosen so that they
/// collide: where they are kept is decided anew by chance in each program.
template <std::size_t Words> class Numbering {
public:
  using Key = std::array<std::uint64_t, Words>;

  Numbering() : m_places(firstPlaces, nowhere) {
    std::random_device chance;
    for (std::uint64_t &factor : m_factors)
      factor = (static_cast<std::uint64_t>(chance()) << 32U | chance()) | 1U;
  }

  /// The key's number, and whether it is new. Requires fewer than 2^32 − 1 keys.
  std::pair<std::uint32_t, bool> numberOf(const Key &key) {
    if (2 * (m_keys.size() + 1) > m_places.size())
      grow();
    std::uint32_t &place = placeOf(key);
    if (place != nowhere)
      return {place, false};
    place = static_cast<std::uint32_t>(m_keys.size());
    m_keys.push_back(key);
    return {place, true};
  }

  /// All keys, by their numbers.
  [[nodiscard]] const std::vector<Key> &keys() const { return m_keys; }

private:
  static constexpr std::size_t firstPlaces = 1024;
  static constexpr std::uint32_t nowhere = 0xFFFFFFFF;

  /// Where the key's number is kept, or is to be kept.
  std::uint32_t &placeOf(const Key &key) {
    const std::size_t mask = m_places.size() - 1;
    for (std::size_t at = mixed(key) & mask;; at = (at + 1) & mask)
      if (m_places[at] == nowhere || m_keys[m_places[at]] == key)
        return m_places[at];
  }

  [[nodiscard]] std::size_t mixed(const Key &key) const {
    std::uint64_t mix = 0;
    for (std::size_t i = 0; i < Words; ++i) {
      mix = (mix ^ key[i]) * m_factors[i];
      mix = std::rotl(mix, 32) * m_factors[Words];
      mix ^= mix >> 29U;
    }
    return mix;
  }

  void grow() {
    m_places.assign(2 * m_places.size(), nowhere);
    for (std::size_t i = 0; i < m_keys.size(); ++i)
      placeOf(m_keys[i]) = static_cast<std::uint32_t>(i);
  }

  std::vector<Key> m_keys;
  std::vector<std::uint32_t> m_places;
  std::array<std::uint64_t, Words + 1> m_factors{};
};

} // namespace halfspace
