// How an object lies on another one.
#pragma once

#include "lessons/object/handle.h"

namespace halfspace {

/// How the objects of a kind lie on another object, their host, as a point on a line. They are told by their
/// freedoms alone, exactly, so they follow whatever becomes of the host.
struct Binding {
  std::string_view host; ///< the word of its kind
  /// Where it lies; nothing where the host has no places, as a plane without a normal.
  std::optional<ExactVec3> (*placeOf)(const Object &bound, const Object &host);
  /// With the freedoms by which it lies nearest to a place; as it is where the host does not tell.
  Object (*nearest)(Object bound, const Object &host, const ExactVec3 &place);
  /// With its freedoms rounded so that it goes in steps of about this length.
  Object (*onGrid)(Object bound, const Object &host, const Rational &step);
  /// Says along what a handle moves.
  void (*guide)(const Object &host, Handle &handle);
};

} // namespace halfspace
