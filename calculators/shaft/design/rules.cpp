// What shaft.design asks of its input beyond the bounds of its fields.
#include "calculators/shaft/design/bending.hpp"
#include "calculators/shaft/design/turn.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;

constexpr double same = 1e-6;   // of the length: places that are meant to be one
constexpr double apart = 1e-4;  // of the length: bearings nearer than that are one bearing

bool are_one(const Input& in, Length a, Length b) { return abs(a - b) <= same * length_of(in); }

/// "seats.gear.x", "seats[2].x".
template <class Elements>
std::string place_of(const char* list, const Elements& all, std::size_t i, const char* key) {
  const Name& name = all[i].name;
  return name.empty() ? std::string(list) + "[" + std::to_string(i + 1) + "]." + key
                      : std::string(list) + "." + std::string(name.view()) + "." + key;
}

/// Calls with the place of everything that is on the shaft, and what makes its key, until one call is true.
template <class Found>
bool find_place(const Input& in, const Found& found) {
  const auto in_list = [&](const char* list, const auto& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (found([&] { return place_of(list, all, i, "x"); }, all[i].x)) return true;
    }
    return false;
  };
  return in_list("supports", in.supports) || in_list("seats", in.seats) || in_list("notches", in.notches);
}

bool is_off(const Input& in, Length x) { return !(x <= (1.0 + same) * length_of(in)); }

/// The ends of the pieces within the shaft where a diameter changes, until a call is true.
template <class Found>
bool find_step(const Input& in, const Found& found) {
  Length x = 0.0 * mm;
  for (std::size_t i = 0; i + 1 < in.pieces.size(); ++i) {
    x += in.pieces[i].l;
    const Length d = in.pieces[i].d, next = in.pieces[i + 1].d;
    const bool changes = d != next || in.pieces[i].d_bore != in.pieces[i + 1].d_bore;
    if (changes && found(x, min(d, next), max(d, next))) return true;
  }
  return false;
}

/// The sum of all torques where it is largest.
Moment balance(const Input& in) {
  Moment most = 0.0 * N_m.one;
  for (std::size_t position = 0; position < positions_of(in); ++position) {
    Moment sum = 0.0 * N_m.one;
    for (std::size_t i = 0; i < in.seats.size(); ++i) sum += torque_of(in, i, position);
    if (abs(sum) > abs(most)) most = sum;
  }
  return most;
}

/// Whether a load is anything but zero in a turn.
template <class Load>
bool acts(const Load& load) {
  for (std::size_t i = 0; i < load.positions(); ++i) {
    if (std::abs(in_si(load.at(i))) > 0.0) return true;
  }
  return false;
}

std::ptrdiff_t count_balancing(const Input& in) {
  return std::count_if(in.seats.begin(), in.seats.end(), [](const Seat& s) { return s.way == Way::balances; });
}

const Piece& piece_at(const Input& in, Length x) { return in.pieces[index_of_piece(in, x)]; }

/// Whether there is a bore on either side.
bool is_bored(const Input& in, Length x) {
  const Length aside = 10.0 * same * length_of(in);
  return max(piece_at(in, x - aside).d_bore, piece_at(in, x + aside).d_bore) > 0.0 * mm;
}

std::string format(Length x) { return format_quantity(in_si(x), mm.symbol); }

/// What a force across makes about the axis, where it acts, is the torque, to what tables round; a force along the
/// shaft that comes with it acts at the same place.
bool makes_its_torque(const Seat& seat, std::size_t position) {
  constexpr double rounding = 0.05;
  const Force F_y = seat.F_y.at(position), F_z = seat.F_z.at(position);
  const bool meshes = abs(F_y) > 0.0 * N.one && abs(F_z) > 0.0 * N.one;
  if (meshes && seat.x_w == 0.0 * mm) return false;
  const Moment made = abs(F_y * seat.x_w), T = is_set(seat.T) ? abs(seat.T.at(position)) : 0.0 * N_m.one;
  return made == 0.0 * N_m.one || seat.way == Way::balances || abs(made - T) <= rounding * max(made, T);
}

