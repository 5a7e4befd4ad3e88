// The rows of rolling bearings against rules that the maker's numbers obey, whoever copied them.
#include "tests/lib/table/tables.hpp"

#include <array>
#include <cctype>
#include <limits>
#include <string>

using namespace loadpath;
using namespace loadpath::table;

namespace {

template <class Visit>
void each_bearing(Visit visit) {
  for (const Table* table : tables_of("bearing")) {
    for (const Row& row : table->rows) visit(Entry{table, &row});
  }
}

/// The bore of a designation by its last two digits: 00 to 03 have their own, from 04 on five times the digits.
double bore_in_mm(const std::string& name) {
  std::size_t end = name.find_first_of("0123456789");
  while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])) != 0) ++end;
  const int code = std::stoi(name.substr(end - 2, 2));
  constexpr std::array own{10.0, 12.0, 15.0, 17.0};
  return code < 4 ? own[static_cast<std::size_t>(code)] : 5.0 * code;
}

/// f_c of ISO 281, table 2, for D_w/D_pw = 0.01 to 0.40.
constexpr std::array f_c{29.1, 35.8, 40.3, 43.8, 46.7, 49.1, 51.1, 52.8, 54.3, 55.5, 56.6, 57.5, 58.2, 58.8,
                         59.3, 59.6, 59.8, 59.9, 60.0, 59.9, 59.8, 59.6, 59.3, 59.0, 58.6, 58.2, 57.7, 57.1,
                         56.6, 56.0, 55.3, 54.6, 53.9, 53.2, 52.4, 51.7, 50.9, 50.0, 49.2, 48.4};
double f_c_at(double gamma) {
  const double at = 100.0 * gamma - 1.0;
  const auto i = static_cast<std::size_t>(at);
  return f_c[i] + (at - static_cast<double>(i)) * (f_c[i + 1] - f_c[i]);
}

/// The ratio of the printed C to that of ISO 281 with the balls that give the printed C_0 by ISO 76, the nearest to 1
/// of all numbers of balls, f_0 within its rounding.
double ratio_to_iso_281(const Entry& row) {
  const double C_0 = value_of(row, "C_0"), D_pw = 0.5e3 * (value_of(row, "d") + value_of(row, "D"));
  double nearest = std::numeric_limits<double>::infinity();
  for (double f_0 = value_of(row, "f_0") - 0.5; f_0 < value_of(row, "f_0") + 0.5; f_0 += 0.1) {
    for (int Z = 6; Z < 25; ++Z) {
      const double D_w = std::sqrt(C_0 / f_0 / Z);
      if (D_w > 0.38e3 * (value_of(row, "D") - value_of(row, "d"))) continue;  // between the rings
      const double of_ball = D_w <= 25.4 ? std::pow(D_w, 1.8) : 3.647 * std::pow(D_w, 1.4);
      const double C = 1.3 * f_c_at(D_w / D_pw) * std::pow(Z, 2.0 / 3.0) * of_ball;
      const double ratio = value_of(row, "C") / C;
      if (std::abs(ratio - 1.0) < std::abs(nearest - 1.0)) nearest = ratio;
    }
  }
  return nearest;
}

}  // namespace

