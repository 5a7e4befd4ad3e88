// The flywheel that keeps a machine even: its moment of inertia for a given unevenness, from the moment over a cycle.
//
// The moment is that of the drive at constant speed, a series of a mechanism's cycle ("=press.drive.M"), a formula or
// points; it includes the inertia of the moving links, so that no reduced inertia is taken off again (R17). J_0
// rotates with the shaft at a constant ratio (rotor, pulley). The unevenness is (omega_max - omega_min)/omega. Not
// covered: the fall of the motor's moment with the speed, and the change of the links' inertia forces by it.
#pragma once

#include "calculators/machine/energy_of_turning.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/law_text.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::machine {

struct Flywheel {
  static constexpr auto id = "machine.flywheel";
  static constexpr auto title = "Flywheel sizing and motor power";
  static constexpr auto scope =
      "Moment of inertia of a flywheel for a required coefficient of speed fluctuation from the driving moment "
      "over a cycle, the fluctuation of a given flywheel, its speed limits and the mean motor power; periodic "
      "motion.";
  static constexpr auto source = "[Khurmi-16], [B36]";
  static constexpr auto headline = "J = {J}|J = {J_F}";
  static constexpr auto subject = "speed fluctuation";
  static constexpr auto synonyms =
      "flywheel, speed fluctuation, coefficient of fluctuation, degree of irregularity, cyclic irregularity, "
      "motor power, Schwungrad, Ungleichförmigkeitsgrad, Massenträgheitsmoment, маховик, "
      "коэффициент неравномерности хода";
  static constexpr auto example = R"toml([project]
title = "Flywheel of an engine"

[flywheel]
calculator = "machine.flywheel"
M_of_phi = "20 kN*m + 9.5 kN*m*sin(2*phi) - 5.7 kN*m*cos(2*phi)"
role = "drive"
omega = "180 rpm"
delta = 0.01
)toml";

  enum class Source { load, drive };
  enum class Work { absorbed, delivered, none };

  struct Point {
    double phi = unset<double>;
    Moment M = unset<Moment>;
    static constexpr Fields fields{Field{&Point::phi, "phi", deg, "angle, not falling from one to the next"},
                                   Field{&Point::M, "M", N_m, "moment; straight to the next point"}.load()};
  };
  static constexpr std::size_t most_points = 72;
  static constexpr std::size_t most_samples = 1440;
  using Samples = List<Sample, most_samples>;

  static constexpr Law::Variable angle{"phi", deg.dimension()};

  struct Input {
    Moment M = unset<Moment>;
    LawOf<N_m, angle> M_of_phi;
    List<Point, most_points> points;
    double period = 2.0 * pi;
    Source role = Source::load;
    AngularSpeed omega = unset<AngularSpeed>;
    double turns_per_turn = 1.0;
    double delta = unset<double>;
    MassMoment inertia = unset<MassMoment>, J_0 = 0.0 * kg_m2;
    double eta = 1.0;
    Power P_n = unset<Power>;
    Length D = unset<Length>;
    Speed v_adm = unset<Speed>;
    Samples series;  // samples of M, filled by the step; not a field
  };
  static constexpr Fields inputs{
      Field{&Input::M, "M", N_m, "moment over a cycle, a series: \"=press.drive.M\""}.load().may_be_missing(),
      FormulaField{&Input::M_of_phi, "M_of_phi", "moment as a formula of the angle phi, in place of the series"}
          .load()
          .may_be_missing(),
      ListField{&Input::points, "points", "moment by points over one period, in place of the series"}
          .as_arrays()
          .may_be_missing(),
      Field{&Input::period, "period", deg, "period of the formula or the points; 720° of a four-stroke engine"}
          .positive()
          .usually(10, 7200),
      Choice{&Input::role, "role", "origin of the moment: load or drive"}.may_be_missing(),
      Field{&Input::omega, "omega", rad_per_s, "mean angular velocity"}.positive().usually(0.1, 1e4),
      Field{&Input::turns_per_turn, called("ratio"), ratio,
            "speed of this shaft over that of the crank over whose angle the series M is given; M is of this shaft"}
          .positive()
          .usually(0.01, 100),
      Field{&Input::delta, "delta", ratio, "permissible coefficient of speed fluctuation (omega_max - omega_min)/omega"}
          .positive()
          .below(2)
          .usually(1e-4, 0.3)
          .customarily_at_most(0.3)
          .may_be_missing(),
      Field{&Input::inertia, called("J"), kg_m2, "moment of inertia of a given flywheel"}.positive().may_be_missing(),
      Field{&Input::J_0, "J_0", kg_m2, "moment of inertia rotating at a constant ratio, reduced to the shaft"}.at_least(
          0),
      Field{&Input::eta, "eta", ratio, "efficiency between the motor and the shaft"}.within(0.01, 1),
      Field{&Input::P_n, "P_n", W, "rated power of the motor"}.positive().may_be_missing(),
      Field{&Input::D, "D", mm, "mean diameter of the rim, for its mass"}.positive().may_be_missing(),
      Field{&Input::v_adm, "v_adm", m_per_s, "allowable speed of the rim"}
          .customarily_at_most(100)
          .positive()
          .may_be_missing()};

  struct Result {
    Moment M_m = unset<Moment>, M_peak = unset<Moment>, A = unset<Moment>;
    Work work = Work::none;
    Moment E_low = unset<Moment>, E_high = unset<Moment>, Delta_E = unset<Moment>;
    double phi_fast = unset<double>, phi_slow = unset<double>;
    MassMoment J_F = unset<MassMoment>, J_add = unset<MassMoment>;
    double delta_is = unset<double>;
    AngularSpeed n_max = unset<AngularSpeed>, n_min = unset<AngularSpeed>;
    Power P_m = unset<Power>, P = unset<Power>;
    Mass m_rim = unset<Mass>;
    Speed v_rim = unset<Speed>;
    double u_delta = unset<double>, u_P = unset<double>, u_v = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::M_m, "M_m", N_m, "mean moment over the angle"},
      Field{&Result::M_peak, "M_peak", N_m, "maximum magnitude of the moment; of a series, of its positions"}.load(),
      Field{&Result::A, "A", J, "work over the period"},
      Choice{&Result::work, "work", "sign of the work over the period"},
      Field{&Result::E_low, "E_low", J, "minimum work of the moment beyond its mean, from the start"},
      Field{&Result::E_high, "E_high", J, "maximum work of the moment beyond its mean"},
      Field{&Result::Delta_E, "Delta_E", J, "energy absorbed and released by the flywheel"},
      Field{&Result::phi_fast, "phi_fast", deg, "angle of the maximum speed"},
      Field{&Result::phi_slow, "phi_slow", deg, "angle of the minimum speed"},
      Field{&Result::J_F, "J_F", kg_m2, "moment of inertia required for delta, on this shaft"},
      Field{&Result::J_add, "J_add", kg_m2, "of the flywheel itself, in addition to J_0; zero if J_0 suffices"},
      Field{&Result::delta_is, "delta_is", ratio,
            "coefficient of speed fluctuation with the given flywheel, or with J_F"},
      Field{&Result::n_max, "n_max", rpm, "maximum speed"},
      Field{&Result::n_min, "n_min", rpm, "minimum speed"},
      Field{&Result::P_m, "P_m", W, "mean power at the shaft; none without net work"},
      Field{&Result::P, "P", W, "mean power of the motor or of the driven machine"},
      Field{&Result::m_rim, "m_rim", kg, "mass of a rim with the required inertia"},
      Field{&Result::v_rim, "v_rim", m_per_s, "speed of the rim"},
      Field{&Result::u_delta, "u_delta", ratio,
            "speed fluctuation with the given flywheel, or with J_F: calculated / permissible"}
          .check(),
      Field{&Result::u_P, "u_P", ratio, "mean power over the rated power of the motor"}.check("P_n"),
      Field{&Result::u_v, "u_v", ratio, "speed of the rim over the allowable one"}.check("v_adm")};

  static bool has_one_moment(const Input& in);
  static bool law_reads(const Input& in);
  static FieldFault law_fault(const Input& in);
  static bool law_repeats(const Input& in);
  static FieldFault law_leap(const Input& in);
  static bool points_rise(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{&has_one_moment, "M, M_of_phi, points",
                  "give the torque over the cycle once: as a series M, as M_of_phi, or as points"},
      Rule<Input>{&law_reads, "M_of_phi, period", "M_of_phi must be a moment as a formula of phi", &law_fault},
      Rule<Input>{&law_repeats, "M_of_phi, period", "the moment must repeat after its period", &law_leap, true},
      Rule<Input>{&points_rise, "points, period",
                  "points need two or more angles, none below the one before, and all within one period"},
      Rule<Input>{[](const Input& in) { return is_set(in.delta) || is_set(in.inertia); }, "delta, J",
                  "give the permissible speed fluctuation delta, or the inertia J of the flywheel, or both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.inertia) || is_set(in.delta); }, "J, delta",
                  "a given flywheel is assessed by the permissible speed fluctuation delta: give it too"},
      Rule<Input>{[](const Input& in) { return !is_set(in.v_adm) || is_set(in.D); }, "v_adm, D",
                  "the speed of the rim needs its diameter D"}};

  static constexpr bool turns = true;
  static constexpr std::array meanings{Meaning{"M_m", "mean"}, Meaning{"ratio", ratio_of_speeds},
                                       Meaning{"J", inertia_of_flywheel}};

  static constexpr std::array modes{
      Mode<Input>{"unevenness", "speed fluctuation", &always<Input>}.of_service().judged_by("u_delta"),
      Mode<Input>{"motor", "motor power rating", &always<Input>}.of_service().judged_by("u_P"),
      Mode<Input>{"bursting", "rim bursting", [](const Input& in) { return shown_by(is_set(in.D)); }}
          .judged_by("u_v")
          .wanting("D, v_adm"),
      Mode<Input>{"period", "validity: period of the moment",
                  [](const Input& in) { return where(!in.M_of_phi.empty() && !law_repeats(in)); }}
          .advising("give the period after which the moment repeats")
          .of_shape(),
      Mode<Input>{"overspeed", "rim bursting at load rejection", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Flywheel::Source) {
  using S = Flywheel::Source;
  return std::array{ChoiceName<S>{S::load, "load", "moment required from the motor; the motor moment is constant"},
                    ChoiceName<S>{S::drive, "drive", "moment of an engine; constant load"}};
}
constexpr auto choices_of(Flywheel::Work) {
  using Word = Flywheel::Work;
  return std::array{ChoiceName<Word>{Word::absorbed, "absorbed", "the shaft has to be driven"},
                    ChoiceName<Word>{Word::delivered, "delivered", "the shaft drives"},
                    ChoiceName<Word>{Word::none, "none", "no net work over the period: no mean power"}};
}

}  // namespace loadpath::machine