/// What a notch lacks, or has and should not have; empty where nothing is.
Message fault_of_fields(const Notched& notch) {
  using Kind = Notch;
  const Kind kind = notch.kind;
  const bool rounded = kind == Kind::shoulder || kind == Kind::groove || kind == Kind::rectangular_groove;
  if (rounded && !is_set(notch.r)) return say("this notch needs the radius r of its root");
  if (kind == Kind::cross_hole && !is_set(notch.r)) return say("a cross hole needs its radius r");
  if (is_groove(kind) != is_set(notch.t)) return say("a groove has a depth t, and nothing else has");
  if ((kind == Kind::rectangular_groove) != is_set(notch.w))
    return say("a rectangular groove has a width w, and nothing else has");
  if ((kind == Kind::given) != is_set(notch.K_t) || is_set(notch.K_t) != is_set(notch.K_ts))
    return say("K_t and K_ts go together, with kind = \"given\" alone");
  if ((kind == Kind::beta) != is_set(notch.beta_b) || is_set(notch.beta_b) != is_set(notch.beta_t))
    return say("beta_b and beta_t go together, with kind = \"beta\" alone");
  if (is_set(notch.h) && kind != Kind::shoulder) return say("h is the least height of a shoulder");
  if (kind == Kind::keyway && is_set(notch.r))
    return say("K_t of a keyway is that of r = 0.02 d: leave out r, or give K_t and K_ts of another");
  if (const bool rootless = kind == Kind::v_groove || kind == Kind::press_fit || kind == Kind::beta;
      rootless && is_set(notch.r))
    return say("its notch factor is of no radius: leave out r");
  if (kind == Kind::given && notch.K_t > 1.0 && !is_set(notch.r))
    return say("a given notch needs the radius r of its root, for the sensitivity to it");
  return {};
}

/// What is wrong with the width of a groove, which lies half on each side of its place; empty where nothing is.
Message fault_of_width(const Input& in, const Notched& notch) {
  if (!is_set(notch.w)) return {};
  if (notch.r > notch.t || notch.r > notch.w / 2.0)
    return say("its root is rounder than the groove is deep, or half as wide");
  const Length from = notch.x - notch.w / 2.0, to = notch.x + notch.w / 2.0, aside = 10.0 * same * length_of(in);
  if (from < 0.0 * mm || is_off(in, to) || index_of_piece(in, from + aside) != index_of_piece(in, to - aside))
    return say("a groove of {1} does not lie within its piece at {2}", format(notch.w), format(notch.x));
  const auto inside = [&](const auto& element) { return element.x > from && element.x < to; };
  if (std::any_of(in.seats.begin(), in.seats.end(), inside) ||
      std::any_of(in.supports.begin(), in.supports.end(), inside))
    return say("something sits on the shaft within the groove of {1} at {2}", format(notch.w), format(notch.x));
  return {};
}

/// What is wrong with the fillet of a shoulder, an arc that leaves the thinner side evenly: one that is rounder than
/// the step is high ends in an edge, as the charts have it, and leaves no face. Empty where nothing is.
Message fault_of_fillet(const Notched& notch, const Piece& before, const Piece& after) {
  const Length high = abs(after.d - before.d) / 2.0, r = notch.r;
  if (is_set(notch.h) && r > high)
    return say("its fillet of {1} is rounder than the step of {2} is high: nothing finds a face there", format(r),
               format(high));
  const Length run = r > high ? sqrt(high * (2.0 * r - high)) : r, room = before.d < after.d ? before.l : after.l;
  if (run > room) return say("its fillet runs {1} along a piece of {2}", format(run), format(room));
  return {};
}

