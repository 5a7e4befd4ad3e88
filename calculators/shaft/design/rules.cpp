// Rules of shaft.design beyond the bounds of its fields; of notches in notch_rules.cpp.
#include "calculators/shaft/design/design.hpp"
#include "calculators/shaft/design/model/bending.hpp"
#include "calculators/shaft/design/model/places.hpp"
#include "calculators/shaft/design/model/positions.hpp"
#include "calculators/shaft/design/torsion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;

constexpr double apart = 1e-4;  // share of the length: closer bearings are one bearing

/// "'coupling' and 'gear'": components with a torque that drive, or that are driven.
std::string twisted_by(const Input& in, Way way) {
  std::string names;
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    if (!is_set(in.seats[i].T) || in.seats[i].way != way) continue;
    const Name& name = in.seats[i].name;
    const std::string one = name.empty() ? "seats[" + std::to_string(i + 1) + "]" : std::string(name.view());
    names += (names.empty() ? "'" : " and '") + one + "'";
  }
  return names;
}

Message how_to_balance(const Input& in) {
  const std::string drive = twisted_by(in, Way::drives), take = twisted_by(in, Way::takes);
  if (drive.empty() && !take.empty())
    return say(
        "{1}: way = \"takes\"; write way = \"drives\" for the driving component, or way = \"balances\" for a coupling "
        "without T",
        take);
  if (take.empty() && !drive.empty())
    return say("{1}: way = \"drives\"; write way = \"takes\" for what is driven, or way = \"balances\" without T",
               drive);
  return say("correct T, or let one component balance the torque: way = \"balances\" without T");
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

/// The first bearing with its pressure centre beyond an end of the shaft; null if none.
const Support* first_floating(const Input& in) {
  const Length slack = one_place * length_of(in);
  const auto found = std::find_if(in.supports.begin(), in.supports.end(), [&](const Support& support) {
    const Length x = pressure_centre(support);
    return x < -slack || is_off(in, x);
  });
  return found == in.supports.end() ? nullptr : &*found;
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

/// The moment of a transverse force about the axis, at its point, is the torque, to the rounding of tables; an
/// accompanying axial force acts at the same place.
bool makes_its_torque(const Seat& seat, std::size_t position) {
  constexpr double rounding = 0.05;
  const Force F_y = seat.F_y.at(position), F_z = seat.F_z.at(position);
  const bool meshes = abs(F_y) > 0.0 * N.one && abs(F_z) > 0.0 * N.one;
  if (meshes && seat.x_w == 0.0 * mm) return false;
  const Moment made = abs(F_y * seat.x_w), T = is_set(seat.T) ? abs(seat.T.at(position)) : 0.0 * N_m.one;
  return made == 0.0 * N_m.one || seat.way == Way::balances || abs(made - T) <= rounding * max(made, T);
}

/// The first bearing on a taper that does not say so; null if none. At the ends of a taper a bearing can have a neck
/// of its own.
const Support* slipping(const Input& in) {
  const Length aside = 10.0 * one_place * length_of(in);
  for (const Support& support : in.supports) {
    const std::size_t i = index_of_piece(in, support.x);
    const bool inside = support.x > start_of(in, i) + aside && support.x < start_of(in, i + 1) - aside;
    if (inside && is_taper(in.pieces[i]) && support.on != On::taper) return &support;
  }
  return nullptr;
}

/// Fault of a mounted component as a rotating body; empty: none.
struct BodyFault {
  const char* key = "";
  Message message = {};
};
BodyFault fault_of_body(const Seat& s) {
  constexpr double rounding = 1.0 + 1e-6;
  const bool across = is_set(s.I_d) || is_set(s.b);
  if (across && !is_set(s.I_p)) return {"I_p", say("the moment of inertia about its axis is missing: give I_p")};
  if (is_set(s.I_p) && !across) return {"I_p", say("it turns about a diameter too: give I_d, or its width b")};
  if (is_set(s.I_d) && is_set(s.b)) return {"b", say("the width replaces I_d: give one of them")};
  if (s.I_p > rounding * 2.0 * s.I_d)
    return {"I_d", say("no body has a moment of inertia about a diameter below half of that about the axis")};
  if (!is_set(s.k_T) && s.I_p > rounding * s.J)
    return {"I_p", say("J includes everything that rotates with it, and this is only a part of that")};
  if (s.mass == 0.0 * kg.one && (s.I_p > 0.0 * kg_m2.one || s.I_d > 0.0 * kg_m2.one))
    return {"mass", say("a component with a moment of inertia needs a mass")};
  return {};
}

}  // namespace

bool Design::held(const Input& in) {
  for (std::size_t i = 0; i < in.supports.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Length between = pressure_centre(in.supports[i]) - pressure_centre(in.supports[k]);
      if (abs(between) <= apart * length_of(in)) return false;  // true if it is unknown
    }
  }
  return in.supports.size() > 1;
}

