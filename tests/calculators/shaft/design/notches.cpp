// Notches of a shaft with factors of DIN 743 or typed: against hand calculation, fatigue.din743, and wrong input.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace loadpath;
using account::State;
using doctest::Approx;
using test::contains;
using test::Solved;

/// A turning bar of 40 mm under 1 kN in the middle of 200 mm, and 100 N m through it; a notch at 60 mm: 30 N m.
std::string barred(const std::string& notch, const std::string& more = "") {
  return "[bar]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"81 GPa\"\nR_m = \"700 MPa\"\nR_e = \"490 "
         "MPa\"\ngroup = \"carbon-steel\"\nR_z = \"6.3 um\"\nn = \"500 rpm\"\npieces = [{ l = \"200 mm\", d = \"40 "
         "mm\" "
         "}]\nsupports = [{ x = \"0 mm\" }, { x = \"200 mm\" }]\nseats = [{ x = \"100 mm\", F_x = \"1 kN\" }, { x = "
         "\"0 mm\", way = \"drives\", T = \"100 N*m\" }, { x = \"200 mm\", T = \"100 N*m\" }]\nnotches = [{ name = "
         "\"n\", x = \"60 mm\", " +
         notch + " }]\nS_D = 1.5\nr_T = 0.5\nS_F = 1.5\n" + more;
}

/// The same section alone.
std::string alone(const std::string& section) {
  return "[alone]\ncalculator = \"fatigue.din743\"\nR_m = \"700 MPa\"\nR_e = \"490 MPa\"\nR_z = \"6.3 um\"\nmean = "
         "\"proportional\"\nM_ba = \"30 N*m\"\nM_tm = \"75 N*m\"\nM_ta = \"25 N*m\"\nf_max = 1\n" +
         section;
}

/// A bar that steps from 40 mm to 50 mm at 80 mm, with a hub of 30 mm from 36 mm to 66 mm that drives it.
std::string stepped(const std::string& notches, const std::string& more = "") {
  return "[bar]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"81 GPa\"\nR_m = \"700 MPa\"\nR_e = \"490 "
         "MPa\"\ngroup = \"carbon-steel\"\nn = \"500 rpm\"\npieces = [{ l = \"80 mm\", d = \"40 mm\" }, { l = "
         "\"120 mm\", d = \"50 mm\" }]\nsupports = [{ x = \"0 mm\" }, { x = \"200 mm\" }]\nseats = [{ name = "
         "\"wheel\", x = \"51 mm\", b = \"30 mm\", I_p = \"0.01 kg*m^2\", way = \"drives\", T = \"100 N*m\" }, { x "
         "= \"200 mm\", T = \"100 N*m\" }]\nnotches = [" +
         notches + "]\nS_D = 1.5\nr_T = 0.5\nS_F = 1.5\n" + more;
}

struct Told {
  const char *notch, *section;
  double beta_b, beta_t;  // by hand
};
const Told kinds[] = {
    {R"(kind = "rectangular-groove", t = "1.25 mm", w = "1.85 mm", r = "0.1 mm")",
     "notch = \"rectangular-groove\"\nd = \"37.5 mm\"\nD = \"40 mm\"\nw = \"1.85 mm\"\nr = \"0.1 mm\"\n", 3.182867,
     2.515483},
    {R"(kind = "v-groove", t = "2.5 mm")", "notch = \"v-groove\"\nd = \"35 mm\"\nD = \"40 mm\"\n", 1.651143, 1.313513},
    {R"(kind = "press-fit")", "notch = \"press-fit\"\nd = \"40 mm\"\n", 2.316093, 1.505460},
    {R"(kind = "cross-hole", r = "4 mm")", "notch = \"cross-hole\"\nd = \"40 mm\"\nr = \"4 mm\"\n", 1.884904, 1.439680},
};

std::string errors(const std::string& notch, const std::string& more = "") {
  return Solved(barred(notch, more)).errors();
}

}  // namespace

