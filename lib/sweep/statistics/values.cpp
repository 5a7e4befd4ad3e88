#include "lib/sweep/statistics/values.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::sweep {

void Values::take(double value) {
  if (!std::isfinite(value)) return;
  ++count_;
  if (count_ <= most_exact) return exact_.push_back(value);
  if (!exact_.empty()) {
    sketch_.add(exact_);
    exact_.clear();
  }
  sketch_.add(std::span(&value, 1));
}

void Values::add(std::span<const double> values) {
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (count_ + values.size() <= most_exact && std::all_of(values.begin(), values.end(), is_finite)) {
    count_ += values.size();
    exact_.insert(exact_.end(), values.begin(), values.end());
    return;
  }
  if (count_ <= most_exact) {
    std::for_each(values.begin(), values.end(), [this](double value) { take(value); });
    return;
  }
  count_ += static_cast<std::uint64_t>(std::count_if(values.begin(), values.end(), is_finite));
  sketch_.add(values);
}

void Values::merge(const Values& other) {
  if (other.count_ <= most_exact) return add(other.exact_);
  if (!exact_.empty()) {
    sketch_.add(exact_);
    exact_.clear();
  }
  sketch_.merge(other.sketch_);
  count_ += other.count_;
}

void Values::clear() {
  if (count_ > most_exact) sketch_ = {};
  count_ = 0;
  exact_.clear();
}

double Values::quantile(double p) const {
  if (count_ == 0) return std::numeric_limits<double>::quiet_NaN();
  if (count_ > most_exact) return Ranks(sketch_).quantile(p);
  std::vector<double> sorted = exact_;
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto rank = static_cast<std::ptrdiff_t>(place);
  const auto at = sorted.begin() + rank;
  std::nth_element(sorted.begin(), at, sorted.end());
  if (at + 1 == sorted.end()) return *at;
  const double next = *std::min_element(at + 1, sorted.end());
  const double part = place - static_cast<double>(rank);
  return part == 0.0 ? *at : *at + part * (next - *at);
}

void Values::store(Writer& writer) const {
  writer.put(count_);
  if (count_ > most_exact) return sketch_.store(writer);
  std::vector<double> sorted = exact_;  // the same bytes in every order
  std::sort(sorted.begin(), sorted.end());
  for (const double value : sorted) writer.put(value);
}

void Values::load(Reader& reader) {
  clear();
  const std::uint64_t count = reader.number();
  if (count > most_exact) {
    count_ = count;
    return sketch_.load(reader);
  }
  if (!reader.has(count)) return void(reader.fail());
  for (std::uint64_t i = 0; i < count; ++i) take(reader.real());
}

}  // namespace loadpath::sweep
