// Mechanisms known in shape: each closes over its cycle, is the same as the mechanism written out, and says what does
// not fit together.
#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/build/build.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const Calculator& planar_mechanism() { return *find_calculator(calculators(), "mechanism.planar"); }

const planar::Mechanism::Input& input_of(const project::Project& project) {
  return *static_cast<const planar::Mechanism::Input*>(project.steps[0]->input().reading.record.data.get());
}

std::string quoted(const Name& name) { return "\"" + std::string(name.view()) + "\""; }
std::string metres(Length l) { return "\"" + format_exact(in_si(l)) + " m\""; }
std::string radians(double angle) { return "\"" + format_exact(angle) + " rad\""; }

template <class Points>
std::string points_text(const Points& points) {
  std::string text = "{ ";
  for (const auto& p : points) {
    text +=
        (text.size() > 2 ? ", " : "") + std::string(p.name.view()) + " = [" + metres(p.x) + ", " + metres(p.y) + "]";
  }
  return text + " }";
}

std::string link_text(const planar::Link& l) {
  return "links." + std::string(l.name.view()) + " = { points = " + points_text(l.points) + ", origin = [" +
         metres(l.origin.x) + ", " + metres(l.origin.y) + "], angle = " + radians(l.angle) + ", mass = \"" +
         format_exact(in_si(l.mass)) + " kg\", J = \"" + format_exact(in_si(l.J)) + " kg*m^2\"" +
         (l.S.empty() ? "" : ", S = " + quoted(l.S)) + " }\n";
}

template <class Enum>
std::string key_of(Enum value) {
  return "\"" + std::string(word_of(value)) + "\"";
}

std::string profile_text(const planar::CamProfile& p) {
  std::string text = "profiles." + std::string(p.name.view()) + " = { shape = " + key_of(p.shape) +
                     ", sense = " + key_of(p.sense) + ", side = " + key_of(p.side) + ", base = " + metres(p.base) +
                     ", roller = " + metres(p.roller) + ", offset = " + metres(p.offset);
  if (is_set(p.pivot)) text += ", pivot = " + metres(p.pivot) + ", arm = " + metres(p.arm);
  text += ", segments = [";
  for (const auto& s : p.segments) {
    text += "{ law = " + key_of(s.law) + ", angle = " + radians(s.angle);
    if (is_set(s.lift)) text += ", lift = " + metres(s.lift);
    if (is_set(s.swing)) text += ", swing = " + radians(s.swing);
    text += " }, ";
  }
  return text + "] }\n";
}

std::string joint_text(const planar::Joint& j) {
  std::string text = "joints." + std::string(j.name.view()) + " = { type = " + key_of(j.type) + ", links = [" +
                     quoted(j.links.first) + ", " + quoted(j.links.second) + "], direction = " + radians(j.direction);
  if (!j.profile.empty()) text += ", profile = " + quoted(j.profile);
  if (!j.points.first.empty()) text += ", points = [" + quoted(j.points.first) + ", " + quoted(j.points.second) + "]";
  return text + " }\n";
}

/// Links and joints of an expanded mechanism, written out.
std::string written_out(const planar::Mechanism::Input& in) {
  std::string text = "ground = " + points_text(in.ground) + "\n";
  for (const auto& link : in.links) text += link_text(link);
  for (const auto& joint : in.joints) text += joint_text(joint);
  for (const auto& profile : in.profiles) text += profile_text(profile);
  return text;
}

/// The lines of a text that do not start with any of these.
std::string without(const std::string& text, const std::vector<std::string>& starts) {
  std::string left;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size() - 1) + 1;
    const std::string line = text.substr(from, end - from);
    if (std::none_of(starts.begin(), starts.end(), [&](const std::string& s) { return line.starts_with(s); }))
      left += line;
    from = end;
  }
  return left;
}

