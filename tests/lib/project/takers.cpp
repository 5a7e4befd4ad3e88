// Steps by what they refer to: a project with thousands of steps is not compared pair by pair.
#include "tests/allocations.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>

using namespace loadpath;
using namespace loadpath::project;
using loadpath::test::Solved;
using loadpath::tests::allocations;

namespace {

std::string torsion(const std::string& name, const std::string& T) {
  return "[" + name + "]\ncalculator = \"shaft.torsion\"\nT = \"" + T + "\"\ntau_adm = \"30 MPa\"\n";
}

/// Steps that each take the load of the one before, with a value that nothing refers to for each.
std::string chain_of(std::size_t count) {
  std::string values = "[values]\nT = \"300 N*m\"\n", steps = torsion("s0", "=values.T");
  for (std::size_t i = 1; i < count; ++i) {
    const std::string number = std::to_string(i);
    values += "note_" + number + " = \"" + number + " kg\"\n";
    steps += torsion("s" + number, "=s" + std::to_string(i - 1) + ".T");
  }
  return values + steps;
}

std::size_t allocations_of(std::size_t count) {
  const std::string text = chain_of(count);
  const std::size_t before = allocations();
  const Solved solved(text);
  CHECK(solved.errors().empty());
  return allocations() - before;
}

}  // namespace

TEST_SUITE("project takers") {
  TEST_CASE("steps are found by name, by the steps and by the values that they refer to") {
    const Solved solved("[values]\nT = \"300 N*m\"\n" + torsion("a", "=values.T") + torsion("b", "=a.T") +
                        torsion("c", "=2*values.T+a.T"));
    const Takers& takers = solved.project.takers;
    CHECK(takers.size() == 3);
    CHECK(takers.find("b") == 1);
    CHECK_FALSE(takers.find("values").has_value());
    CHECK(takers.of("a") == std::vector<std::size_t>{1, 2});
    CHECK(takers.of("values.T") == std::vector<std::size_t>{0, 2});
    CHECK(takers.of("c").empty());
    CHECK(solved.project.is_referred_to("a.T"));
    CHECK_FALSE(solved.project.is_referred_to("a.d"));
    CHECK(solved.project.is_referred_into("a."));
    CHECK_FALSE(solved.project.is_referred_into("c."));
  }

  TEST_CASE("a project of twice as many steps and values takes about twice as many allocations") {
    const std::size_t once = allocations_of(60), twice = allocations_of(120);
    MESSAGE(once, " and ", twice, " allocations");
    CHECK(10 * twice < 25 * once);
  }
}
