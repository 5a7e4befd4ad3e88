// The program loadpath-mpi: the same bytes by any number of ranks, after a rank that is killed, and nothing but one
// voice.
#include "tests/cli/sweeps.hpp"
#include "tests/parts.hpp"
#include "tests/program.hpp"
#include "tests/tries.hpp"

#include <chrono>
#include <csignal>
#include <random>
#include <string>
#include <thread>

using namespace loadpath::test;

namespace {

namespace fs = std::filesystem;

fs::path mpi_program() { return fs::path(program).parent_path() / "loadpath-mpi"; }

bool is_built() {
  if (fs::exists(mpi_program())) return true;
  MESSAGE("skipped: no loadpath-mpi");
  return false;
}

/// A line of the shell in which `ranks N WORDS` runs the program so often; each rank leaves its process in a file. An
/// mpirun whose ranks are killed while it starts may wait for ever: it is ended.
Ran shell(const Desk& desk, const std::string& line) {
  const std::string as_any_user = "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; ";
  const std::string ranks =
      "ranks() { count=$1; shift; timeout -k 1 300 mpirun --oversubscribe -n $count sh -c "
      "'echo $$ > rank.$OMPI_COMM_WORLD_RANK; exec \"$@\"' sh '" +
      mpi_program().string() + "' \"$@\"; }; ";
  return desk.shell(as_any_user + ranks + line);
}

/// mpirun may end before its ranks do.
const std::string until_left = "while loadpath sweep --status by | grep -q 'at work'; do sleep 0.1; done; ";

}  // namespace

