// How the diameters of a shaft go together when they are searched for: they fall from one piece to both ends, so that
// all that sits on the shaft can be pushed onto it. Each piece between the bearings that carries none may be the
// thickest, without such a piece each; the lightest shaft is taken. A shoulder is at least as high as its fillet and
// its abutting part require; without a notch between them two pieces are one cylinder; bearings sit on bores of
// bearings. Tapers are given, and their ends require of adjacent cylinders what other cylinders do.
#include "calculators/shaft/design/design.hpp"
#include "calculators/shaft/design/model/places.hpp"

#include <algorithm>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;

/// Index of a sought piece among the sought ones, else none.
constexpr std::size_t none = most_pieces;
using OfPieces = List<std::size_t, most_pieces>;

OfPieces sought_of(const Input& in, std::span<const OpenSize> sought) {
  OfPieces all(in.pieces.size(), none);
  for (std::size_t k = 0; k < sought.size(); ++k) {
    for (std::size_t i = 0; i < in.pieces.size(); ++i) {
      if (sought[k].owner == &in.pieces[i]) all[i] = k;
    }
  }
  return all;
}

/// Where piece i ends.
Length end_of(const Input& in, std::size_t i) {
  Length x = 0.0 * mm;
  for (std::size_t k = 0; k <= i; ++k) x += in.pieces[k].l;
  return x;
}

const Notched* notch_at(const Input& in, Length x) {
  const auto found = std::find_if(in.notches.begin(), in.notches.end(),
                                  [&](const Notched& n) { return abs(n.x - x) <= one_place * length_of(in); });
  return found == in.notches.end() ? nullptr : &*found;
}

/// Joint between a piece and the one to its right.
struct Joint {
  Length x;
  bool tied = false;        // nothing: one cylinder
  Length least = 0.0 * mm;  // that the diameters differ, of a shoulder
  [[nodiscard]] bool steps() const { return least > 0.0 * mm; }
};
Joint joint_after(const Input& in, std::size_t i) {
  Joint joint{end_of(in, i)};
  const Notched* const notch = notch_at(in, joint.x);
  joint.tied = notch == nullptr && asks_fatigue(in);
  if (notch == nullptr || notch->kind != Notch::shoulder) return joint;
  const Length fillet = is_set(notch->r) ? notch->r : 0.0 * mm, asked = is_set(notch->h) ? notch->h : 0.0 * mm;
  joint.least = 2.0 * max(max(fillet, asked), 1e-6 * mm);
  return joint;
}

bool carries_bearing(const Input& in, std::size_t i) {
  return std::any_of(in.supports.begin(), in.supports.end(),
                     [&](const Support& s) { return index_of_piece(in, s.x) == i; });
}

/// Whether a bearing sits on it, or on what is one cylinder with it.
bool is_bearing_seat(const Input& in, std::size_t i) {
  std::size_t first = i, last = i;
  while (first > 0 && joint_after(in, first - 1).tied) --first;
  while (last + 1 < in.pieces.size() && joint_after(in, last).tied) ++last;
  for (std::size_t k = first; k <= last; ++k) {
    if (carries_bearing(in, k)) return true;
  }
  return false;
}

/// Whether a piece lies between two bearings and carries none itself.
bool is_free_between(const Input& in, std::size_t i) {
  const auto any_bearing = [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      if (carries_bearing(in, k)) return true;
    }
    return false;
  };
  return !is_bearing_seat(in, i) && any_bearing(0, i) && any_bearing(i + 1, in.pieces.size());
}

bool has_free_between(const Input& in) {
  for (std::size_t i = 0; i < in.pieces.size(); ++i) {
    if (is_free_between(in, i)) return true;
  }
  return false;
}

/// The pieces from which the diameters may fall to both ends: those between bearings that carry none, and collars that
/// are given; where there are none, every cylinder.
OfPieces tops_of(const Input& in, const OfPieces& sought) {
  OfPieces tops;
  for (std::size_t i = 0; i < in.pieces.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == in.pieces.size();
    const bool is_collar = sought[i] == none && !is_end && !is_bearing_seat(in, i);
    if (is_free_between(in, i) || is_collar) tops.push_back(i);
  }
  const bool any = !tops.empty();
  for (std::size_t i = 0; !any && i < in.pieces.size(); ++i) {
    if (!is_set(in.pieces[i].d_2)) tops.push_back(i);
  }
  return tops;
}

