#include "lib/project/references/order.hpp"

#include "tests/lib/project/texts.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string step(const std::string& name, const std::string& T) {
  return "[" + name + "]\ncalculator = \"shaft.torsion\"\nT = \"" + T + "\"\ntau_adm = \"30 MPa\"\n";
}

std::vector<std::string> order_of(const std::string& text) {
  const auto project = solved(text);
  std::vector<std::string> names;
  for (const std::size_t i : project.order) names.push_back(project.steps[i]->name());
  return names;
}

/// The steps as they are solved; "key-" without the inputs that wait for another step.
std::string passes_of(const std::string& text) {
  const Told t = told(text);
  for (const Issue& issue : t.issues) CHECK_MESSAGE(issue.severity != Severity::error, issue.message.text());
  std::string passes;
  for (const project::Pass& pass : t.project.passes)
    passes += (passes.empty() ? "" : " ") + t.project.steps[pass.step]->name() + (pass.without.empty() ? "" : "-");
  return passes;
}

/// A shaft whose diameters are searched for with the notch of a key, and the key, which takes its strength from it.
std::string shaft_of_key(const std::string& key = "key", const std::string& T = "100 N*m") {
  return "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\npieces = [{ l = \"60 mm\", d = \"?\" }, { l = "
         "\"140 mm\", d = \"?\" }]\nsupports = [{ x = \"70 mm\", holds = \"both\" }, { x = \"190 mm\" }]\nseats = [{ x "
         "= \"30 mm\", T = \"" +
         T + "\", F_x = \"2 kN\", way = \"drives\" }, { x = \"130 mm\", T = \"" + T +
         "\", way = \"takes\" }]\nnotches = [{ x = \"45 mm\", part = \"=" + key +
         ".notch\" }, { x = \"60 mm\", kind = \"shoulder\", r = \"1 mm\" }]\nS_F = 1.5\nS_D = 1.5\nr_T = 0\nR_z = "
         "\"6.3 um\"\n\n";
}

std::string key(const std::string& R_e_1, const std::string& name = "key", const std::string& R_e_2 = "250 MPa") {
  return "[" + name +
         "]\ncalculator = \"shaft.key\"\nT = \"100 N*m\"\ntorque = \"one_way\"\nd = \"40 mm\"\nkey = \"12x8\"\nl "
         "= \"45 mm\"\nl_n = \"50 mm\"\nR_e_1 = \"" +
         R_e_1 + "\"\nR_e_2 = \"" + R_e_2 + "\"\nR_e_k = \"420 MPa\"\n\n";
}

/// A rod next to a press whose force depends on an input of the rod that has a default value.
std::string press_and_rod(const std::string& source, const std::string& lines = "") {
  return "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"200 mm\"\n"
         "crank = { speed = \"120 rpm\" }\nloads = [{ name = \"work\", link = \"slider\", at = \"B\", "
         "F_x = \"=-40 N*rod.lambda_max\", F_y = \"0 N\" }]\n\n[rod]\ncalculator = \"link.member\"\nload = \"=" +
         source +
         "\"\nh = \"=0.2*press.l\"\nb = \"20 mm\"\nends = \"pinned_pinned\"\nmaterial = \"S235\"\n"
         "method = \"johnson\"\nn_st = 3\nS = 2\n" +
         lines;
}

}  // namespace

