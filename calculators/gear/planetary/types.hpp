// Input and result of gear.planetary.
#pragma once

#include "calculators/gear/planetary/mesh_of_set.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>

namespace loadpath::gear {

/// The sun as a shaft that carries it sees it, input record of its connection: load = "=set.gear_s". Planets that share
/// the load evenly leave no transverse force.
struct SunLoad {
  Moment T = unset<Moment>;
  AngularSpeed n = unset<AngularSpeed>;
  Length d_f = unset<Length>, h_t = unset<Length>;

  static constexpr Fields fields{Field{&SunLoad::T, "T", N_m, "external torque on the sun, magnitude"}.load(),
                                 Field{&SunLoad::n, "n", rpm, "speed of the sun, signed"},
                                 Field{&SunLoad::d_f, "d_f", mm, "root diameter of the sun"},
                                 Field{&SunLoad::h_t, "h_t", mm, "tooth depth of the sun"}};
};

struct PlanetaryTypes {
  enum class Member { ring, carrier, sun, none };
  enum class Spacing { even, uneven };
  enum class Coaxial { exact, by_shift, none };

  struct Input {
    Whole z_s = 0, z_p = 0, z_r = 0;
    Whole N_p = 3;
    Member fixed = Member::ring;
    AngularSpeed n_s = unset<AngularSpeed>, n_c = unset<AngularSpeed>, n_r = unset<AngularSpeed>;
    Moment T_s = unset<Moment>, T_c = unset<Moment>, T_r = unset<Moment>;
    double eta_0 = unset<double>;
    double h_aP = 1.0, x_s = 0.0, x_p = 0.0, h_ar = unset<double>;
    Length m_n = unset<Length>;
    double beta = 0.0;
    double K_gamma = 1.0;
  };
  /// As given, or what brings sun, planets and ring to one axis.
  static Whole ring_teeth(const Input& in) { return in.z_r > 0 ? in.z_r : Whole(in.z_s + 2 * in.z_p); }
  static bool evenly_spaced(const Input& in) { return Whole(in.z_s + ring_teeth(in)) % static_cast<int>(in.N_p) == 0; }

  struct Result {
    double z_r = unset<double>;
    double i_0 = unset<double>, i = unset<double>;
    AngularSpeed n_s = unset<AngularSpeed>, n_c = unset<AngularSpeed>, n_r = unset<AngularSpeed>;
    AngularSpeed n_p = unset<AngularSpeed>, n_pc = unset<AngularSpeed>;
    Moment T_s = unset<Moment>, T_c = unset<Moment>, T_r = unset<Moment>;
    Power P_s = unset<Power>, P_c = unset<Power>, P_r = unset<Power>, P_w = unset<Power>;
    Power P_in = unset<Power>, P_loss = unset<Power>;
    double eta = unset<double>;
    Force F_t = unset<Force>;
    double q = unset<double>;
    Spacing spacing = Spacing::even;
    double phi_2 = unset<double>;
    Coaxial coaxial = Coaxial::exact;
    double z_gap = unset<double>;
    double u_N = unset<double>;
    double f_sp = unset<double>, f_pr = unset<double>, eps_sp = unset<double>, eps_pr = unset<double>;
    double x_free = unset<double>, h_clear = unset<double>, c_a = unset<double>, s_a = unset<double>;
    MeshOfSet sun_mesh, ring_mesh;
    SunLoad gear_s;
  };
};

constexpr auto choices_of(PlanetaryTypes::Member) {
  using Member = PlanetaryTypes::Member;
  return std::array{ChoiceName<Member>{Member::ring, "ring", "the ring"},
                    ChoiceName<Member>{Member::carrier, "carrier", "the carrier"},
                    ChoiceName<Member>{Member::sun, "sun", "the sun"},
                    ChoiceName<Member>{Member::none, "none", "none: a differential"}};
}
constexpr auto choices_of(PlanetaryTypes::Spacing) {
  using Spacing = PlanetaryTypes::Spacing;
  return std::array{ChoiceName<Spacing>{Spacing::even, "even", "evenly"},
                    ChoiceName<Spacing>{Spacing::uneven, "uneven", "uneven: (z_s + z_r)/N_p is not an integer"}};
}
constexpr auto choices_of(PlanetaryTypes::Coaxial) {
  using Coaxial = PlanetaryTypes::Coaxial;
  return std::array{
      ChoiceName<Coaxial>{Coaxial::exact, "exact", "without profile shift: z_r = z_s + 2 z_p"},
      ChoiceName<Coaxial>{Coaxial::by_shift, "by_shift", "only by profile shift: z_r differs from z_s + 2 z_p"},
      ChoiceName<Coaxial>{Coaxial::none, "none", "not at all: z_r is too far from z_s + 2 z_p for profile shift"}};
}

}  // namespace loadpath::gear
