// Values of [values] that no step takes, in every kind of search: a design that contradicts the file is not found, and
// its sound neighbour is.
#include "tests/parts.hpp"
#include "tests/program.hpp"

#include <string>
#include <vector>

using namespace loadpath::test;

namespace {

/// The key of a coupling, 50 to 70 mm long, next to an entry of [values].
std::string coupling(const std::string& entry, const std::string& step) {
  return "[project.sweep]\nresults = [\"p = seat.p_2\", \"l = seat.l\"]\n\n[values]\n" + entry +
         "\n\n[seat]\ncalculator = \"shaft.key\"\nT = \"280 N*m\"\ntorque = \"one_way\"\nK_A = 1.25\nd = \"45 "
         "mm\"\nkey = "
         "\"14x9\"\nl = { from = \"50 mm\", to = \"70 mm\"" +
         step +
         " }\nl_n = \"75 mm\"\nR_e_1 = \"370 MPa\"\nS_F = 1.5\nR_e_2 = \"250 MPa\"\nR_e_k = \"420 MPa\"\naccept.seat = "
         "\"H7/k6, drawing 12\"\naccept.fatigue = \"shaft by its maker, sheet 8\"\n";
}

struct Kind {
  const char *held, *sound;
};

}  // namespace

TEST_SUITE("held designs of sweeps") {
  TEST_CASE("a point, a sweep, the best design and the Pareto set") {
    const std::vector<Kind> kinds{{"R_e_hub = \"180 MPa\"", "R_e_hub = \"250 MPa\""},
                                  {"T_gate = \"600 N*m\"", "T_gate = \"200 N*m\""},
                                  {"K_A_mill = 1.75", "K_A_mill = 1.25"},
                                  {"l_hub = \"30 mm\"", "l_hub = \"75 mm\""},
                                  {"duty = \"reversing\"", "duty = \"one_way\""}};
    const Desk desk;
    const std::string every = "every mode passes";
    const auto codes = [&](const std::string& entry) {
      desk.put("list.toml", coupling(entry, ", step = \"5 mm\""));
      desk.put("range.toml", coupling(entry, ""));
      return std::vector<int>{
          desk.run({"run", "list.toml", "--point", "2", "--quiet"}).code,
          desk.run({"sweep", "list.toml", "--quiet"}).code,
          desk.run({"sweep", "list.toml", "--pareto", "l:min,p:min", "--such-that", every, "--quiet"}).code,
          desk.run({"sweep", "range.toml", "--minimise", "l", "--such-that", every, "--quiet"}).code};
    };
    const std::vector<int> held{4, 4, 1, 1}, sound{0, 0, 0, 0};
    for (const Kind& kind : kinds) {
      CHECK_MESSAGE(codes(kind.held) == held, kind.held);
      CHECK_MESSAGE(codes(kind.sound) == sound, kind.sound);
    }
  }
}
