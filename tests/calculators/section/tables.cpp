// Every row of the section tables against the calculators, which know nothing of the tables: each checks the other.
#include "calculators/section/polygon_moments.hpp"
#include "calculators/section/profile.hpp"
#include "calculators/section/shapes/angle.hpp"
#include "calculators/section/shapes/channel.hpp"
#include "calculators/section/shapes/hollow.hpp"
#include "calculators/section/shapes/i.hpp"
#include "calculators/section/shapes/ring.hpp"
#include "tests/calculators/section/sections.hpp"

using namespace loadpath;
using namespace loadpath::section;

namespace {

using Row = table::Typed<Profile>;

/// The relative tolerances of a family: of area and of second moments, from its printed digits and its corners.
struct Tolerance {
  double A, I, I_t;
};

void check_against(const Row& row, const Properties& p, const Tolerance& within) {
  CHECK(rel(row.A, p.A) < within.A);
  CHECK(rel(row.I_y, p.I_y) < within.I);
  CHECK(rel(row.I_z, p.I_z) < within.I);
  CHECK(rel(row.i_y, p.i_y) < within.I);
  CHECK(rel(row.i_z, p.i_z) < within.I);
  CHECK(rel(row.I_min, p.I_min) < 2.0 * within.I);
  CHECK(rel(row.i_min, p.i_min) < within.I);
  CHECK(rel(row.W_y, min(p.W_y_top, p.W_y_bottom)) < within.I);
  CHECK(rel(row.W_z, min(p.W_z_left, p.W_z_right)) < within.I);
  CHECK(rel(in_si(row.m), 7850.0 * in_si(row.A)) < 0.01);
  if (is_set(row.I_t)) CHECK(rel(row.I_t, p.I_t) < within.I_t);
}

template <class Check>
std::size_t for_family(std::string_view table, Check check) {
  std::size_t count = 0;
  for (const Row& row : table::rows_of<Profile>()) {
    if (row.entry.table->name != table) continue;
    CAPTURE(row.name());
    check(row);
    ++count;
  }
  return count;
}

/// A channel with tapered flanges: t_f is measured at half the width, from 300 mm depth on at half of the outstand.
Properties tapered_channel(const Row& row) {
  const bool deep = row.h > 300.5 * mm;
  const double slope = deep ? 0.05 : 0.08;
  const Length out = deep ? 0.5 * (row.b - row.t_w) : 0.5 * row.b;  // from the toe to where t_f is measured
  const Length at_toe = row.t_f - slope * out, at_web = row.t_f + slope * (row.b - row.t_w - out);
  const Length none = 0.0 * row.h, z = 0.5 * row.h;
  const Outline outline{
      {none, -z}, {row.b, -z}, {row.b, at_toe - z}, {row.t_w, at_web - z}, {row.t_w, z - at_web}, {row.b, z - at_toe},
      {row.b, z}, {none, z}};
  NoTrace trace;
  return centroidal(polygon_moments(outline, outline[0]), outline[0], trace);
}

}  // namespace

