// Regression tests of values typed next to a row of a table or a record that has them too.
#include "lib/table/library.hpp"
#include "lib/table/tables.hpp"
#include "tests/found/modes.hpp"

#include <algorithm>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string state_in(const std::string& text, const char* step, const char* id) {
  return mode_of(solved_as_found(text), step, id);
}

bool says(const std::string& text, const std::string& part) {
  return first_error_of(text).find(part) != std::string::npos;
}

/// The text with another value of the first key of that name; without a value, without its line.
std::string in_place(std::string text, const std::string& key, const std::string& value) {
  const std::size_t at = text.find("\n" + key + " = ") + 1, end = text.find('\n', at);
  return text.replace(at, end - at, value.empty() ? "" : key + " = " + value);
}

std::string post(const std::string& lines) {
  return "[c]\ncalculator = \"column.buckling\"\nends = \"pinned_pinned\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = "
         "1\nmaterial = \"S235JR\"\nl = \"3 m\"\nP = \"100 kN\"\n" +
         lines + "\n";
}

std::string lug(const std::string& lines) {
  return "[eye]\ncalculator = \"pin.lug\"\nF = \"50 kN\"\nd = \"40 mm\"\nb = \"80 mm\"\na = \"30 mm\"\nt = \"20 "
         "mm\"\nmaterial = \"S235JR\"\nS = 1.5\np_adm = \"200 MPa\"\n" +
         lines + "\n";
}

std::string axle(const std::string& lines) {
  return "[s]\ncalculator = \"shaft.torsion\"\nT = \"1 kN*m\"\nd = \"50 mm\"\nmaterial = \"S235JR\"\n" + lines + "\n";
}

std::string rod(const std::string& lines) {
  return "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"1200 "
         "mm\"\ncrank = { speed = \"120 rpm\", positions = 36 }\nlinks.rod.mass = \"6 kg\"\nlinks.slider.mass = \"5 "
         "kg\"\n[rod]\ncalculator = \"link.member\"\nload = \"=press.links.rod\"\nh = \"30 mm\"\nb = \"20 mm\"\n"
         "ends_y = \"pinned_pinned\"\nends_z = \"fixed_fixed\"\nmaterial = \"S355\"\nmethod = \"johnson\"\nn_st = 3\n"
         "S = 2\n" +
         lines + "\n";
}

std::string own_section(const std::string& values) {
  return "[tables.sections.X]\nsource = \"maker\"\nkind = \"rolled_I\"\nh = \"160 mm\"\nb = \"160 mm\"\nt_f = \"9 "
         "mm\"\nt_w = \"6 mm\"\n" +
         values + "\n" + post("section = \"X\"");
}

std::string own_chain(const std::string& values) {
  return "[tables.chains.Y]\np = \"25.4 mm\"\nsource = \"maker\"\nq = \"2.7 kg/m\"\n" + values +
         "\n[c]\ncalculator = \"chain.roller\"\nchain = \"Y\"\nz_1 = 21\nz_2 = 57\nP = \"5 kW\"\nn_1 = \"96 rpm\"\na = "
         "\"1 m\"\np_adm = \"35 MPa\"\nS_min = 7.6\nP_R = \"10 kW\"\n";
}

}  // namespace

