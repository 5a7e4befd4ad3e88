// Cells and headings of a text with columns, and series along a row.
#include "lib/rainflow/series/cells.hpp"

#include "lib/rainflow/series/read_series.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

using namespace loadpath;
using namespace loadpath::rainflow;

namespace {

class Bytes : public Source {
 public:
  explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}
  Outcome<std::size_t> read(std::span<char> room) override {
    const std::size_t count = std::min(room.size(), bytes_.size() - at_);
    std::copy_n(bytes_.data() + at_, count, room.data());
    at_ += count;
    return count;
  }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

struct Read {
  std::vector<double> values;
  std::string heading, message;
};

Read read(const std::string& text, const rainflow::Form& form) {
  Read result;
  const auto reader = read_series(std::make_unique<Bytes>(text), form);
  if (!reader) return {{}, "", reader.fault().message.text()};
  result.heading = (*reader)->heading();
  for (auto part = (*reader)->next(); part && !part->empty(); part = (*reader)->next())
    result.values.insert(result.values.end(), part->begin(), part->end());
  return result;
}

rainflow::Form column(const std::string& name) {
  rainflow::Form form;
  form.column = name;
  return form;
}

rainflow::Form row(const std::string& name) {
  rainflow::Form form;
  form.row = name;
  return form;
}

}  // namespace

TEST_SUITE("cells of a text") {
  TEST_CASE("a heading is a name with a unit in brackets") {
    CHECK(heading_of("t [s]").name == "t");
    CHECK(heading_of("t [s]").unit == "s");
    CHECK(heading_of(" F (kN) ").unit == "kN");
    CHECK(heading_of("share [-]").unit == "");
    CHECK(heading_of("share").name == "share");
    CHECK(heading_of("f(x) of it").name == "f(x) of it");
  }

  TEST_CASE("a comma is a decimal mark where it does not separate fields") {
    CHECK(number_of("2,5", ';') == 2.5);
    CHECK(number_of("-0,25e3", '\t') == -250.0);
    CHECK_FALSE(number_of("2,5", ','));
    CHECK_FALSE(number_of("1,234,5", ';'));
    CHECK(separator_of("0,5 1,25") == blanks);
    CHECK(separator_of("0.5, 1.25") == ',');
    CHECK(separator_of("t;F") == ';');
  }

  TEST_CASE("columns are named with their unit or without; lines above them are reported") {
    const std::string text = "t [s];F [kN]\n0;1,5\n0,1;-2,25\n";
    for (const char* name : {"F [kN]", "F", "2"}) {
      const Read force = read(text, column(name));
      CHECK(force.values == std::vector<double>{1.5, -2.25});
      CHECK(force.heading == "F [kN]");
    }
    CHECK(read("F [N], F [kN]\n1, 2\n", column("F")).message == "line 1: two columns are called 'F'");
  }

  TEST_CASE("a series along a row is that of a name or of a number") {
    const std::string text = "# gauge\nt [s]\t0\t0.1\t0.2\nS1 [MPa]\t10\t-20\t30\n";
    CHECK(read(text, row("S1")).values == std::vector<double>{10.0, -20.0, 30.0});
    CHECK(read(text, row("S1")).heading == "S1 [MPa]");
    CHECK(read(text, row("1")).values == std::vector<double>{0.0, 0.1, 0.2});
    CHECK(read("1 2 3\n4 5 6\n", row("2")).values == std::vector<double>{4.0, 5.0, 6.0});
    CHECK(read(text, row("S2")).message == "no line begins with 'S2'");
    CHECK(read(text, row("3")).message == "there are 2 lines, and no line 3");
    CHECK(read("a 1 oops 3\n", row("a")).message == "line 1: 'oops' in column 3 is not a finite number");
  }
}