TEST_SUITE("project order") {
  TEST_CASE("a step comes after those that it refers to, otherwise in the order of the file") {
    CHECK(order_of(step("d", "=b.M_max + c.M_max") + step("a", "1 N*m") + step("c", "=a.M_max") +
                   step("b", "=a.M_max")) == std::vector<std::string>{"a", "b", "c", "d"});
    CHECK(order_of(step("b", "1 N*m") + step("a", "1 N*m")) == std::vector<std::string>{"b", "a"});
  }

  TEST_CASE("a circle of references is reported with its members") {
    CHECK(
        issues_of(step("a", "=1 N*m + b.M_max") + step("b", "=c.M_max") + step("c", "=a.M_max")) ==
        "a.toml:1:2: error: circular reference between steps: a -> b -> c -> a\n1 | [a]\n  |  ^\n"
        "  = help: a.T takes b.M_max (line 3), b.T takes c.M_max (line 7), c.T takes a.M_max (line 11): write a value "
        "instead of one of these references\n");
    const std::string own = issues_of(step("a", "=a.M_max"));
    CHECK(own.starts_with("a.toml:1:2: error: circular reference between steps: a -> a\n"));
    CHECK(own.find("help: a.T takes a.M_max (line 3): write a value instead") != std::string::npos);
  }

  TEST_CASE(
      "a size of a row that is searched for with the loads of its taker: the row, or its sizes, are to be given") {
    const std::string said = issues_of(
        "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"80 GPa\"\nR_e = \"370 MPa\"\nS_F = 1.5\npieces "
        "= [{ l "
        "= \"20 mm\", d = \"=bl.d\" }, { l = \"200 mm\", d = \"50 mm\" }]\nsupports = [{ name = \"left\", x = \"10 "
        "mm\" "
        "}, { x = \"210 mm\" }]\nseats = [{ x = \"110 mm\", F_x = \"4 kN\" }]\n\n[bl]\ncalculator = "
        "\"bearing.rolling\"\nload = \"=axle.bearings.left\"\nn = \"900 rpm\"\nbearing = { stock = \"bearing/62\" "
        "}\nL_h = \"10000 h\"\ns_0 = 1\n");
    CHECK_MESSAGE(said.find("circular reference between steps: axle -> bl -> axle") != std::string::npos, said);
    CHECK_MESSAGE(said.find("bl.d is of the row that 'bl' searches for: name a row there, bearing = \"...\", or") !=
                      std::string::npos,
                  said);
    CHECK_MESSAGE(said.find("bearing = { where = \"d = ... mm\" }") != std::string::npos, said);
  }

  TEST_CASE("a step outside of the circle is not named in it") {
    const std::string said = issues_of(step("first", "=a.M_max") + step("a", "=b.M_max") + step("b", "=a.M_max"));
    CHECK(said.starts_with("a.toml:5:2: error: circular reference between steps: a -> b -> a\n"));
    CHECK(said.find("first") == std::string::npos);
  }

  TEST_CASE("an optional input waits for a step that needs another result of its own") {
    const std::string of_shaft = "=shaft.R_e";
    CHECK(passes_of(shaft_of_key() + key("300 MPa")) == "key shaft");
    CHECK(passes_of(shaft_of_key() + key(of_shaft)) == "key- shaft key");
    CHECK(passes_of(key(of_shaft) + shaft_of_key()) == "key- shaft key");
    CHECK(passes_of(shaft_of_key() + key("300 MPa") + key(of_shaft, "other")) == "key shaft other");
    CHECK(passes_of(shaft_of_key() + key(of_shaft) + step("last", "5 N*m")) == "key- shaft key last");
  }

  TEST_CASE("what takes a result of a waiting step follows its complete solution") {
    const std::string next = step("next", "=key.T_eq/20");
    CHECK(passes_of(next + shaft_of_key() + key("=shaft.R_e")) == "key- shaft key next");
    const std::string between = step("between", "=key.T_eq/20") + shaft_of_key("key", "=between.M_max");
    CHECK(passes_of(key("=shaft.R_e") + between) == "key- between shaft key");  // the shaft needs it
  }

  TEST_CASE("inputs that cannot wait make a circle") {
    const std::string circle = "circular reference between steps";
    const auto said = [](const std::string& text) { return first_error(text); };
    CHECK(said(shaft_of_key() + key("=shaft.R_e", "key", "=shaft.R_e")).starts_with(circle));
    CHECK(said(shaft_of_key() + key("=min(shaft.R_e, shaft.R_m)")).starts_with(circle));
    CHECK(said(shaft_of_key() + key("=0.001*shaft.theta_max/(1 deg/m)*1 MPa")).starts_with(circle));  // a result
    CHECK(said(shaft_of_key() + key("=shaft.R_e") + key("=key.R_e_1", "other")).starts_with(circle));
  }

  TEST_CASE("of two bearings whose rows are searched for together, the first has what both need") {
    const auto bearing = [](const std::string& name, const std::string& other, const std::string& F_r,
                            const std::string& row = "{ stock = \"bearing/302\" }") {
      return "[" + name + "]\ncalculator = \"bearing.rolling\"\nbearing = " + row + "\nF_r = \"" + F_r +
             "\"\nF_a = \"0 kN\"\nn = \"300 rpm\"\nL_h = \"10000 h\"\ns_0 = 1.5\narrangement = "
             "\"face_to_face\"\nx = \"" +
             (name == "left" ? "10" : "200") + " mm\"\nmate = { F_r = \"5 kN\", x = \"" +
             (name == "left" ? "200" : "10") + " mm\", Y = \"=" + other + ".Y\" }\n\n";
    };
    const std::string source = step("source", "50 N*m"), take = "=source.M_max/(10 mm)";
    const std::string left = bearing("left", "right", "5 kN"), right = bearing("right", "left", "5 kN");
    CHECK(passes_of(left + right) == "left right");
    CHECK(passes_of(left + bearing("right", "left", take) + source) == "source left right");
    const std::string last = step("last", "=right.F_ax*(10 mm)");
    CHECK(passes_of(last + bearing("left", "right", take) + right + source) == "source right last left");
  }

  TEST_CASE("a default value is certain if no record of a mechanism may replace it") {
    const std::string circle = "circular reference between steps: press -> rod -> press";
    CHECK(issues_of(press_and_rod("press.links.rod")).find(circle) != std::string::npos);
    CHECK(order_of(press_and_rod("press.links.rod", "lambda_max = 200\n")) == std::vector<std::string>{"press", "rod"});
    const std::string unknown = issues_of(press_and_rod("hammer.links.rod"));
    CHECK_MESSAGE(unknown.find("hammer") != std::string::npos, unknown);
    CHECK_MESSAGE(unknown.find("circular") == std::string::npos, unknown);
  }
}
