// Fatigue limits of another part, size, material or notch, and loads that are a part of their source.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

struct Neck {
  std::string material = "C45E", d = "40 mm", d_h = "40 mm", limit = "=limit.sigma_D", more = "";
};

std::string neck_with(const Neck& neck) {
  return "[limit]\ncalculator = \"fatigue.endurance\"\nmaterial = \"" + neck.material +
         "\"\ngroup = \"carbon-steel\"\nloading = \"bending\"\nrule = \"din743\"\nd = \"" + neck.d +
         "\"\nR_z = \"6.3 um\"\nK_t = 1.7\nr_n = \"2 mm\"\n"
         "[neck]\ncalculator = \"fatigue.life\"\nsigma_max = \"80 MPa\"\nsigma_min = \"-60 MPa\"\nsigma_D = \"" +
         neck.limit + "\"\ngroup = \"carbon-steel\"\nmaterial = \"C45E\"\nd_h = \"" + neck.d_h +
         "\"\nS_D = 1.3\nS_F = 1.5\n" + neck.more;
}

std::string fatigue_of(const Neck& neck) { return mode_of(solved_as_found(neck_with(neck)), "neck", "fatigue"); }

std::string lug_with(const std::string& limit) {
  return "[eye]\ncalculator = \"pin.lug\"\nF = \"12 kN\"\nd = \"30 mm\"\nt = \"30 mm\"\nb = \"70 mm\"\na = \"30 mm\"\n"
         "sigma_adm = \"80 MPa\"\ntau_adm = \"40 MPa\"\np_adm = \"80 MPa\"\n"
         "[limit]\ncalculator = \"fatigue.endurance\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\nrule = "
         "\"shigley\"\n"
         "school = \"marin\"\nfinish = \"machined\"\nd_h = \"40 mm\"\nK_t = \"=eye.K_t\"\nP_s = 0.99\n" +
         limit +
         "[life]\ncalculator = \"fatigue.cycle\"\ncycle = \"=eye.cycle\"\nr = -1\nsigma_D = \"=limit.sigma_D\"\nS_D = "
         "2\n"
         "material = \"C45E\"\nd_h = \"40 mm\"\nS_F = 1.5\n";
}

std::string arm_with(const std::string& V, const std::string& M_b, const std::string& more = "") {
  return "[arm]\ncalculator = \"link.member\"\nN = \"-20 kN\"\nV = \"" + V + "\"\nM_b = \"" + M_b +
         "\"\nl = \"900 mm\"\nh = \"80 mm\"\nb = \"60 mm\"\nends = \"pinned_pinned\"\nmaterial = \"S355\"\n"
         "method = \"johnson\"\nn_st = 3\nS = 1.5\n" +
         more;
}

}  // namespace

TEST_SUITE("found limits elsewhere") {
  TEST_CASE("a fatigue limit is that of the part and not above its source") {
    CHECK(fatigue_of({}) == "pass");
    CHECK(fatigue_of({.limit = "=limit.sigma_D*limit.K_D"}) == "not-judged");
    CHECK(fatigue_of({.limit = "=1.2*limit.sigma_D"}) == "not-judged");
    CHECK(fatigue_of({.limit = "=0.9*limit.sigma_D"}) == "pass");
    CHECK(fatigue_of({.d = "8 mm"}) == "not-judged");
    CHECK(fatigue_of({.d_h = "8 mm"}) == "not-judged");
    CHECK(fatigue_of({.material = "42CrMo4"}) == "not-judged");
    CHECK(fatigue_of({.material = "42CrMo4", .more = "because.sigma_D = \"tested, sheet 4\"\n"}) == "pass");
  }

  TEST_CASE("the notch of a bore has its radius, and a factor for tension") {
    CHECK(mode_of(solved_as_found(lug_with("loading = \"tension\"\nr_n = \"0.1 mm\"\n")), "limit", "typed_values") ==
          "not-judged");
    CHECK(mode_of(solved_as_found(lug_with("loading = \"tension\"\nr_n = \"15 mm\"\n")), "limit", "typed_values") ==
          "none");
    CHECK(mode_of(solved_as_found(lug_with("loading = \"tension\"\nr_n = \"=eye.r_n\"\n")), "limit", "typed_values") ==
          "none");
    CHECK(first_error_of(lug_with("loading = \"bending\"\nturning = \"standing\"\nd = \"30 mm\"\nr_n = \"=eye.r_n\"\n"))
              .find("'K_t' takes a stress concentration factor in bending") == 0);
  }

  TEST_CASE("a link with a shear force is bent by it") {
    CHECK(mode_of(solved_as_found(arm_with("12 kN", "0 N*m")), "arm", "yield") == "not-judged");
    CHECK(mode_of(solved_as_found(arm_with("12 kN", "2.7 kN*m")), "arm", "yield") == "pass");
    CHECK(mode_of(solved_as_found(arm_with("12 kN", "0 N*m", "because.M_b = \"force next to the pin\"\n")), "arm",
                  "yield") == "pass");
  }

  TEST_CASE("the fatigue of a link is assessed with its full stress") {
    const auto life = [](const std::string& sigma, const std::string& more = "") {
      return mode_of(solved_as_found(arm_with("12 kN", "2.7 kN*m") +
                                     "[life]\ncalculator = \"fatigue.life\"\nsigma_max = \"" + sigma +
                                     "\"\nr = 0\nsigma_D = \"160 MPa\"\ngroup = \"carbon-steel\"\nmaterial = \"S355\"\n"
                                     "d_h = \"60 mm\"\nS_D = 1.3\nS_F = 1.5\n" +
                                     more),
                     "life", "fatigue");
    };
    CHECK(life("=-arm.sigma_N") == "not-judged");
    CHECK(life("=arm.sigma_o") != "not-judged");
    CHECK(life("=arm.sigma_M + abs(arm.sigma_N)") != "not-judged");
    CHECK(life("=-arm.sigma_N", "because.sigma_max = \"at the pin, where M_b is zero\"\n") != "not-judged");
  }

  TEST_CASE("a force on an overhang has a lever arm") {
    CHECK(first_error_of("[e]\ncalculator = \"shaft.overhung\"\nF = \"3 kN\"\na = \"0 mm\"\nT = \"78 N*m\"\n"
                         "sigma_adm = \"60 MPa\"\n")
              .find("a transverse force on an overhang needs its distance") != std::string::npos);
  }

  TEST_CASE("one component of a gear force is not the force on its shaft") {
    const auto overhung = [](const std::string& F) {
      return "[stage]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"2.5 mm\"\nb = \"28 mm\"\nT_1 = \"40 "
             "N*m\"\n"
             "n_1 = \"1450 rpm\"\nK_A = 1.25\n[e]\ncalculator = \"shaft.overhung\"\nF = \"" +
             F + "\"\nT = \"=stage.gear_1.T\"\na = \"40 mm\"\nsigma_adm = \"60 MPa\"\n";
    };
    CHECK(mode_of(solved_as_found(overhung("=stage.gear_1.F_y")), "e", "yield") == "not-judged");
    CHECK(mode_of(solved_as_found(overhung("=stage.gear_1.F")), "e", "yield") == "pass");
  }
}
