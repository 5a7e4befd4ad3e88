// The command `sweep`: the same bytes by any number of threads and shards, after every kind of end; and its words.
#include "tests/cli/sweeps.hpp"
#include "tests/parts.hpp"
#include "tests/program.hpp"
#include "tests/tries.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <random>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace loadpath::test;

namespace {

pid_t start(const Desk& desk, const std::vector<std::string>& words) {
  std::vector<char*> all;
  const std::string folder = desk.folder().string();
  std::vector<std::string> kept{"sh", "-c", "cd '" + folder + "' && exec '" + program + "' \"$@\" 2>/dev/null", "sh"};
  kept.insert(kept.end(), words.begin(), words.end());
  for (std::string& word : kept) all.push_back(word.data());
  all.push_back(nullptr);
  pid_t child = 0;
  REQUIRE(posix_spawn(&child, "/bin/sh", nullptr, nullptr, all.data(), environ) == 0);
  return child;
}

}  // namespace

TEST_SUITE("sweep command" * by_case) {
  TEST_CASE("threads, shards and one process write the same bytes") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    CHECK(desk.run({"sweep", "a.toml", "--out", "one", "--jobs", "1", "--quiet"}).code == 0);
    CHECK(desk.run({"sweep", "a.toml", "--out", "three", "--jobs", "3", "--quiet"}).code == 0);
    CHECK(same_folders(desk, "one", "three"));
    for (const char* k : {"1", "2", "3", "4", "5"})
      CHECK(desk.run({"sweep", "a.toml", "--out", std::string("s") + k, "--shard", std::string(k) + "/5", "--quiet"})
                .code == 0);
    CHECK(desk.run({"sweep", "a.toml", "--out", "merged", "--merge", "s3", "s1", "s5", "s2", "s4", "--quiet"}).code ==
          0);
    CHECK(same_folders(desk, "one", "merged"));
    const Ran json = desk.run({"sweep", "a.toml", "--json"});
    CHECK(json.out == desk.run({"sweep", "a.toml", "--json", "--jobs", "1"}).out);
    CHECK(contains(json.out, "\"points\": 14000"));
    CHECK(desk.run({"sweep", "a.toml", "--out", "gap", "--merge", "s1", "s2", "s4", "s5"}).code == 2);
    CHECK(!desk.has("gap"));
    const Ran twice = desk.run({"sweep", "a.toml", "--out", "twice", "--merge", "s1", "s1", "s2", "s3", "s4", "s5"});
    CHECK(contains(twice.error, "left out, the points are in others: 's1'"));
    CHECK(same_folders(desk, "one", "twice"));
    CHECK(desk.run({"sweep", "a.toml", "--out", "one"}).code == 2);
  }
}

TEST_SUITE("killed sweeps" * takes_share) {
  TEST_CASE("a killed or interrupted sweep resumes, and ends with the same bytes") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(desk.run({"sweep", "a.toml", "--out", "one", "--quiet", "--no-columns"}).code == 0);
    const std::vector<std::string> slow{"sweep", "a.toml", "--quiet", "--jobs", "1", "--save-every", "0", "--out"};
    const auto into = [&](const std::string& folder) {
      std::vector<std::string> words = slow;
      words.push_back(folder);
      return words;
    };
    auto lasts = duration_of([&] { REQUIRE(desk.run(into("whole")).code == 0); });
    std::mt19937 random(5);
    const int enough = tries(100) / 5 + 1;
    int ended_early = 0;
    for (int i = 0; i < tries(100) || (ended_early < enough && i < 10 * tries(100)); ++i) {
      std::filesystem::remove_all(desk.folder() / "part");
      const int signal = i % 4 == 0 ? SIGINT : SIGKILL;
      const pid_t child = start(desk, into("part"));
      std::this_thread::sleep_for(lasts * (random() % 1000) / 1000);
      kill(child, signal);
      int status = 0;
      REQUIRE(waitpid(child, &status, 0) == child);
      const bool ended = !WIFEXITED(status) || WEXITSTATUS(status) != 0;
      ended_early += ended ? 1 : 0;
      if (!ended) lasts = lasts * 4 / 5;  // the machine is less loaded than when it was measured
      std::vector<std::string> words{"sweep", "a.toml", "--out", "part", "--quiet"};
      if (desk.has("part")) words.emplace_back("--resume");  // with a state or before the first
      const Ran again = desk.run(words);
      CHECK_MESSAGE(again.code == 0, again.error);
      CHECK(same_folders(desk, "whole", "part"));
    }
    CHECK(ended_early >= enough);
  }
}

