// Formulas that steps share, printed once.
#include "lib/report/repeated.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::report;

account::Derived line(const char* symbol, const char* formula) {
  account::Derived derived;
  derived.step.symbol = symbol;
  derived.step.formula = formula;
  return derived;
}

/// The notes among the blocks.
std::vector<std::string> notes_of(const std::vector<Block>& blocks) {
  std::vector<std::string> notes;
  for (const Block& block : blocks) {
    const auto* const paragraph = std::get_if<Paragraph>(&block);
    if (paragraph != nullptr) notes.push_back(paragraph->text.text());
  }
  return notes;
}

}  // namespace

TEST_SUITE("report repeated formulas") {
  TEST_CASE("a step refers to the step that has printed its formula") {
    PrintedFormulas printed;
    CHECK(notes_of(printed.blocks("bearing", "Roller", {line("P", "F_r"), line("u", "C_req / C")})).empty());
    const auto second = notes_of(printed.blocks("bearing", "Ball", {line("P", "X * F_r"), line("u", "C_req / C")}));
    CHECK(second == std::vector<std::string>{"Formulas as for Roller, with these numbers:"});
    const auto third = notes_of(printed.blocks("bearing", "Second ball", {line("P", "X * F_r")}));
    CHECK(third == std::vector<std::string>{"Formulas as for Ball, with these numbers:"});
    CHECK(notes_of(printed.blocks("gear", "Gear", {line("P", "F_r")})).empty());
  }
}
