// The sweeps of a calculator class. Included by the source of a calculator, through calculator_of.hpp.
//
// The generic loop serves every input: a record per point. The others are compiled for the forms that the calculator
// names (Form): blocks of columns pass through `evaluate` in vector lanes, and the given inputs are known at compile
// time. There is no other difference: each point equals that of a single `evaluate`, to the bit.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/calculator/form_of.hpp"
#include "lib/simd/attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace loadpath::detail {

/// A record per point: for any inputs, lists too.
template <class C>
void sweep_records(void* input, std::span<const InputColumn> in, std::span<const ResultColumn> out, std::size_t count) {
  NoTrace trace;
  char* const base = static_cast<char*>(input);
  for (std::size_t i = 0; i < count; ++i) {
    for (const InputColumn& column : in) std::memcpy(base + column.offset, column.si + i, sizeof(double));
    const typename C::Result result = C::evaluate(*static_cast<const typename C::Input*>(input), trace);
    const char* const values = reinterpret_cast<const char*>(&result);
    for (const ResultColumn& column : out) std::memcpy(column.si + i, values + column.offset, sizeof(double));
  }
}

/// The same with `evaluate` and all that it calls inlined: half the time of a point, and several times that of the
/// build.
template <class C>
LOADPATH_LANES void sweep_inlined(void* input, std::span<const InputColumn> in, std::span<const ResultColumn> out,
                                  std::size_t count) {
  sweep_records<C>(input, in, out, count);
}

/// The loop for any set of inputs.
template <class C>
constexpr SweepLoop general_loop() {
  if constexpr (
      requires { C::forms; } || requires { C::is_inlined; }) {
    return &sweep_inlined<C>;
  } else {
    return &sweep_records<C>;
  }
}

template <class Column>
const Column* column_at(std::span<const Column> columns, std::size_t offset) {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.offset == offset; });
  return found == columns.end() ? nullptr : &*found;
}

template <class Column, std::size_t n>
bool all_among(std::span<const Column> columns, const std::array<std::size_t, n>& offsets) {
  return std::all_of(columns.begin(), columns.end(), [&](const Column& c) {
    return std::find(offsets.begin(), offsets.end(), c.offset) != offsets.end();
  });
}

/// Whether the form serves: the base gives the inputs of the form, and no other quantity varies or is requested.
template <class C, std::size_t which>
bool serves(const typename C::Input& base, std::span<const InputColumn> in, std::span<const ResultColumn> out) {
  using F = FormOf<C, which>;
  const auto given = offsets_in<typename C::Input>(F::given);
  const auto values = values_in(base, F::given);
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (std::isnan(values[k]) && column_at(in, given[k]) == nullptr) return false;
  }
  return all_among(in, given) && all_among(out, offsets_in<typename C::Result>(F::asked)) && F::fits(base);
}

/// A block in lanes. No value of `in` is missing.
template <class C, class F, class... Given, class... Asked, std::size_t... K, std::size_t... J>
LOADPATH_LANES void sweep_lanes(const typename C::Input& base, const double* const* in, double* const* out,
                                std::size_t count, Leaves<Given...>, Leaves<Asked...>, std::index_sequence<K...>,
                                std::index_sequence<J...>) {
  NoTrace trace;
  const double* const from[] = {in[K]...};
  double* const to[] = {out[J]...};
  LOADPATH_POINTWISE
  for (std::size_t i = 0; i < count; ++i) {
    const double given[] = {from[K][i]...};
    if ((std::isnan(given[K]) || ...)) __builtin_unreachable();
    typename C::Input point;
    F::settle(point, base);
    ((Given::in(point) = from_si<std::remove_cvref_t<decltype(Given::in(point))>>(given[K])), ...);
    const typename C::Result result = C::evaluate(point, trace);
    ((to[J][i] = in_si(Asked::in(result))), ...);
  }
}

/// Without a branch, for the compiler to put into lanes.
template <class Column>
LOADPATH_LANES bool any_missing(const Column* columns, std::size_t width, std::size_t count) {
  std::uint64_t any = 0;
  for (std::size_t k = 0; k < width; ++k) {
    const double* const si = columns[k].si;
    for (std::size_t i = 0; i < count; ++i) any |= static_cast<std::uint64_t>(std::isnan(si[i]));
  }
  return any != 0;
}

/// The columns from `start` on.
template <std::size_t most, class Column>
std::array<Column, most> from(std::size_t start, std::span<const Column> columns) {
  std::array<Column, most> later{};
  for (std::size_t k = 0; k < columns.size(); ++k) later[k] = {columns[k].offset, columns[k].si + start};
  return later;
}

/// A form's sweep, block by block. Given inputs that do not vary are columns of equal values; a block with missing
/// values does not match any form.
template <class C, std::size_t which>
void sweep_form(void* input, std::span<const InputColumn> in, std::span<const ResultColumn> out, std::size_t count) {
  using F = FormOf<C, which>;
  constexpr std::size_t block = 256, inputs = F::given.count, results = F::asked.count;
  const auto given = offsets_in<typename C::Input>(F::given);
  const auto asked = offsets_in<typename C::Result>(F::asked);
  const auto values = values_in(*static_cast<const typename C::Input*>(input), F::given);
  std::array<std::array<double, block>, inputs> constant;
  for (std::size_t k = 0; k < inputs; ++k) {
    if (column_at(in, given[k]) == nullptr) constant[k].fill(values[k]);
  }
  std::array<double, block> unasked;
  for (std::size_t start = 0; start < count; start += block) {
    const std::size_t n = std::min(block, count - start);
    const auto rest = from<inputs>(start, in);
    const auto found = from<results>(start, out);
    const std::span columns = std::span(rest).first(in.size());
    const std::span wanted = std::span(found).first(out.size());
    if (any_missing(columns.data(), columns.size(), n)) {
      general_loop<C>()(input, columns, wanted, n);
      continue;
    }
    std::array<const double*, inputs> sources;
    std::array<double*, results> targets;
    for (std::size_t k = 0; k < inputs; ++k) {
      const InputColumn* const column = column_at<InputColumn>(columns, given[k]);
      sources[k] = column == nullptr ? constant[k].data() : column->si;
    }
    for (std::size_t k = 0; k < results; ++k) {
      const ResultColumn* const column = column_at<ResultColumn>(wanted, asked[k]);
      targets[k] = column == nullptr ? unasked.data() : column->si;
    }
    sweep_lanes<C, F>(*static_cast<const typename C::Input*>(input), sources.data(), targets.data(), n, F::given,
                      F::asked, std::make_index_sequence<inputs>{}, std::make_index_sequence<results>{});
  }
}

/// The first form that serves, else the generic loop.
template <class C>
SweepLoop loop_of(const void* input, std::span<const InputColumn> in, std::span<const ResultColumn> out) {
  SweepLoop loop = general_loop<C>();
  if constexpr (requires { C::forms; }) {
    const auto& base = *static_cast<const typename C::Input*>(input);
    [&]<std::size_t... which>(std::index_sequence<which...>) {
      (void)((serves<C, which>(base, in, out) && (loop = &sweep_form<C, which>, true)) || ...);
    }
    (std::make_index_sequence<C::forms.size()>{});
  }
  return loop;
}

}  // namespace loadpath::detail