TEST_SUITE("table") {
  TEST_CASE("bearings: the bore is that of the designation, and the sizes are those of a ring around it") {
    int count = 0;
    each_bearing([&](const Entry& row) {
      INFO(row.row->name);
      CHECK(value_of(row, "d") == doctest::Approx(bore_in_mm(row.row->name) * table::mm));
      CHECK(value_of(row, "D") > value_of(row, "d"));
      const double r_s = value_of(row, "r_s"), d_a = value_of(row, "d_a");
      if (!std::isnan(r_s)) CHECK(r_s < 0.3 * (value_of(row, "D") - value_of(row, "d")));
      if (!std::isnan(d_a)) CHECK((value_of(row, "d") + 2.0 * r_s < d_a && d_a < value_of(row, "D")));
      ++count;
    });
    CHECK(count > 800);
  }

  TEST_CASE("bearings: C and C_0 of deep groove ball bearings are those of ISO 281 and ISO 76") {
    each_bearing([](const Entry& row) {
      if (row.row->kind != "deep_groove_ball") return;
      INFO(row.row->name);
      CHECK(std::abs(ratio_to_iso_281(row) - 1.0) < 0.035);
    });
  }

  TEST_CASE("bearings: e Y is a constant of the kind, as both come from the contact angle") {
    each_bearing([](const Entry& row) {
      INFO(row.row->name);
      const double e = value_of(row, "e"), Y = value_of(row, "Y"), Y_1 = value_of(row, "Y_1");
      if (row.row->kind == "tapered_roller") CHECK(e * Y == doctest::Approx(0.595).epsilon(0.015));
      if (row.row->kind == "spherical_roller") CHECK(e * Y_1 == doctest::Approx(0.675).epsilon(0.025));
      if (row.row->kind == "self_aligning_ball") CHECK(e * Y_1 == doctest::Approx(0.63).epsilon(0.025));
      if (row.row->kind == "spherical_roller" || row.row->kind == "self_aligning_ball")
        CHECK(Y / Y_1 == doctest::Approx(1.54).epsilon(0.045));
    });
  }

  TEST_CASE(
      "bearings: the pressure centre is where the contact angle meets the axis, seen from the outer ring's back") {
    int count = 0;
    each_bearing([&](const Entry& row) {
      INFO(row.row->name);
      const double a = value_of(row, "a"), B = value_of(row, "B");
      const double pitch_radius = 0.25 * (value_of(row, "d") + value_of(row, "D"));
      if (std::isnan(a)) return;
      const bool balls = row.row->kind == "angular_contact_ball";
      CHECK((balls || row.row->kind == "tapered_roller"));
      // e = 1.5 tan(alpha) of rollers, which are not in the middle of T; the catalogue rounds to 1 mm
      const double tangent = balls ? std::tan(40.0 / 180.0 * 3.14159265358979) : value_of(row, "e") / 1.5;
      const double ratio = a / (0.5 * B + pitch_radius * tangent);
      CHECK(ratio > (balls ? 0.97 : 0.86));
      CHECK(ratio < (balls ? 1.03 : 1.04));
      CHECK(a > 0.5 * B);
      ++count;
    });
    CHECK(count == 156);
  }

  TEST_CASE("bearings: in a series sizes grow with the bore, and so do mass and ratings but for changes of class") {
    for (const Table* table : tables_of("bearing")) {
      const double class_step = table->name == "bearing/NU10" ? 0.6 : 0.75;
      for (std::size_t i = 1; i < table->rows.size(); ++i) {
        const Entry before{table, &table->rows[i - 1]}, here{table, &table->rows[i]};
        INFO(here.row->name);
        for (const char* key : {"D", "B", "r_s", "d_a", "a"}) {
          if (!std::isnan(value_of(here, key) * value_of(before, key)))
            CHECK(value_of(here, key) >= value_of(before, key));
        }
        for (const char* key : {"C", "C_0", "C_u", "m"})
          CHECK(value_of(here, key) > class_step * value_of(before, key));
      }
    }
  }

  TEST_CASE("bearings: C_u is C_0/22 for balls and C_0/8.2 for rollers, up to the manufacturers' designs") {
    each_bearing([](const Entry& row) {
      INFO(row.row->name);
      const bool balls = row.row->kind.find("ball") != std::string::npos || row.row->kind == "angular_contact_pair";
      const double ratio = value_of(row, "C_0") / value_of(row, "C_u");
      CHECK(ratio > (balls ? 17.0 : 7.4));
      CHECK(ratio < (balls ? 45.0 : 12.5));
    });
  }

  TEST_CASE("bearings: the short designation names the row") {
    CHECK(find_row("bearing", "NU 308")->row->name == "NU 308 ECP");
    CHECK(find_row("bearing", "30208")->row->name == "30208 J2/Q");
    CHECK(find_row("bearing", "nu308ecp")->row->name == "NU 308 ECP");
    CHECK(value_of(*find_row("bearing", "6208"), "C") == doctest::Approx(32500.0));
    CHECK_FALSE(find_row("bearing", "7208"));  // 15, 25 or 40 degrees
  }
}