bool Design::stiff_enough(const Input& in) {
  const bool violates_others = !held(in) || !on_shaft(in) || !bores_fit(in) || !(is_set(in.E) && is_set(in.G));
  return violates_others || bears(in);  // by another rule
}

/// A rule without `pieces` among its fields, so that it is checked before diameters are searched for; where lengths
/// vary, `on_shaft` includes it.
bool Design::within_ends(const Input& in) {
  return !find_place(in, [&](const auto&, Length x) { return is_off(in, x); });
}

bool Design::on_shaft(const Input& in) { return within_ends(in) && first_floating(in) == nullptr; }

FieldFault Design::off_shaft(const Input& in) {
  FieldFault fault;
  if (const Support* const support = first_floating(in); support != nullptr && !is_off(in, support->x)) {
    return {place_of("supports", in.supports, static_cast<std::size_t>(support - in.supports.data()), "s_p"),
            say("the pressure centre at {1} is beyond the end of the shaft", format(pressure_centre(*support))),
            say("correct s_p, or lengthen the end of the shaft at the same diameter up to the pressure centre")};
  }
  find_place(in, [&](const auto& key, Length x) {
    if (!is_off(in, x)) return false;
    fault = {key(), say("{1} is beyond the end of the shaft at {2}", format(x), format(length_of(in))),
             say("x counts from the left end: correct it, or the lengths of the pieces")};
    return true;
  });
  return fault;
}

bool Design::bores_fit(const Input& in) {
  const bool within =
      std::all_of(in.pieces.begin(), in.pieces.end(), [](const Piece& p) { return p.d_bore < thinnest(p); });
  return within && !find_meeting(in, [](const Meeting& m) {
           return !(m.before.d_bore < m.after.d) || !(m.after.d_bore < right_diameter(m.before));
         });
}

bool Design::bearings_sit(const Input& in) { return slipping(in) == nullptr; }

