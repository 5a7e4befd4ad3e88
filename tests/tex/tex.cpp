// Reports as pdflatex sets them, where it is installed: scripts/packages.sh names the packages.
#include "lib/text/utf8.hpp"
#include "tests/browser/examples.hpp"
#include "tests/lib/report/documents.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <vector>

using namespace loadpath::test;

namespace {

bool is_there(const std::string& program) { return Desk().shell("command -v " + program).code == 0; }

/// Sets r.tex twice, for the widths of tables; what is wrong with it.
std::string errors_of(const Desk& desk) {
  const std::string set = "pdflatex -interaction=nonstopmode -halt-on-error r.tex >/dev/null";
  std::string errors = desk.shell(set + " && " + set).code == 0 ? "" : "pdflatex failed\n";
  std::istringstream log(desk.get("r.log"));
  for (std::string line; std::getline(log, line);) {
    if (line.starts_with("!")) errors += line + "\n";
  }
  return errors;
}

/// Lines that extend beyond the page, and letters that were not set.
std::string blemishes_of(const Desk& desk) {
  constexpr std::string_view overfull = "Overfull \\hbox (";
  constexpr double most = 20.0;  // points
  std::string blemishes;
  std::istringstream log(desk.get("r.log"));
  for (std::string line; std::getline(log, line);) {
    const bool is_out = line.starts_with(overfull) && std::stod(line.substr(overfull.size())) > most;
    if (is_out || line.starts_with("Missing character")) blemishes += line + "\n";
  }
  return blemishes;
}

std::string first_page(const Desk& desk) { return desk.shell("pdftotext -f 1 -l 1 -layout r.pdf -").out; }

}  // namespace

TEST_SUITE("reports set by LaTeX" * takes_share) {
  TEST_CASE("the report of every example compiles without an error, and within its margins") {
    if (!is_there("pdflatex")) {
      MESSAGE("skipped: no pdflatex");
      return;
    }
    const Desk desk;
    std::size_t at = 0;
    for (const std::string& name : examples()) {
      if (!is_tried(at++, 7)) continue;
      CAPTURE(name);
      if (!write_report(desk, name, "r.tex")) continue;
      CHECK(errors_of(desk) == "");
      CHECK(blemishes_of(desk) == "");
    }
  }

  TEST_CASE("the words and numbers of page 1 are in the PDF") {
    if (!is_there("pdflatex") || !is_there("pdftotext")) {
      MESSAGE("skipped: no pdflatex, or no pdftotext");
      return;
    }
    const Desk desk;
    REQUIRE(write_report(desk, "fan-belt", "r.tex"));
    REQUIRE(errors_of(desk) == "");
    const std::string page = first_page(desk);
    for (const std::string_view words :
         {"V-belt drive of a fan", "project.toml", "failure modes", "0.954", "53 mm", "Chosen sizes"}) {
      CAPTURE(words);
      CHECK(page.find(words) != std::string::npos);
    }
  }

  TEST_CASE("no text can stop it") {
    if (!is_there("pdflatex")) {
      MESSAGE("skipped: no pdflatex");
      return;
    }
    const Desk desk;
    loadpath::report::Document document = loadpath::report::hostile_document();
    std::u32string all;
    for (char32_t letter = 0; letter < 0x3000; ++letter) all += letter;
    document.blocks.emplace_back(loadpath::report::Paragraph{loadpath::say("{1}", loadpath::utf8(all) + "中🔩\xff")});
    document.input = std::string(loadpath::report::hostile) + "\n\\end{verbatim}\n" + loadpath::utf8(all);
    desk.put("r.tex", loadpath::report::latex(document));
    CHECK(errors_of(desk) == "");
  }
}
