// Folders of sweeps in rough hands: two processes in one, damage, an end before the first state, a disk without room,
// shards that are missing, changed in number, or of something else.
#include "tests/cli/sweeps.hpp"
#include "tests/parts.hpp"
#include "tests/program.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

using namespace loadpath::test;

namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

Ran sweep(const Desk& desk, const std::string& out, const Words& more = {}) {
  Words words{"sweep", "a.toml", "--quiet", "--out", out};
  words.insert(words.end(), more.begin(), more.end());
  return desk.run(words);
}

/// A line of the shell in which $P is the program itself, so that $! is its process.
Ran shell(const Desk& desk, const std::string& line) {
  return desk.shell(std::string("export P='") + program + "'; " + line);
}

void refused(const Ran& ran, const std::string& why) {
  CHECK(ran.code == 2);
  CHECK_MESSAGE(contains(ran.error, why), ran.error);
}

void damage(const fs::path& file, std::streamoff at) {
  std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
  bytes.seekg(at);
  const int there = bytes.get();
  bytes.seekp(at);
  bytes.put(static_cast<char>(there ^ 4));
}

/// A line during which a sweep that takes its time is at work.
std::string while_at_work(const std::string& meanwhile) {
  return "$P sweep a.toml --samples 30000000 --no-columns --quiet --out busy & at=$!; "
         "while [ ! -e busy/state ]; do sleep 0.02; done; " +
         meanwhile + "; code=$?; kill -9 $at; wait $at; exit $code";
}

}  // namespace

