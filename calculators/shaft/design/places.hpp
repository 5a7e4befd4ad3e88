// Places along a shaft, and how messages name them.
#pragma once

#include "calculators/shaft/design/bending.hpp"
#include "lib/quantity/format.hpp"

#include <cstddef>
#include <string>

namespace loadpath::shaft {

inline constexpr double one_place = 1e-6;  // of the length: places that are meant to be one

inline bool are_one(const Design::Input& in, Length a, Length b) { return abs(a - b) <= one_place * length_of(in); }

/// Beyond the end of the shaft.
inline bool is_off(const Design::Input& in, Length x) { return !(x <= (1.0 + one_place) * length_of(in)); }

/// "seats.gear.x", "seats[2].x".
template <class Elements>
std::string place_of(const char* list, const Elements& all, std::size_t i, const char* key) {
  const Name& name = all[i].name;
  return name.empty() ? std::string(list) + "[" + std::to_string(i + 1) + "]." + key
                      : std::string(list) + "." + std::string(name.view()) + "." + key;
}

/// The ends of the pieces within the shaft where a diameter changes, until a call is true.
template <class Found>
bool find_step(const Design::Input& in, const Found& found) {
  Length x = 0.0 * mm;
  for (std::size_t i = 0; i + 1 < in.pieces.size(); ++i) {
    x += in.pieces[i].l;
    const Length d = in.pieces[i].d, next = in.pieces[i + 1].d;
    const bool changes = d != next || in.pieces[i].d_bore != in.pieces[i + 1].d_bore;
    if (changes && found(x, min(d, next), max(d, next))) return true;
  }
  return false;
}

inline const Piece& piece_at(const Design::Input& in, Length x) { return in.pieces[index_of_piece(in, x)]; }

/// Whether there is a bore on either side.
inline bool is_bored(const Design::Input& in, Length x) {
  const Length aside = 10.0 * one_place * length_of(in);
  return max(piece_at(in, x - aside).d_bore, piece_at(in, x + aside).d_bore) > 0.0 * mm;
}

inline std::string format(Length x) { return format_quantity(in_si(x), mm.symbol); }

}  // namespace loadpath::shaft
