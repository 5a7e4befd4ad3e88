// Differences between two projects, from the shell.
#include "tests/cli/process.hpp"

#include <boost/json.hpp>

using namespace loadpath::test;
namespace json = boost::json;

namespace {

const std::string shaft =
    "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"900 N*m\"\nG = \"80 GPa\"\ntau_adm = \"30 MPa\"\n";
const std::string rod =
    "[rod]\ncalculator = \"fatigue.cycle\"\nstress = \"shear\"\nsigma_max = \"=shaft.tau_max\"\nsigma_min = \"0 "
    "MPa\"\n";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string changed(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

Ran diff(const std::string& before, const std::string& after, const std::vector<std::string>& more = {}) {
  const Desk desk;
  desk.put("a.toml", before);
  desk.put("b.toml", after);
  std::vector<std::string> words{"diff", "a.toml", "b.toml"};
  words.insert(words.end(), more.begin(), more.end());
  return desk.run(words);
}

/// A line of columns as words: "chosen d 56 mm -> 63 mm".
std::string in_words(const std::string& text) {
  std::string words;
  for (const char c : text) {
    if (c != ' ' || !words.ends_with(' ')) words += c;
  }
  return words;
}

}  // namespace

TEST_SUITE("cli diff") {
  TEST_CASE("there is no difference where the same is given in another order and other units") {
    const Ran same = diff(shaft + rod, "# other words\n" + rod + changed(shaft, "900 N*m", "0.9 kN*m"));
    CHECK(same.code == 0);
    CHECK(same.out == "a.toml -> b.toml\nno difference\n");
    CHECK(same.error.empty());
  }

  TEST_CASE("inputs, chosen sizes, verdicts, governing modes, utilisations and results are compared by step") {
    const Ran told = diff(shaft + rod, changed(shaft, "900 N*m", "1200 N*m") + rod);
    CHECK(told.code == 1);
    const std::string words = in_words(told.out);
    CHECK(contains(words, "\n input T 900 N·m -> 1200 N·m +33.3 %\n"));
    CHECK(contains(words, "\n chosen d 56 mm -> 60 mm +7.14 %\n"));
    CHECK(contains(words, "\n utilisation yield 0.870016 -> 0.94314 +8.4 %\n"));
    CHECK(contains(words, "\n result tau_max 26.1005 MPa -> 28.2942 MPa +8.4 %\n"));
    CHECK(contains(words, "\n linked sigma_max 26.1005 MPa -> 28.2942 MPa +8.4 %\n"));
    const Ran weak = diff(shaft + "d = \"56 mm\"\n", shaft + "d = \"40 mm\"\n");
    CHECK(weak.code == 1);
    CHECK(contains(in_words(weak.out), "\n verdict yield pass -> fail"));
  }

  TEST_CASE("added and removed steps, and another calculator, are reported") {
    const Ran gone = diff(shaft + rod, shaft);
    CHECK(gone.code == 1);
    CHECK(contains(gone.out, "\nrod: Stress cycle (fatigue.cycle), removed: "));
    CHECK_FALSE(contains(gone.out, "\nshaft"));
    CHECK(contains(diff(shaft, shaft + rod).out, "\nrod: Stress cycle (fatigue.cycle), added: "));
    const Ran other = diff(shaft, "[shaft]\ncalculator = \"fatigue.cycle\"\nsigma_a = \"90 MPa\"\nr = -1\n");
    CHECK(contains(in_words(other.out), "\n heading calculator shaft.torsion -> fatigue.cycle\n"));
  }

  TEST_CASE("titles, rows of tables and reasons are inputs too") {
    const Ran material = diff(changed(shaft, "G = \"80 GPa\"", "material = \"C45E\""),
                              changed(shaft, "G = \"80 GPa\"", "material = \"S355\""));
    CHECK(contains(in_words(material.out), "\n input material C45E -> S355\n"));
    const Ran title =
        diff("[project]\ntitle = \"A\"\n" + shaft, "[project]\ntitle = \"B\"\nrevision = \"2\"\n" + shaft);
    CHECK(title.code == 1);
    CHECK(contains(in_words(title.out), "\n heading title A -> B\n"));
    CHECK(contains(in_words(title.out), "\n heading revision none -> 2\n"));
    const Ran accepted = diff(shaft, shaft + "accept.fatigue = \"stands still\"\n");
    CHECK(contains(in_words(accepted.out), "\n input accept.fatigue none -> stands still"));
    CHECK(contains(in_words(accepted.out), "\n verdict fatigue not considered -> accepted by user"));
  }

  TEST_CASE("as JSON every difference is listed, with its relative change") {
    const Ran told = diff(shaft, changed(shaft, "900 N*m", "1200 N*m"), {"--json"});
    CHECK(told.code == 1);
    const json::object all = json::parse(told.out).as_object();
    CHECK(all.at("differ").as_bool());
    const json::object step = all.at("steps").as_array().at(0).as_object();
    CHECK(step.at("name") == "shaft");
    const json::object first = step.at("differences").as_array().at(0).as_object();
    CHECK(first.at("kind") == "input");
    CHECK(first.at("name") == "T");
    CHECK(first.at("before") == "900 N·m");
    CHECK(first.at("relative").as_double() == doctest::Approx(1.0 / 3.0));
    CHECK_FALSE(json::parse(diff(shaft, shaft, {"--json"}).out).at("differ").as_bool());
  }

  TEST_CASE("a file that cannot be solved or read is reported, and nothing is compared") {
    const Ran wrong = diff(shaft, changed(shaft, "MPa", "mpa"));
    CHECK(wrong.code == 2);
    CHECK(wrong.out.empty());
    CHECK(contains(wrong.error, "b.toml:5:"));
    CHECK(loadpath_with({"diff", "a.toml", "b.toml"}).code == 2);
    CHECK(loadpath_with({"diff", "-", "-"}).code == 2);
    const Desk desk;
    desk.put("a.toml", shaft);
    CHECK(desk.run({"diff", "a.toml", "-"}, shaft).code == 0);
  }
}