/// What is wrong with a notch where it is; empty where nothing is.
Message fault_of(const Input& in, const Notched& notch) {
  if (Message fault = fault_of_fields(notch); !fault.empty()) return fault;
  const bool typed = notch.kind == Notch::given || notch.kind == Notch::beta;
  const Length aside = 10.0 * same * length_of(in);
  const Piece &before = piece_at(in, notch.x - aside), &piece = piece_at(in, notch.x + aside);
  if (!typed && notch.kind != Notch::keyway && is_bored(in, notch.x))
    return say("the charts are of solid shafts: of a bored one give K_t and K_ts");
  if (is_groove(notch.kind) && !(2.0 * notch.t < piece.d)) return say("the groove is deeper than the shaft");
  if (Message fault = fault_of_width(in, notch); !fault.empty()) return fault;
  if (notch.kind == Notch::cross_hole && !(notch.r < 0.29 * piece.d)) return say("the hole leaves no section");
  if (has_factors(notch.kind) && !typed && in.group > fatigue::Endurance::Group::cast_steel)
    return say("its notch factor is told of steels alone: give K_t and K_ts");
  if (is_set(notch.d) && abs(notch.d - piece.d) > same * piece.d)
    return say("it is made for {1}, and the shaft has {2} at {3}", format(notch.d), format(piece.d), format(notch.x));
  if (notch.r_T < in.r_T)
    return say("its torque runs back to {1} of the largest, and that of the shaft, r_T, to {2}",
               format_number(notch.r_T, 3), format_number(in.r_T, 3));
  const bool at_step = find_step(in, [&](Length x, Length, Length) { return are_one(in, x, notch.x); });
  if (notch.kind == Notch::shoulder && (!at_step || before.d == piece.d))
    return say("the diameter does not change at {1}", format(notch.x));
  if (notch.kind == Notch::shoulder) {
    if (Message fault = fault_of_fillet(notch, before, piece); !fault.empty()) return fault;
  }
  if (notch.kind != Notch::shoulder && !typed && at_step)
    return say("at {1} the diameter changes: a notch of both is one given by K_t and K_ts", format(notch.x));
  return {};
}

/// How far along the shaft a notch is felt: as far as it is deep, twice. Of a keyway a tenth of the diameter counts as
/// its depth.
Length reach_of(const Input& in, const Notched& notch) {
  const Length aside = 10.0 * same * length_of(in), none = 0.0 * mm;
  const Length d = piece_at(in, notch.x - aside).d, next = piece_at(in, notch.x + aside).d;
  const Length root = is_set(notch.r) ? notch.r : none, deep = is_set(notch.t) ? notch.t : none;
  const Length cut = notch.kind == Notch::keyway ? 0.1 * d : abs(d - next) / 2.0;
  return 2.0 * max(max(root, deep), cut);
}

/// The first notch behind which another begins before it has died down; null where there is none.
const Notched* crowded(const Input& in) {
  for (const Notched& notch : in.notches) {
    for (const Notched& other : in.notches) {
      const Length gap = other.x - notch.x;
      if (gap > 0.0 * mm && gap < max(reach_of(in, notch), reach_of(in, other)) * (1.0 - same)) return &notch;
    }
  }
  return nullptr;
}

}  // namespace

bool Design::held(const Input& in) {
  for (std::size_t i = 0; i < in.supports.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!(abs(in.supports[i].x - in.supports[k].x) > apart * length_of(in))) return false;
    }
  }
  return in.supports.size() > 1;
}

bool Design::stiff_enough(const Input& in) {
  const bool told = !held(in) || !on_shaft(in) || !bores_fit(in) || !(is_set(in.E) && is_set(in.G));
  return told || bears(in);  // by another rule
}

bool Design::on_shaft(const Input& in) {
  return !find_place(in, [&](const auto&, Length x) { return is_off(in, x); });
}

FieldFault Design::off_shaft(const Input& in) {
  FieldFault fault;
  find_place(in, [&](const auto& key, Length x) {
    if (!is_off(in, x)) return false;
    fault = {key(), say("{1} is beyond the end of the shaft at {2}", format(x), format(length_of(in))),
             say("x counts from the left end: correct it, or the lengths of the pieces")};
    return true;
  });
  return fault;
}

