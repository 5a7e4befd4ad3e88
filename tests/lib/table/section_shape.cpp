#include "lib/table/section_shape.hpp"

#include "lib/table/library.hpp"
#include "lib/table/search.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace loadpath::table;

namespace {

SectionShape shape_of(const Row& row) {
  const auto of = [&](const char* column) { return searched_value(row, column); };
  return {of("h"),   of("b"),  of("d"),     of("t_f"), of("t_w"), of("A"),      of("I_y"),
          of("I_z"), row.kind, of("I_min"), of("I_t"), of("I_w"), of("W_pl_y"), of("W_pl_z")};
}

/// HEB 200, in mm.
SectionShape heb_200() {
  constexpr double mm = 1e-3, mm2 = 1e-6, mm3 = 1e-9, mm4 = 1e-12, mm6 = 1e-18;
  return {.h = 200 * mm,
          .b = 200 * mm,
          .t_f = 15 * mm,
          .t_w = 9 * mm,
          .A = 7808 * mm2,
          .I_y = 5696e4 * mm4,
          .I_z = 2003e4 * mm4,
          .kind = "rolled_I",
          .I_t = 59.3e4 * mm4,
          .I_w = 171100e6 * mm6,
          .W_pl_y = 642.5e3 * mm3,
          .W_pl_z = 305.8e3 * mm3};
}

std::string key_of(const SectionShape& shape) {
  const auto misfit = inconsistency_of(shape);
  return misfit ? misfit->key : "";
}

}  // namespace

TEST_SUITE("table section_shape") {
  TEST_CASE("every section of the tables fits its sizes") {
    for (const Table* table : tables_of("section")) {
      for (const Row& row : table->rows) {
        const auto misfit = inconsistency_of(shape_of(row));
        CHECK_MESSAGE(!misfit, row.name, ": ", misfit ? misfit->message.text() : "");
      }
    }
  }

  TEST_CASE("constants far above those of the walls are detected") {
    CHECK(key_of(heb_200()).empty());
    for (double SectionShape::*value : {&SectionShape::W_pl_y, &SectionShape::W_pl_z, &SectionShape::I_t,
                                        &SectionShape::I_w, &SectionShape::I_y, &SectionShape::A}) {
      SectionShape wrong = heb_200();
      wrong.*value *= 2.0;
      CHECK_FALSE(key_of(wrong).empty());
    }
  }

  TEST_CASE("an angle has a minimum second moment of its own, by its legs") {
    constexpr double mm = 1e-3;
    SectionShape angle{.h = 100 * mm, .b = 100 * mm, .t_w = 10 * mm, .A = 1915e-6, .I_y = 177e-8, .I_z = 177e-8};
    angle.kind = "angle";
    angle.I_min = 73e-8;
    CHECK(key_of(angle).empty());
    angle.I_min = 177e-8;
    CHECK(key_of(angle) == "I_min");
  }
}
