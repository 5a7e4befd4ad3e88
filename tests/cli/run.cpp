#include "tests/cli/process.hpp"
#include "tests/lib/project/texts.hpp"

#include <boost/json.hpp>

#include <cctype>
#include <cmath>
#include <filesystem>

using namespace loadpath::test;
namespace json = boost::json;

namespace {

const std::string passing = "[axle]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 MPa\"\n";
const std::string failing = passing + "d = \"40 mm\"\n";
const std::string wrong = "[axle]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 mpa\"\n";

/// A four-bar that cannot turn round, and two shafts behind it.
const std::string not_turning = bar_that_cannot_turn(36) + R"toml([sized]
calculator = "shaft.torsion"
T = "=peak(bar.drive.M)"
tau_adm = "30 MPa"
[lifted]
calculator = "shaft.overhung"
F = "=bar.joints.A.F"
T = "=bar.drive.M"
a = "50 mm"
sigma_adm = "60 MPa"
)toml";

Ran run(const std::string& project, std::vector<std::string> words = {}) {
  words.insert(words.begin(), {"run", "-"});
  return Desk().run(words, project);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Whether a text contains NaN or infinity as a word.
/// The text without embedded fonts, whose letters are arbitrary.
std::string without_fonts(std::string text) {
  for (std::size_t at = 0; (at = text.find("base64,", at)) != std::string::npos;)
    text.erase(at, text.find(')', at) - at);
  return text;
}

bool has_no_number(const std::string& text) {
  for (const char* word : {"nan", "NaN", "inf", "Infinity", "-nan"}) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) {
      const auto letter = [&](std::size_t i) {
        return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
      };
      if (!(at > 0 && letter(at - 1)) && !letter(at + std::string(word).size())) return true;
    }
  }
  return false;
}

}  // namespace

