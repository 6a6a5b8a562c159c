#include "lessons/object/object.h"

#include <array>

namespace halfspace {
namespace {

/// One kind's description: its word, its coordinates and where they are kept.
template <class Kind> struct Description;

template <> struct Description<PointObject> {
  static constexpr std::string_view kind = "point";
  static inline const std::vector<CoordinateSpec> specs{{"", CoordinateRole::Position}};
  static constexpr std::array members{&PointObject::at};
};

template <> struct Description<PlaneObject> {
  static constexpr std::string_view kind = "plane";
  static inline const std::vector<CoordinateSpec> specs{{"P0", CoordinateRole::Position},
                                                        {"n", CoordinateRole::Direction}};
  static constexpr std::array members{&PlaneObject::point, &PlaneObject::normal};
};

template <> struct Description<RayObject> {
  static constexpr std::string_view kind = "ray";
  static inline const std::vector<CoordinateSpec> specs{{"Q", CoordinateRole::Position},
                                                        {"r", CoordinateRole::Direction}};
  static constexpr std::array members{&RayObject::origin, &RayObject::direction};
};

template <> struct Description<TriangleObject> {
  static constexpr std::string_view kind = "triangle";
  static inline const std::vector<CoordinateSpec> specs{
      {"P0", CoordinateRole::Position}, {"P1", CoordinateRole::Position}, {"P2", CoordinateRole::Position}};
  static constexpr std::array members{&TriangleObject::p0, &TriangleObject::p1, &TriangleObject::p2};
};

template <class Visitor> void forEachKind(Visitor visit) {
  [&]<class... Kinds>(std::type_identity<std::variant<Kinds...>>) {
    (visit(std::type_identity<Kinds>{}), ...);
  }(std::type_identity<Object>{});
}

} // namespace

std::string_view kindOf(const Object &object) {
  return std::visit([]<class Kind>(const Kind &) { return Description<Kind>::kind; }, object);
}

const std::vector<std::string_view> &objectKinds() {
  static const std::vector<std::string_view> kinds = [] {
    std::vector<std::string_view> words;
    forEachKind([&]<class Kind>(std::type_identity<Kind>) { words.push_back(Description<Kind>::kind); });
    return words;
  }();
  return kinds;
}

std::optional<Object> makeObject(std::string_view kind) {
  std::optional<Object> made;
  forEachKind([&]<class Kind>(std::type_identity<Kind>) {
    if (Description<Kind>::kind == kind)
      made = Kind{};
  });
  return made;
}

const std::vector<CoordinateSpec> &coordinatesOf(const Object &object) {
  return std::visit(
      []<class Kind>(const Kind &) -> const auto & { return Description<Kind>::specs; }, object);
}

const ExactVec3 &coordinate(const Object &object, std::size_t index) {
  return std::visit(
      [index]<class Kind>(const Kind &kind) -> const auto & {
        return kind.*Description<Kind>::members.at(index);
      },
      object);
}

ExactVec3 &coordinate(Object &object, std::size_t index) {
  return std::visit(
      [index]<class Kind>(Kind & kind) -> auto & { return kind.*Description<Kind>::members.at(index); },
      object);
}

} // namespace halfspace
