// Lists of values that are shared between copies, and found by their names.
#pragma once

#include <algorithm>
#include <compare>
#include <concepts>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace halfspace {

/// An ordered list whose values no copy of it copies: a copy costs the same however long the list is, and one
/// in which a value was replaced shares all others with the list that it was copied from. So a value never
/// changes where it stands; whoever holds one as `shared` may keep it.
template <class T> class SharedList {
public:
  using value_type = T;
  using Shared = std::shared_ptr<const T>;

  class const_iterator {
  public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T *;
    using reference = const T &;

    const_iterator() = default;
    explicit const_iterator(const Shared *at) : m_at(at) {}

    reference operator*() const { return **m_at; }
    pointer operator->() const { return m_at->get(); }
    reference operator[](difference_type steps) const { return *m_at[steps]; }
    const_iterator &operator+=(difference_type steps) {
      m_at += steps;
      return *this;
    }
    const_iterator &operator-=(difference_type steps) { return *this += -steps; }
    const_iterator &operator++() { return *this += 1; }
    const_iterator &operator--() { return *this += -1; }
    const_iterator operator++(int) { return const_iterator(m_at++); }
    const_iterator operator--(int) { return const_iterator(m_at--); }
    friend const_iterator operator+(const_iterator at, difference_type steps) { return at += steps; }
    friend const_iterator operator+(difference_type steps, const_iterator at) { return at += steps; }
    friend const_iterator operator-(const_iterator at, difference_type steps) { return at -= steps; }
    friend difference_type operator-(const const_iterator &a, const const_iterator &b) {
      return a.m_at - b.m_at;
    }
    auto operator<=>(const const_iterator &) const = default;

  private:
    const Shared *m_at = nullptr;
  };
  using iterator = const_iterator;

  SharedList() = default;
  SharedList(std::initializer_list<T> values) : SharedList(values.begin(), values.end()) {}
  SharedList(std::vector<T> values) // NOLINT(google-explicit-constructor): the same values
      : SharedList(std::make_move_iterator(values.begin()), std::make_move_iterator(values.end())) {}
  template <std::input_iterator From> SharedList(From begin, From end) {
    for (; begin != end; ++begin)
      push_back(*begin);
  }

  [[nodiscard]] const_iterator begin() const { return const_iterator(data()); }
  [[nodiscard]] const_iterator end() const { return begin() + static_cast<std::ptrdiff_t>(size()); }
  [[nodiscard]] auto rbegin() const { return std::make_reverse_iterator(end()); }
  [[nodiscard]] auto rend() const { return std::make_reverse_iterator(begin()); }
  [[nodiscard]] std::size_t size() const { return m_values ? m_values->size() : 0; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] const T &operator[](std::size_t place) const { return *(*m_values)[place]; }
  [[nodiscard]] const T &front() const { return *m_values->front(); }
  [[nodiscard]] const T &back() const { return *m_values->back(); }
  /// The value at a place below `size`, to be kept.
  [[nodiscard]] const Shared &shared(std::size_t place) const { return (*m_values)[place]; }

  void push_back(T value) { push_back(std::make_shared<const T>(std::move(value))); }
  void push_back(Shared value) { own().push_back(std::move(value)); }
  /// Goes on with the values of another list, which are those of both from then on.
  void append(const SharedList &others) {
    const auto more = others.m_values; // kept as they are: the other list may be this one
    if (more)
      own().insert(own().end(), more->begin(), more->end());
  }
  void pop_back() { own().pop_back(); }
  void insert(std::size_t place, T value) {
    own().insert(positionOf(place), std::make_shared<const T>(std::move(value)));
  }
  void erase(std::size_t place) { own().erase(positionOf(place)); }
  /// Puts another value in the place of one.
  void replace(std::size_t place, T value) { replace(place, std::make_shared<const T>(std::move(value))); }
  void replace(std::size_t place, Shared value) { own()[place] = std::move(value); }
  /// Puts a changed copy of the value in its place.
  template <std::invocable<T &> Change> void change(std::size_t place, Change change) {
    T value = (*this)[place];
    change(value);
    replace(place, std::move(value));
  }
  /// Takes away what a predicate holds for.
  template <std::predicate<const T &> Goes> void eraseIf(Goes goes) {
    if (std::any_of(begin(), end(), goes))
      std::erase_if(own(), [&](const Shared &value) { return goes(*value); });
  }

  /// Whether the values are equal, whoever else has them.
  bool operator==(const SharedList &other) const {
    const auto areEqual = [](const Shared &a, const Shared &b) { return a == b || *a == *b; };
    return m_values == other.m_values ||
           std::equal(data(), data() + size(), other.data(), other.data() + other.size(), areEqual);
  }

private:
  using Values = std::vector<Shared>;

  [[nodiscard]] const Shared *data() const { return m_values ? m_values->data() : nullptr; }
  /// The values as nobody else has them.
  [[nodiscard]] Values &own() {
    if (!m_values)
      m_values = std::make_shared<Values>();
    else if (m_values.use_count() > 1)
      m_values = std::make_shared<Values>(*m_values);
    return *m_values;
  }
  [[nodiscard]] typename Values::iterator positionOf(std::size_t place) {
    return own().begin() + static_cast<std::ptrdiff_t>(place);
  }

  std::shared_ptr<Values> m_values; ///< null for none
};

