#include "calculators/drive/train.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using StageKind = drive::Train::StageKind;

constexpr auto solve = test::evaluated<drive::Train>;

using test::rel;

drive::Train::Stage stage(StageKind kind, double i, double eta) {
  drive::Train::Stage s;
  s.kind = kind, s.i = i, s.eta = eta;
  return s;
}

drive::Train::Input train(std::initializer_list<drive::Train::Stage> stages) {
  drive::Train::Input in;
  in.T_1 = 30.0 * N_m, in.n_1 = 1000.0 * rpm;
  for (const auto& s : stages) in.stages.push_back(s);
  return in;
}

bool says(const std::string& stages, const std::string& part) {
  std::vector<Issue> issues;
  project::read_project("[g]\ncalculator = \"drive.train\"\nT_1 = \"5 N*m\"\nstages = [" + stages + "]\n", "g.toml",
                        catalogue(), issues);
  std::string all;
  for (const Issue& i : issues) all += i.key + ": " + i.message.text() + " | " + i.hint.text() + "\n";
  CAPTURE(all);
  const bool found = all.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("drive train") {
  TEST_CASE("ratios and efficiencies multiply: the worked case of [B40]") {
    const auto r = solve(train({stage(StageKind::chain, 2.5, 0.96), stage(StageKind::other, 4.0, 0.97)}));
    CHECK(rel(r.i, 10.0) < 1e-15);
    CHECK(rel(r.eta, 0.9312) < 1e-14);
    CHECK(rel(in_si(r.T_out), 279.36) < 1e-14);
    CHECK(r.works == drive::Train::Works::reducer);
  }

  TEST_CASE("two stages of 3:1 turn 1750 rpm, 10 N m into 194 rpm, 90 N m, in the same direction (rulesofthumb.info)") {
    drive::Train::Input in = train({});
    in.T_1 = 10.0 * N_m, in.n_1 = 1750.0 * rpm;
    drive::Train::Stage s;
    s.z_1 = 20, s.z_2 = 60;
    in.stages.push_back(s);
    s.z_1 = 15, s.z_2 = 45;
    in.stages.push_back(s);
    const auto r = solve(in);
    CHECK(std::abs(r.n_out / rpm - 194.4) < 0.05);
    CHECK(rel(in_si(r.T_out), 90) < 1e-14);
    CHECK(r.shafts[1].n < 0.0 * rpm);
  }

  TEST_CASE("slip lowers the speed behind a belt, not the torque") {
    drive::Train::Stage s;
    s.kind = StageKind::belt, s.d_1 = 125.0 * mm, s.d_2 = 315.0 * mm, s.slip = 0.015;
    const auto r = solve(train({s}));
    CHECK(rel(r.stages[0].i, 2.558375635) < 1e-9);
    CHECK(rel(r.n_out / rpm, 1000.0 / 2.558375635) < 1e-9);
    CHECK(rel(in_si(r.T_out), 30.0 * 2.52) < 1e-12);
    CHECK(rel(r.eta, 0.985) < 1e-12);
    CHECK(rel(in_si(r.shafts[0].F_out), 60.0 / 0.125) < 1e-14);
    CHECK(rel(in_si(r.shafts[1].F_in), in_si(r.shafts[0].F_out)) < 1e-12);
  }

  TEST_CASE("bevel gears: the ratio is positive unless the direction is stated, the force is at the outer diameter") {
    drive::Train::Stage s;
    s.kind = StageKind::bevel, s.z_1 = 20, s.z_2 = 40, s.m_n = 4.0 * mm, s.eta = 0.96;
    auto r = solve(train({s}));
    CHECK(rel(r.i, 2.0) < 1e-14);
    CHECK(rel(in_si(r.shafts[0].F_out), 2 * 30.0 / 0.08) < 1e-14);
    CHECK(r.stages[0].range == drive::Train::EtaRange::usual);
    s.sense = drive::Train::Sense::opposite;
    CHECK(rel(solve(train({s})).i, -2.0) < 1e-14);
  }

  TEST_CASE("without losses the power is constant, and the losses of the stages are those of the train") {
    const auto r = solve(
        train({stage(StageKind::gear, 3, 0.97), stage(StageKind::worm, 20, 0.7), stage(StageKind::chain, 0.5, 0.95)}));
    CHECK(rel(in_si(r.P_out), 30.0 * 1000.0 * pi / 30.0 * r.eta) < 1e-12);
    Power sum = from_si<Power>(0.0);
    for (const auto& s : r.stages) sum += s.P_loss;
    CHECK(rel(in_si(sum), in_si(r.P_loss)) < 1e-12);
  }

  TEST_CASE("a planetary stage by Willis: ring held, sun to carrier, and the reverse as a speed-up drive") {
    drive::Train::Stage s;
    s.kind = StageKind::planetary, s.z_s = 24, s.z_r = 84, s.eta = 0.97;
    const auto r = solve(train({s}));
    CHECK(rel(r.i, 4.5) < 1e-14);
    CHECK(rel(r.eta, (1.0 + 3.5 * 0.97) / 4.5) < 1e-13);
    s.in = drive::Train::Member::carrier, s.out = drive::Train::Member::sun;
    CHECK(solve(train({s})).works == drive::Train::Works::multiplier);
    s.in = drive::Train::Member::sun, s.out = drive::Train::Member::ring;
    CHECK(rel(solve(train({s})).i, -3.5) < 1e-14);
  }

  TEST_CASE("an efficiency beyond the usual range gives a warning, not an error") {
    const auto r = solve(
        train({stage(StageKind::chain, 2, 0.96), stage(StageKind::chain, 2, 0.9), stage(StageKind::worm, 2, 0.97)}));
    CHECK(r.stages[0].range == drive::Train::EtaRange::usual);
    CHECK(r.stages[1].range == drive::Train::EtaRange::below);
    CHECK(r.stages[2].range == drive::Train::EtaRange::above);
  }

  TEST_CASE("wrong input is reported") {
    says("", "'stages' is empty");
    says("{ kind = \"gear\", z_1 = 20 }", "the ratio of this stage is not given");
    says("{ kind = \"crossed\", d_1 = \"40 mm\", d_2 = \"80 mm\" }", "the ratio of this stage is not given");
    says("{ kind = \"gear\", i = 2, z_1 = 20, z_2 = 40 }", "given more than once");
    says("{ kind = \"gear\", z_s = 20, z_r = 40, i = 3 }", "given more than once");
    says("{ kind = \"planetary\", z_s = 20, z_r = 60, out = \"sun\" }", "cannot enter and leave through one member");
    says("{ kind = \"belt\", i = -2 }", "must be > 0");
    says("{ kind = \"chain\", i = 2, slip = 0.01 }", "slip applies to belts only, and their efficiency includes it");
    says("{ kind = \"belt\", i = 2, slip = 0.05, eta = 0.97 }",
         "slip applies to belts only, and their efficiency includes it");
  }
}