bool Design::bores_fit(const Input& in) {
  for (std::size_t i = 0; i < in.pieces.size(); ++i) {
    const Length bore = in.pieces[i].d_bore;
    if (!(bore < in.pieces[i].d) || (i > 0 && !(bore < in.pieces[i - 1].d))) return false;
    if (i + 1 < in.pieces.size() && !(bore < in.pieces[i + 1].d)) return false;
  }
  return true;
}

bool Design::torques_close(const Input& in) {
  double largest = 0.0;
  for (const Seat& seat : in.seats) {
    for (std::size_t i = 0; is_set(seat.T) && i < seat.T.positions(); ++i)
      largest = std::max(largest, std::abs(in_si(seat.T.at(i))));
  }
  const bool balanced_alone = std::all_of(in.seats.begin(), in.seats.end(),
                                          [](const Seat& s) { return s.way != Way::balances || !is_set(s.T); });
  return count_balancing(in) <= 1 && balanced_alone && std::abs(in_si(balance(in))) <= 1e-6 * largest;
}

FieldFault Design::open_sum(const Input& in) {
  if (count_balancing(in) > 1) return {"seats", say("more than one seat balances the torque"), say("one is enough")};
  const bool typed = std::any_of(in.seats.begin(), in.seats.end(),
                                 [](const Seat& s) { return s.way == Way::balances && is_set(s.T); });
  const double sum = in_si(balance(in));
  if (!typed)
    return {"seats", say("of the torques {1} are left over", format_quantity(sum, N_m.symbol)),
            say("say what drives the shaft, way = \"drives\", or let a coupling take the rest, way = \"balances\"")};
  return {"seats", say("what balances has no torque of its own"), say("leave out its T")};
}

bool Design::speeds_agree(const Input& in) {
  const AngularSpeed n = speed_of(in);
  const auto agrees = [&](AngularSpeed own) {
    return !is_set(own) || (abs(own) > 0.0 * rpm && abs(abs(own) - n) <= 1e-3 * n);
  };
  return agrees(in.n) && std::all_of(in.seats.begin(), in.seats.end(), [&](const Seat& s) { return agrees(s.n); });
}

Applies Design::running(const Input& in) { return shown_by(is_set(speed_of(in))); }

bool Design::thrust_is_held(const Input& in) {
  const auto fixed =
      std::count_if(in.supports.begin(), in.supports.end(), [](const Support& s) { return s.holds == Holds::both; });
  const bool pushed = std::any_of(in.seats.begin(), in.seats.end(), [](const Seat& s) { return acts(s.F_z); });
  return fixed == 1 || (fixed == 0 && !pushed);
}

bool Design::notches_fit(const Input& in) {
  for (std::size_t i = 0; i < in.notches.size(); ++i) {
    if (!fault_of(in, in.notches[i]).empty()) return false;
    for (std::size_t k = 0; k < i; ++k) {
      if (are_one(in, in.notches[i].x, in.notches[k].x)) return false;
    }
  }
  return true;
}

FieldFault Design::misfit(const Input& in) {
  for (std::size_t i = 0; i < in.notches.size(); ++i) {
    const Message fault = fault_of(in, in.notches[i]);
    if (!fault.empty()) return {place_of("notches", in.notches, i, "kind"), fault, {}};
  }
  return {"notches", say("two notches stand at one place"),
          say("a notch in a notch is one given by its K_t and K_ts: kind = \"given\"")};
}

bool Design::notches_apart(const Input& in) { return crowded(in) == nullptr; }

FieldFault Design::crowd(const Input& in) {
  const Notched* const notch = crowded(in);
  if (notch == nullptr) return {};
  const auto i = static_cast<std::size_t>(notch - in.notches.data());
  return {place_of("notches", in.notches, i, "x"),
          say("the next notch is nearer than twice the depth or the radius of one of them: each is rated alone"),
          say("keep them apart, or give K_t and K_ts of both together")};
}

bool Design::steps_are_notched(const Input& in) { return bare_step(in).path.empty(); }