TEST_SUITE("sweep over machines" * by_case) {
  TEST_CASE("any number of ranks writes the same bytes as one process") {
    if (!is_built()) return;
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(desk.run({"sweep", "a.toml", "--out", "plain", "--csv", "plain.csv", "--quiet"}).code == 0);
    const std::string told = desk.run({"sweep", "a.toml", "--pareto", "tau:min,shaft.theta_max:min"}).out;
    for (const char* n : {"1", "2", "4"}) {
      CAPTURE(n);
      const Ran ran = shell(desk, "ranks " + std::string(n) + " sweep a.toml --out by --csv by.csv --quiet");
      CHECK_MESSAGE(ran.code == 0, ran.error);
      CHECK(ran.out.empty());
      CHECK(same_folders(desk, "plain", "by"));
      CHECK(desk.get("plain.csv") == desk.get("by.csv"));
      fs::remove_all(desk.folder() / "by");
      CHECK(shell(desk, "ranks " + std::string(n) + " sweep a.toml --pareto tau:min,shaft.theta_max:min").out == told);
    }
    const Ran threads = shell(desk, "ranks 3 sweep a.toml --out by --csv by.csv --jobs 2 --quiet");
    CHECK_MESSAGE(threads.code == 0, threads.error);
    CHECK(same_folders(desk, "plain", "by"));
  }

  TEST_CASE("only one rank reads standard input, prints and writes") {
    if (!is_built()) return;
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    const Ran json = desk.run({"sweep", "a.toml", "--json", "--no-columns", "--samples", "300"});
    const Ran typed = shell(desk, "cat a.toml | ranks 3 sweep - --json --samples 300");
    CHECK_MESSAGE(typed.code == 0, typed.error);
    CHECK(contains(typed.out, "\"points\": 2100"));
    CHECK(shell(desk, "ranks 3 convert '1 kN' N").out == desk.run({"convert", "1 kN", "N"}).out);
    CHECK(shell(desk, "ranks 3 --version").out == desk.run({"--version"}).out);
    const Ran point = shell(desk, "ranks 3 run a.toml --point 5 --json");
    CHECK(point.out == desk.run({"run", "a.toml", "--point", "5", "--json"}).out);
    const Ran wrong = shell(desk, "ranks 3 sweep a.toml --results shaft.tau_mux");
    CHECK(wrong.code == 2);
    CHECK(contains(wrong.error, "shaft.tau_max"));
    const std::string told = "has no result 'tau_mux'";
    CHECK(wrong.error.find(told) == wrong.error.rfind(told));
  }

  TEST_CASE("a rank that reads other files is reported, and nothing is solved") {
    if (!is_built()) return;
    const Desk desk;
    const std::string table = R"(table = "mine/steels"
group = "material"
units = { E = "GPa", G = "GPa" }
[[row]]
name = "X"
E = 212
G = 8)";
    for (const std::string rank : {"0", "1", "2"}) {
      fs::create_directory(desk.folder() / rank);
      desk.put(rank + "/a.toml", "[project]\ntables = [\"t.toml\"]\n" + swept_shaft);
      desk.put(rank + "/t.toml", table + (rank == "2" ? "2" : "1") + "\nsources = [\"certificate\"]\n" +
                                     "[sources]\ncertificate = \"Certificate of the maker\"\n");
    }
    const std::string run =
        "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; "
        "mpirun --oversubscribe -n $N sh -c 'cd $OMPI_COMM_WORLD_RANK; exec \"$@\"' sh '" +
        mpi_program().string() + "' sweep a.toml --out out --quiet";
    const Ran alike = desk.shell("N=2; " + run);
    CHECK_MESSAGE(alike.code == 0, alike.error);
    fs::remove_all(desk.folder() / "0/out");
    const Ran other = desk.shell("N=3; " + run);
    CHECK(other.code == 2);
    CHECK_MESSAGE(contains(other.error, "loadpath: rank 2 on "), other.error);
    CHECK(contains(other.error, "reads other files than the first rank"));
  }

  TEST_CASE("a rank that all others wait for is reported with its points") {
    if (!is_built()) return;
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    const Ran ran = shell(desk, "ranks 3 sweep a.toml --samples 100000 --out by --save-every 0 2> errors & at=$!; " +
                                    until_solved("by") +
                                    "kill -STOP $(cat rank.2); "
                                    "until grep -q 'waits for rank' errors || ! kill -0 $at; do sleep 0.05; done; "
                                    "kill -CONT $(cat rank.2); wait $at");
    const std::string errors = desk.get("errors");
    CHECK_MESSAGE(ran.code == 0, errors);
    CHECK_MESSAGE(contains(errors, "loadpath: waits for rank 2 on "), errors);
    CHECK(contains(errors, ": points "));
  }

  TEST_CASE("more ranks than blocks, and a folder that is continued by other ranks") {
    if (!is_built()) return;
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(desk.run({"sweep", "a.toml", "--samples", "100", "--out", "plain", "--quiet"}).code == 0);  // 3 blocks
    const Ran many = shell(desk, "ranks 7 sweep a.toml --samples 100 --out by --quiet");
    CHECK_MESSAGE(many.code == 0, many.error);
    CHECK(same_folders(desk, "plain", "by"));
    const Ran done = shell(desk, "ranks 2 sweep a.toml --samples 100 --out by --quiet --resume");
    CHECK_MESSAGE(done.code == 0, done.error);
    CHECK(same_folders(desk, "plain", "by"));
    for (const char* k : {"1", "2"})
      CHECK(shell(desk, std::string("ranks 3 sweep a.toml --samples 100 --quiet --out s") + k + " --shard " + k + "/2")
                .code == 0);
    CHECK(shell(desk, "ranks 3 sweep a.toml --samples 100 --quiet --out all --merge s1 s2").code == 0);
    CHECK(same_folders(desk, "plain", "all"));
    const Ran taken = shell(desk, "ranks 3 sweep a.toml --samples 100 --quiet --out all");
    CHECK(taken.code == 2);
    CHECK(contains(taken.error, "a file or folder of this name already exists"));
  }

  TEST_CASE("the script for MPI, twice, and that of a job array under Slurm") {
    if (!is_built()) return;
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(desk.run({"sweep", "a.toml", "--out", "plain", "--quiet"}).code == 0);
    const std::string path = "export PATH='" + mpi_program().parent_path().string() + "':$PATH:/usr/sbin; ";
    const std::string scripts = LOADPATH_ROOT "/examples/cluster/";
    for (int i = 0; i < 2; ++i) {
      const Ran ran = shell(desk, path + "sh '" + scripts + "mpi.sh' a.toml by 2");
      CHECK_MESSAGE(ran.code == 0, ran.error);
      CHECK(same_folders(desk, "plain", "by"));
    }
    if (desk.shell("PATH=$PATH:/usr/sbin; command -v slurmctld && command -v slurmd && command -v munged && command -v "
                   "sbatch")
            .code != 0) {
      MESSAGE("without Slurm: slurmctld, slurmd, slurm-client, munge are not installed");
      return;
    }
    const Ran ran = shell(
        desk, path + "export CPUS=1; sh '" + scripts + "one-node-slurm.sh' sh '" + scripts + "slurm.sh' a.toml out 3");
    CHECK_MESSAGE(ran.code == 0, ran.error);
    CHECK(same_folders(desk, "plain", "out"));
  }

  TEST_CASE("Ctrl-C on mpirun keeps the saved state, and the folder states what is missing") {
    if (!is_built()) return;
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    // mpirun kills its ranks a second after the signal, on a loaded machine before they have reported what is missing.
    const Ran ran = shell(
        desk, "ranks 3 sweep a.toml --samples 100000000 --no-columns --out by --save-every 0.1 --quiet & at=$!; " +
                  until_solved("by") + "kill -INT $(ps -o ppid= -p $(cat rank.0)); wait $at; code=$?; " + until_left +
                  "exit $code");
    CHECK(ran.code != 0);
    CHECK(!contains(ran.error, "stopped at 0 points"));
    const Ran status = desk.run({"sweep", "--status", "by"});
    CHECK(status.code == 1);
    CHECK_MESSAGE(contains(status.out, "go on    loadpath sweep a.toml --out by --resume"), status.out);
  }

  TEST_CASE("if a rank is lost, the folder states what is missing") {
    if (!is_built()) return;
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    const Ran ran = shell(
        desk, "ranks 3 sweep a.toml --samples 100000000 --no-columns --out by --save-every 0.1 --quiet & at=$!; " +
                  until_solved("by") + "kill -9 $(cat rank.2); wait $at; code=$?; " + until_left + "exit $code");
    CHECK(ran.code != 0);
    const Ran status = desk.run({"sweep", "--status", "by"});
    CHECK(status.code == 1);
    CHECK_MESSAGE(contains(status.out, " to 699999999\ngo on    loadpath sweep a.toml --out by --resume"), status.out);
  }
}

