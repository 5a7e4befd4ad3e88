// The elastic buckling of a column in pieces, each of one stiffness, under a compression that grows evenly downwards.
//
// In each piece the slope phi of the bent axis follows E I phi'' + alpha N(x) phi = c with N linear in x, which its
// power series solves exactly: that is the stiffness of an element. The load factor alpha at which the column buckles
// is found by counting the critical loads below a trial load (Wittrick and Williams), which misses none; the elements
// are so short that none of them buckles by itself below any trial load.
#pragma once

#include "calculators/column/member/stability.hpp"
#include "lib/calculator/list.hpp"

namespace loadpath::column {

inline constexpr std::size_t most_pieces = 8;

/// In SI, under the loads as given: from its lower end to its upper one.
struct Piece {
  double EI, l;
  double N_l, N_u;  // compression at the lower and the upper end, not negative
};
using Pieces = List<Piece, most_pieces>;

/// The factor on all loads at which the column buckles; infinite if nothing compresses it, NaN if it moves without
/// a load.
double critical_factor(const Pieces& pieces, const End& foot, const End& top);

/// Its first mode, at even steps in each piece; x in metres from the foot, the largest deflection is 1.
Shape critical_shape(const Pieces& pieces, const End& foot, const End& top, double alpha);

}  // namespace loadpath::column