FieldFault Design::bare_step(const Input& in) {
  FieldFault fault;
  if (!asks_fatigue(in)) return fault;
  find_step(in, [&](Length x, Length d, Length D) {
    const bool known = std::any_of(in.notches.begin(), in.notches.end(),
                                   [&](const Notched& notch) { return are_one(in, notch.x, x); });
    if (known) return false;
    fault = {"notches",
             d == D ? say("at {1} the bore changes, and no notch says how", format(x))
                    : say("at {1} the diameter changes from {2} to {3}, and no notch says how", format(x), format(d),
                          format(D)),
             say("add {1} to notches", "{ x = \"" + format(x) + "\", " +
                                           (is_bored(in, x) ? "kind = \"given\", K_t = ..., K_ts = ..., r = \"...\" }"
                                                            : "kind = \"shoulder\", r = \"...\" }"))};
    return true;
  });
  return fault;
}

bool Design::slopes_of_all(const Input& in) {
  const auto all_or_none = [](const auto& elements) {
    const auto given =
        std::count_if(elements.begin(), elements.end(), [](const auto& e) { return is_set(e.beta_adm); });
    return given == 0 || given == static_cast<std::ptrdiff_t>(elements.size());
  };
  return all_or_none(in.supports) && all_or_none(in.seats);
}

bool Design::forces_make_torques(const Input& in) {
  for (std::size_t i = 0; i < positions_of(in); ++i) {
    if (!std::all_of(in.seats.begin(), in.seats.end(), [&](const Seat& s) { return makes_its_torque(s, i); }))
      return false;
  }
  return true;
}

bool Design::turn_is_known(const Input& in) { return *fault_of_turn(in).key == '\0'; }

FieldFault Design::open_turn(const Input& in) {
  const TurnFault fault = fault_of_turn(in);
  return {"seats." + std::string(fault.key), fault.message, fault.hint};
}

bool Design::torque_runs(const Input& in) { return torque_varies(in); }

Applies Design::tired(const Input& in) {
  return min(loaded(in), max(max(running(in), shown_by(varies(in))), load_varies(in)));
}

/// About z what drives has one sign, what is driven the other.
bool Design::forces_turn_alike(const Input& in) {
  for (std::size_t i = 0; i < positions_of(in); ++i) {
    double sense = 0.0;
    for (const Seat& seat : in.seats) {
      const double way = (seat.way == Way::drives ? 1.0 : -1.0) * (in_si(seat.T.at(i)) < 0.0 ? -1.0 : 1.0);
      const double made = in_si(seat.F_y.at(i)) * in_si(seat.x_w) * way;
      if (made == 0.0 || seat.way == Way::balances) continue;
      if (made * sense < 0.0) return false;
      sense = made > 0.0 ? 1.0 : -1.0;
    }
  }
  return true;
}

bool Design::turn_alike(const Input& in) {
  const auto has_speed = [](const Seat& seat) { return is_set(seat.n); };
  const auto first = std::find_if(in.seats.begin(), in.seats.end(), has_speed);
  return std::none_of(first, in.seats.end(), [&](const Seat& s) { return in_si(first->n) * in_si(s.n) < 0.0; });
}

Applies Design::weighed(const Input& in) {
  if (is_set(in.g_angle)) return Applies::no;
  return shown_by(std::any_of(in.seats.begin(), in.seats.end(), [](const Seat& s) { return s.mass > 0.0 * kg.one; }));
}

Applies Design::abuts(const Input& in) {
  return where(std::any_of(in.notches.begin(), in.notches.end(), [](const Notched& n) { return is_set(n.h); }));
}

Applies Design::thin_wall(const Input& in) {
  Applies applies = Applies::no;
  for (const Piece& p : in.pieces) applies = std::max(applies, thin_wall_of(p.d, unset<double>, p.d_bore));
  return applies;
}

bool Design::treated_thick(const Input& in) {
  return std::none_of(in.pieces.begin(), in.pieces.end(), [&](const Piece& p) { return in.d_h < p.d; });
}

}  // namespace loadpath::shaft
