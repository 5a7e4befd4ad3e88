// Gears of two shafts: an idler, pairs side by side, and gears that reach into what is next to their mates.
#include "tests/found/modes.hpp"

#include <algorithm>
#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string twice = "z_1 = 20\nz_2 = 40";

std::string pair_with(const std::string& name, const std::string& teeth, const std::string& m_n = "3 mm",
                      const std::string& load = "T_1 = \"30 N*m\"\nn_1 = \"730 rpm\"\n") {
  return "[" + name + "]\ncalculator = \"gear.pair\"\n" + teeth + "\nm_n = \"" + m_n + "\"\nb = \"30 mm\"\n" + load +
         "\n";
}

std::string shaft_with(const std::string& name, const std::string& seats, const std::string& d = "40 mm") {
  return "[" + name + "]\ncalculator = \"shaft.design\"\nmaterial = \"16MnCr5\"\nR_e = \"440 MPa\"\n" +
         "group = \"carbon-steel\"\npieces = [{ name = \"middle\", l = \"300 mm\", d = \"" + d + "\" }]\n" +
         "supports = [{ name = \"left\", x = \"15 mm\", holds = \"both\" }, { name = \"right\", x = \"220 mm\" }]\n" +
         "seats = [\n" + seats + "]\nS_F = 1.5\nS_D = 1.5\nr_T = 0\n\n";
}

std::string gear_at(const std::string& name, const std::string& x, const std::string& gear, const std::string& more) {
  return "  { name = \"" + name + "\", x = \"" + x + "\", load = \"=" + gear + "\", integral = true, " + more + " },\n";
}

/// Two pairs of one ratio between two shafts; `x` of gear 2 of the second pair, and its module.
std::string two_pairs(const std::string& x, const std::string& m_n) {
  const std::string coupling = "  { name = \"coupling\", x = \"280 mm\", way = \"balances\" },\n";
  return pair_with("first", twice) + pair_with("second", twice, m_n) +
         shaft_with("upper", gear_at("a", "60 mm", "first.gear_1", "way = \"takes\"") +
                                 gear_at("b", "160 mm", "second.gear_1", "way = \"takes\"") + coupling) +
         shaft_with("lower", gear_at("a", "60 mm", "first.gear_2", "way = \"drives\"") +
                                 gear_at("b", x, "second.gear_2", "way = \"drives\"") + coupling);
}

/// A pinion, an idler and a wheel; `x` of the second mesh on the shaft of the idler.
std::string idler_with(const std::string& x) {
  const std::string coupling = "  { name = \"coupling\", x = \"280 mm\", way = \"balances\" },\n";
  return pair_with("first", "z_1 = 21\nz_2 = 40") +
         "[second]\ncalculator = \"gear.pair\"\nz_1 = \"=first.z_2\"\nz_2 = 45\nm_n = \"3 mm\"\nb = \"30 mm\"\n"
         "T_1 = \"=first.T_2\"\nn_1 = \"=first.n_2\"\n\n" +
         shaft_with("driver", gear_at("pinion", "80 mm", "first.gear_1", "way = \"takes\"") + coupling) +
         shaft_with("idler", gear_at("in", "80 mm", "first.gear_2", "way = \"drives\", angle = \"180 deg\"") +
                                 gear_at("out", x, "second.gear_1", "way = \"takes\", angle = \"0 deg\"")) +
         shaft_with("driven", gear_at("wheel", "80 mm", "second.gear_2", "way = \"drives\"") + coupling);
}

/// Whether a mode waits for a reason with these words.
bool waits(const std::string& text, const std::string& words) {
  const auto modes = project::modes(solved_as_found(text));
  return std::any_of(modes.begin(), modes.end(),
                     [&](const account::Mode& mode) { return mode.note.text().find(words) != std::string::npos; });
}

}  // namespace

TEST_SUITE("found space") {
  TEST_CASE("an idler is one gear with two meshes; two gears at one place are not") {
    CHECK(mode_of(solved_as_found(idler_with("80 mm")), "idler", "assembly") == "none");
    CHECK_FALSE(waits(idler_with("80 mm"), "apart"));
    CHECK_FALSE(waits(idler_with("80 mm"), "collide"));
    CHECK(mode_of(solved_as_found(idler_with("95 mm")), "idler", "assembly") == "not-judged");
  }

  TEST_CASE("pairs between two shafts have one centre distance, and gears that face each other") {
    CHECK_FALSE(waits(two_pairs("160 mm", "3 mm"), "apart"));
    CHECK(waits(two_pairs("160 mm", "4 mm"), "and their centre distances are 90 mm and 120 mm"));
    CHECK(waits(two_pairs("150 mm", "3 mm"), "are 100 mm apart on 'upper' and 90 mm on 'lower'"));
  }

  TEST_CASE("a gear that reaches into the shaft of its mate's neighbour") {
    const std::string pair = pair_with("first", twice) + pair_with("third", "z_1 = 18\nz_2 = 60", "3 mm",
                                                                   "T_1 = \"=first.T_2\"\nn_1 = \"=first.n_2\"\n");
    const std::string shafts =
        shaft_with("middle", gear_at("wheel", "60 mm", "first.gear_2", "way = \"drives\", angle = \"180 deg\"") +
                                 gear_at("pinion", "160 mm", "third.gear_1", "way = \"takes\", angle = \"0 deg\"")) +
        shaft_with("out",
                   gear_at("wheel", "160 mm", "third.gear_2", "way = \"drives\"") +
                       "  { name = \"coupling\", x = \"280 mm\", way = \"balances\" },\n",
                   "120 mm");
    CHECK(
        waits(pair + shafts, "gear 2 of 'first' and segment 'middle' of 'out', diameters 126 mm and 120 mm, collide"));
  }
}
