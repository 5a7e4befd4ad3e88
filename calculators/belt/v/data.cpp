#include "calculators/belt/v/data.hpp"

#include "lib/table/library.hpp"
#include "lib/table/table.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::belt {

namespace {

struct WrapRow {
  static constexpr auto group = "v_belt_wrap";
  double alpha = unset<double>, c_alpha = unset<double>;
  static constexpr Fields fields{Field{&WrapRow::alpha, "alpha", deg, "wrap"},
                                 Field{&WrapRow::c_alpha, "c_alpha", ratio, "arc-of-contact factor"}};
};

struct CountRow {
  static constexpr auto group = "v_belt_count";
  double z = unset<double>, low = unset<double>, high = unset<double>;
  static constexpr Fields fields{Field{&CountRow::z, "z", ratio, "number of belts"},
                                 Field{&CountRow::low, called("C_K_low"), ratio, "low end"},
                                 Field{&CountRow::high, called("C_K_high"), ratio, "high end"}};
};

struct ServiceRow {
  static constexpr auto group = "v_belt_service";
  double c_10 = unset<double>, c_16 = unset<double>, c_24 = unset<double>;
  static constexpr Fields fields{Field{&ServiceRow::c_10, "c_10", ratio, "up to 10 h a day"},
                                 Field{&ServiceRow::c_16, "c_16", ratio, "up to 16 h a day"},
                                 Field{&ServiceRow::c_24, "c_24", ratio, "more than 16 h a day"}};
};

constexpr std::string_view prefix_of(Basis basis) { return basis == Basis::iso ? "iso " : "optibelt "; }

std::vector<VSection> read_sections() {
  std::vector<VSection> sections;
  for (const auto& row : table::rows_of<VRow>()) {
    const Basis basis = row.name().starts_with(prefix_of(Basis::iso)) ? Basis::iso : Basis::optibelt;
    VSection section{basis, Name(row.kind()), row, {}};
    for (const auto& length : table::rows_of<VLengthRow>()) {
      if (length.kind() == row.kind() && length.name().starts_with(prefix_of(basis))) section.lengths.push_back(length);
    }
    std::sort(section.lengths.begin(), section.lengths.end(),
              [](const VLengthRow& a, const VLengthRow& b) { return a.L < b.L; });
    sections.push_back(std::move(section));
  }
  return sections;
}

std::vector<WrapRow> read_wraps() {
  std::vector<WrapRow> wraps(table::rows_of<WrapRow>().begin(), table::rows_of<WrapRow>().end());
  std::sort(wraps.begin(), wraps.end(), [](const WrapRow& a, const WrapRow& b) { return a.alpha < b.alpha; });
  return wraps;
}

std::span<const WrapRow> wraps() {
  static const auto rows = read_wraps();
  return rows;
}

std::vector<Length> read_pulleys(Basis basis) {
  std::vector<Length> pulleys;
  if (const auto series = table::find_series(basis == Basis::iso ? "v_pulleys_gost" : "v_pulleys")) {
    for (const double d : table::members_in_si(**series)) pulleys.push_back(from_si<Length>(d));
  }
  return pulleys;
}

bool is_same(Length a, Length b) { return std::abs(in_si(a) - in_si(b)) < 1e-9; }

/// y at x, linear between points in ascending order of x; NaN outside.
template <class Point, class X, class Y>
double between(std::span<const Point> points, double at, X x, Y y) {
  const auto next = std::find_if(points.begin(), points.end(), [&](const Point& p) { return x(p) >= at; });
  if (next == points.end()) return unset<double>;
  if (x(*next) == at) return y(*next);
  if (next == points.begin()) return unset<double>;
  const Point& last = *(next - 1);
  return y(last) + (y(*next) - y(last)) * (at - x(last)) / (x(*next) - x(last));
}

}  // namespace

std::span<const VSection> v_sections() {
  static const auto sections = read_sections();
  return sections;
}

const VSection* find_v_section(Basis basis, const Name& name) {
  for (const VSection& section : v_sections()) {
    if (section.basis == basis && section.name == name) return &section;
  }
  return nullptr;
}

SectionWord word_of(const Name& name) {
  for (const auto& choice : choices_of(SectionWord{})) {
    if (name.view() == choice.key) return choice.value;
  }
  return SectionWord::none;
}

std::string names_of_v_sections(Basis basis) {
  std::string names;
  for (const VSection& section : v_sections()) {
    if (section.basis == basis) names += (names.empty() ? "" : ", ") + std::string(section.name.view());
  }
  return names;
}

std::span<const Length> v_pulleys(Basis basis) {
  static const auto iso = read_pulleys(Basis::iso), optibelt = read_pulleys(Basis::optibelt);
  return basis == Basis::iso ? iso : optibelt;
}

bool is_sold_pulley(Length d) {
  const auto lists = [d](Basis basis) {
    const auto all = v_pulleys(basis);
    return std::any_of(all.begin(), all.end(), [d](Length listed) { return is_same(listed, d); });
  };
  return lists(Basis::iso) || lists(Basis::optibelt);
}

bool is_sold_belt(const VSection& section, Length L) {
  return std::any_of(section.lengths.begin(), section.lengths.end(),
                     [L](const VLengthRow& row) { return is_same(row.L, L); });
}

double v_length_factor(const VSection& section, Length L) {
  // A length that rounding has moved by its last bits is the length of the table.
  const double at = std::round(in_si(L) * 1e9) * 1e-9;
  return between(
      std::span<const VLengthRow>(section.lengths), at,
      [](const VLengthRow& r) { return std::round(in_si(r.L) * 1e9) * 1e-9; },
      [](const VLengthRow& r) { return r.c_L; });
}

double optibelt_wrap_factor(double alpha) {
  if (wraps().empty()) return unset<double>;
  return between(
      wraps(), min(alpha, wraps().back().alpha), [](const WrapRow& r) { return r.alpha; },
      [](const WrapRow& r) { return r.c_alpha; });
}

double least_optibelt_wrap() { return wraps().empty() ? unset<double> : wraps().front().alpha; }

double v_count_factor(double z, bool high_end) {
  const auto& rows = table::rows_of<CountRow>();
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    if (z >= row->z) return high_end ? row->high : row->low;
  }
  return unset<double>;
}

double optibelt_service_factor(std::string_view name, double hours) {
  for (const auto& row : table::rows_of<ServiceRow>()) {
    if (row.name() == name) return hours <= 10.0 ? row.c_10 : hours <= 16.0 ? row.c_16 : row.c_24;
  }
  return unset<double>;
}

}  // namespace loadpath::belt