TEST_SUITE("shaft design notches") {
  TEST_CASE("a step that is high for its fillet has K_t of DIN 743 in torsion, beyond Peterson's fit") {
    const auto shouldered = [](const std::string& r) {
      const std::string bar = barred("kind = \"shoulder\", r = \"" + r + "\"");
      const std::string one = "[{ l = \"200 mm\", d = \"40 mm\" }]";
      const std::size_t at = bar.find(one);
      REQUIRE(at != std::string::npos);
      return bar.substr(0, at) + "[{ l = \"60 mm\", d = \"45 mm\" }, { l = \"140 mm\", d = \"60 mm\" }]" +
             bar.substr(at + one.size());
    };
    // By hand: t = 7.5 mm; 3.4 r/t + 38 r/d (1 + 2 r/d)^2 + (r/t)^2 d/D = 1.38784, 1 + 1/1.17807 = 1.84885.
    const Solved sharp(shouldered("1 mm"));
    CHECK(sharp.value("bar.safeties.n.K_ts") == Approx(1.84885).epsilon(1e-4));
    CHECK(test::mode_of(sharp.project, "bar", "fatigue") != "not-covered");
    double before = 10.0;  // no leap where the fit ends, h/r = 4, and never less for a sharper fillet
    for (const char* const r : {"0.4 mm", "1 mm", "1.4 mm", "1.8 mm", "1.87 mm", "1.88 mm", "2 mm", "3 mm", "6 mm"}) {
      const double K_ts = Solved(shouldered(r)).value("bar.safeties.n.K_ts");
      CHECK(K_ts <= before * (1.0 + 1e-12));
      before = K_ts;
    }
    CHECK(Solved(shouldered("1.87 mm")).value("bar.safeties.n.K_ts") ==
          Approx(Solved(shouldered("1.88 mm")).value("bar.safeties.n.K_ts")).epsilon(0.01));
    CHECK(test::mode_of(Solved(shouldered("0.2 mm")).project, "bar", "fatigue") == "not-covered");
  }

  TEST_CASE("notch factors are those of DIN 743, by hand and as in fatigue.din743, for every school") {
    for (const Told& kind : kinds) {
      CAPTURE(kind.notch);
      Solved both(barred(kind.notch) + alone(kind.section));
      REQUIRE_MESSAGE(!has_errors(both.issues), both.messages());
      CHECK(both.value("bar.safeties.n.K_f") == Approx(kind.beta_b).epsilon(1e-4));
      CHECK(both.value("bar.safeties.n.K_fs") == Approx(kind.beta_t).epsilon(1e-4));
      CHECK(both.value("bar.safeties.n.K_f") == Approx(both.value("alone.stresses.bending.beta")));
      CHECK(both.value("bar.safeties.n.K_fs") == Approx(both.value("alone.stresses.torsion.beta")));
      CHECK(both.value("bar.safeties.n.n_DIN743") == Approx(both.value("alone.S_D")));
      CHECK(both.value("bar.safeties.n.sigma_a") > both.value("bar.sections.n.sigma_b") * kind.beta_b);
    }
  }

  TEST_CASE("a cross hole has its nominal stresses on the net section") {
    Solved holed(barred(R"(kind = "cross-hole", r = "4 mm")"));
    const double d = 0.04, r = 0.004;
    CHECK(holed.value("bar.sections.n.sigma_b") ==
          Approx(30.0 / (std::numbers::pi * d * d * d / 32.0 - r * d * d / 3.0)));
    CHECK(holed.value("bar.sections.n.tau") == Approx(100.0 / (std::numbers::pi * d * d * d / 16.0 - r * d * d / 3.0)));
  }

  TEST_CASE("a typed notch factor is used unchanged, at a step and of other materials too") {
    Solved typed(barred(R"(kind = "beta", beta_b = 2, beta_t = 1.6)"));
    CHECK(typed.value("bar.safeties.n.K_f") == 2.0);
    CHECK(typed.value("bar.safeties.n.K_fs") == 1.6);
    const double smooth = Solved(barred(R"(kind = "beta", beta_b = 1, beta_t = 1)")).value("bar.safeties.n.S_e");
    CHECK(typed.value("bar.safeties.n.S_e") == Approx(smooth));
    const std::string light = test::with(barred(R"(kind = "beta", beta_b = 2, beta_t = 1.6)"), "group",
                                         "\"wrought-aluminium\"\nsigma_W = \"150 MPa\"");
    CHECK_MESSAGE(Solved(light).errors().empty(), Solved(light).errors());
    const std::string pressed =
        test::with(barred(R"(kind = "press-fit")"), "group", "\"wrought-aluminium\"\nsigma_W = \"150 MPa\"");
    CHECK(contains(Solved(pressed).errors(), "for steels only"));
  }

  TEST_CASE("beyond the range of its factor a notch is not covered, by any school") {
    for (const char* notch : {R"(kind = "v-groove", t = "0.5 mm")", R"(kind = "v-groove", t = "7 mm")",
                              R"(kind = "cross-hole", r = "7 mm")"}) {
      CAPTURE(notch);
      Solved beyond(barred(notch));
      REQUIRE_MESSAGE(!has_errors(beyond.issues), beyond.messages());
      CHECK(beyond.mode("bar.fatigue").state == State::not_covered);
    }
  }

  TEST_CASE("missing or superfluous input of a notch is reported") {
    CHECK(contains(errors(R"(kind = "rectangular-groove", t = "1 mm", r = "0.1 mm")"), "has a width w"));
    CHECK(contains(errors(R"(kind = "rectangular-groove", w = "1 mm", r = "0.1 mm")"), "has a depth t"));
    CHECK(contains(errors(R"(kind = "rectangular-groove", t = "1 mm", w = "1 mm")"), "needs the radius r"));
    CHECK(contains(errors(R"(kind = "v-groove")"), "has a depth t"));
    CHECK(contains(errors(R"(kind = "cross-hole")"), "needs its radius r"));
    CHECK(contains(errors(R"(kind = "cross-hole", r = "12 mm")"), "the hole must be smaller than the section"));
    CHECK(contains(errors(R"(kind = "press-fit", r = "1 mm")"), "leave out r"));
    CHECK(contains(errors(R"(kind = "beta", beta_b = 2)"), "beta_b and beta_t are given together"));
    CHECK(contains(errors(R"(kind = "press-fit", beta_b = 2, beta_t = 2)"), "beta_b and beta_t are given together"));
    CHECK(contains(errors(R"(kind = "keyway", h = "2 mm")"), "minimum height of a shoulder"));
  }

  TEST_CASE("a shoulder must be as high as its abutting part needs") {
    const auto state = [](const char* h) {
      return test::mode_with("shaft.design",
                             "notches = [{ x = \"60 mm\", kind = \"shoulder\", r = \"2 mm\", h = \"" + std::string(h) +
                                 "\" }, { x = \"140 mm\", kind = \"shoulder\", r = \"2 mm\" }]",
                             "abutment");
    };
    CHECK(state("5 mm") == "pass");
    CHECK(state("5.01 mm") == "fail");
  }

  TEST_CASE("notches that are too near to each other are reported") {
    const auto warns = [](const char* gap) {
      return contains(Solved(barred(R"(kind = "groove", t = "2 mm", r = "2 mm" }, { x = ")" + std::string(gap) +
                                    R"(", kind = "groove", t = "1 mm", r = "1 mm")"))
                          .messages(),
                      "notches are assessed separately");
    };
    CHECK(warns("63.9 mm"));
    CHECK_FALSE(warns("64.1 mm"));
  }

  TEST_CASE("both ends of a keyway count for its distance from a shoulder") {
    const auto messages = [](const char* x, const char* l) {
      return Solved(stepped("{ name = \"key\", kind = \"keyway\", x = \"" + std::string(x) + "\", l = \"" + l +
                            "\" }, { name = \"step\", x = \"80 mm\", kind = \"shoulder\", r = \"2 mm\" }"))
          .messages();
    };
    const std::string near = messages("43 mm", "36 mm");
    CHECK_MESSAGE(contains(near, "'key' (43 mm to 79 mm) and 'step' (80 mm) are 1 mm apart, less than 10 mm"), near);
    CHECK(contains(messages("79 mm", "36 mm"), "'key' (43 mm to 79 mm) and 'step' (80 mm) are 1 mm apart"));
    CHECK_FALSE(contains(messages("43 mm", "26 mm"), "assessed separately"));
    CHECK_FALSE(contains(messages("69 mm", "26 mm"), "assessed separately"));
  }

  TEST_CASE("a keyway lies within its hub") {
    const auto keyed = [](const char* x, const std::string& more = "") {
      return Solved(stepped("{ name = \"key\", kind = \"keyway\", x = \"" + std::string(x) +
                                "\", l = \"26 mm\" }, { x = \"80 mm\", kind = \"shoulder\", r = \"2 mm\" }",
                            more));
    };
    const Solved beyond = keyed("34 mm");
    CHECK_MESSAGE(contains(beyond.messages(),
                           "the keyway from 34 mm to 60 mm reaches beyond the hub 'wheel', from 36 "
                           "mm to 66 mm"),
                  beyond.messages());
    CHECK(beyond.mode("bar.hub_length").state == State::not_judged);
    CHECK(keyed("34 mm", "accept = { hub_length = \"boss\" }\n").mode("bar.hub_length").state == State::accepted);
    const Solved within = keyed("40 mm");
    CHECK_FALSE(contains(within.messages(), "reaches beyond"));
    CHECK_FALSE(within.has("bar.hub_length"));
  }
}
