#include "lib/sweep/statistics/sketch.hpp"

#include <algorithm>
#include <bit>

namespace loadpath::sweep {

namespace {

constexpr unsigned kept_bits = 12, dropped_bits = 52 - kept_bits;
constexpr std::size_t page_size = std::size_t{1} << kept_bits, all_pages = 4096, positive_pages = all_pages / 2;
constexpr std::size_t not_finite = 0x7ff;  // the exponent of infinity and NaN

void merge_classes(ValueClass& left, const ValueClass& right) {
  left.count += right.count;
  left.least = std::min(left.least, right.least);
  left.largest = std::max(left.largest, right.largest);
}

}  // namespace

Sketch::Page& Sketch::page(std::size_t number) {
  if (pages_.empty()) pages_.resize(all_pages);
  if (pages_[number].empty()) pages_[number].resize(page_size);
  return pages_[number];
}

void Sketch::add(std::span<const double> values) {
  if (pages_.empty()) pages_.resize(all_pages);
  for (const double value : values) {
    const double x = value + 0.0;  // there is one zero
    const std::uint64_t key = std::bit_cast<std::uint64_t>(x) >> dropped_bits;
    const std::size_t number = key >> kept_bits;
    if (pages_[number].empty()) {
      if ((number & not_finite) == not_finite) continue;
      page(number);
    }
    ValueClass& of = pages_[number][key & (page_size - 1)];
    ++of.count;  // no branches: in a class of few values they are unpredictable
    of.least = x < of.least ? x : of.least;
    of.largest = x > of.largest ? x : of.largest;
  }
}

void Sketch::merge(const Sketch& other) {
  for (std::size_t number = 0; number < other.pages_.size(); ++number) {
    const Page& from = other.pages_[number];
    if (from.empty()) continue;
    Page& to = page(number);
    for (std::size_t k = 0; k < page_size; ++k) merge_classes(to[k], from[k]);
  }
}

std::vector<ValueClass> Sketch::classes() const {
  std::vector<ValueClass> found;
  if (pages_.empty()) return found;
  const auto take = [&](const ValueClass& of) {
    if (of.count > 0) found.push_back(of);
  };
  for (std::size_t number = all_pages; number-- > positive_pages;)
    std::for_each(pages_[number].rbegin(), pages_[number].rend(), take);
  for (std::size_t number = 0; number < positive_pages; ++number)
    std::for_each(pages_[number].begin(), pages_[number].end(), take);
  return found;
}

void Sketch::store(Writer& writer) const {
  const std::vector<ValueClass> all = classes();
  writer.put(std::uint64_t{all.size()});
  for (const ValueClass& of : all) {
    writer.put(of.count);
    writer.put(of.least);
    writer.put(of.largest);
  }
}

void Sketch::load(Reader& reader) {
  pages_.clear();
  for (std::uint64_t left = reader.count(3); left > 0; --left) {
    ValueClass of{reader.number(), reader.real(), reader.real()};
    const auto key = [](double x) { return std::bit_cast<std::uint64_t>(x) >> dropped_bits; };
    const std::size_t number = key(of.least) >> kept_bits;
    if (key(of.least) != key(of.largest) || (number & not_finite) == not_finite || of.count == 0) {
      reader.fail();
      return;
    }
    merge_classes(page(number)[key(of.least) & (page_size - 1)], of);
  }
}

}  // namespace loadpath::sweep