/// The example of a template without template, parameters and masses, and with the joints of its drives.
std::string without_template(const Template& t, const planar::Mechanism::Input& in) {
  std::vector<std::string> starts{"template", "links.", "ground."};
  for (const FieldInfo& f : t.parameters->fields) starts.push_back(std::string(f.key) + " = ");
  std::string text = without(t.example, starts);
  if (!in.crank.joint.empty()) text = replaced(text, "crank = {", "crank = { joint = " + quoted(in.crank.joint) + ",");
  for (const auto& c : in.cylinders) {
    const std::string name(c.name.view());
    if (is_set(c.to))
      text =
          replaced(text, "cylinders." + name + " = {", "cylinders." + name + " = { joint = " + quoted(c.joint) + ",");
    else
      text += "cylinders." + name + " = { joint = " + quoted(c.joint) + " }\n";
  }
  return text;
}

/// The largest difference of two results, as a part of the largest value.
double difference(const Value& a, const Value& b) {
  REQUIRE(a.si.size() == b.si.size());
  double most = 0.0, scale = 0.0;
  for (std::size_t k = 0; k < a.si.size(); ++k) {
    most = std::max(most, std::abs(a.si[k] - b.si[k]));
    scale = std::max(scale, std::abs(a.si[k]));
  }
  return scale == 0.0 ? most : most / scale;
}

/// Every result of one step against that of another; forces against the largest force, for a zero is rounding.
void check_same(const project::Project& one, const project::Project& other) {
  const auto& results = one.steps[0]->account().results;
  CHECK(results.size() == other.steps[0]->account().results.size());
  for (const auto& entry : results) {
    CAPTURE(entry.path);
    const Value* value = other.steps[0]->value(entry.path);
    REQUIRE(value != nullptr);
    double scale = 0.0;
    for (const auto& e : results) {
      if (e.unit == entry.unit) scale = std::max(scale, std::abs(largest(e.value).value));
    }
    for (std::size_t k = 0; k < value->si.size(); ++k) {
      const bool neither = std::isnan(value->si[k]) && std::isnan(entry.value.si[k]) && !entry.missing.empty();
      CHECK((neither || std::abs(value->si[k] - entry.value.si[k]) <= 1e-12 * scale));
    }
  }
}

void check_same(const project::Project& one, const project::Project& other, const std::vector<const char*>& paths) {
  for (const char* path : paths) {
    CAPTURE(path);
    const Value *a = one.steps[0]->value(path), *b = other.steps[0]->value(path);
    REQUIRE(a != nullptr);
    REQUIRE(b != nullptr);
    CHECK(difference(*a, *b) <= 1e-12);
  }
}

const std::string start = "[a]\ncalculator = \"mechanism.planar\"\ncrank = { speed = \"60 rpm\", positions = 12 }\n";
const std::string by_hand =
    "[a]\ncalculator = \"mechanism.planar\"\ncrank = { joint = \"O\", speed = \"60 rpm\", positions = 12 }\n";
const std::string slider = start + "template = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n";
const std::string four_bar =
    start + "template = \"four_bar\"\na = \"40 mm\"\nb = \"120 mm\"\nc = \"80 mm\"\nd = \"100 mm\"\n";

/// Message when a part of a project is replaced, after its place.
std::string said(const std::string& text, const std::string& part, const std::string& other) {
  const auto issues = told(replaced(text, part, other)).issues;
  REQUIRE(issues.size() == 1);
  return issues[0].key + ": " + issues[0].message.text() + (issues[0].hint.empty() ? "" : "; " + issues[0].hint.text());
}

}  // namespace

TEST_SUITE("mechanism templates") {
  TEST_CASE("every example closes over its cycle and passes every proof") {
    for (const Template* t : planar_mechanism().templates) {
      CAPTURE(t->id);
      const auto project = solved(t->example);
      CHECK(project.steps[0]->input().from == t);
      CHECK(account::worst(project::verdicts(project)) == account::State::pass);
    }
  }

  TEST_CASE("every template is the same as its mechanism written out") {
    for (const Template* t : planar_mechanism().templates) {
      CAPTURE(t->id);
      const auto project = solved(t->example);
      const std::string text = without_template(*t, input_of(project)) + written_out(input_of(project));
      CAPTURE(text);
      check_same(project, solved(text));
    }
  }

  TEST_CASE("parameters have unique names in every template") {
    for (const Template* t : planar_mechanism().templates) {
      CAPTURE(t->id);
      for (const FieldInfo& f : t->parameters->fields) {
        CAPTURE(f.key);
        CHECK(find_field(planar_mechanism().input->fields, f.key) == nullptr);
        for (const char* key : {"calculator", "template", "title", "note", "material", "display"})
          CHECK(std::string(f.key) != key);
        CHECK(std::string(f.doc) != "");
      }
    }
  }
}