TEST_SUITE("sweep over machines: killed" * takes_share) {
  TEST_CASE("after a hundred kills of its ranks, --resume restores everything of a sweep") {
    if (!is_built()) return;
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(desk.run({"sweep", "a.toml", "--samples", "1000", "--out", "whole", "--quiet"}).code == 0);
    const std::string words = "4 sweep a.toml --samples 1000 --out part --quiet --save-every 0 ";
    const auto lasts = duration_of([&] { REQUIRE(shell(desk, "ranks " + words).code == 0); });
    CHECK(same_folders(desk, "whole", "part"));
    fs::remove_all(desk.folder() / "part");
    std::mt19937 random(7);
    // Without the time that MPI takes to start and to end, the sweep may be a small part of it: a kill that came too
    // late makes the later ones come earlier.
    double latest = 1e-6 * static_cast<double>(lasts.count());
    const int enough = tries(100) / 5 + 1;
    int killed = 0, told = 0, finished = 0;
    for (int i = 0; i < tries(100) || (killed < enough && i < 10 * tries(100)); ++i) {
      CAPTURE(i);
      const std::string rank = std::to_string(i % 4),
                        after = std::to_string(1e-3 * latest * static_cast<double>(random() % 1000));
      const Ran ran = shell(
          desk, "rm -f rank.*; export OMPI_MCA_odls_base_sigkill_timeout=0; ranks " + words +
                    (desk.has("part") ? "--resume" : "") +
                    " & while [ $(ls rank.* 2>/dev/null | wc -l) -lt 4 ] && kill -0 $!; do sleep 0.01; done; sleep " +
                    after + "; kill -9 $(cat rank." + rank + "); wait $!");
      killed += ran.code != 0;
      told += contains(ran.error, "--resume goes on");
      if (ran.code != 0) continue;
      ++finished;
      latest *= 0.8;
      CHECK(same_folders(desk, "whole", "part"));
      fs::remove_all(desk.folder() / "part");
    }
    CHECK(killed >= enough);
    MESSAGE(killed << " killed, " << told << " told what is missing, " << finished << " ended before");
    const Ran last = shell(desk, "ranks " + words + (desk.has("part") ? "--resume" : ""));
    CHECK_MESSAGE(last.code == 0, last.error);
    CHECK(same_folders(desk, "whole", "part"));
  }
}
