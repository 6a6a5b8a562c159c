// The edges of a face as lines: their Plücker coordinates, and the products of a ray's line with them.
#pragma once

#include "geometry/line.h"
#include "lessons/construction/parts/own_names.h"
#include "lessons/construction/working.h"
#include "lessons/figure/figure.h"
#include "lessons/object/kinds/ray.h"

namespace halfspace {

/// An edge as a line: direction, moment, and the product of the ray's line with it.
struct EdgeTerms {
  Term e, m, p;
  Rational product;
};

/// The letters of an edge with an index, from the corner `from` along the way that it is.
[[nodiscard]] EdgeTerms edgeTerms(const Naming &naming, std::size_t index, const Line<Rational> &edge,
                                  const Rational &product, const Term &from, const Term &way);

/// The products of all edges.
template <class Edge> [[nodiscard]] std::vector<Term> productsOf(const std::vector<Edge> &edges) {
  std::vector<Term> products;
  products.reserve(edges.size());
  for (const EdgeTerms &edge : edges)
    products.push_back(edge.p);
  return products;
}

/// m = P×d, of a point on a line and the line's direction.
[[nodiscard]] WorkingLine momentLine(const Term &moment, const Term &point, const Term &direction,
                                     std::string sentence);

/// The mistakes that the permuted inner product d₁·m₂ + d₂·m₁ invites.
[[nodiscard]] std::vector<WrongTerm> productMistakes(const Term &d1, const Term &m1, const Term &d2,
                                                     const Term &m2);

/// The product of the ray's line, of which m is the moment, with an edge.
[[nodiscard]] WorkingLine productLine(const RayTerms &ray, const Term &m, const EdgeTerms &edge,
                                      std::string sentence);

/// An edge in the colour of its sign, with an arrow that says which way it runs; none of an edge without a
/// length. `numbers` goes on behind the letter of the product.
void addEdge(Figure &figure, const EdgeTerms &edge, const Term &from, const Term &to, std::string numbers);

} // namespace halfspace