TEST_SUITE("mechanism templates by hand") {
  TEST_CASE("a slider-crank") {
    check_same(solved(slider + "e = \"10 mm\"\nlinks.slider.mass = \"2 kg\"\n"), solved(by_hand + R"(
ground = { O = ["0 mm", "0 mm"], G = ["0 mm", "10 mm"] }
links.crank = { points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"] }, angle = "0 deg" }
links.rod = { points = { A = ["0 mm", "0 mm"], B = ["200 mm", "0 mm"] }, angle = "3 deg" }
links.slider = { points = { B = ["0 mm", "0 mm"] }, angle = "0 deg", mass = "2 kg" }
joints.O = { type = "revolute", links = ["ground", "crank"] }
joints.A = { type = "revolute", links = ["crank", "rod"] }
joints.B = { type = "revolute", links = ["rod", "slider"] }
joints.guide = { type = "prismatic", links = ["slider", "ground"], points = ["B", "G"] }
)"),
               {"drive.M", "joints.O.F", "joints.B.y", "points.B.x", "points.A.a_x", "links.rod.phi"});
  }

  TEST_CASE("positions of a slider-crank and its mirror image, by Pythagoras") {
    for (const double sign : {1.0, -1.0}) {
      const auto p = solved(slider + "e = \"10 mm\"\nassembly = \"" + (sign > 0 ? "open" : "crossed") + "\"\n");
      const Value& x = *p.value("a.points.B.x");
      for (std::size_t k = 0; k < 12; ++k) {
        const double phi = pi / 6.0 * static_cast<double>(k), y = 0.01 - 0.05 * std::sin(phi);
        CHECK(x.si[k] == doctest::Approx(0.05 * std::cos(phi) + sign * std::sqrt(0.04 - y * y)).epsilon(1e-12));
      }
    }
  }

  TEST_CASE("a four-bar with a coupler point") {
    const std::string mass = "links.coupler.mass = \"2 kg\"\nlinks.coupler.points.P = [\"60 mm\", \"40 mm\"]\n";
    check_same(solved(four_bar + mass), solved(by_hand + R"(
ground = { O = ["0 mm", "0 mm"], C = ["100 mm", "0 mm"] }
links.crank = { points = { O = ["0 mm", "0 mm"], A = ["40 mm", "0 mm"] }, angle = "0 deg" }
joints.O = { type = "revolute", links = ["ground", "crank"] }
joints.A = { type = "revolute", links = ["crank", "coupler"] }
joints.B = { type = "revolute", links = ["coupler", "rocker"] }
joints.C = { type = "revolute", links = ["ground", "rocker"] }
[a.links.rocker]
points = { C = ["0 mm", "0 mm"], B = ["80 mm", "0 mm"] }
angle = "62 deg"
[a.links.coupler]
points = { A = ["0 mm", "0 mm"], B = ["120 mm", "0 mm"], P = ["60 mm", "40 mm"], S = ["60 mm", "0 mm"] }
angle = "36 deg"
S = "S"
mass = "2 kg"
J = "0.0024 kg*m^2"
)"),
               {"drive.M", "joints.C.F", "points.P.x", "points.P.a_y", "links.rocker.omega"});
  }

  TEST_CASE("example 10.1 of [A10], from a template") {
    const auto t = solved(R"([lever]
calculator = "mechanism.planar"
template = "slotted_lever"
r = "30 mm"
d = "90 mm"
l = "150 mm"
crank = { speed = "45 rad/s", start = "-60 deg", positions = 360 }
loads = [{ link = "lever", at = "P", F = "720 N", direction = "-110 deg", axes = "link" }]
[lever.links.lever]
mass = "20 kg"
J = "0.14 kg*m^2"
S = "S3"
points = { S3 = ["55 mm", "0 mm"], P = { r = "40 mm", angle = "-20 deg" } }
)");
    CHECK(std::abs(largest(*t.value("lever.drive.M")).value) == doctest::Approx(86.085).epsilon(1e-5));
    CHECK(largest(*t.value("lever.joints.A.F")).value == doctest::Approx(3653.6).epsilon(1e-5));
  }

  TEST_CASE("the inertia of a bar is that of a slender bar about its middle, unless it is given") {
    const auto J = [](const std::string& more) { return value(solved(four_bar + more), "a.links.rocker.J"); };
    CHECK(J("links.rocker.mass = \"3 kg\"\n") == doctest::Approx(3.0 * 0.08 * 0.08 / 12.0).epsilon(1e-15));
    CHECK(J("links.rocker = { mass = \"3 kg\", J = \"1 kg*m^2\" }\n") == 1.0);
    CHECK(J("links.rocker = { mass = \"3 kg\", J = \"1 kg*m^2\", S = \"B\" }\n") == 1.0);
    CHECK(J("") == 0.0);
  }

  TEST_CASE("typed links and joints are added to a template") {
    const auto p = solved(slider + R"(links.crank.points.W = ["-30 mm", "0 mm"]
links.pump = { points = { V = ["0 mm", "0 mm"], W = ["80 mm", "0 mm"] }, angle = "0 deg", origin = ["-110 mm", "0 mm"] }
links.plunger = { points = { V = ["0 mm", "0 mm"] }, angle = "0 deg", mass = "1 kg" }
ground.H = ["0 mm", "0 mm"]
joints.W = { type = "revolute", links = ["crank", "pump"] }
joints.V = { type = "revolute", links = ["pump", "plunger"] }
joints.bore = { type = "prismatic", links = ["plunger", "ground"], points = ["V", "H"] }
)");
    CHECK(value(p, "a.points.V.x") == doctest::Approx(-0.11).epsilon(1e-12));
    CHECK(account::worst(project::verdicts(p)) == account::State::pass);
  }

  TEST_CASE("friction in a template's joints is that of the user") {
    const auto p = solved(slider + "links.slider.mass = \"9 kg\"\njoints.guide.c = \"20 N*s/m\"\n");
    CHECK(value(p, "a.joints.guide.c") == 20.0);
    CHECK(mean(*p.value("a.drive.P")) > 0.1);
    CHECK(mean(*solved(slider + "links.slider.mass = \"9 kg\"\n").value("a.drive.P")) == doctest::Approx(0.0));
  }

  TEST_CASE("parameters and masses are expressions over other steps") {
    const auto p = solved("[b]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 MPa\"\n" +
                          replaced(slider, "r = \"50 mm\"", "r = \"=b.d / 2\"") + "links.rod.mass = \"=2 * 3 kg\"\n");
    CHECK(value(p, "a.points.A.x") == doctest::Approx(0.04).epsilon(1e-12));
    CHECK(value(p, "a.points.B.x") == doctest::Approx(0.24).epsilon(1e-12));
    CHECK(value(p, "a.links.rod.J") == doctest::Approx(6.0 * 0.04 / 12.0).epsilon(1e-12));
  }

  TEST_CASE("a part of a revolution needs no full one, and starts at the given angle") {
    const auto p = solved(replaced(replaced(slider, "l = \"200 mm\"", "l = \"40 mm\""), "positions = 12",
                                   "at = [\"170 deg\", \"180 deg\"]"));
    CHECK(p.value("a.points.B.x")->si[1] == doctest::Approx(-0.01).epsilon(1e-12));
  }

  TEST_CASE("the report has the template, its parameters, and the origin of values") {
    const auto p = solved(slider + "links.rod.mass = \"1 kg\"\n");
    const std::string text = report::markdown(report::build(p, "loadpath"), "a").text;
    CHECK(text.find("Template slider_crank: Slider-crank, central or offset") != std::string::npos);
    std::vector<std::string> origins;
    for (const char* path : {"r", "e", "links.rod.points.B.x", "links.rod.mass", "links.rod.J", "crank.start"}) {
      for (const auto& e : p.steps[0]->account().inputs) {
        if (e.path == path) origins.push_back(e.origin.text.text());
      }
    }
    CHECK(origins ==
          std::vector<std::string>{"given", "default", "template slider_crank", "given", "slender bar", "default"});
  }
}

TEST_SUITE("mechanism template faults") {
  TEST_CASE("a template, a parameter or a link that does not exist is reported with the nearest one") {
    CHECK(issues_of(replaced(slider, "slider_crank", "slidercrank")) ==
          R"(a.toml:4:13: error: unknown template 'slidercrank'
4 | template = "slidercrank"
  |             ^^^^^^^^^^^
  = help: did you mean 'slider_crank'?
)");
    CHECK(said(slider, "r = \"50", "asembly = \"open\"\nr = \"50")
              .starts_with("a.asembly: 'asembly' is not a valid key here; did you mean 'assembly' ("));
    CHECK(said(slider, "r = \"50 mm\"\n", "") == "a.r: 'r' is missing: length of the crank OA; write r = \"... mm\"");
    CHECK(said(slider, "r = \"50", "links.rdo.mass = \"1 kg\"\nr = \"50") ==
          "a.links.rdo.points: 'links.rdo.points' is missing: points in the link's axes; without origin and angle in "
          "global axes; did you mean 'links.rod'?");
    CHECK(said(slider, "r = \"50", "assembly = \"opne\"\nr = \"50") ==
          "a.assembly: 'opne' is not a valid value of 'assembly'; did you mean 'open'?");
    CHECK(said(axle + "T = \"9 N*m\"\ntau_adm = \"3 MPa\"\n", "T =", "template = \"x\"\nT =") ==
          "axle.template: 'shaft.torsion' has no templates");
  }

  TEST_CASE("parameters without a template, and a template as a calculator, are reported with the template") {
    const std::string none = issues_of(replaced(slider, "template = \"slider_crank\"\n", ""));
    CHECK(none.find("'r' is a parameter of templates, and no template is named") != std::string::npos);
    CHECK(none.find("with one of slider_crank") != std::string::npos);
    CHECK(none.find("is missing") == std::string::npos);
    CHECK(issues_of("[a]\ncalculator = \"mechanism.crank_slider\"\n")
              .ends_with("a template: write calculator = \"mechanism.planar\" and template = \"slider_crank\"\n"));
    CHECK(issues_of(replaced(slider, "slider_crank", "crank_slider")).ends_with("did you mean 'slider_crank'?\n"));
  }

  TEST_CASE("a table that is written as one of its values is reported with the input") {
    CHECK(said(slider, "r = \"50", "loads = [\"3 kN\"]\nr = \"50") ==
          "a.loads[1]: 'loads[1]' is a table of fields, not a text; write loads = [{ F = \"3 kN\" }]");
  }

  TEST_CASE("a key at the wrong level is reported with the place where it belongs") {
    CHECK(said(slider, "r = \"50", "slider.mass = \"1 kg\"\nr = \"50") ==
          "a.slider: 'slider' is not a valid key here; did you mean 'links.slider'?");
    CHECK(said(slider, "r = \"50", "n = \"60 rpm\"\nr = \"50") ==
          "a.n: 'n' is not a valid key here; it is an input of crank: write crank = { speed = \"... rad/s\" }");
    CHECK(
        said(slider, "r = \"50", "loads = { link = \"slider\", at = \"B\", F_x = \"3 kN\" }\nr = \"50") ==
        "a.loads: 'loads' is a list, and this is a single element of it; put it in square brackets: loads = [{ link = "
        "... }]");
  }

  TEST_CASE("a parameter is checked like every field") {
    CHECK(said(slider, "\"50 mm\"", "\"-5 mm\"") == "a.r: r = -5 mm: must be > 0 mm");
    CHECK(said(slider, "\"50 mm\"", "\"5 kg\"") ==
          "a.r: '5 kg' is a mass; a length is expected; write a unit such as mm");
  }

  TEST_CASE("what the template gives cannot be given again") {
    CHECK(said(slider, "r = \"50", "links.rod.angle = \"3 deg\"\nr = \"50") ==
          "a.links.rod.angle: 'links.rod.angle' comes from the template 'slider_crank'; leave it out; mass, J "
          "and S of its links, friction in its joints and new points are free");
    CHECK(said(slider, "speed =", "joint = \"A\", speed =").starts_with("a.crank.joint: 'crank.joint' comes from "));
    CHECK(said(slider, "r = \"50", "links.rod.points.B = [\"1 mm\", \"0 mm\"]\nr = \"50").find("comes from") !=
          std::string::npos);
  }

  TEST_CASE("a point of the template given in the other way is reported once, and so is a duplicate link") {
    CHECK(said(slider, "r = \"50", "links.rod.points.B = { r = \"1 mm\", angle = \"0 deg\" }\nr = \"50")
              .starts_with("a.links.rod.points.B: 'links.rod.points.B' comes from the template 'slider_crank'; "));
    CHECK(said(slider, "r = \"50",
               "links = [{ name = \"rod\", mass = \"1 kg\" }, { name = \"rod\", J = \"1 kg*m^2\" }]\nr = \"50") ==
          "a.links: the name 'rod' is used twice in 'links'");
  }

  TEST_CASE("a bar with a typed mass centre needs its inertia") {
    CHECK(said(slider, "r = \"50", "links.rod = { mass = \"1 kg\", S = \"B\" }\nr = \"50") ==
          "a.links.rod: 'links.rod.J' is missing: 'rod' has its own mass centre, so the slender-bar default does not "
          "apply; write J = "
          "\"... kg*m^2\", about the mass centre; 0 kg*m^2 where its mass is in that point");
  }

  TEST_CASE("a crank that cannot revolve is reported with the numbers") {
    const std::string remedy =
        "; change a length, or solve part of a revolution: crank = { at = [\"0 deg\", \"10 deg\"] }";
    const auto part = [](double least, double most) {
      const auto hundredths = [](double at) { return format_number(0.01 * std::round(100.0 * at * 180.0 / pi), 9); };
      return "; change a length, or solve part of a revolution, between " + hundredths(least) + "° and " +
             hundredths(most) + "°: crank = { at = [...] }";
    };
    // Law of cosines: where coupler and rocker of 120 mm and 80 mm are in line over a frame of 100 mm.
    const auto folded = [](double a) { return std::acos((a * a + 100.0 * 100.0 - 40.0 * 40.0) / (200.0 * a)); };
    CHECK(said(slider, "r = \"50 mm\"", "e = \"160 mm\"\nr = \"50 mm\"") ==
          "a.l: the crank cannot make a full revolution: the rod, l = 200 mm, must exceed the sum of crank and offset, "
          "210 "
          "mm" +
              part(-std::asin(0.8), pi + std::asin(0.8)));
    CHECK(said(four_bar, "a = \"40 mm\"", "a = \"100 mm\"") ==
          "a.a: the crank cannot make a full revolution: its pin moves as far as 200 mm from the fixed pin of the "
          "rocker, but coupler and rocker together reach only 200 mm" +
              part(folded(100.0), 2.0 * pi - folded(100.0)));
    CHECK(said(four_bar, "a = \"40 mm\"", "a = \"70 mm\"") ==
          "a.a: the crank cannot make a full revolution: its pin comes within 30 mm of the fixed pin of the rocker, "
          "but coupler and rocker differ by 40 mm" +
              part(folded(70.0), 2.0 * pi - folded(70.0)));
    const std::string lever = start + "template = \"slotted_lever\"\nr = \"30 mm\"\nd = \"90 mm\"\nl = \"150 mm\"\n";
    CHECK(said(lever, "\"30 mm\"", "\"60 mm\"") ==
          "a.l: the crank pin leaves the slot: it moves as far as d + r = 150 mm from B, but the lever is only 150 mm "
          "long" +
              remedy);
    CHECK(said(lever, "\"90 mm\"", "\"30 mm\"") ==
          "a.r: the crank cannot make a full revolution: r and d are both 30 mm, so its pin A passes through B" +
              remedy);
    const std::string whitworth =
        start + "template = \"whitworth\"\nr = \"100 mm\"\nd = \"40 mm\"\nc = \"80 mm\"\nl = \"250 mm\"\n";
    CHECK(said(whitworth, "\"40 mm\"", "\"140 mm\"") ==
          "a.r: the slotted lever does not turn round: the crank, r = 100 mm, must be longer than the distance of the "
          "lever's pin, d = 140 mm; with a shorter crank the lever swings: template = \"shaper\"");
    // The arm of 80 mm is 70 mm high where its lever has this angle; the crank pin is on the lever's line then.
    const auto crank_of = [](double lever_angle) {
      return lever_angle - std::asin(0.4 * std::cos(lever_angle));  // d/r = 0.4
    };
    CHECK(said(whitworth, "\"250 mm\"", "\"70 mm\"") ==
          "a.l: the lever cannot make a full revolution: the rod, l = 70 mm, must exceed the sum of arm and offset, 80 "
          "mm" +
              part(crank_of(-std::asin(0.875)), crank_of(std::asin(0.875))));
    const std::string shaper = find_template(planar_mechanism(), "shaper")->example;
    CHECK(said(shaper, "d = \"250 mm\"", "d = \"70 mm\"") ==
          "shaper.r: the lever does not swing: the crank, r = 80 mm, must be shorter than the distance of the lever's "
          "pin, d = 70 mm; with a longer crank the lever makes full revolutions: template = \"whitworth\"");
    CHECK(said(shaper, "c = \"450 mm\"", "c = \"330 mm\"").starts_with("shaper.c: the crank pin leaves the slot: "));
    CHECK(said(shaper, "e = \"440 mm\"", "e = \"600 mm\"") ==
          "shaper.l: the crank cannot make a full revolution: the end of the lever moves as far as 173.66 mm from the "
          "guide, but the rod is only 150 mm long" +
              remedy);
    const std::string engine = start + "template = \"oscillating_cylinder\"\nr = \"40 mm\"\nd = \"160 mm\"\n";
    CHECK(said(engine, "\"160 mm\"", "\"40 mm\"")
              .starts_with("a.r: the crank cannot make a full revolution: r and d are both 40 "));
    const Template* toggle = find_template(planar_mechanism(), "toggle_press");
    CHECK(said(toggle->example, "r = \"40 mm\"", "r = \"140 mm\"")
              .starts_with("press.r: the crank cannot make a full revolution: its pin moves as far as "));
  }

  TEST_CASE("lengths that do not meet at the first position are reported by name") {
    const std::string at = "at = \"0 deg\"";
    CHECK(
        said(replaced(four_bar, "positions = 12", at), "b = \"120 mm\"", "b = \"160 mm\"") ==
        "a: 'coupler' (160 mm) and 'rocker' (80 mm) do not meet at a crank angle of 0°: their other ends are 60 mm "
        "apart, less than their difference of 80 mm; change a length, or start elsewhere: the mechanism closes between "
        "49.46° and 310.54°");  // acos(0.65)
    CHECK(said(replaced(four_bar, "positions = 12", "at = \"180 deg\""), "b = \"120 mm\"", "b = \"50 mm\"") ==
          "a: 'coupler' (50 mm) and 'rocker' (80 mm) do not meet at a crank angle of 180°: their other ends are 140 "
          "mm apart, more than their sum of 130 mm; change a length, or start elsewhere: the mechanism closes between "
          "228.51° and 491.49°");  // acos((40^2 + 100^2 - 130^2)/(2 40 100))
    CHECK(said(replaced(slider, "positions = 12", "at = \"90 deg\""), "l = \"200 mm\"", "l = \"45 mm\"") ==
          "a: 'rod' (45 mm) does not reach its guide, which is 50 mm away at a crank angle of 90°; change a length, "
          "or start elsewhere: the mechanism closes between 115.84° and 244.16°");  // asin(45/50)
    const Template* loader = find_template(planar_mechanism(), "loader_arm");
    CHECK(said(loader->example, "s_1 = \"1 m\"", "s_1 = \"4 m\"").starts_with("loader: 'arm' ("));
  }

  TEST_CASE("errors in values that are known later are reported later") {
    CHECK(said(slider, "\"50 mm\"", "\"=5 * 50 mm\"")
              .starts_with("a.l: the crank cannot make a full revolution: the rod, l = 200 "));
  }
}