TEST_SUITE("folders of sweeps" * by_case) {
  TEST_CASE("two processes do not work in one folder") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    const std::string again = "$P sweep a.toml --samples 30000000 --no-columns --quiet --out busy";
    refused(shell(desk, while_at_work(again)), " is using it");
    fs::remove_all(desk.folder() / "busy");
    refused(shell(desk, while_at_work(again + " --resume")), " is using it");
    fs::remove_all(desk.folder() / "busy");
    refused(shell(desk, while_at_work(again + "2 --merge busy")), " is using it");
    CHECK(!desk.has("busy2"));
  }

  TEST_CASE("the lock of a dead process does not block, and is removed at the end") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    const Words many{"--samples", "60000"};  // so many blocks that no machine ends before it is killed
    REQUIRE(sweep(desk, "whole", many).code == 0);
    CHECK(!desk.has("whole/.loadpath.lock"));
    const Ran killed = shell(desk,
                             "$P sweep a.toml --samples 60000 --quiet --out part --save-every 0 & at=$!; "
                             "while [ ! -e part/state ]; do sleep 0.005; done; kill -9 $at; wait $at");
    CHECK(killed.code == 137);
    CHECK(desk.has("part/.loadpath.lock"));
    const Ran again = sweep(desk, "part", {"--samples", "60000", "--resume"});
    CHECK_MESSAGE(again.code == 0, again.error);
    CHECK(same_folders(desk, "whole", "part"));
  }

  TEST_CASE("a folder killed before its first state is used by a new run and by --resume") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(sweep(desk, "whole").code == 0);
    for (const std::string left :
         {"mkdir part", "mkdir part; echo 1 on node > part/.loadpath.lock",
          "mkdir -p part/columns; echo > part/.state.part; head -c 128 whole/columns/3-tau.npy "
          "> part/columns/9-other.npy; : > part/columns/1-shaft.d.npy"}) {
      CAPTURE(left);
      for (const bool resumed : {false, true}) {
        fs::remove_all(desk.folder() / "part");
        REQUIRE(desk.shell(left).code == 0);
        const Ran ran = sweep(desk, "part", resumed ? Words{"--resume"} : Words{});
        CHECK_MESSAGE(ran.code == 0, ran.error);
        CHECK(same_folders(desk, "whole", "part"));
      }
    }
    REQUIRE(
        desk.shell("mkdir -p other/columns letters; cp whole/columns/3-tau.npy other/columns/; : > letters/one").code ==
        0);
    for (const std::string folder : {"other", "letters"}) {
      refused(sweep(desk, folder), "a file or folder of this name already exists");
      refused(sweep(desk, folder, {"--resume"}), "no sweep in this folder");
    }
    CHECK(desk.has("other/columns/3-tau.npy"));
    CHECK(desk.shell("ls -A letters").out == "one\n");
  }

  TEST_CASE("damaged files are reported as damaged") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(sweep(desk, "s").code == 0);
    damage(desk.folder() / "s/columns/3-tau.npy", 50000);
    refused(sweep(desk, "s", {"--resume"}), "'s/columns/3-tau.npy' is not what was written");
    refused(sweep(desk, "m", {"--merge", "s"}), "'s/columns/3-tau.npy' is not what was written");
    damage(desk.folder() / "s/columns/3-tau.npy", 50000);
    REQUIRE(sweep(desk, "s", {"--resume"}).code == 0);
    fs::rename(desk.folder() / "s/columns/3-tau.npy", desk.folder() / "tau");
    refused(sweep(desk, "s", {"--resume"}), "'s/columns/3-tau.npy' is missing");
    fs::rename(desk.folder() / "tau", desk.folder() / "s/columns/3-tau.npy");
    const auto size = static_cast<std::streamoff>(fs::file_size(desk.folder() / "s/state"));
    for (const std::streamoff at : {std::streamoff{0}, std::streamoff{700}, size / 2, size - 1}) {
      damage(desk.folder() / "s/state", at);
      refused(sweep(desk, "s", {"--resume"}), "its state is damaged");
      refused(sweep(desk, "m", {"--merge", "s"}), "its state is damaged");
      damage(desk.folder() / "s/state", at);
    }
    for (const auto left : {size - 8, std::streamoff{3}, std::streamoff{0}}) {
      fs::resize_file(desk.folder() / "s/state", static_cast<std::uintmax_t>(left));
      refused(sweep(desk, "s", {"--resume"}), "its state is damaged");
    }
    CHECK(!desk.has("m"));
  }

  TEST_CASE("a column that is damaged while the sweep is stopped is found before it resumes") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    const Ran ran = shell(desk, "$P sweep a.toml --samples 3000000 --quiet --out s --save-every 0.05 & at=$!; " +
                                    until_solved("s") + "kill -INT $at; wait $at");
    CHECK(ran.code == 130);
    REQUIRE(fs::file_size(desk.folder() / "s/columns/3-tau.npy") > 2000);
    damage(desk.folder() / "s/columns/3-tau.npy", 1000);
    refused(sweep(desk, "s", {"--samples", "3000000", "--resume"}), "is not what was written");
  }

  TEST_CASE("Ctrl-C keeps the solved points in the folder also with --csv") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(sweep(desk, "whole", {"--samples", "300000"}).code == 0);
    const Ran ran =
        shell(desk, "$P sweep a.toml --samples 300000 --quiet --out part --csv all.csv --save-every 0.05 & at=$!; " +
                        until_solved("part") + "kill -INT $at; wait $at");
    CHECK(ran.code == 130);
    CHECK(contains(ran.error, "stopped at "));
    CHECK(!contains(ran.error, "stopped at 0 points"));
    CHECK(contains(ran.error, "--out part --resume goes on"));
    CHECK(desk.shell("ls -A").out == "a.toml\npart\nwhole\n");
    CHECK(sweep(desk, "part", {"--samples", "300000", "--resume"}).code == 0);
    CHECK(same_folders(desk, "whole", "part"));
  }

  TEST_CASE("SIGTERM, as a cluster sends it before the end, keeps the solved points; slow points do not delay it") {
    const Desk desk;
    REQUIRE(desk.shell("sed 's/speed = \"45 rad.s\"/speed = { from = \"40 rad\\/s\", to = \"50 rad\\/s\", count = "
                       "200000 }/; s/positions = 360/positions = 36/' "
                       "'" LOADPATH_ROOT
                       "/examples/slotted-lever/project.toml' > a.toml; grep -q 'count = 200000' a.toml")
                .code == 0);
    const Ran ran = shell(desk,
                          "$P sweep a.toml --quiet --out part --save-every 1000 & at=$!; "
                          "while [ ! -e part/state ]; do sleep 0.02; done; sleep 1; kill -TERM $at; "
                          "timeout 1200 tail --pid=$at -f /dev/null || exit 99; wait $at");
    CHECK(ran.code == 130);
    CHECK_MESSAGE(contains(ran.error, "--out part --resume goes on"), ran.error);
  }

  TEST_CASE("shards of a changed number: those that fit are used, a command for the missing ones is printed") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    REQUIRE(sweep(desk, "whole").code == 0);
    for (const char* k : {"1", "2", "3"})
      REQUIRE(sweep(desk, std::string("s") + k, {"--shard", k + std::string("/5")}).code == 0);
    REQUIRE(sweep(desk, "half", {"--shard", "2/2"}).code == 0);
    const Ran gap = sweep(desk, "m", {"--merge", "s1", "s2", "s3", "half"});
    refused(gap, "the points 8448-13999 are in no shard that fits the others");
    CHECK(contains(gap.error, "--shard 8448-13999"));
    REQUIRE(sweep(desk, "rest", {"--shard", "8448-13999"}).code == 0);
    const Ran merged = desk.run({"sweep", "a.toml", "--out", "m", "--merge", "s1", "s2", "s3", "half", "rest", "s2"});
    CHECK_MESSAGE(merged.code == 0, merged.error);
    CHECK(contains(merged.error, "left out, the points are in others: 'half'"));
    CHECK(contains(merged.error, "left out, the points are in others: 's2'"));
    CHECK(same_folders(desk, "whole", "m"));
    for (const char* k : {"7", "8", "9", "10"})
      REQUIRE(sweep(desk, std::string("t") + k, {"--shard", k + std::string("/10")}).code == 0);
    CHECK(sweep(desk, "n", {"--merge", "t7", "s1", "t9", "s2", "t8", "t10", "s3"}).code == 0);
    CHECK(same_folders(desk, "whole", "n"));
  }

  TEST_CASE("a shard that is missing, not finished, or from another sweep") {
    const Desk desk;
    // So many blocks that no machine ends before it is killed.
    const std::string many = std::string(swept_shaft).replace(swept_shaft.find("2000\n"), 4, "60000");
    desk.put("a.toml", many);
    REQUIRE(sweep(desk, "s1", {"--shard", "1/3"}).code == 0);
    REQUIRE(sweep(desk, "s3", {"--shard", "3/3"}).code == 0);
    refused(sweep(desk, "m", {"--merge", "s1", "s3"}), "the points 140032-280063 are in no shard");
    refused(sweep(desk, "m", {"--merge", "s1", "s2", "s3"}), "'s2': no sweep in this folder");
    const Ran killed = shell(desk,
                             "$P sweep a.toml --quiet --out s2 --shard 2/3 --save-every 0 & at=$!; "
                             "while [ ! -e s2/state ]; do :; done; kill -9 $at; wait $at");
    CHECK(killed.code == 137);
    refused(sweep(desk, "m", {"--merge", "s1", "s2", "s3"}), "'s2': it is not finished: ");
    refused(sweep(desk, "s2", {"--resume", "--shard", "1/3"}),
            "it is another share: points 140032-280063, not 0-140031");
    REQUIRE(sweep(desk, "s2", {"--resume", "--shard", "140032-280063"}).code == 0);
    REQUIRE(sweep(desk, "seed", {"--shard", "2/3", "--seed", "2"}).code == 0);
    refused(sweep(desk, "m", {"--merge", "s1", "seed", "s3"}), "'seed = 2' there, 'seed = 1' here");
    desk.put("b.toml", "\n[shaft]\n# thicker" + many.substr(8));
    REQUIRE(desk.run({"sweep", "b.toml", "--quiet", "--out", "other", "--shard", "2/3"}).code == 0);
    refused(sweep(desk, "m", {"--merge", "s1", "other", "s3"}), "'# thicker' there");
    CHECK(!desk.has("m"));
    REQUIRE(desk.shell("mkdir empty").code == 0);
    refused(sweep(desk, "n", {"--merge", "empty"}), "the points 0-419999 are in no shard");
    CHECK(sweep(desk, "m", {"--merge", "s1", "s2", "empty", "s3"}).code == 0);
  }

  TEST_CASE("more shards than blocks: some have nothing to do") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    const Words few{"--samples", "100"};  // 700 points, 3 blocks
    REQUIRE(sweep(desk, "whole", few).code == 0);
    Words merge{"--samples", "100", "--merge"};
    for (const std::string k : {"1", "2", "3", "4", "5"}) {
      REQUIRE(sweep(desk, "s" + k, {"--samples", "100", "--shard", k + "/5"}).code == 0);
      REQUIRE(sweep(desk, "s" + k, {"--samples", "100", "--shard", k + "/5", "--resume"}).code == 0);
      merge.push_back("s" + k);
    }
    const Ran merged = sweep(desk, "m", merge);
    CHECK_MESSAGE(merged.code == 0, merged.error);
    CHECK(merged.error.empty());
    CHECK(same_folders(desk, "whole", "m"));
    CHECK(contains(desk.get("s1/manifest.json"), "\"rows\": 0"));
  }

  TEST_CASE("invalid shards") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    for (const std::string share : {"", "0/3", "4/3", "1", "1/", "/3", "-1/3", "1/0", "1.5/3", "1/3x", "5-4", "0-14000",
                                    "1-255", "0-254", "99999999999999999999/3", "0-"}) {
      CAPTURE(share);
      if (share.empty()) continue;
      refused(sweep(desk, "x", {"--shard=" + share}), "'" + share + "' is not a shard of a sweep");
    }
    CHECK(!desk.has("x"));
  }

  TEST_CASE("a full disk, a folder that cannot be written") {
    const Desk desk;
    desk.put("a.toml", swept_shaft);
    desk.put("file", "");
    refused(sweep(desk, "file/x"), "'file/x': ");
    refused(sweep(desk, "file"), "a file or folder of this name already exists");
    if (::geteuid() != 0) {
      fs::create_directory(desk.folder() / "closed");
      fs::permissions(desk.folder() / "closed", fs::perms::owner_read | fs::perms::owner_exec);
      refused(sweep(desk, "closed"), "cannot write");
    }
    REQUIRE(sweep(desk, "whole", {"--samples", "60000"}).code == 0);
    const Ran mount = shell(desk,
                            "mkdir small; unshare -m sh -c 'mount -t tmpfs -o size=4m none small && "
                            "$P sweep a.toml --samples 60000 --quiet --out small/part; echo $?; "
                            "mount -o remount,size=400m small && "
                            "$P sweep a.toml --samples 60000 --quiet --out small/part --resume; echo $?; "
                            "diff -r small/part whole && echo same'");
    if (contains(mount.error, "unshare") || contains(mount.error, "mount:")) {
      MESSAGE("without a small disk: this user cannot mount one");
      return;
    }
    CHECK_MESSAGE(mount.out == "2\n0\nsame\n", mount.out, mount.error);
    CHECK_MESSAGE(contains(mount.error, "cannot write 'small/part/"), mount.error);
  }
}