/// A shared list of values that have a `name`, by which they are found without a search. Of several with one
/// name that is the first.
template <class T> class NamedList : private SharedList<T> {
  using Values = SharedList<T>;

public:
  using typename Values::const_iterator;
  using typename Values::iterator;
  using typename Values::Shared;
  using typename Values::value_type;
  using Values::back;
  using Values::begin;
  using Values::empty;
  using Values::end;
  using Values::front;
  using Values::rbegin;
  using Values::rend;
  using Values::operator[];
  using Values::shared;
  using Values::size;

  NamedList() = default;
  NamedList(std::initializer_list<T> values) : Values(values) { findPlaces(); }

  /// Where the value of this name stands; nothing where there is none.
  [[nodiscard]] std::optional<std::size_t> placeOf(std::string_view name) const {
    if (!m_places)
      return {};
    const auto found = m_places->find(name);
    return found == m_places->end() ? std::nullopt : std::optional(found->second);
  }
  /// The value of this name, or null.
  [[nodiscard]] const T *find(std::string_view name) const {
    const auto place = placeOf(name);
    return place ? &(*this)[*place] : nullptr;
  }

  void push_back(T value) { push_back(std::make_shared<const T>(std::move(value))); }
  void push_back(Shared value) {
    ownPlaces().emplace(value->name, size());
    Values::push_back(std::move(value));
  }
  void pop_back() { erase(size() - 1); }
  void insert(std::size_t place, T value) {
    Values::insert(place, std::move(value));
    findPlaces();
  }
  void erase(std::size_t place) {
    Values::erase(place);
    findPlaces();
  }
  void replace(std::size_t place, T value) { replace(place, std::make_shared<const T>(std::move(value))); }
  void replace(std::size_t place, Shared value) {
    const bool isRenamed = value->name != (*this)[place].name;
    Values::replace(place, std::move(value));
    if (isRenamed)
      findPlaces();
  }
  template <std::invocable<T &> Change> void change(std::size_t place, Change change) {
    T value = (*this)[place];
    change(value);
    replace(place, std::move(value));
  }
  template <std::predicate<const T &> Goes> void eraseIf(Goes goes) {
    Values::eraseIf(goes);
    findPlaces();
  }

  bool operator==(const NamedList &other) const { return Values::operator==(other); }

private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  using Places = std::unordered_map<std::string, std::size_t, Hash, std::equal_to<>>;

  void findPlaces() {
    Places places;
    for (std::size_t place = 0; place < size(); ++place)
      places.emplace((*this)[place].name, place);
    m_places = std::make_shared<Places>(std::move(places));
  }
  /// The places as nobody else has them.
  [[nodiscard]] Places &ownPlaces() {
    if (!m_places)
      m_places = std::make_shared<Places>();
    else if (m_places.use_count() > 1)
      m_places = std::make_shared<Places>(*m_places);
    return *m_places;
  }

  std::shared_ptr<Places> m_places; ///< of the names; null for none
};

} // namespace halfspace
