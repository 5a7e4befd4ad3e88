// Input and result of drive.train.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>

namespace loadpath::drive {

struct TrainTypes {
  enum class StageKind { gear, internal, bevel, belt, chain, worm, crossed, planetary, other };
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
        Choice{&Stage::kind, "kind", "drive type"},
        Field{&Stage::i, "i", ratio, "speed ratio, first / second shaft, slip included; replaces teeth or diameters"}
            .positive()
            .usually(0.05, 100)
            .may_be_missing(),
        Count{&Stage::z_1, "z_1", 0, 5000, "number of teeth on the first shaft, or of worm threads"}.may_be_missing(),
        Count{&Stage::z_2, "z_2", 0, 5000, "number of teeth on the second shaft"}.may_be_missing(),
        Field{&Stage::d_1, "d_1", mm, "diameter on the first shaft"}.positive().may_be_missing(),
        Field{&Stage::d_2, "d_2", mm, "diameter on the second shaft"}.positive().may_be_missing(),
        Field{&Stage::slip, "slip", ratio, "slip of a belt; 0.01 to 0.02 is usual"}.within(0, 0.1).usually(0, 0.03),
        Field{&Stage::m_n, "m_n", mm, "normal module of gears (bevel gears: outer module), for the tooth force"}
            .positive()
            .may_be_missing(),
        Field{&Stage::p, "p", mm, "chain pitch, for the chain pull"}.positive().may_be_missing(),
        Field{&Stage::beta, "beta", deg, "helix angle of gears, for the tooth force"}.within(0, 45),
        Count{&Stage::z_s, "z_s", 0, 5000, "number of teeth of the sun"}.may_be_missing(),
        Count{&Stage::z_r, "z_r", 0, 5000, "number of teeth of the ring gear"}.may_be_missing(),
        Choice{&Stage::in, "in", "member of the planetary set on the first shaft"}.may_be_missing(),
        Choice{&Stage::out, "out", "member of the planetary set on the second shaft; the third is fixed"}
            .may_be_missing(),
        Field{&Stage::eta, "eta", ratio,
              "efficiency (planetary set: basic efficiency, carrier at rest); omitted: no losses"}
            .within(0.01, 1)
            .may_be_missing(),
        Choice{&Stage::sense, "sense", "direction of rotation of the second shaft"}.may_be_missing()};
  };

  struct Input {
    Power P = unset<Power>;
    Moment T_1 = unset<Moment>;
    AngularSpeed n_1 = unset<AngularSpeed>;
    List<Stage, most_stages> stages;
  };

  struct StageResult {
    double i = unset<double>, eta = unset<double>, eta_low = unset<double>, eta_high = unset<double>;
    EtaRange range = EtaRange::none;
    Moment T_h = unset<Moment>;
    Power P_loss = unset<Power>;
    double x_eta = unset<double>;
    static constexpr Fields fields{
        Field{&StageResult::i, "i", ratio, "ratio, negative for opposite direction of rotation"},
        Field{&StageResult::eta, "eta", ratio, "efficiency"},
        Field{&StageResult::eta_low, "eta_low", ratio, "lowest usual efficiency of such a stage"},
        Field{&StageResult::eta_high, "eta_high", ratio, "highest usual efficiency of such a stage"},
        Choice{&StageResult::range, "range", "the efficiency against the usual range"},
        Field{&StageResult::T_h, "T_h", N_m, "reaction torque of the housing on the foundation"}.load(),
        Field{&StageResult::P_loss, "P_loss", kW, "power loss"},
        Field{&StageResult::x_eta, "x_eta", ratio, "worm efficiency / maximum usual efficiency (1 if omitted)"}
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
        Field{&Shaft::T, "T", N_m, "transmitted torque, signed"}.load().with("F_in, F_out"),
        Field{&Shaft::P, "P", kW, "power"},
        Field{&Shaft::F_in, "F_in", N, "tangential force on the driven wheel of the shaft"}.load().with("T, F_out"),
        Field{&Shaft::F_out, "F_out", N, "tangential force on the driving wheel of the shaft"}.load().with("T, F_in")};
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
};

constexpr auto choices_of(TrainTypes::StageKind) {
  return std::array{
      ChoiceName<TrainTypes::StageKind>{TrainTypes::StageKind::gear, "gear", "wheels with outer teeth"},
      ChoiceName<TrainTypes::StageKind>{TrainTypes::StageKind::internal, "internal", "a wheel in a ring"},
      ChoiceName<TrainTypes::StageKind>{TrainTypes::StageKind::bevel, "bevel", "bevel gears"},
      ChoiceName<TrainTypes::StageKind>{TrainTypes::StageKind::belt, "belt", "belt"},
      ChoiceName<TrainTypes::StageKind>{TrainTypes::StageKind::chain, "chain", "chain"},
      ChoiceName<TrainTypes::StageKind>{TrainTypes::StageKind::worm, "worm", "worm and wheel"},
      ChoiceName<TrainTypes::StageKind>{TrainTypes::StageKind::crossed, "crossed", "crossed helical gears"},
      ChoiceName<TrainTypes::StageKind>{TrainTypes::StageKind::planetary, "planetary",
                                        "planetary set with one member held"},
      ChoiceName<TrainTypes::StageKind>{TrainTypes::StageKind::other, "other", "anything with a ratio"}};
}
constexpr auto choices_of(TrainTypes::Member) {
  using Member = TrainTypes::Member;
  return std::array{ChoiceName<Member>{Member::sun, "sun", "the sun"},
                    ChoiceName<Member>{Member::carrier, "carrier", "the carrier"},
                    ChoiceName<Member>{Member::ring, "ring", "the ring"}};
}
constexpr auto choices_of(TrainTypes::Sense) {
  using Sense = TrainTypes::Sense;
  return std::array{ChoiceName<Sense>{Sense::usual, "usual", "as the kind of drive has it"},
                    ChoiceName<Sense>{Sense::same, "same", "the same, as with an idler"},
                    ChoiceName<Sense>{Sense::opposite, "opposite", "the opposite, as with a crossed belt"}};
}
constexpr auto choices_of(TrainTypes::EtaRange) {
  return std::array{ChoiceName<TrainTypes::EtaRange>{TrainTypes::EtaRange::usual, "usual", "within the usual range"},
                    ChoiceName<TrainTypes::EtaRange>{TrainTypes::EtaRange::below, "below", "lower than usual"},
                    ChoiceName<TrainTypes::EtaRange>{TrainTypes::EtaRange::above, "above", "higher than usual"},
                    ChoiceName<TrainTypes::EtaRange>{TrainTypes::EtaRange::none, "none", "no usual range is known"}};
}
constexpr auto choices_of(TrainTypes::Works) {
  using Works = TrainTypes::Works;
  return std::array{ChoiceName<Works>{Works::reducer, "reducer", "reducer: the last shaft is slower"},
                    ChoiceName<Works>{Works::multiplier, "multiplier", "speed increaser: the last shaft is faster"},
                    ChoiceName<Works>{Works::neither, "neither", "neither: equal speeds"}};
}

}  // namespace loadpath::drive
