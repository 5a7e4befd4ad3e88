// A train of drives, one behind the other: gears, belts with slip, chains, worms, planetary sets.
//
// Decides the ratio, speed, torque and power of every shaft, the efficiency of the whole, whether it reduces or
// multiplies, and what the wheels on each shaft pull: T_k = T_1 i eta over the stages before. Loads are nominal: the
// service factor belongs to the part that is designed with them. An efficiency that is left out is 1,
// of a belt 1 - slip: the slip lowers the speed, not the ratio of the torques. Given, it contains the slip.
// Signs: torque and speed of a shaft are positive in the sense of the first one; a stage's ratio is negative where it
// turns its second shaft the other way. Not covered: branches, power that circulates, losses of bearings.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::drive {

struct Train {
  static constexpr auto id = "drive.train";
  static constexpr auto title = "Train of drives";
  static constexpr auto scope =
      "Ratio, speeds, torques, powers and efficiencies through any chain of stages: gears, belts with slip, chains, "
      "worms, planetary sets; what every shaft carries. Branched trains are not covered.";
  static constexpr auto source = "[B40]";
  static constexpr auto example = R"([project]
title = "Drive of a conveyor"

[conveyor]
calculator = "drive.train"
P = "5.5 kW"
n_1 = "1450 rpm"
stages = [
  { name = "belt", kind = "belt", d_1 = "125 mm", d_2 = "315 mm", slip = 0.015, eta = 0.95 },
  { name = "gears", kind = "gear", z_1 = 20, z_2 = 80, m_n = "3 mm", eta = 0.97 },
  { name = "chain", kind = "chain", z_1 = 21, z_2 = 57, p = "25.4 mm", eta = 0.96 },
]
)";

  enum class StageKind { gear, internal, belt, chain, worm, planetary, other };
  enum class Member { sun, carrier, ring };
  enum class Sense { usual, same, opposite };
  enum class EtaRange { usual, below, above, none };
  enum class Works { reducer, multiplier, neither };

  static constexpr std::size_t most_stages = 12;

  struct Stage {
    Name name;
    StageKind kind = StageKind::gear;
    double i = unset<double>;
    Whole z_1 = 0, z_2 = 0;
    Length d_1 = unset<Length>, d_2 = unset<Length>;
    double slip = 0.0;
    Length m_n = unset<Length>, p = unset<Length>;
    double beta = 0.0;
    Whole z_s = 0, z_r = 0;
    Member in = Member::sun, out = Member::carrier;
    double eta = unset<double>;
    Sense sense = Sense::usual;

    [[nodiscard]] bool has_teeth() const { return z_1 > 0 && z_2 > 0; }

    static constexpr Fields fields{
        NameField{&Stage::name, "name", "name of the stage"}.may_be_missing(),
        Choice{&Stage::kind, "kind", "kind of drive"},
        Field{&Stage::i, "i", ratio,
              "ratio of speeds, first over second shaft, slip included; in place of teeth or diameters"}
            .positive()
            .usually(0.05, 100)
            .may_be_missing(),
        Count{&Stage::z_1, "z_1", 0, 5000, "teeth on the first shaft, or threads of the worm"}.may_be_missing(),
        Count{&Stage::z_2, "z_2", 0, 5000, "teeth on the second shaft"}.may_be_missing(),
        Field{&Stage::d_1, "d_1", mm, "diameter on the first shaft"}.positive().may_be_missing(),
        Field{&Stage::d_2, "d_2", mm, "diameter on the second shaft"}.positive().may_be_missing(),
        Field{&Stage::slip, "slip", ratio, "slip of a belt; 0.01 to 0.02 is usual"}.within(0, 0.1).usually(0, 0.03),
        Field{&Stage::m_n, "m_n", mm, "normal module of gears, for their force"}.positive().may_be_missing(),
        Field{&Stage::p, "p", mm, "pitch of a chain, for its pull"}.positive().may_be_missing(),
        Field{&Stage::beta, "beta", deg, "helix angle of gears, for their force"}.within(0, 45),
        Count{&Stage::z_s, "z_s", 0, 5000, "teeth of the sun"}.may_be_missing(),
        Count{&Stage::z_r, "z_r", 0, 5000, "teeth of the ring"}.may_be_missing(),
        Choice{&Stage::in, "in", "member of the planetary set on the first shaft"}.may_be_missing(),
        Choice{&Stage::out, "out", "member of the planetary set on the second shaft; the third is held"}
            .may_be_missing(),
        Field{&Stage::eta, "eta", ratio,
              "efficiency; of a planetary set the basic one, carrier at rest; missing: no losses"}
            .within(0.01, 1)
            .may_be_missing(),
        Choice{&Stage::sense, "sense", "sense of rotation of the second shaft"}.may_be_missing()};
  };

  struct Input {
    Power P = unset<Power>;
    Moment T_1 = unset<Moment>;
    AngularSpeed n_1 = unset<AngularSpeed>;
    List<Stage, most_stages> stages;
  };
  static bool ratios_known(const Input& in);
  static FieldFault open_ratio(const Input& in);
  static bool ratios_single(const Input& in);
  static FieldFault double_ratio(const Input& in);
  static bool slips_fit(const Input& in);
  static FieldFault wrong_slip(const Input& in);
  static bool members_differ(const Input& in);
  static FieldFault same_member(const Input& in);
  static constexpr Fields inputs{
      Field{&Input::P, "P", kW, "power that enters, with n_1"}.load().positive().may_be_missing(),
      Field{&Input::T_1, "T_1", N_m, "torque that enters, in place of P"}.load().positive().may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of the first shaft"}.positive().may_be_missing(),
      ListField{&Input::stages, "stages", "stages from the motor to the machine"}};

  struct StageResult {
    double i = unset<double>, eta = unset<double>, eta_low = unset<double>, eta_high = unset<double>;
    EtaRange range = EtaRange::none;
    Moment T_h = unset<Moment>;
    Power P_loss = unset<Power>;
    double x_eta = unset<double>;
    static constexpr Fields fields{
        Field{&StageResult::i, "i", ratio, "ratio, negative where the sense of rotation changes"},
        Field{&StageResult::eta, "eta", ratio, "efficiency"},
        Field{&StageResult::eta_low, "eta_low", ratio, "lowest usual efficiency of such a stage"},
        Field{&StageResult::eta_high, "eta_high", ratio, "highest usual efficiency of such a stage"},
        Choice{&StageResult::range, "range", "the efficiency against what is usual"},
        Field{&StageResult::T_h, "T_h", N_m, "torque of the housing on the foundation"}.load(),
        Field{&StageResult::P_loss, "P_loss", kW, "power that is lost"},
        Field{&StageResult::x_eta, "x_eta", ratio, "efficiency of a worm over the highest usual one; missing, it is 1"}
            .limit(0, 1)
            .where_it_applies()};
  };
  struct Shaft {
    AngularSpeed n = unset<AngularSpeed>;
    Moment T = unset<Moment>;
    Power P = unset<Power>;
    Force F_in = unset<Force>, F_out = unset<Force>;
    static constexpr Fields fields{
        Field{&Shaft::n, "n", rpm, "speed, signed"},
        Field{&Shaft::T, "T", N_m, "torque that it carries, signed"}.load().with("F_in, F_out"),
        Field{&Shaft::P, "P", kW, "power"},
        Field{&Shaft::F_in, "F_in", N, "tangential force on its driven wheel"}.load().with("T, F_out"),
        Field{&Shaft::F_out, "F_out", N, "tangential force on its driving wheel"}.load().with("T, F_in")};
  };
  struct Result {
    double i = unset<double>, eta = unset<double>;
    Works works = Works::neither;
    Moment T_1 = unset<Moment>, T_out = unset<Moment>;
    AngularSpeed n_out = unset<AngularSpeed>;
    Power P_out = unset<Power>, P_loss = unset<Power>;
    List<StageResult, most_stages> stages;
    List<Shaft, most_stages + 1> shafts;
  };
  static constexpr Fields results{
      Field{&Result::i, "i", ratio, "ratio of the train, negative where the last shaft turns the other way"},
      Field{&Result::eta, "eta", ratio, "efficiency of the train"},
      Choice{&Result::works, "works", "what the train does to the speed"},
      Field{&Result::T_1, "T_1", N_m, "torque that enters"}.load(),
      Field{&Result::n_out, "n_out", rpm, "speed of the last shaft, signed"},
      Field{&Result::T_out, "T_out", N_m, "torque that leaves, signed"}.load(),
      Field{&Result::P_out, "P_out", kW, "power that leaves"},
      Field{&Result::P_loss, "P_loss", kW, "power that is lost"},
      ListField{&Result::stages, "stages", "stages"},
      ListField{&Result::shafts, "shafts", "shafts, the first to the last"}};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !in.stages.empty(); }, "stages", "give at least one stage"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.P) && is_set(in.T_1)); }, "P, T_1",
                  "give the load as P or as T_1, never both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.P) || is_set(in.n_1); }, "P, n_1",
                  "a power needs the speed n_1"},
      Rule<Input>{&ratios_known, "stages", "every stage needs a ratio: i, teeth, or diameters", &open_ratio},
      Rule<Input>{&ratios_single, "stages", "the ratio of a stage is given once", &double_ratio},
      Rule<Input>{&slips_fit, "stages", "slip belongs to a belt, and its efficiency contains it", &wrong_slip},
      Rule<Input>{&members_differ, "stages", "in and out of a planetary set are two members", &same_member}};

  static constexpr bool turns = true;
  static bool drives_a_worm(const Input& in);
  static Applies loads_a_worm(const Input& in);
  static constexpr std::array modes{
      Mode<Input>{"self_locking", "a worm that its wheel cannot drive",
                  [](const Input& in) { return where(drives_a_worm(in)); }}
          .of_shape(),
      Mode<Input>{"efficiency", "losses of the worm gear", &loads_a_worm}.judged_by("stages.x_eta"),
      Mode<Input>{"strength", "strength of the stages that no step takes",
                  [](const Input& in) { return is_set(in.P) || is_set(in.T_1) ? Applies::unseen : Applies::no; }}
          .assessed_beside("gear.pair, gear.planetary, chain.roller, belt.v, belt.flat"),
      Mode<Input>{"heat", "heat", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<draw::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Train::StageKind) {
  return std::array{
      ChoiceName<Train::StageKind>{Train::StageKind::gear, "gear", "wheels with outer teeth"},
      ChoiceName<Train::StageKind>{Train::StageKind::internal, "internal", "a wheel in a ring"},
      ChoiceName<Train::StageKind>{Train::StageKind::belt, "belt", "belt"},
      ChoiceName<Train::StageKind>{Train::StageKind::chain, "chain", "chain"},
      ChoiceName<Train::StageKind>{Train::StageKind::worm, "worm", "worm and wheel"},
      ChoiceName<Train::StageKind>{Train::StageKind::planetary, "planetary", "planetary set with one member held"},
      ChoiceName<Train::StageKind>{Train::StageKind::other, "other", "anything with a ratio"}};
}
constexpr auto choices_of(Train::Member) {
  using Member = Train::Member;
  return std::array{ChoiceName<Member>{Member::sun, "sun", "the sun"},
                    ChoiceName<Member>{Member::carrier, "carrier", "the carrier"},
                    ChoiceName<Member>{Member::ring, "ring", "the ring"}};
}
constexpr auto choices_of(Train::Sense) {
  using Sense = Train::Sense;
  return std::array{ChoiceName<Sense>{Sense::usual, "usual", "as the kind of drive has it"},
                    ChoiceName<Sense>{Sense::same, "same", "the same, as with an idler"},
                    ChoiceName<Sense>{Sense::opposite, "opposite", "the opposite, as with a crossed belt"}};
}
constexpr auto choices_of(Train::EtaRange) {
  return std::array{ChoiceName<Train::EtaRange>{Train::EtaRange::usual, "usual", "within what is usual"},
                    ChoiceName<Train::EtaRange>{Train::EtaRange::below, "below", "lower than usual"},
                    ChoiceName<Train::EtaRange>{Train::EtaRange::above, "above", "higher than usual"},
                    ChoiceName<Train::EtaRange>{Train::EtaRange::none, "none", "no usual range is known"}};
}
constexpr auto choices_of(Train::Works) {
  using Works = Train::Works;
  return std::array{ChoiceName<Works>{Works::reducer, "reducer", "a reducer: the last shaft is slower"},
                    ChoiceName<Works>{Works::multiplier, "multiplier", "a multiplier: the last shaft is faster"},
                    ChoiceName<Works>{Works::neither, "neither", "neither: both shafts are equally fast"}};
}

}  // namespace loadpath::drive