TEST_SUITE("sweep command" * by_case) {
  TEST_CASE("Ctrl-C keeps the solved points, and states how to resume") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    const Ran ran = desk.shell(std::string("'") + program +
                               "' sweep a.toml --samples 10000000 --out part --save-every 0.05 --no-columns --quiet & "
                               "at=$!; " +
                               until_solved("part") + "kill -INT $at; wait $at");
    CHECK(ran.code == 130);
    CHECK(contains(ran.error, "stopped at "));
    CHECK(!contains(ran.error, "stopped at 0 points"));
    CHECK(contains(ran.error, "--out part --resume goes on"));
  }

  TEST_CASE("searches find the same with any number of threads") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    for (const std::vector<std::string>& asked :
         std::vector<std::vector<std::string>>{{"--minimise", "shaft.d", "--quantile", "0.9", "--samples", "20000"},
                                               {"--sobol", "30000", "--results", "shaft.phi"},
                                               {"--seek", "shaft.tau_max = 20 MPa"}}) {
      std::vector<std::string> words{"sweep", "a.toml", "--jobs", "1"};
      words.insert(words.end(), asked.begin(), asked.end());
      const Ran one = desk.run(words);
      words[3] = "5";
      const Ran five = desk.run(words);
      CAPTURE(one.out);
      CHECK(one.code == five.code);
      CHECK(one.out == five.out);
      CHECK(one.error == five.error);
      CHECK(one.code == 0);
    }
  }

  TEST_CASE("the folder states its progress") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    CHECK(desk.run({"sweep", "--status", "by"}).code == 2);
    CHECK(desk.run({"sweep"}).code == 2);
    CHECK(desk.run({"sweep", "a.toml", "--status", "by"}).code == 2);
    REQUIRE(desk.run({"sweep", "a.toml", "--out", "by", "--quiet"}).code == 0);
    const Ran done = desk.run({"sweep", "--status", "by"});
    CHECK(done.code == 0);
    CHECK(done.out == "project  a.toml\npoints   0 to 13999 of 14000\nsolved   0 to 13999\nmissing  none\n");
    CHECK(contains(desk.run({"sweep", "--status", "by", "--json"}).out, "\"missing\": 0"));
    REQUIRE(desk.run({"sweep", "a.toml", "--out", "part", "--shard", "2/2", "--quiet"}).code == 0);
    CHECK(contains(desk.run({"sweep", "--status", "part"}).out, " to 13999 of 14000"));
    desk.put("by/manifest.json", "{}");
    const Ran damaged = desk.run({"sweep", "--status", "by"});
    CHECK(damaged.code == 2);
    CHECK(contains(damaged.error, "'by/manifest.json' is damaged"));
  }

  TEST_CASE("a truncated column is not filled up, and a merge that fails leaves nothing") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(desk.run({"sweep", "a.toml", "--out", "s1", "--shard", "1/2", "--quiet"}).code == 0);
    REQUIRE(desk.run({"sweep", "a.toml", "--out", "s2", "--shard", "2/2", "--quiet"}).code == 0);
    std::filesystem::resize_file(desk.folder() / "s2/columns/3-tau.npy", 5000);
    const Ran merged = desk.run({"sweep", "a.toml", "--out", "all", "--merge", "s1", "s2"});
    CHECK(merged.code == 2);
    CHECK(contains(merged.error, "its end is missing"));
    CHECK(!desk.has("all"));
    const Ran again = desk.run({"sweep", "a.toml", "--out", "s2", "--shard", "2/2", "--resume"});
    CHECK(again.code == 2);
    CHECK(contains(again.error, "its end is missing"));
  }

  TEST_CASE("a point is solved by itself with the values of its line") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(desk.run({"sweep", "a.toml", "--csv", "a.csv", "--quiet"}).code == 0);
    CHECK(contains(desk.get("a.csv"), "point,shaft.d [mm],shaft.T [N*m],tau [MPa],shaft.theta_max [deg/m],state,"));
    const Ran point = desk.run({"run", "a.toml", "--point", "13999", "--json"});
    CHECK(contains(point.out, "\"d\""));
    CHECK(contains(desk.run({"run", "a.toml", "--point", "14000"}).error, "point 14000 does not exist"));
    CHECK(contains(desk.run({"run", "a.toml"}).error, "--point 0"));
    CHECK(desk.run({"run", "a.toml", "--point", "5", "--samples", "3", "--quiet"}).code == 1);
  }

  TEST_CASE("numpy reads the columns") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(desk.run({"sweep", "a.toml", "--out", "one", "--quiet"}).code == 0);
    const std::string file = desk.get("one/columns/3-tau.npy");
    REQUIRE(file.size() == 128 + 8 * 14000);
    CHECK(file.substr(1, 5) == "NUMPY");
    CHECK(contains(file, "'descr': '<f8', 'fortran_order': False, 'shape': (14000,), }"));
  }

  TEST_CASE("a result that is an input has one column, and the name of an input is not used for another result") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    const std::vector<std::string> words{"sweep", "a.toml", "--results", "shaft.d", "--quiet"};
    const auto with = [&](std::vector<std::string> more) {
      more.insert(more.begin(), words.begin(), words.end());
      return desk.run(more);
    };
    REQUIRE(with({"--csv", "a.csv", "--out", "one", "--pareto", "shaft.d:min,tau:min"}).code == 0);
    CHECK(desk.get("a.csv").starts_with(
        "point,shaft.d [mm],shaft.T [N*m],tau [MPa],shaft.theta_max [deg/m],state,utilisation\n0,30,"));
    CHECK(desk.has("one/columns/6-utilisation.npy"));
    CHECK(!desk.has("one/columns/7-utilisation.npy"));
    REQUIRE(desk.run({"sweep", "a.toml", "--csv", "b.csv", "--quiet"}).code == 0);
    CHECK(desk.get("a.csv") == desk.get("b.csv"));
    const Ran other = desk.run({"sweep", "a.toml", "--results", "shaft.d = 2*shaft.tau_max"});
    CHECK(other.code == 2);
    CHECK_MESSAGE(contains(other.error, "'shaft.d' is an input that the sweep varies"), other.error);
  }

  TEST_CASE("a project in which nothing varies is one point, and this is reported") {
    const Desk desk;
    desk.put("a.toml", "[a]\ncalculator = \"shaft.torsion\"\nT = \"1 N*m\"\nd = \"9 mm\"\ntau_adm = \"30 MPa\"\n");
    const Ran ran = desk.run({"sweep", "a.toml", "--results", "a.tau_max"});
    CHECK(ran.code == 0);
    CHECK_MESSAGE(contains(ran.error, "nothing to vary in 'a.toml'"), ran.error);
    CHECK(contains(ran.error, "d = { from = "));
    CHECK_MESSAGE(contains(ran.out, "1 point: 1 pass"), ran.out);
    CHECK(contains(ran.out, "Nothing varies"));
    CHECK(desk.run({"sweep", "a.toml", "--quiet"}).error.empty());
  }

  TEST_CASE("a sweep of designs ends with the exit code of its best design") {
    const std::string head = "[a]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = \"200 N*m\"\n";
    const std::string none = head + "d = [\"10 mm\", \"12 mm\", \"15 mm\"]\n";  // 33.3 mm are needed: 16 T/(pi d^3)
    const std::string one = head + "d = [\"10 mm\", \"12 mm\", \"34 mm\"]\n";
    const std::string open =
        "[a]\ncalculator = \"shaft.torsion\"\nmaterial = \"C45E\"\ntau_adm = \"600 MPa\"\nT = \"200 N*m\"\nd = [\"10 "
        "mm\", \"34 mm\"]\n";
    const std::string invalid = head + "d = [\"40 mm\", \"42 mm\"]\nd_bore = \"50 mm\"\n";
    const auto ran = [](const std::string& text, std::vector<std::string> words = {}) {
      const Desk desk;
      desk.put("a.toml", text);
      words.insert(words.begin(), {"sweep", "a.toml"});
      return desk.run(words);
    };
    CHECK(ran(one).code == 0);
    CHECK(contains(ran(one).out, "1 of 3 designs pass; 2 fail"));
    CHECK(ran(none).code == 1);
    CHECK_MESSAGE(contains(ran(none).out, "FAIL: 0 of 3 designs pass; 3 fail"), ran(none).out);
    CHECK(contains(ran(none, {"--full"}).out, "FAIL: 0 of 3 designs pass; 3 fail."));
    CHECK(contains(ran(none, {"--json"}).out, "\"headline\": \"FAIL\""));
    CHECK(contains(ran(one, {"--json"}).out, "\"headline\": \"PASS\""));
    CHECK(ran(none, {"--quiet"}).code == 1);
    CHECK(ran(invalid).code == 1);
    CHECK(contains(ran(invalid).out, "FAIL: none of the 2 designs is valid"));
    CHECK(ran(open).code == 4);  // 600 MPa are more than C45E has
    CHECK(contains(ran(open).out, "INCOMPLETE: 0 of 2 designs pass; 1 fail; 1 not assessed"));
  }

  TEST_CASE("scatter alone and a part of a sweep have no requirement to fail") {
    const std::string head = "[a]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n";
    const std::string scatter = "T = { mean = \"200 N*m\", sd = \"5 %\" }\n[project.sweep]\nsamples = 500\n";
    const Desk desk;
    desk.put("one.toml", head + "d = \"20 mm\"\n" + scatter);
    const Ran one = desk.run({"sweep", "one.toml"});
    CHECK(one.code == 0);
    CHECK_MESSAGE(contains(one.out, "500 points: 0 pass"), one.out);
    desk.put("two.toml", head + "d = [\"20 mm\", \"22 mm\"]\n" + scatter);
    CHECK(desk.run({"sweep", "two.toml", "--out", "s1", "--shard", "1/2"}).code == 0);
    CHECK(desk.run({"sweep", "two.toml", "--out", "s2", "--shard", "2/2"}).code == 0);
    const Ran all = desk.run({"sweep", "two.toml", "--out", "all", "--merge", "s1", "s2"});
    CHECK(all.code == 1);
    CHECK_MESSAGE(contains(all.out, "FAIL: 0 of 2 designs pass in all 500 samples; 2 fail in all"), all.out);
    // 33.73 mm carry 226 N*m, the mean load and 2.6 standard deviations: 0.47 % of the samples, spread evenly, exceed
    // it
    desk.put("rare.toml", head + "d = [\"20 mm\", \"33.73 mm\"]\n" + scatter + "sampling = \"latin\"\n");
    CHECK(contains(desk.run({"sweep", "rare.toml"}).out, "0 of 2 designs pass in all 500 samples; 1 fail in some"));
    CHECK(desk.run({"sweep", "rare.toml", "--quiet"}).code == 0);
  }

  TEST_CASE("the Pareto set of the designs that satisfy demands, the lightest of which --minimise finds, too") {
    const Desk desk;
    desk.put("a.toml",
             "[project.sweep]\nresults = [\"area = pi/4*a.d^2\", \"u = a.utilisation\"]\nsamples = 200\nsampling = "
             "\"latin\"\n[a]\n"
             "calculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = { mean = \"200 N*m\", sd = \"5 %\" }\n"
             "d = { from = \"30 mm\", to = \"40 mm\", step = \"0.5 mm\" }\n");
    const auto front = [&](std::vector<std::string> more) {
      more.insert(more.begin(), {"sweep", "a.toml", "--pareto", "area:min,u:min", "--quantile", "0.95"});
      return desk.run(more);
    };
    const Ran best =
        desk.run({"sweep", "a.toml", "--minimise", "area", "--such-that", "a passes", "--quantile", "0.95"});
    const std::size_t at = best.out.find("a.d  ");
    REQUIRE(at != std::string::npos);
    const std::size_t from = best.out.find_first_not_of(' ', at + 3);
    const std::string lightest = best.out.substr(from, best.out.find(" mm", from) - from);  // "33.5"
    const Ran some = front({"--such-that", "a passes"});
    CHECK(some.code == 0);
    const std::string caption = "Pareto set of the designs that satisfy 'a passes' at 95 %: ";
    REQUIRE_MESSAGE(contains(some.out, caption), some.out);
    const std::string set = some.out.substr(some.out.find(caption));
    CHECK_MESSAGE(set.find(lightest + " mm ") < set.find("mm²"), set);  // in the first row
    CHECK(contains(front({"--such-that", "a passes", "--json"}).out, "\"met_by\": "));
    const Ran none = front({"--such-that", "a passes", "--such-that", "area <= 800 mm^2"});
    CHECK(none.code == 1);
    CHECK_MESSAGE(contains(none.out, "None of 21 designs satisfies all demands: 'a passes' by "), none.out);
    CHECK(contains(none.out, "'area <= 800 mm^2' by 4"));  // 30 to 31.5 mm: 707 to 779 mm²
    CHECK(front({"--such-that", "area <= 800 mm"}).code == 2);
    CHECK(front({"--such-that", "area"}).code == 2);
    CHECK(contains(desk.run({"sweep", "a.toml", "--such-that", "a passes"}).error, "--maximise or --pareto"));
    REQUIRE(front({"--such-that", "a passes", "--csv", "a.csv", "--quiet"}).code == 0);
    CHECK(desk.get("a.csv").starts_with("point,a.T [N*m],a.d [mm],area [mm^2],u,state,utilisation\n"));
  }

  TEST_CASE("an answer ends with a point of the first design that it shows") {
    const Desk desk;
    const std::string head =
        "[project.sweep]\nresults = [\"A = a.d^2\"]\nsamples = 50\n[a]\ncalculator = \"shaft.torsion\"\n"
        "tau_adm = \"30 MPa\"\nd = [\"20 mm\", \"30 mm\", \"40 mm\"]\n";  // 33.3 mm are needed: 16 T/(pi d^3)
    desk.put("a.toml", head + "T = \"200 N*m\"\n");
    desk.put("b.toml", head + "T = { min = \"199 N*m\", max = \"201 N*m\" }\n");
    const auto named = [&](const char* file, std::vector<std::string> more) {
      more.insert(more.begin(), {"sweep", file});
      const std::string out = desk.run(more).out, before = std::string("loadpath run ") + file + " --point ";
      const std::size_t at = out.find(before);
      REQUIRE_MESSAGE(at != std::string::npos, out);
      return std::stoi(out.substr(at + before.size()));
    };
    const auto is_of = [](int design, int point) { return point / 50 == design; };
    CHECK(named("a.toml", {"--pareto", "A:min", "--such-that", "a passes"}) == 2);
    CHECK(named("a.toml", {"--pareto", "A:min"}) == 0);
    CHECK(named("a.toml", {}) == 2);          // the design that passes
    CHECK(named("a.toml", {"--full"}) == 0);  // the worst point
    CHECK(is_of(2, named("b.toml", {"--pareto", "A:min", "--such-that", "a passes"})));
    CHECK(is_of(2, named("b.toml", {})));
    CHECK(is_of(0, named("b.toml", {"--pareto", "A:min"})));
    CHECK(is_of(0, named("b.toml", {"--full"})));
  }

  TEST_CASE("a search refuses inputs that vary in parallel, and names the Pareto set that finds the best") {
    const Desk desk;
    desk.put("a.toml",
             "[a]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = \"200 N*m\"\n"
             "d = [\"50 mm\", \"40 mm\"]\nd_bore = [\"40 mm\", \"0 mm\"]\n");
    const std::vector<std::string> sweep{"sweep", "a.toml", "--zip", "a.d,a.d_bore"};
    const auto with = [&](std::vector<std::string> more) {
      more.insert(more.begin(), sweep.begin(), sweep.end());
      return desk.run(more);
    };
    const Ran least = with({"--minimise", "a.d^2 - a.d_bore^2"});
    CHECK(least.code == 2);
    CHECK_MESSAGE(contains(least.error, "vary in parallel (zip), and a search chooses each input separately"),
                  least.error);
    CHECK_MESSAGE(contains(least.error, "--results \"x = a.d^2 - a.d_bore^2\" --pareto \"x:min\" --such-that"),
                  least.error);
    const Ran best =
        with({"--results", "x = a.d^2 - a.d_bore^2", "--pareto", "x:min", "--such-that", "every mode passes"});
    CHECK_MESSAGE(contains(best.out, "that satisfy 'every mode passes': 1"), best.out);
    CHECK_MESSAGE(contains(best.out, "--point 0"), best.out);  // 900 mm² against 1600 mm², 13.8 and 15.9 MPa
    CHECK(contains(with({"--results", "x = a.d", "--maximise", "x"}).error, "designs: --pareto \"x:max\""));
  }

  TEST_CASE("errors in the arguments are reported, and nothing is written") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    const auto refused = [&](std::vector<std::string> words, const char* part) {
      words.insert(words.begin(), {"sweep", "a.toml"});
      const Ran ran = desk.run(words);
      CHECK_MESSAGE(contains(ran.error, part), ran.error);
      CHECK(ran.code == 2);
    };
    refused({"--results", "shaft.tau_mux"}, "shaft.tau_max");
    refused({"--pareto", "m:min"}, "'m' is not one of the results");
    refused({"--pareto", "tau:least"}, "'least' is not an objective");
    refused({"--shard", "1/2"}, "--out DIR");
    refused({"--out", "x", "--shard", "3/2"}, "'3/2' is not a shard");
    refused({"--out", "x", "--resume"}, "no sweep in this folder");
    refused({"--out", "x", "--merge", "y"}, "no sweep in this folder");
    refused({"--zip", "shaft.d,shaft.T"}, "uncertain");
    refused({"--report", "a.txt"}, "a report is written as");
    refused({"--csv", "a.toml"}, "is the project itself");
    refused({"--samples", "0"}, "'0' is not an integer of 1 or more");
    refused({"--samples", "1e6"}, "'1e6' is not an integer of 1 or more");
    refused({"--seed", "-1"}, "'-1' is not an integer of 0 or more");
    refused({"--seed", "9223372036854775808"}, "is not an integer of 0 or more");
    CHECK(desk.files() == std::vector<std::string>{"a.toml"});
    desk.put("two.toml",
             "[a]\ncalculator = \"shaft.torsion\"\nT = [\"1 N*m\", \"2 N*m\"]\nd = [\"9 mm\", \"8 mm\"]\n"
             "tau_adm = \"30 MPa\"\n");
    CHECK(contains(desk.run({"sweep", "two.toml", "--zip", "a.T, a.d"}).out, " of 2 designs pass"));
  }
}
