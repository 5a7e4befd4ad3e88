#include "lib/rainflow/series/read_series.hpp"

#include "lib/rainflow/series/binary.hpp"
#include "lib/rainflow/series/csv.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace loadpath::rainflow {

std::optional<Format> format_of(std::string_view path) {
  static constexpr std::array<std::pair<std::string_view, Format>, 7> ends{{{".csv", Format::csv},
                                                                            {".tsv", Format::csv},
                                                                            {".txt", Format::csv},
                                                                            {".dat", Format::csv},
                                                                            {".npy", Format::npy},
                                                                            {".f64", Format::f64},
                                                                            {".f32", Format::f32}}};
  const auto found = std::find_if(ends.begin(), ends.end(), [&](const auto& end) { return path.ends_with(end.first); });
  return found == ends.end() ? std::nullopt : std::optional(found->second);
}

Outcome<std::unique_ptr<Reader>> read_series(std::unique_ptr<Source> source, const Form& form) {
  switch (form.format) {
    case Format::csv:
      break;
    case Format::npy:
      return read_npy(std::move(source), form.column);
    case Format::f64:
      return read_plain(std::move(source), sizeof(double));
    case Format::f32:
      return read_plain(std::move(source), sizeof(float));
  }
  return read_csv(std::move(source), form);
}

}  // namespace loadpath::rainflow