TEST_SUITE("cli run") {
  TEST_CASE("the exit code distinguishes passed, not passed and wrong") {
    CHECK(run(passing).code == 0);
    CHECK(run(failing).code == 1);
    CHECK(run(wrong).code == 2);
  }

  TEST_CASE("results are on standard output, everything else on standard error") {
    const Ran good = run(passing), bad = run(wrong);
    CHECK(good.out.starts_with("PASS (torsion only; "));
    CHECK(good.error.empty());
    CHECK(bad.out.empty());
    CHECK(bad.error == R"(standard input:4:15: error: unknown unit 'mpa'
4 | tau_adm = "30 mpa"
  |               ^^^
  = help: did you mean 'MPa'?
)");
  }

  TEST_CASE("a file is read by its name, and errors have it") {
    const Desk desk;
    desk.put("shaft.toml", wrong);
    CHECK(desk.run({"run", "shaft.toml"}).error.starts_with("shaft.toml:4:15: error: unknown unit 'mpa'\n"));
    CHECK(desk.run({"run", "nothing.toml"}).error == "loadpath: cannot read 'nothing.toml'\n  = help: no such file\n");
    CHECK(desk.run({"run", "shfat.toml"}).error ==
          "loadpath: cannot read 'shfat.toml'\n  = help: did you mean 'shaft.toml'?\n");
    CHECK(desk.run({"run", "nothing.toml"}).code == 2);
    CHECK(desk.run({"run", "."}).code == 2);
  }

  TEST_CASE("a file may have the name of a command") {
    const Desk desk;
    desk.put("list", passing);
    CHECK(desk.run({"run", "list"}).code == 0);
  }

  TEST_CASE("nothing is written when the input is wrong") {
    const Desk desk;
    desk.put("a.toml", wrong);
    CHECK(desk.run({"run", "a.toml", "--report", "a.html", "--report", "a.md", "--csv", "out"}).code == 2);
    CHECK(desk.files() == std::vector<std::string>{"a.toml"});
  }

  TEST_CASE("nothing is written when a computed value is out of bounds") {
    const Desk desk;
    desk.put("a.toml", passing + "K_A = \"=1 - 2\"\n");
    const Ran o = desk.run({"run", "a.toml", "--report", "a.html"});
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(o.error == "a.toml:5:9: error: K_A = -1: must be >= 1\n5 | K_A = \"=1 - 2\"\n  |         ^^^^^\n");
    CHECK(desk.files() == std::vector<std::string>{"a.toml"});
  }

  TEST_CASE("reports are written to the given files, several at once") {
    const Desk desk;
    const Ran o = desk.run({"run", "-", "--report", "out/a.html", "--report", "a.md"}, passing);
    CHECK(o.code == 0);
    CHECK(o.error == "report: out/a.html\nreport: a.md\n");
    CHECK(desk.get("out/a.html").starts_with("<!doctype html>"));
    CHECK(desk.has("a.md"));
  }

  TEST_CASE("a report that cannot be written is refused before solving") {
    const Desk desk;
    desk.put("file", "");
    CHECK(desk.run({"run", "-", "--report", "a.doc"}, passing).error ==
          "loadpath: a report is written as .html, .md, .tex or .pdf, not as 'a.doc'\n");
    CHECK(desk.run({"run", "-", "--report", "file/a.html"}, passing).error ==
          "loadpath: cannot write 'file/a.html': it is a folder, or lies in a file\n");
    CHECK(desk.run({"run", "-", "--report", "/proc/a.html"}, passing).code == 2);
    const Ran o = desk.run({"run", "-", "--report", "a.pdf"}, passing, {{"PATH", "/nowhere"}});
    CHECK(o.code == 2);
    CHECK(o.error.starts_with("loadpath: a PDF needs Chromium, and there is none\n"));
    CHECK(desk.files() == std::vector<std::string>{"file"});
  }

  TEST_CASE("--quiet keeps errors and the exit code") {
    const Ran good = run(passing + "theta_adm = \"15 deg/m\"\nG = \"80 GPa\"\n", {"--quiet"});
    CHECK(good.code == 0);
    CHECK(good.out.empty());
    CHECK(good.error.empty());
    CHECK(run(failing, {"--quiet"}).code == 1);
    CHECK(run(wrong, {"--quiet"}).error.starts_with("standard input:4:15: error:"));
  }

  TEST_CASE("with --strict modes not considered count as not assessed in every verdict") {
    const Desk desk;
    desk.put("a.toml", passing);
    const std::vector<std::string> strict{"run",      "a.toml", "--strict", "--full",
                                          "--report", "a.md",   "--report", "a.html"};
    const Ran shown = desk.run(strict);
    CHECK(shown.code == 4);
    CHECK(contains(shown.out, "\n  not assessed       axle.twist "));
    CHECK(contains(shown.out, "\nnot assessed: axle."));
    CHECK_FALSE(contains(shown.out, "not considered"));
    CHECK(contains(desk.get("a.md"), "INCOMPLETE: "));
    CHECK(contains(desk.get("a.md"), "- Strict: failure modes not considered count as not assessed (--strict)\n"));
    CHECK_FALSE(contains(desk.get("a.md"), "not considered\\."));
    CHECK(contains(desk.get("a.html"), "not assessed"));
    const Ran as_json = desk.run({"run", "a.toml", "--strict", "--json"});
    CHECK(as_json.code == 4);
    CHECK(json::parse(as_json.out).at("verdict").at("state") == "not judged");
    CHECK(json::parse(as_json.out).at("verdict").at("headline") == "INCOMPLETE");
    CHECK(json::parse(as_json.out).at("verdict").at("not_considered") == 0);
    CHECK(json::parse(as_json.out).at("verdict").at("strict") == true);
    CHECK(desk.run({"run", "a.toml"}).code == 0);
  }

  TEST_CASE("the result of a search is at the top, with its reason") {
    const Desk desk;
    desk.put("a.toml", passing);
    const std::string reason = "smallest of R40 with which no assessed mode fails; 75 mm fails: u_tau = 1.086";
    const Ran ran = desk.run({"run", "a.toml", "--full", "--report", "a.md", "--report", "a.html"});
    CHECK(contains(ran.out, ")\n  found  d = 80 mm  " + reason + "\n"));
    CHECK(contains(loadpath_with({"shaft", "torsion", "--T", "2700 N*m", "--tau_adm", "30 MPa", "--full"}).out,
                   ")\n  found  d = 80 mm  " + reason + "\n"));
    const std::string page = desk.get("a.md");
    CHECK(page.find("**Table 1.** Sized and selected values") < page.find("failure mode "));
    CHECK(contains(page, "smallest of R40 with which no assessed mode fails; 75 mm fails"));
    CHECK(contains(desk.get("a.html"), "</b> Sized and selected values"));
    CHECK_FALSE(contains(run(failing).out, "found"));
  }

  TEST_CASE("a size that the row of a table leaves out is not a size of the part") {
    const Ran ran =
        run("[stay]\ncalculator = \"column.buckling\"\nP = \"60 kN\"\nl = \"2.2 m\"\nends = \"pinned_pinned\"\n"
            "section = \"SHS 60x60x3\"\nmaterial = \"S235JR\"\nmethod = \"ec3\"\ncurve_y = \"a\"\ncurve_z = \"a\"\n"
            "gamma_M1 = 1\ngamma_F = 1.4\n");
    CHECK_MESSAGE(contains(ran.out, "\n  stay       SHS 60x60x3  "), ran.out);
    CHECK_FALSE(contains(ran.out, "not available"));
  }

  TEST_CASE("expectations that are missed are reported in one line, and do not affect the verdict") {
    const std::string right = "[[expect]]\nvalue = \"axle.T\"\nis = \"2700 N*m\"\ndigits = 3\nsource = \"given\"\n";
    const std::string wrong_one =
        "[[expect]]\nvalue = \"axle.T\"\nis = \"2600 N*m\"\ndigits = 3\nsource = \"a slip\"\n";
    const Desk desk;
    desk.put("a.toml", passing + right + wrong_one);
    const Ran ran = desk.run({"run", "a.toml"});
    CHECK(ran.code == 0);
    CHECK(ran.error == "1 of 2 expectations miss: `loadpath verify a.toml` shows them\n");
    CHECK(desk.run({"run", "a.toml", "--quiet"}).error.empty());
    CHECK(run(passing + right).error.empty());
    CHECK(run(passing + wrong_one).error == "1 of 1 expectation misses: `loadpath verify -` shows them\n");
  }

  TEST_CASE("--json is one object, and a number reads back to the result") {
    const Ran o = run(passing, {"--json"});
    CHECK(o.code == 0);
    const json::value v = json::parse(o.out);
    CHECK(v.at("verdict").at("state") == "pass");
    const double d = v.at("steps").at(0).at("results").at("d_min").at("value").as_double();
    CHECK(d == doctest::Approx(std::cbrt(16.0 * 2700.0 / (std::acos(-1.0) * 30e6))).epsilon(1e-14));
  }

  TEST_CASE("--json gives errors as one object, too") {
    const Ran o = run(wrong, {"--json"});
    CHECK(o.code == 2);
    const json::value v = json::parse(o.out);
    CHECK(v.at("issues").at(0).at("message") == "unknown unit 'mpa'");
    CHECK(contains(o.error, "unknown unit 'mpa'"));
  }

  TEST_CASE("no colour without a terminal, nor with NO_COLOR") {
    CHECK_FALSE(contains(run(failing).out, "\x1b"));
    CHECK_FALSE(contains(Desk().run({"run", "-"}, failing, {{"NO_COLOR", "1"}}).out, "\x1b"));
  }

  TEST_CASE("two runs write the same bytes") {
    const Desk one, two;
    for (const Desk* desk : {&one, &two}) {
      CHECK(desk->run({"run", LOADPATH_ROOT "/examples/slotted-lever/project.toml", "--report", "a.html", "--report",
                       "a.md", "--csv", "csv", "--quiet"})
                .code == 0);
    }
    REQUIRE(one.files() == two.files());
    CHECK(one.files().size() > 3);
    for (const std::string& file : one.files()) {
      CAPTURE(file);
      CHECK(one.get(file) == two.get(file));
    }
    const std::vector<std::string> as_json{"run", LOADPATH_ROOT "/examples/slotted-lever/project.toml", "--json"};
    CHECK(one.run(as_json).out == two.run(as_json).out);
  }

  TEST_CASE("the user's words are escaped in reports") {
    const Desk desk;
    const std::string script = "<script>alert('x')</script>";
    desk.put("a.toml", "[project]\ntitle = \"" + script + "\"\nprepared = \"a & b <em>\"\n" + passing + "title = \"" +
                           script + "\"\nnote = \"" + script + "\"\n");
    REQUIRE(desk.run({"run", "a.toml", "--report", "a.html", "--report", "a.md"}).code == 0);
    CHECK_FALSE(contains(desk.get("a.html"), "<script>alert"));
    CHECK_FALSE(contains(desk.get("a.html"), "<em>"));
    CHECK(contains(desk.get("a.html"), "&lt;script&gt;"));
    CHECK_FALSE(contains(desk.get("a.md"), "<script"));
  }

  TEST_CASE("a mechanism that does not close around the revolution fails: exit 1, dependent results not available") {
    const Desk desk;
    desk.put("a.toml", not_turning);
    const Ran o = desk.run({"run", "a.toml", "--json", "--report", "a.html", "--csv", "csv"});
    CHECK(o.code == 1);
    const json::value v = json::parse(o.out);
    CHECK(v.at("verdict").at("state") == "fail");
    const auto& steps = v.at("steps").as_array();
    CHECK(contains(std::string(steps[0].at("checks").at(0).at("reason").as_string()), "between "));
    for (const std::size_t dependent : {1U, 2U}) {
      const auto& checks = steps[dependent].at("checks").as_array();
      REQUIRE_FALSE(checks.empty());
      CHECK(checks[0].at("verdict") == "not available");
      CHECK(contains(std::string(checks[0].at("reason").as_string()), " is not available: = "));
    }
    CHECK(contains(desk.get("a.html"), "not available"));
    CHECK_FALSE(contains(desk.run({"run", "a.toml"}).out, "(at not available)"));
  }

  TEST_CASE("no output contains nan or inf, for any input") {
    const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\n";
    const std::string pin = "[pin]\ncalculator = \"shaft.overhung\"\n";
    const std::string projects[] = {
        not_turning,
        axle + no_torque + "tau_adm = \"30 MPa\"\n" + relay,
        axle + "T = \"0 N*m\"\ntau_adm = \"30 MPa\"\ntheta_adm = \"1 deg/m\"\nG = \"80 GPa\"\n",
        axle + "T = \"1e300 N*m\"\nK_A = 1e300\ntau_adm = \"1e-300 MPa\"\n",
        axle +
            "T = \"1 N*m\"\nd = \"1e-300 mm\"\nl = \"1e300 m\"\nG = \"1e-300 GPa\"\ntheta_adm = \"1e-300 "
            "rad/m\"\ntau_adm = \"1 MPa\"\n",
        axle + "T = \"1 N*m\"\nd_bore = \"1e300 mm\"\ntau_adm = \"1 MPa\"\n",
        axle + "T = \"1 MN*m\"\nS = 3\nmaterial = \"C45E\"\n",
        pin +
            "F = \"1e300 N\"\na = \"1e300 m\"\nT = \"1e300 N*m\"\nsigma_adm = \"1e-300 MPa\"\ntau_adm = \"1e-300 "
            "MPa\"\n",
        pin + "F = \"0 N\"\na = \"1 mm\"\nT = \"0 N*m\"\nsigma_adm = \"60 MPa\"\n",
    };
    for (const std::string& project : projects) {
      CAPTURE(project);
      const Desk desk;
      const Ran text = desk.run({"run", "-", "--report", "a.html", "--report", "a.md", "--csv", "csv"}, project);
      CHECK((text.code <= 2 || text.code == 4));
      CHECK_FALSE(has_no_number(text.out));
      for (const std::string& file : desk.files()) {
        CAPTURE(file);
        CHECK_FALSE(has_no_number(without_fonts(desk.get(file))));
      }
      const Ran as_json = desk.run({"run", "-", "--json"}, project);
      CHECK_FALSE(has_no_number(as_json.out));
      CHECK_NOTHROW(json::parse(as_json.out));
    }
  }

  TEST_CASE("the paper of a report: A4, or letter if the project states so") {
    const Desk desk;
    desk.put("a.toml", passing);
    desk.put("b.toml", "[project]\npaper = \"letter\"\n" + passing);
    desk.put("c.toml", "[project]\npaper = \"lettre\"\n" + passing);
    REQUIRE(desk.run({"run", "a.toml", "--report", "a.html"}).code == 0);
    REQUIRE(desk.run({"run", "b.toml", "--report", "b.html"}).code == 0);
    CHECK(contains(desk.get("a.html"), "@page{size:A4;"));
    CHECK(contains(desk.get("b.html"), "@page{size:letter;"));
    const Ran wrong = desk.run({"run", "c.toml", "--report", "c.html"});
    CHECK(wrong.code == 2);
    CHECK(contains(wrong.error, "did you mean 'letter'?"));
    CHECK(!desk.has("c.html"));
  }

  TEST_CASE("a project names the report that a run writes next to it; the flag replaces it") {
    const Desk desk;
    std::filesystem::create_directory(desk.folder() / "job");
    desk.put("job/a.toml", "[project]\nreport = \"sheet.md\"\n" + passing);
    const Ran own = desk.run({"run", "job/a.toml"});
    CHECK(own.code == 0);
    CHECK(contains(own.error, "report: job/sheet.md"));
    REQUIRE(desk.has("job/sheet.md"));
    const Ran other = desk.run({"run", "job/a.toml", "--report", "other.html"});
    CHECK(other.code == 0);
    CHECK(desk.has("other.html"));
    CHECK_FALSE(contains(other.error, "sheet.md"));
  }

  TEST_CASE("a report that a project names is checked like a flag, before anything is solved") {
    const Desk desk;
    desk.put("a.toml", "[project]\nreport = \"sheet.docx\"\n" + passing);
    const Ran unknown = desk.run({"run", "a.toml"});
    CHECK(unknown.code == 2);
    CHECK(contains(unknown.error, "a report is written as .html, .md, .tex or .pdf, not as 'sheet.docx'"));
    desk.put("b.toml", "[project]\nreport = 3\n" + passing);
    CHECK(desk.run({"run", "b.toml"}).code == 2);
    desk.put("c.toml", "[project]\nreport = \"a.toml/c.html\"\n" + passing);
    const Ran in_file = desk.run({"run", "c.toml"});
    CHECK(in_file.code == 2);
    CHECK(contains(in_file.error, "cannot write 'a.toml/c.html'"));
  }

  TEST_CASE("amount of output: brief is the answer, full has the input, and the answer is the same") {
    const Desk desk;
    desk.put("a.toml", "# my words\n" + passing);
    const Ran brief = desk.run({"run", "a.toml", "--detail", "brief", "--report", "b.html"});
    const Ran normal = desk.run({"run", "a.toml", "--full", "--report", "n.html"});
    const Ran full = desk.run({"run", "a.toml", "--detail", "full", "--report", "f.html"});
    CHECK(brief.out.size() < normal.out.size());
    CHECK(normal.out.size() < full.out.size());
    CHECK(desk.get("b.html").size() < desk.get("n.html").size());
    CHECK(contains(desk.get("f.html"), "# my words"));
    CHECK(!contains(desk.get("n.html"), "# my words"));
    for (const Ran* ran : {&brief, &normal, &full}) {
      CHECK(ran->code == 0);
      CHECK(contains(ran->out, "d = 80 mm"));
      CHECK(contains(ran->out, "█"));
    }
    CHECK(desk.run({"run", "a.toml", "--detail", "much"}).code == 2);
  }

  TEST_CASE("a given size is shown next to those that were found") {
    const Desk desk;
    desk.put("a.toml",
             "[axle]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 MPa\"\nd = \"85 mm\"\n");
    const Ran ran = desk.run({"run", "a.toml", "--detail", "brief", "--report", "a.md"});
    CHECK(contains(ran.out, "d = 85 mm"));
    CHECK(contains(desk.get("a.md"), "d\u00A0=\u00A085\u00A0mm"));
  }

  TEST_CASE("--brief writes the pages without the appendix, and needs a report") {
    const Desk desk;
    desk.put("a.toml", passing);
    const Ran brief = desk.run({"run", "a.toml", "--brief", "--report", "b.html", "--report", "b.md"});
    CHECK(brief.code == 0);
    CHECK(brief.out == desk.run({"run", "a.toml", "--report", "n.html"}).out);
    CHECK(!contains(desk.get("b.html"), "id=appendix"));
    CHECK(contains(desk.get("n.html"), "id=appendix"));
    CHECK(contains(desk.get("b.md"), "## Assumptions"));
    CHECK(!contains(desk.get("b.md"), "# Appendix"));
    const Ran alone = desk.run({"run", "a.toml", "--brief"});
    CHECK(alone.code == 2);
    CHECK(alone.error == "loadpath: --brief needs --report FILE\n");
    CHECK(desk.run({"run", "a.toml", "--brief", "--detail", "full", "--report", "c.html"}).code == 2);
  }

  TEST_CASE("a page with signatures has the date of the run, a text for comparison does not") {
    const Desk desk;
    desk.put("a.toml", passing);
    CHECK(desk.run({"run", "a.toml", "--report", "a.html", "--report", "a.md"}).code == 0);
    CHECK(contains(desk.get("a.html"), "<dt>Date<dd>20"));
    CHECK(contains(desk.get("a.md"), "- Date: not given"));
  }
}