TEST_SUITE("section tables") {
  TEST_CASE("the values of IPE, HEA, HEB and HEM follow from their dimensions, the torsion constant within 4.5 %") {
    std::size_t count = 0;
    for (const char* table : {"sections/ipe", "sections/hea", "sections/heb", "sections/hem"}) {
      count += for_family(table, [](const Row& row) {
        const section::I::Input in{{row.h, row.b, row.t_w, row.t_f, row.r}};
        REQUIRE(broken<section::I>(in).empty());
        check_against(row, solve<section::I>(in), {0.0005, 0.004, 0.045});
      });
    }
    CHECK(count == 90);
  }

  TEST_CASE("the values of W sections follow from their dimensions, but for the fillets, which are not in the table") {
    const std::size_t count = for_family("sections/w", [](const Row& row) {
      const auto p = solve<section::I>({{row.h, row.b, row.t_w, row.t_f}});
      CHECK(in_si(p.A) / in_si(row.A) < 1.03);
      CHECK(in_si(p.A) / in_si(row.A) > 0.93);
      CHECK(rel(row.I_y, p.I_y) < 0.07);
      CHECK(rel(row.I_z, p.I_z) < 0.025);
      CHECK(rel(row.i_z, sqrt(row.I_z / row.A)) < 0.015);
      CHECK(rel(row.i_y, sqrt(row.I_y / row.A)) < 0.015);
      CHECK(rel(row.W_y, 2.0 * row.I_y / row.h) < 0.015);
      CHECK(rel(row.W_z, 2.0 * row.I_z / row.b) < 0.015);
      CHECK(rel(in_si(row.m), 7850.0 * in_si(row.A)) < 0.025);
    });
    CHECK(count == 289);
  }

  TEST_CASE(
      "American beams, channels and piles: radii of gyration, section moduli and mass, shear centres of channels") {
    const auto agree = [](const Row& row) {
      CHECK(rel(row.i_y, sqrt(row.I_y / row.A)) < 0.015);
      CHECK(rel(row.i_z, sqrt(row.I_z / row.A)) < 0.015);
      CHECK(rel(row.W_y, 2.0 * row.I_y / row.h) < 0.03);
      CHECK(rel(in_si(row.m), 7850.0 * in_si(row.A)) < 0.03);
      CHECK(in_si(row.I_min) == in_si(row.I_z));
      const auto p = solve<section::I>({{row.h, row.b, row.t_w, row.t_f}});
      if (row.kind() == "rolled_I") CHECK(rel(row.I_y, p.I_y) < 0.07);
    };
    CHECK(for_family("sections/hp", agree) == 22);
    CHECK(for_family("sections/s", agree) == 28);
    const auto channel = [&](const Row& row) {
      agree(row);
      const auto p = solve<section::Channel>({row.h, row.b, row.t_w, row.t_f});
      CHECK(rel(row.A, p.A) < 0.04);
      CHECK(rel(row.I_y, p.I_y) < 0.04);
      CHECK(rel(row.e_z, p.y_S) < 0.13);  // tapered flanges
      CHECK(rel(row.W_z, row.I_z / (row.b - row.e_z)) < 0.03);
    };
    CHECK(for_family("sections/c", channel) == 31);
    CHECK(for_family("sections/mc", channel) == 40);
  }

  TEST_CASE("the values of American hollow sections follow from their design thickness, outer radii twice that") {
    const std::size_t count = for_family("sections/hss", [](const Row& row) {
      const auto p = solve<section::Hollow>({row.h, row.b, row.t_w, 2.0 * row.t_w, row.t_w});
      CHECK(rel(row.A, p.A) < 0.02);
      CHECK(rel(row.I_y, p.I_y) < 0.02);
      CHECK(rel(row.I_z, p.I_z) < 0.02);
      if (row.b > 4.5 * row.t_w) CHECK(rel(row.I_t, p.I_t) < 0.05);  // else its corners meet
      CHECK(rel(row.i_y, sqrt(row.I_y / row.A)) < 0.02);
      CHECK(rel(row.W_y, 2.0 * row.I_y / row.h) < 0.02);
      CHECK(rel(row.W_z, 2.0 * row.I_z / row.b) < 0.02);
    });
    CHECK(count == 525);
    for (const char* table : {"sections/hss_round", "sections/pipe"}) {
      for_family(table, [](const Row& row) {
        section::Ring::Input in{row.h};
        in.t = row.t_w;
        const auto p = solve<section::Ring>(in);
        CHECK(rel(row.A, p.A) < 0.04);  // the design thickness of pipe is rounded
        CHECK(rel(row.I_y, p.I_y) < 0.04);
        CHECK(rel(row.I_t, 2.0 * row.I_y) < 0.02);
        CHECK(rel(row.W_y, 2.0 * row.I_y / row.h) < 0.03);
        CHECK(rel(row.W_t, 2.0 * row.I_t / row.h) < 0.03);
      });
    }
  }

  TEST_CASE("the values of UPE follow from their dimensions, with the distance of their centroid") {
    const std::size_t count = for_family("sections/upe", [](const Row& row) {
      const auto p = solve<section::Channel>({row.h, row.b, row.t_w, row.t_f, row.r});
      check_against(row, p, {0.004, 0.005, 0.17});
      CHECK(rel(row.e_z, p.y_S) < 0.003);
      CHECK(p.I_t < row.I_t);
    });
    CHECK(count == 14);
  }

  TEST_CASE(
      "UPN are within 3 % of the polygon of their tapered flanges, without fillets and toes; the centroid within 4.5 "
      "%") {
    const std::size_t count = for_family("sections/upn", [](const Row& row) {
      const Properties p = tapered_channel(row);
      CHECK(rel(row.A, p.A) < 0.02);
      CHECK(rel(row.I_y, p.I_y) < 0.02);
      CHECK(rel(row.I_z, p.I_z) < 0.03);
      CHECK(rel(row.e_z, p.y_S) < 0.045);
      CHECK(rel(row.i_y, sqrt(row.I_y / row.A)) < 0.011);
      CHECK(rel(row.i_z, sqrt(row.I_z / row.A)) < 0.005);
      CHECK(rel(row.W_y, 2.0 * row.I_y / row.h) < 0.005);
      CHECK(rel(row.W_z, row.I_z / (row.b - row.e_z)) < 0.015);
      CHECK(in_si(row.I_min) == in_si(row.I_z));
    });
    CHECK(count == 16);
  }

  TEST_CASE("the values of equal angles follow from their dimensions, I_min about a principal axis") {
    const std::size_t count = for_family("sections/l_equal", [](const Row& row) {
      const section::Angle::Input in{row.h, row.b, row.t_w, row.r, row.r_2};
      REQUIRE(broken<section::Angle>(in).empty());
      const auto p = solve<section::Angle>(in);
      check_against(row, p, {0.007, 0.015, 1.0});
      CHECK(rel(row.e_z, p.z_S) < 0.007);
      CHECK(rel(row.I_yz, p.I_yz) < 0.023);
      CHECK(p.I_yz < 0.0 * p.I_yz);
      CHECK(p.alpha == doctest::Approx(pi / 4.0).epsilon(1e-9));
    });
    CHECK(count == 80);
  }

  TEST_CASE("round tubes are rings") {
    const std::size_t count = for_family("sections/chs", [](const Row& row) {
      section::Ring::Input in{row.h};
      in.t = row.t_w;
      const auto p = solve<section::Ring>(in);
      check_against(row, p, {0.003, 0.003, 0.003});
      CHECK(rel(row.W_t, p.W_t) < 0.001);
    });
    CHECK(count == 162);
  }

  TEST_CASE("hollow rectangles agree with EN 10210-2 for their dimensions, torsion included, within 0.5 %") {
    std::size_t count = 0;
    for (const char* table : {"sections/rhs", "sections/shs"}) {
      count += for_family(table, [](const Row& row) {
        const Length t = row.t_w;
        const section::Hollow::Input in{row.h, row.b, t, 1.5 * t, t};
        REQUIRE(broken<section::Hollow>(in).empty());
        const auto p = solve<section::Hollow>(in);
        check_against(row, p, {0.005, 0.007, 0.006});
        CHECK(rel(row.W_t, p.W_t) < 0.006);
      });
    }
    CHECK(count == 248);
  }

  TEST_CASE("every row has a source, and its name and aliases find it") {
    for (const Row& row : table::rows_of<Profile>()) {
      CAPTURE(row.name());
      for (const auto& value : row.entry.row->values) CHECK_FALSE(value.sources.empty());
      CHECK(find_profile(row.name()) == &row);
    }
    CHECK(find_profile("he 200 a")->name() == "HEA 200");
    CHECK(find_profile("ipe200")->name() == "IPE 200");
    CHECK(find_profile("SHS 100x5")->name() == "SHS 100x100x5");
    CHECK(find_profile("IPE 205") == nullptr);
  }
}
