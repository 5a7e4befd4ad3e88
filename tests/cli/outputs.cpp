// Outputs come into being completely or not at all.
#include "calculators/catalogue.hpp"
#include "lib/export/json.hpp"
#include "tests/cli/process.hpp"
#include "tests/program.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>

using namespace loadpath::test;
namespace fs = std::filesystem;

namespace {

const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 MPa\"\n";
const std::string two_axles =
    "[axle]\ncalculator = \"shaft.torsion\"\nT = [\"2 kN*m\", \"3 kN*m\"]\ntau_adm = \"30 MPa\"\n";
const std::string old_report = "an old report\n";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Whether this machine lets a test mount a folder of its own.
bool can_mount() { return std::system("unshare -rm true 2>/dev/null") == 0; }

}  // namespace

TEST_SUITE("cli outputs") {
  TEST_CASE("the program contains the schema of its own calculators") {
    const Desk desk;
    const bool is_same = desk.run({"schema"}).out == loadpath::exports::project_schema(loadpath::calculators());
    CHECK(is_same);  // not shown: a megabyte
  }

  TEST_CASE("the project itself cannot be an output, also through a link") {
    const Desk desk;
    desk.put("a.md", axle);
    fs::create_symlink("a.md", desk.folder() / "b.md");
    for (const char* name : {"a.md", "./a.md", "b.md"}) {
      const Ran ran = desk.run({"run", "a.md", "--report", name});
      CHECK(ran.code == 2);
      CHECK(contains(ran.error, "is the project itself: nothing is written"));
      CHECK(desk.get("a.md") == axle);
    }
  }

  TEST_CASE("without space the old report stays, and no other file") {
    const Desk desk;
    desk.put("a.toml", axle);
    desk.put("a.html", old_report);
    const Ran ran = desk.shell("trap '' XFSZ; ulimit -f 4; loadpath run a.toml --report a.html");
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "cannot write 'a.html': File too large"));
    CHECK(desk.get("a.html") == old_report);
    CHECK(desk.files().size() == 2);
  }

  TEST_CASE("on a full disk the old report stays, and no other file") {
    if (!can_mount()) return;
    const Desk desk;
    desk.put("a.toml", axle);
    const Ran ran =
        desk.shell("unshare -rm sh -c 'mkdir d && mount -t tmpfs -o size=16k none d && echo old > d/a.html && \"" +
                   std::string(program) + "\" run a.toml --report d/a.html; echo code $?; ls -A d; cat d/a.html'");
    CHECK(contains(ran.error, "cannot write 'd/a.html': No space left on device"));
    CHECK(ran.out == "code 2\na.html\nold\n");
  }

  TEST_CASE("a device that is full is reported") {
    const Desk desk;
    desk.put("a.toml", axle);
    fs::create_symlink("/dev/full", desk.folder() / "a.md");
    const Ran ran = desk.run({"run", "a.toml", "--report", "a.md"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "cannot write 'a.md': No space left on device"));
  }

  TEST_CASE("two outputs are not written to one file, also through a link") {
    const Desk desk;
    desk.put("a.toml", axle);
    desk.put("a.md", old_report);
    fs::create_symlink("a.md", desk.folder() / "b.md");
    for (const char* other : {"a.md", "./a.md", "b.md"}) {
      const Ran ran = desk.run({"run", "a.toml", "--report", "a.md", "--report", other});
      CHECK(ran.code == 2);
      CHECK(contains(ran.error, "is named for two outputs: nothing is written"));
      CHECK(desk.get("a.md") == old_report);
    }
  }

  TEST_CASE("a link stays a link, and what it names is written") {
    const Desk desk;
    desk.put("a.toml", axle);
    desk.put("real.md", old_report);
    fs::create_symlink("real.md", desk.folder() / "link.md");
    CHECK(desk.run({"run", "a.toml", "--quiet", "--report", "link.md"}).code == 0);
    CHECK(fs::is_symlink(desk.folder() / "link.md"));
    CHECK(contains(desk.get("real.md"), "# a.toml"));
  }

  TEST_CASE("a dangling link is followed, and its target is created") {
    const Desk desk;
    desk.put("a.toml", axle);
    fs::create_symlink("real.md", desk.folder() / "second.md");
    fs::create_symlink("second.md", desk.folder() / "first.md");
    CHECK(desk.run({"run", "a.toml", "--quiet", "--report", "first.md"}).code == 0);
    CHECK(fs::is_symlink(desk.folder() / "first.md"));
    CHECK(fs::is_symlink(desk.folder() / "second.md"));
    CHECK(contains(desk.get("real.md"), "# a.toml"));
  }

  TEST_CASE("a loop of links cannot be an output") {
    const Desk desk;
    desk.put("a.toml", axle);
    fs::create_symlink("b.md", desk.folder() / "a.md");
    fs::create_symlink("a.md", desk.folder() / "b.md");
    const Ran ran = desk.run({"run", "a.toml", "--quiet", "--report", "a.md"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "cannot write 'a.md': Too many levels of symbolic links"));
    CHECK(fs::is_symlink(desk.folder() / "a.md"));
  }

  TEST_CASE("output to an open file is written at its current position") {
    const Desk desk;
    desk.put("s.toml", two_axles);
    const std::string table = desk.shell("loadpath sweep s.toml --quiet --csv out.csv; cat out.csv").out;
    CHECK(contains(table, "T"));
    for (const std::string name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
      CAPTURE(name);
      const Ran ran = desk.shell("(echo before; loadpath sweep s.toml --quiet --csv " + name +
                                 "; echo after) > all.txt; cat all.txt");
      CHECK_MESSAGE(ran.out == "before\n" + table + "after\n", ran.error);
    }
  }

  TEST_CASE("standard output that cannot be written is an error") {
    const Desk desk;
    desk.put("a.toml", axle);
    for (const std::string words : {"run a.toml", "run a.toml --json", "list", "describe gear.pair", "schema"}) {
      CAPTURE(words);
      for (const char* where : {" > /dev/full", " >&-"}) {
        const Ran ran = desk.shell("loadpath " + words + where);
        CHECK(ran.code == 3);
        CHECK(contains(ran.error, "standard output cannot be written"));
      }
    }
  }

  TEST_CASE("a pipe is written to, by every option that names a file") {
    const Desk desk;
    desk.put("a.toml", axle);
    desk.put("s.toml", two_axles);
    const std::string lever = LOADPATH_ROOT "/examples/cam-valve/project.toml";
    for (const std::string& words :
         std::vector<std::string>{"run a.toml --report p.html", "run a.toml --report p.md", "run a.toml --report p.tex",
                                  "sweep s.toml --csv p.csv", "sweep s.toml --report p.html",
                                  "run '" + lever + "' --svg p.svg", "run '" + lever + "' --dxf p.dxf"}) {
      CAPTURE(words);
      const std::string pipe = words.substr(words.rfind(' ') + 1);
      const Ran ran =
          desk.shell("mkfifo " + pipe + "; timeout 60 cat " + pipe + " > read & loadpath " + words +
                     " --quiet > /dev/null; echo code $?; wait; test -p " + pipe + " && echo is a pipe; rm " + pipe);
      CHECK_MESSAGE((contains(ran.out, "code 0") || contains(ran.out, "code 4")), ran.error);
      CHECK(contains(ran.out, "is a pipe"));
      CHECK(desk.get("read").size() > 50);
    }
  }

  TEST_CASE("a device stays one") {
    const Desk desk;
    desk.put("s.toml", two_axles);
    if (desk.shell("mknod null.csv c 1 3 && echo > null.csv").code != 0) return;  // who is not root makes no devices
    const Ran ran =
        desk.shell("loadpath sweep s.toml --quiet --csv null.csv; echo code $?; test -c null.csv && echo stays");
    CHECK_MESSAGE(ran.out == "code 0\nstays\n", ran.error);
    CHECK(desk.shell("ln null.csv null.pdf && ln null.csv null.h5").code == 0);
    for (const char* option : {"--hdf5 null.h5", "--report null.pdf"}) {
      CHECK(desk.shell(std::string("loadpath sweep s.toml --quiet ") + option).code == 2);
    }
    CHECK(desk.shell("test -c null.h5 && test -c null.pdf").code == 0);
  }

  TEST_CASE("a folder cannot be the file of a sweep") {
    const Desk desk;
    desk.put("s.toml", two_axles);
    fs::create_directory(desk.folder() / "d");
    const Ran ran = desk.run({"sweep", "s.toml", "--csv", "d"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "cannot write 'd': it is a folder"));
  }

  TEST_CASE("a project that never ends is refused by its size") {
    const Ran ran = loadpath_with({"run", "/dev/zero"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "larger than 4 MiB"));
  }

  TEST_CASE("control characters reach neither terminal nor report") {
    const Desk desk;
    desk.put("a.toml", "[project]\ntitle = \"\\u001b[31mred\"\n" + axle);
    const Ran ran = desk.run({"run", "a.toml"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "a control character in a text"));
  }

  TEST_CASE("tables that are nested too deeply are refused") {
    std::string key = "a";
    for (int i = 0; i < 10'000; ++i) key += ".a";
    const Desk desk;
    desk.put("a.toml", axle + key + " = 1\n");
    const Ran ran = desk.run({"run", "a.toml"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "too deep"));
  }

  TEST_CASE("figures of any step: one in a file, all in a folder") {
    const Desk desk;
    const std::vector<std::string> beam{"section", "I",     "--h",    "200 mm", "--b",   "100 mm", "--t_w",
                                        "5.6 mm",  "--t_f", "8.5 mm", "--r",    "12 mm", "--quiet"};
    auto with = [&](std::vector<std::string> more) {
      more.insert(more.begin(), beam.begin(), beam.end());
      return desk.run(more);
    };
    CHECK(with({"--svg", "a.svg"}).code == 0);
    CHECK(desk.get("a.svg").starts_with("<svg"));
    CHECK(with({"--svg", "all"}).code == 0);
    CHECK(with({"--dxf", "a.dxf"}).code == 0);
    CHECK(desk.get("a.dxf").find("SECTION") != std::string::npos);
    const Ran none =
        desk.run({"fatigue", "cycle", "--sigma_max", "120 MPa", "--sigma_min", "-40 MPa", "--dxf", "c.dxf"});
    CHECK(none.error.find("nothing to write as DXF") != std::string::npos);
    CHECK(!desk.has("c.dxf"));
    const std::string gearbox = LOADPATH_ROOT "/examples/gearbox-shaft/project.toml";
    const Ran one = desk.run({"run", gearbox, "--quiet", "--svg", "b.svg"});
    CHECK(one.code == 2);
    CHECK(one.error.find("steps are drawn") != std::string::npos);
    CHECK(!desk.has("b.svg"));
    const auto before = desk.files().size();
    CHECK(with({"--svg", "a.png"})
              .error.starts_with("loadpath: figures are written as FILE.svg or into a folder, not as 'a.png'\n"));
    CHECK(with({"--dxf", "a.dwg"}).code == 2);
    CHECK(with({"--csv", "a.txt"}).code == 2);
    CHECK(desk.files().size() == before);
    CHECK(desk.run({"run", gearbox, "--svg", "figures"}).error.ends_with("figures: figures\n"));
    CHECK(desk.files().size() > before + 1);
    CHECK(desk.get("figures/shaft-shaft.svg").find("left: 6308, locating") != std::string::npos);
  }
}