TEST_SUITE("found beside") {
  TEST_CASE("V1, V3, V5: sizes and kinds are those of the row, to the digits typed") {
    CHECK(says(post("section = \"UPN 200\"\nkind = \"rolled_I\""), "the section 'UPN 200', which has channel"));
    CHECK(says(post("section = \"HEA 100\"\nA = \"100 cm^2\""), "the section 'HEA 100', which has 2124 mm²"));
    CHECK(says(post("section = \"HEA 100\"\nA = \"=100 cm^2\""), "the section 'HEA 100', which has 2124 mm²"));
    CHECK(says(post("section = \"HEA 100\"\nI_z = \"160 cm^4\""), "'HEA 100'"));
    CHECK(first_error_of(post("section = \"HEA 100\"\nA = \"21.2 cm^2\"")).empty());
    CHECK(says(post("section = \"HEA 100\"\nA = \"21.20 cm^2\""), "'HEA 100'"));
    CHECK(says(post("section = \"HEA 100\"\nA = \"2e3 mm^2\""), "'HEA 100'"));
    CHECK(first_error_of(post("section = \"HEA 100\"\nA = '=tables.sections.\"HEA 100\".A'")).empty());
    CHECK(
        says("[ring]\ncalculator = \"shaft.circlip\"\ncirclip = \"18x1.2\"\nd_1 = \"60 mm\"\nF_a = \"1 kN\"\nS = "
             "1\nw = \"5 mm\"\nc = \"0 mm\"\nR_e = \"340 MPa\"\nn = \"0 rpm\"\n",
             "the circlip '18x1.2', which has 18 mm"));
  }

  TEST_CASE("V1: the row may come from another step, or be one of many") {
    CHECK(says(post("section = \"UPN 200\"") +
                   "[e]\ncalculator = \"column.buckling\"\nsection = \"=c.section\"\nkind = \"rolled_I\"\nends = "
                   "\"pinned_pinned\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\nmaterial = \"S235JR\"\nl = \"3 "
                   "m\"\nP = \"100 kN\"\n",
               "has channel"));
  }

  TEST_CASE("M3: a strength above that of the material needs a reason, and one below does not") {
    for (const char* id : {"net", "shear_out"}) {
      CHECK(state_in(lug("R_e = \"960 MPa\""), "eye", id) == "not-judged");
      CHECK(state_in(lug("R_e = \"=960 MPa\""), "eye", id) == "not-judged");
      CHECK(state_in(lug("R_e = \"220 MPa\""), "eye", id) == "pass");
      CHECK(state_in(lug("R_e = \"225 MPa\""), "eye", id) == "pass");
      CHECK(state_in(lug("R_e = \"960 MPa\"\nbecause.R_e = \"certificate 4711\""), "eye", id) == "pass");
    }
    CHECK(state_in(lug("R_e = \"960 MPa\""), "eye", "bearing") == "pass");  // which R_e does not decide
    CHECK(state_in(in_place(lug("R_e = \"960 MPa\""), "F", "\"5 MN\""), "eye", "net") == "fail");
  }

  TEST_CASE("an unneeded reason, and a reason for no input, are errors") {
    CHECK(says(lug("R_e = \"220 MPa\"\nbecause.R_e = \"certificate\""), "because.R_e is not needed"));
    CHECK(says(lug("because.R_e = \"certificate\""), "because.R_e is not needed"));
    CHECK(says(lug("because.R_f = \"certificate\""), "has no input 'R_f' | did you mean"));
    CHECK(says(lug("R_e = \"960 MPa\"\nbecause.R_e = \" \""), "justified by a text"));
    CHECK(says(lug("R_e = \"960 MPa\"\nbecause = \"R_e\""), "is a table of reasons"));
  }

  TEST_CASE("a reason does not change a failure, and is shown with the value") {
    const auto project = solved_as_found(lug("R_e = \"300 MPa\"\nbecause.R_e = \"certificate 4711\""));
    const auto& inputs = project.steps[0]->account().inputs;
    const auto R_e = std::find_if(inputs.begin(), inputs.end(), [](const auto& e) { return e.path == "R_e"; });
    REQUIRE(R_e != inputs.end());
    CHECK(R_e->origin.text.text().find("certificate 4711") != std::string::npos);
    CHECK(R_e->origin.text.text().find("225 MPa") != std::string::npos);
  }

  TEST_CASE("M1: an allowable stress above the yield strength of the material, over sqrt(3) in shear") {
    // 225 MPa at 50 mm, 235 MPa at the least size: 235/sqrt(3) = 135.7 MPa
    CHECK(state_in(axle("tau_adm = \"450 MPa\""), "s", "yield") == "not-judged");
    CHECK(state_in(axle("tau_adm = \"140 MPa\""), "s", "yield") == "not-judged");
    CHECK(state_in(axle("tau_adm = \"135 MPa\""), "s", "yield") == "not-judged");  // no margin
    CHECK(state_in(axle("tau_adm = \"112 MPa\""), "s", "yield") == "pass");
    CHECK(state_in(axle("tau_adm = \"450 MPa\"\nbecause.tau_adm = \"test 12\""), "s", "yield") == "pass");
    CHECK(state_in(axle("sigma_adm = \"400 MPa\"\nbehaviour = \"ductile\""), "s", "yield") == "not-judged");
    const std::string eye = in_place(lug("tau_adm = \"90 MPa\"\nsigma_adm = \"150 MPa\""), "S", "");
    CHECK(state_in(eye, "eye", "net") == "pass");
    CHECK(state_in(in_place(eye, "sigma_adm", "\"300 MPa\""), "eye", "net") == "not-judged");
    CHECK(state_in(in_place(eye, "sigma_adm", "\"300 MPa\""), "eye", "shear_out") == "pass");
    CHECK(state_in(in_place(eye, "tau_adm", "\"150 MPa\""), "eye", "shear_out") == "not-judged");
  }

  TEST_CASE("M1: vessels, pins, bars of several parts") {
    const std::string wall =
        "[w]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"500 mm\"\ndelta = \"10 mm\"\nends = \"closed\"\n"
        "material = \"P265GH\"\n";
    CHECK(state_in(wall + "sigma_adm = \"300 MPa\"\n", "w", "strength") == "not-judged");
    CHECK(state_in(wall + "sigma_adm = \"150 MPa\"\n", "w", "strength") == "pass");
    const std::string bar =
        "[b]\ncalculator = \"shaft.held\"\nend_1 = \"held\"\nend_2 = \"free\"\nmaterial = \"S235JR\"\ntorques = [{ x = "
        "\"300 mm\", T = \"500 N*m\" }]\nsegments = [{ l = \"300 mm\", d = \"60 mm\", tau_adm = \"";
    CHECK(state_in(bar + "300 MPa\" }]\n", "b", "yield") == "not-judged");
    CHECK(state_in(bar + "100 MPa\" }]\n", "b", "yield") == "pass");
  }

  TEST_CASE("M5: a fatigue limit above 0.7 of the tensile strength") {
    const std::string shaft =
        "[shaft]\ncalculator = \"shaft.design\"\npieces = [{ l = \"300 mm\", d = \"30 mm\" }]\nsupports = [{ name = "
        "\"left\", x = \"25 mm\", holds = \"both\" }, { name = \"right\", x = \"275 mm\" }]\nseats = [{ name = \"g\", "
        "x "
        "= \"150 mm\", T = \"0 N*m\", F_x = \"3 kN\", mass = \"1 kg\", J = \"0.001 kg*m^2\", I_p = \"0.001 kg*m^2\", b "
        "= \"20 mm\" }]\nn = \"1450 rpm\"\ng_angle = \"-90 deg\"\nS_F = 1.2\nS_D = 1.2\nr_T = 0\nmaterial = "
        "\"C45E\"\ngroup = \"carbon-steel\"\nfinish = \"ground\"\n";
    CHECK(state_in(shaft + "sigma_W = \"600 MPa\"\n", "shaft", "fatigue") == "not-judged");
    CHECK(state_in(shaft + "sigma_W = \"600 MPa\"\nbecause.sigma_W = \"tests\"\n", "shaft", "fatigue") == "pass");
    CHECK(state_in(shaft + "sigma_W = \"350 MPa\"\n", "shaft", "fatigue") == "pass");
  }

  TEST_CASE("M5: a fatigue limit that only other steps compare with stresses") {
    const std::string e =
        "[e]\ncalculator = \"fatigue.endurance\"\nloading = \"bending\"\nmaterial = \"C45E\"\nd = \"20 mm\"\nd_h = "
        "\"20 mm\"\nsigma_W = ";
    CHECK(state_in(e + "\"600 MPa\"\n", "e", "typed_values") == "not-judged");
    CHECK(state_in(e + "\"300 MPa\"\n", "e", "typed_values") == "none");
    CHECK(state_in(e + "\"600 MPa\"\nbecause.sigma_W = \"tests\"\n", "e", "typed_values") == "none");
  }

  TEST_CASE("V7: a buckling length is not shorter than the link, and may be longer") {
    CHECK(state_in(rod("l = \"30 mm\""), "rod", "buckling") == "not-judged");
    CHECK(state_in(rod("l = \"=30 mm\""), "rod", "buckling") == "not-judged");
    CHECK(state_in(rod("l = \"30 mm\"\nbecause.l = \"guided all along\""), "rod", "buckling") == "pass");
    CHECK(state_in(rod(""), "rod", "buckling") == state_in(rod("l = \"1200 mm\""), "rod", "buckling"));
    CHECK(state_in(rod("l = \"1250 mm\""), "rod", "slenderness") != "not-judged");
  }

  TEST_CASE("a load that is typed next to a record is not below its peak") {
    CHECK(state_in(rod("N = \"1 N\"\nV = \"0 N\"\nM_b = \"0 N*m\""), "rod", "yield") == "not-judged");
    CHECK(state_in(rod("N = \"-50 kN\""), "rod", "yield") != "not-judged");
  }

  TEST_CASE("X3: the type of stress is that of the record") {
    CHECK(says(axle("tau_adm = \"100 MPa\"") +
                   "[f]\ncalculator = \"fatigue.cycle\"\ncycle = \"=s.cycle\"\nstress = \"normal\"\nr = -1\nsigma_D = "
                   "\"150 MPa\"\nS_D = 1.2\nS_F = 1.2\nmaterial = \"S235JR\"\nd_h = \"50 mm\"\n",
               "'s.cycle.stress' is \"shear\""));
  }

  TEST_CASE("O1, O3: own rows are consistent in themselves, and near their group") {
    const std::string head = "[tables.materials.X]\nE = \"210 GPa\"\nsource = \"certificate\"\n";
    const std::string eye = in_place(lug(""), "material", "\"X\"");
    CHECK(says(head + "R_e = \"3550 MPa\"\nR_m = \"400 MPa\"\n" + eye, "is above its R_m = 400 MPa"));
    CHECK(says(head + "by_size = [{ size_max = \"40 mm\", R_e = \"500 MPa\", R_m = \"400 MPa\" }]\n" + eye,
               "is above its R_m"));
    CHECK(first_error_of(head + "R_e = \"355 MPa\"\nR_m = \"490 MPa\"\n" + eye).empty());
    CHECK(says(own_chain("A = \"2100 mm^2\"\nF_uM = \"60 kN\""), "A = 2100 mm² of 'Y' is far"));
    CHECK(says(own_chain("A = \"210 mm^2\"\nF_uM = \"640 kN\""), "F_uM = 640 kN of 'Y' is far"));
    CHECK(first_error_of(own_chain("A = \"210 mm^2\"\nF_uM = \"60 kN\"")).empty());
    CHECK(first_error_of(own_chain("A = \"2100 mm^2\"\nF_uM = \"60 kN\"\nbecause.A = \"data sheet\"")).empty());
    CHECK(says(own_chain("A = \"210 mm^2\"\nF_uM = \"60 kN\"\nbecause.A = \"data sheet\""), "not needed"));
  }

  TEST_CASE("own rows in the place of built-in ones are not stronger without a reason") {
    const std::string head = "[tables.materials.S235JR]\nE = \"210 GPa\"\nsource = \"certificate\"\n";
    CHECK(says(head + "R_e = \"300 MPa\"\n" + lug(""), "above the 235 MPa of the built-in row"));
    CHECK(first_error_of(head + "R_e = \"300 MPa\"\nbecause.R_e = \"no. 4711\"\n" + lug("")).empty());
    // one value for all sizes is held against the thickest too, which has 175 MPa
    CHECK(says(head + "R_e = \"200 MPa\"\n" + lug(""), "above the 195 MPa of the built-in row"));
    CHECK(first_error_of(head + "R_e = \"175 MPa\"\n" + lug("")).empty());
    CHECK(first_error_of(head + "by_size = [{ size_max = \"40 mm\", R_e = \"200 MPa\" }]\n" + lug("")).empty());
  }

  TEST_CASE("G8, O: dimensions, area and second moments are of one section") {
    const std::string I = "I_y = \"1673 cm^4\"\nI_z = \"615.6 cm^4\"\n";
    CHECK(first_error_of(own_section("A = \"38.77 cm^2\"\n" + I)).empty());
    CHECK(says(own_section("A = \"388 cm^2\"\n" + I), "the area of h times b"));
    CHECK(says(own_section("A = \"38.77 cm^2\"\nI_y = \"16730 cm^4\"\nI_z = \"615.6 cm^4\"\n"), "A h^2/4"));
    CHECK(says(own_section("A = \"60 cm^2\"\n" + I), "does not match its walls"));
    const std::string typed = "kind = \"rolled_I\"\nh = \"160 mm\"\nb = \"160 mm\"\nt_f = \"9 mm\"\nt_w = \"6 mm\"\n";
    CHECK(says(post(typed + "A = \"388 cm^2\"\n" + I), "the area of h times b"));
    CHECK(first_error_of(post(typed + "A = \"38.77 cm^2\"\n" + I)).empty());
    CHECK(says(post("kind = \"solid\"\nA = \"1567 mm^2\"\nI_y = \"4879 cm^4\"\nI_z = \"4879 cm^4\""), "it is hollow"));
    CHECK(says(post("section = \"CHS 60.3x4\"\nkind = \"solid\""), "it is hollow"));
  }

  TEST_CASE("S1, S3: what A and I do not determine is not assessed, and the user may accept it") {
    const std::string tube =
        "curve_y = \"a\"\ncurve_z = \"a\"\nA = \"1567.65 mm^2\"\nI_y = \"4879.3 cm^4\"\nI_z = \"4879.3 cm^4\"";
    CHECK(state_in(post(tube), "c", "local") == "not-judged");
    CHECK(state_in(post(tube), "c", "torsional") == "not-judged");
    CHECK(state_in(post(tube + "\naccept.local = \"D/t 20\""), "c", "local") == "accepted");
    const std::string box = "[sec]\ncalculator = \"section.hollow\"\nh = \"300 mm\"\nb = \"300 mm\"\nt = \"1.5 mm\"\n";
    CHECK(
        state_in(box + post("curve_y = \"a\"\ncurve_z = \"a\"\nA = \"=sec.A\"\nI_y = \"=sec.I_y\"\nI_z = \"=sec.I_z\""),
                 "c", "local") == "not-judged");
    // A square bar of 40 mm by its area and moments: full, without walls.
    const std::string bar =
        "curve_y = \"c\"\ncurve_z = \"c\"\nA = \"1600 mm^2\"\nI_y = \"213333 mm^4\"\nI_z = \"213333 mm^4\"";
    CHECK(state_in(in_place(post(bar), "P", "\"1 kN\""), "c", "local") == "none");
  }

  TEST_CASE("Z1: a tie has no slenderness limit, nor walls that buckle") {
    const std::string tie =
        "[c]\ncalculator = \"column.buckling\"\nN = \"30 kN\"\nl = \"3 m\"\nends = \"pinned_pinned\"\nmaterial = "
        "\"S235JR\"\nmethod = \"johnson\"\nn_st = 2\nn_t = 1.5\n";
    for (const char* section : {"h = \"8 mm\"\nb = \"40 mm\"\n", "section = \"IPE 80\"\n"})
      CHECK(account::overall(project::modes(solved_as_found(tie + section))) == account::State::pass);
    CHECK(state_in(in_place(tie, "N", "\"-3 kN\"") + "h = \"8 mm\"\nb = \"40 mm\"\n", "c", "slenderness") == "fail");
  }

  TEST_CASE("Z3: torsional buckling applies to the section found") {
    const std::string head =
        "[p]\ncalculator = \"column.lightest\"\nl = \"4 m\"\nP = \"300 kN\"\nmaterial = \"S235JR\"\nends = "
        "\"pinned_pinned\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1.4\nfamilies = ";
    CHECK(state_in(head + "[\"SHS\", \"UPN\"]\n", "p", "torsional") == "none");
    CHECK(state_in(head + "[\"UPN\"]\n", "p", "torsional_flexural") == "pass");
  }

  TEST_CASE("F6: by AISC the walls are compared with E7: 48.1 of 60.0 of a W16X36") {
    const ExampleStep step(
        "column.buckling",
        "d = \nsigma_P = \nn_st = \nends = \nsection = \"W16X36\"\nl = \"15 ft\"\nbeta_y = "
        "0.6667\nbeta_z = 1\nP = \"100 kip\"\nE = \"29000 ksi\"\nR_e = \"50 ksi\"\nmethod = \"aisc\"");
    const auto row = table::find_row("section", "W16X36");
    REQUIRE(row);
    const auto of = [&](const char* key) { return table::property(*row, key)->si; };
    const double web = (of("h") - 2.0 * (of("t_f") + of("r"))) / of("t_w");  // 48.1 with the radius of the manual
    CHECK(step("r_class") == doctest::Approx(web / 60.0).epsilon(0.005));
  }

  TEST_CASE("F14: warping and torsion constants of an HEA 160 are those of the manufacturer") {
    const auto row = table::find_row("section", "HEA 160");
    REQUIRE(row);
    CHECK(table::property(*row, "I_w")->si == doctest::Approx(31410e-12).epsilon(1e-3));
  }
}
