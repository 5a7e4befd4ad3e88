// The structure of textbook mechanisms: initial links and Assur groups, by class, order and kind.
#include "lib/mechanism/structure/assur.hpp"

#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace loadpath::mechanism;

namespace {

/// Only structure: the places of the points do not matter.
struct Sketch {
  Model model;

  int link(const std::string& name) { return models::add_link(model, name, {}); }
  void pin(int i, int j) { models::pin(model, "pin", i, {}, j, {}); }
  void slide(int i, int j) { models::slide(model, "guide", i, {}, j, {}); }
  void slot(int i, int j) { models::slot(model, "slot", i, {}, j, {}); }
  int crank() {
    const int k = link("crank");
    pin(k, ground);
    models::drive_turning(model, "motor", k);
    return k;
  }
};

/// "1: crank; 2.2 RRP: rod piston".
std::string structure_of(const Model& model) {
  std::string text;
  for (const Group& group : groups(model)) {
    CHECK(3 * group.links.size() == static_cast<std::size_t>(2 * group.p5 + group.p4) + group.drivers.size());
    if (!text.empty()) text += "; ";
    text += std::to_string(group.contour_class) + "." + std::to_string(group.order);
    text += (group.kind.empty() ? "" : " " + group.kind) + ":";
    for (const std::size_t k : group.links) text += " " + model.links[k].name;
  }
  return text;
}

}  // namespace

TEST_SUITE("mechanism structure") {
  TEST_CASE("slider-crank, four-bar and six-bar are initial links with dyads") {
    CHECK(structure_of(models::slider_crank()) == "1.1: crank; 2.2 RRP: rod piston");
    CHECK(structure_of(models::four_bar()) == "1.1: crank; 2.2 RRR: coupler rocker");
    CHECK(structure_of(models::six_bar()).starts_with("1.1: crank; 2.2 RRR: coupler rocker; 2.2 RRP: "));
  }

  TEST_CASE("the five kinds of dyads") {
    const auto dyad = [](char first, char inner, char last) {
      Sketch s;
      const int crank = s.crank(), a = s.link("a"), b = s.link("b");
      const auto join = [&](char kind, int i, int j) { kind == 'R' ? s.pin(i, j) : s.slide(i, j); };
      join(first, a, crank);
      join(inner, a, b);
      join(last, b, ground);
      return structure_of(s.model);
    };
    CHECK(dyad('R', 'R', 'R') == "1.1: crank; 2.2 RRR: a b");
    CHECK(dyad('R', 'R', 'P') == "1.1: crank; 2.2 RRP: a b");
    CHECK(dyad('P', 'R', 'R') == "1.1: crank; 2.2 RRP: a b");
    CHECK(dyad('R', 'P', 'R') == "1.1: crank; 2.2 RPR: a b");
    CHECK(dyad('P', 'R', 'P') == "1.1: crank; 2.2 PRP: a b");
    CHECK(dyad('P', 'P', 'R') == "1.1: crank; 2.2 RPP: a b");
  }

  TEST_CASE("a pin in a slot counts as a slider, as in text A") {
    CHECK(structure_of(models::slotted_lever()) == "1.1: crank; 2.2 RPR: lever");
    CHECK(structure_of(models::slotted_lever(true)).find("2.2 RPR: ") != std::string::npos);
  }

  TEST_CASE("a link with three pairs makes class III") {
    Sketch s;
    const int crank = s.crank(), plate = s.link("plate");
    for (const int base : {crank, ground, ground}) {
      const int leg = s.link("leg");
      s.pin(leg, base);
      s.pin(leg, plate);
    }
    CHECK(structure_of(s.model) == "1.1: crank; 3.3: plate leg leg leg");
  }

  TEST_CASE("a loop of four links makes class IV") {
    Sketch s;
    const int crank = s.crank();
    const int a = s.link("a"), b = s.link("b"), c = s.link("c"), d = s.link("d");
    s.pin(a, crank);
    s.pin(a, b);
    s.pin(b, c);
    s.pin(c, d);
    s.pin(d, a);
    s.pin(c, ground);
    CHECK(structure_of(s.model) == "1.1: crank; 4.2: a b c d");
  }

  TEST_CASE("a boom moved by a cylinder is a dyad with a driven link") {
    Sketch s;
    const int boom = s.link("boom"), barrel = s.link("barrel"), rod = s.link("rod");
    s.pin(boom, ground);
    s.pin(barrel, ground);
    s.pin(rod, boom);
    s.slide(rod, barrel);
    models::drive_sliding(s.model, "cylinder", 3);
    CHECK(structure_of(s.model) == "2.2 RRR: boom barrel rod");
  }

  TEST_CASE("a chain of dyads is attached one after the other, however its links are listed") {
    Sketch s;
    constexpr int dyads = 50;
    std::vector<int> rods, rockers;
    for (int k = 0; k < dyads; ++k) {
      rods.push_back(s.link("rod"));
      rockers.push_back(s.link("rocker"));
    }
    const int crank = s.crank();
    for (std::size_t k = dyads; k-- > 0;) {
      s.pin(rods[k], rockers[k]);
      s.pin(rockers[k], ground);
      s.pin(rods[k], k == 0 ? crank : rockers[k - 1]);
    }
    const std::vector<Group> found = groups(s.model);
    REQUIRE(found.size() == dyads + 1);
    CHECK(found[0].contour_class == 1);
    for (std::size_t k = 0; k < dyads; ++k) {
      CHECK(found[k + 1].kind == "RRR");
      CHECK(found[k + 1].links == std::vector<std::size_t>{2 * k, 2 * k + 1});
    }
  }

  TEST_CASE("mobility 0 without a drive: a beam on three supports") {
    Sketch s;
    const int beam = s.link("beam");
    s.pin(beam, ground);
    s.slot(beam, ground);
    CHECK(structure_of(s.model) == "2.2 RRP: beam");
  }
}