/// The diameters as they are tried: of what is searched for its size, else what is given.
struct Trial {
  const Input& in;
  std::span<const OpenSize> sought;
  OfPieces of;
  [[nodiscard]] bool is_sought(std::size_t i) const { return of[i] != none; }
  [[nodiscard]] Length d(std::size_t i) const { return from_si<Length>(sought[of[i]].size()); }
  /// Where it meets another piece, of a taper the end that does.
  [[nodiscard]] Length end(std::size_t i, std::size_t neighbour) const {
    if (is_sought(i)) return d(i);
    return neighbour < i ? in.pieces[i].d : right_diameter(in.pieces[i]);
  }
  /// Diameter to be passed over.
  [[nodiscard]] Length over(std::size_t i) const { return is_sought(i) ? d(i) : thickest(in.pieces[i]); }
  /// From the thickest piece.
  [[nodiscard]] std::size_t away(std::size_t i) const {
    const std::size_t top = sought.front().note;
    return i < top ? top - i : i - top;
  }
  /// Minimum diameter that a neighbour requires. A given one, further in, is a collar, or a neck to be passed over.
  [[nodiscard]] Length asked_by(const Joint& joint, std::size_t i, std::size_t neighbour) const {
    const Length beyond = end(neighbour, i);
    if (joint.tied) return beyond;
    if (away(i) < away(neighbour)) return max(beyond + joint.least, over(neighbour));
    const bool passes_neck = !is_sought(neighbour) && abs(d(i) - beyond) < (1.0 - one_place) * joint.least;
    return passes_neck ? beyond + joint.least : 0.0 * mm;
  }
  [[nodiscard]] Length asked(std::size_t i) const {
    Length least = 0.0 * mm;
    if (i > 0) least = max(least, asked_by(joint_after(in, i - 1), i, i - 1));
    if (i + 1 < in.pieces.size()) least = max(least, asked_by(joint_after(in, i), i, i + 1));
    return least;
  }
  /// Where a piece between the bearings could be thicker, no bearing seat is the thickest.
  [[nodiscard]] bool has_thick_middle() const {
    if (!has_free_between(in)) return true;
    Length seats = 0.0 * mm, others = 0.0 * mm;
    for (std::size_t i = 0; i < of.size(); ++i) {
      Length& thickest_of_kind = is_bearing_seat(in, i) ? seats : others;
      thickest_of_kind = max(thickest_of_kind, over(i));
    }
    return seats <= others * (1.0 + one_place);
  }
  /// One cylinder of one diameter.
  [[nodiscard]] bool agrees(std::size_t i) const {
    return !joint_after(in, i).tied || abs(end(i, i + 1) - end(i + 1, i)) <= one_place * end(i, i + 1);
  }
};

}  // namespace

bool Design::arrange(const Input& in, std::span<OpenSize> sought, std::size_t way) {
  const OfPieces of = sought_of(in, sought), tops = tops_of(in, of);
  if (way >= tops.size()) return false;
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (of[i] == none) continue;
    sought[of[i]].note = tops[way];
    if (is_bearing_seat(in, i)) sought[of[i]].stock = "bearing";
    if (i > 0 && of[i - 1] != none && joint_after(in, i - 1).tied) sought[of[i]].like = sought[of[i - 1]].like;
  }
  return true;
}

/// The volume, in m^3.
double Design::cost(const Input& in) {
  double V = 0.0;
  for (const Piece& piece : in.pieces) {
    const double a = in_si(piece.d), b = in_si(right_diameter(piece)), bore = in_si(piece.d_bore);
    V += pi / 12.0 * in_si(piece.l) * (a * a + a * b + b * b - 3.0 * bore * bore);
  }
  return V;
}

/// Place of sections and of their safeties: the piece there, the thinner of two.
const void* Design::place(const Input& in, std::string_view list, const void* element) {
  Length x = unset<Length>;
  if (list == "sections") x = static_cast<const Section*>(element)->x;
  if (list == "safeties") x = static_cast<const Safety*>(element)->x;
  if (!is_set(x)) return nullptr;
  const auto [before, after, sides] = around(in, x);
  return sides.left.d <= sides.right.d ? &before : &after;
}

bool Design::raise(const Input& in, std::span<OpenSize> sought) {
  const Trial trial{in, sought, sought_of(in, sought)};
  for (std::size_t i = 0; i < trial.of.size(); ++i) {
    if (trial.is_sought(i) && is_set(in.pieces[i].d_2)) return false;  // both ends of a taper are given
  }
  for (bool raised = true; raised;) {
    raised = false;
    for (std::size_t i = 0; i < trial.of.size(); ++i) {
      if (!trial.is_sought(i)) continue;
      OpenSize& own = sought[trial.of[i]];
      const double least = (1.0 - one_place) * in_si(trial.asked(i));
      while (own.size() < least) {
        raised = true;
        if (++own.at == own.sizes.size()) return false;
      }
    }
  }
  for (std::size_t i = 0; i + 1 < trial.of.size(); ++i) {
    if (!trial.agrees(i)) return false;
  }
  return true;
}

Message Design::unsound(const Input& in, std::span<const OpenSize> sought, std::size_t which) {
  const Trial trial{in, sought, sought_of(in, sought)};
  const auto i = static_cast<std::size_t>(std::find(trial.of.begin(), trial.of.end(), which) - trial.of.begin());
  const auto fault_at = [&](const Joint& joint, std::size_t k) -> Message {
    const Length own = trial.d(i), beyond = trial.end(k, i), step = abs(own - beyond);
    if (joint.tied && step > one_place * own)
      return say("no shoulder given at x = {1}: same diameter as the adjacent {2} required", format(joint.x),
                 format(beyond));
    if (joint.steps() && step < (1.0 - one_place) * joint.least)
      return say("shoulder at x = {1}: height {2}, required {3}", format(joint.x), format(step / 2.0),
                 format(joint.least / 2.0));
    const Length passed = max(beyond + joint.least * (1.0 - one_place), trial.over(k));
    if (!joint.tied && trial.away(i) < trial.away(k) && own < passed)
      return say("a component mounted there cannot be pushed over the {1} beyond {2}", format(trial.over(k)),
                 format(joint.x));
    return {};
  };
  if (!trial.has_thick_middle())
    return say("a bearing seat is the thickest segment: no shoulder towards the middle for its ring");
  Message fault = i == 0 ? Message{} : fault_at(joint_after(in, i - 1), i - 1);
  if (fault.empty() && i + 1 < in.pieces.size()) fault = fault_at(joint_after(in, i), i + 1);
  return fault;
}

}  // namespace loadpath::shaft