FieldFault Design::slips(const Input& in) {
  const Support* const support = slipping(in);
  if (support == nullptr) return {};
  const Piece& taper = piece_at(in, support->x);
  return {place_of("supports", in.supports, static_cast<std::size_t>(support - in.supports.data()), "x"),
          say("at {1} the shaft tapers from {2} to {3}, and bores of bearings are cylinders", format(support->x),
              format(taper.d), format(right_diameter(taper))),
          say("give the bearing a piece of its own; if its own bore is a taper, or it has a sleeve: on = \"taper\"")};
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
  if (count_balancing(in) > 1)
    return {"seats", say("more than one component balances the torque"), say("one is enough")};
  const bool typed = std::any_of(in.seats.begin(), in.seats.end(),
                                 [](const Seat& s) { return s.way == Way::balances && is_set(s.T); });
  const double sum = in_si(balance(in));
  if (!typed)
    return {"seats", say("the torques do not balance: {1} remains", format_quantity(sum, N_m.symbol, 4)),
            how_to_balance(in)};
  return {"seats", say("a balancing component must not have a given torque"), say("leave out its T")};
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

FieldFault Design::loose_thrust(const Input& in) {
  std::string names;
  std::size_t last = 0;
  for (std::size_t i = 0; i < in.supports.size(); ++i) {
    if (in.supports[i].holds != Holds::both) continue;
    const Name& name = in.supports[i].name;
    const std::string one = name.empty() ? "supports[" + std::to_string(i + 1) + "]" : std::string(name.view());
    names += (names.empty() ? "'" : " and '") + one + "'";
    last = i;
  }
  if (names.empty())
    return {"supports", say("exactly one bearing must take axial forces: holds = \"both\" is given for none"),
            say("write holds = \"both\" for one of the supports")};
  return {place_of("supports", in.supports, last, "holds"),
          say("only one bearing can be the locating bearing: holds = \"both\" is given for {1}", names),
          say("remove holds from all but one")};
}

bool Design::slopes_of_all(const Input& in) {
  const auto all_or_none = [](const auto& elements) {
    const auto given =
        std::count_if(elements.begin(), elements.end(), [](const auto& e) { return is_set(e.beta_adm); });
    return given == 0 || given == static_cast<std::ptrdiff_t>(elements.size());
  };
  return all_or_none(in.supports) && all_or_none(in.seats);
}

FieldFault Design::slope_missing(const Input& in) {
  FieldFault fault;
  const auto find_in = [&](const char* list, const auto& elements) {
    const auto has = [](const auto& e) { return is_set(e.beta_adm); };
    const auto with = std::find_if(elements.begin(), elements.end(), has);
    const auto without = std::find_if_not(elements.begin(), elements.end(), has);
    if (with == elements.end() || without == elements.end()) return;
    const auto named = [&](const Name& name) {
      return name.empty() ? std::string("one of the ") + list : "'" + std::string(name.view()) + "'";
    };
    fault = {place_of(list, elements, static_cast<std::size_t>(without - elements.begin()), "beta_adm"),
             say("{1} has no beta_adm, but {2} has", named(without->name), named(with->name)),
             say("give beta_adm of all {1} or of none", list)};
  };
  find_in("seats", in.seats);
  find_in("supports", in.supports);
  return fault;
}

bool Design::forces_make_torques(const Input& in) {
  for (std::size_t i = 0; i < positions_of(in); ++i) {
    if (!std::all_of(in.seats.begin(), in.seats.end(), [&](const Seat& s) { return makes_its_torque(s, i); }))
      return false;
  }
  return true;
}

/// The first component at the first position where its forces make another torque.
FieldFault Design::other_torque(const Input& in) {
  for (std::size_t i = 0; i < positions_of(in); ++i) {
    const auto seat = std::ranges::find_if(in.seats, [&](const Seat& s) { return !makes_its_torque(s, i); });
    if (seat == in.seats.end()) continue;
    const Moment made = abs(seat->F_y.at(i) * seat->x_w), T = is_set(seat->T) ? abs(seat->T.at(i)) : 0.0 * N_m.one;
    return {place_of("seats", in.seats, static_cast<std::size_t>(seat - in.seats.begin()), "F_y"),
            say("F_y x_w = {1}, but the torque is T = {2}", format_quantity(in_si(made), N_m.symbol, 4),
                format_quantity(in_si(T), N_m.symbol, 4)),
            say("x_w is the lever arm of a tooth force F_y: make F_y x_w = T; of a pulley or a sprocket give the pull "
                "as F_x and "
                "its torque as T, without F_y and x_w")};
  }
  return {};
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

/// Whether components with a direction (forces off the axis, which rotate with it, or a crank) rotate alike.
bool Design::turn_alike(const Input& in) {
  double sense = 0.0;
  for (const Seat& seat : in.seats) {
    if (!is_set(seat.n) || (seat.x_w == 0.0 * mm && !is_set(seat.psi))) continue;
    if (sense * in_si(seat.n) < 0.0) return false;
    sense = in_si(seat.n);
  }
  return true;
}

bool Design::discs_are_bodies(const Input& in) {
  return std::all_of(in.seats.begin(), in.seats.end(), [](const Seat& s) { return *fault_of_body(s).key == '\0'; });
}

FieldFault Design::no_body(const Input& in) {
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const BodyFault fault = fault_of_body(in.seats[i]);
    if (*fault.key != '\0') return {place_of("seats", in.seats, i, fault.key), fault.message, {}};
  }
  return {};
}

/// Point masses represent discs between bearings, where these hardly tilt in the first mode; not overhung, and not
/// next to components with given inertia.
Applies Design::bears_discs(const Input& in) {
  const auto is_point = [](const Seat& s) { return s.mass > 0.0 * kg.one && !is_set(s.I_p); };
  if (!is_set(speed_of(in)) || std::none_of(in.seats.begin(), in.seats.end(), is_point)) return Applies::no;
  const auto ends = std::minmax_element(in.supports.begin(), in.supports.end(),
                                        [](const Support& a, const Support& b) { return a.x < b.x; });
  return shown_by(std::any_of(in.seats.begin(), in.seats.end(), [&](const Seat& s) {
    return is_set(s.I_p) || (is_point(s) && (s.x < ends.first->x || s.x > ends.second->x));
  }));
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
  for (const Piece& p : in.pieces) applies = std::max(applies, thin_wall_of(thinnest(p), unset<double>, p.d_bore));
  return applies;
}

bool Design::treated_thick(const Input& in) {
  return std::none_of(in.pieces.begin(), in.pieces.end(), [&](const Piece& p) { return in.d_h < thickest(p); });
}

Applies Design::passes_resonance(const Input& in) { return resonance_on_the_way(in); }

}  // namespace loadpath::shaft
