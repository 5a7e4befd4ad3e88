#include "lib/project/run/search/joint_sizes.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace loadpath::project {

namespace {

constexpr double same_size = 1e-9;  // relative, in two stocks

/// The index of a size in a stock; nothing if the stock does not have it.
std::optional<std::size_t> index_of(double size, const std::vector<double>& stock) {
  const auto found = std::lower_bound(stock.begin(), stock.end(), size * (1.0 - same_size));
  if (found == stock.end() || *found > size * (1.0 + same_size)) return std::nullopt;
  return static_cast<std::size_t>(found - stock.begin());
}

}  // namespace

JointSizes::JointSizes(const PreparedStep& step, const Inputs& inputs)
    : inputs_(inputs), sizing_(step.input().calculator->sizing) {
  for (const Search& search : step.searches()) {
    searches_.push_back(&search);
    sought_.push_back({inputs.leaf(search.path).owner});
    sought_.back().like = count() - 1;
  }
  arrange(0);
  for (std::size_t i = 0; i < count(); ++i) {
    const std::string_view own = sought_[i].stock;
    stocks_.push_back(search(i).names_stock || own.empty() ? search(i).stock : std::string(own));
    const auto before = std::find(stocks_.begin(), stocks_.end() - 1, stocks_.back()) - stocks_.begin();
    sizes_.push_back(before < static_cast<std::ptrdiff_t>(i) ? sizes_[static_cast<std::size_t>(before)]
                                                             : stock_values(*step.input().tables, stocks_.back()));
    std::erase_if(sizes_.back(), [&](double size) { return !search(i).leaf.field->bounds.holds(size); });
  }
  for (std::size_t i = 0; i < count(); ++i) sought_[i].sizes = sizes_[i];
}

SizeIndices JointSizes::now() const {
  SizeIndices at;
  for (const OpenSize& s : sought_) at.push_back(s.at);
  return at;
}

SizeIndices JointSizes::largest_first() const {
  SizeIndices order(count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sought_[a].size() > sought_[b].size(); });
  return order;
}

SizeIndices JointSizes::firsts() const {
  SizeIndices firsts;
  for (std::size_t i = 0; i < count(); ++i) {
    if (is_first(i)) firsts.push_back(i);
  }
  return firsts;
}

std::vector<double> JointSizes::levels() const {
  std::vector<double> levels;
  for (const std::vector<double>& all : sizes_) levels.insert(levels.end(), all.begin(), all.end());
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

SizeIndices JointSizes::first_from(double size) const {
  SizeIndices first;
  first.reserve(count());
  for (const std::vector<double>& all : sizes_)
    first.push_back(static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), size) - all.begin()));
  for (std::size_t i = 0; i < caps_.size(); ++i) first[i] = std::min(first[i], caps_[i]);
  return first;
}

bool JointSizes::arrange(std::size_t way) {
  caps_.clear();
  return sizing_.arrange(inputs_.record().data.get(), sought_, way);
}

bool JointSizes::cap() {
  SizeIndices caps;
  bool limits = false;
  for (std::size_t i = 0; i < count(); ++i) {
    const auto is_possible = [&](std::size_t at) {
      SizeIndices least(count(), 0);
      least[i] = at;
      return set(least) && is_sound();
    };
    const std::size_t last = sizes_[i].size() - 1;
    std::size_t cap = last;
    while (cap > 0 && !is_possible(cap)) --cap;
    if (cap == 0 && !is_possible(0)) cap = last;  // a fault that no size removes
    limits = limits || cap < last;
    caps.push_back(cap);
  }
  caps_ = std::move(caps);
  return limits;
}

bool JointSizes::set(const SizeIndices& least) {
  for (std::size_t i = 0; i < count(); ++i) {
    if (least[i] >= sizes_[i].size()) return false;
    sought_[i].at = least[i];
  }
  if (!sizing_.raise(inputs_.record().data.get(), sought_)) return false;
  for (std::size_t i = 0; i < count(); ++i) inputs_.leaf(search(i).path).set(sought_[i].size());
  return true;
}

void JointSizes::set_alone(const SizeIndices& least) {
  for (std::size_t i = 0; i < count(); ++i)
    inputs_.leaf(search(i).path).set(sizes_[i][std::min(least[i], sizes_[i].size() - 1)]);
}

bool JointSizes::shrink(const SizeIndices& laid, std::size_t which) {
  for (std::size_t i = 0; i < count(); ++i) sought_[i].at = laid[i];
  for (std::size_t less = laid[which]; less-- > 0;) {
    bool in_all = true;
    for (std::size_t i = 0; i < count() && in_all; ++i) {
      if (sought_[i].like != sought_[which].like) continue;
      const auto found = index_of(sizes_[which][less], sizes_[i]);
      in_all = found.has_value();
      sought_[i].at = found.value_or(0);
    }
    if (in_all) return true;
  }
  return false;
}

bool JointSizes::set_smaller(const SizeIndices& laid, std::size_t which) {
  return shrink(laid, which) && set(now()) && sought_[which].at < laid[which];
}

Message JointSizes::fault(std::size_t i) const { return sizing_.fault(inputs_.record().data.get(), sought_, i); }

bool JointSizes::is_sound() const {
  for (std::size_t i = 0; i < count(); ++i) {
    if (!fault(i).empty()) return false;
  }
  return true;
}

double JointSizes::cost() const { return sizing_.cost(inputs_.record().data.get()); }

bool JointSizes::is_place_of(std::size_t first, const FieldInfo& list, const void* element) const {
  const void* const owner = sizing_.place(inputs_.record().data.get(), list.key, element);
  return std::any_of(sought_.begin(), sought_.end(),
                     [&](const OpenSize& s) { return s.like == first && s.owner == owner; });
}

bool JointSizes::is_given_place(const FieldInfo& list, const void* element) const {
  const void* const owner = sizing_.place(inputs_.record().data.get(), list.key, element);
  return owner != nullptr &&
         std::none_of(sought_.begin(), sought_.end(), [&](const OpenSize& s) { return s.owner == owner; });
}

SizeIndices JointSizes::alike(double size) const {
  SizeIndices all;
  for (const std::vector<double>& stock : sizes_) {
    const auto at = static_cast<std::size_t>(std::lower_bound(stock.begin(), stock.end(), size) - stock.begin());
    all.push_back(std::min(at, stock.size() - 1));
  }
  return all;
}

std::string JointSizes::given_place_of(const FieldInfo& list, const void* element) const {
  const Record& record = inputs_.record();
  const void* const owner = sizing_.place(record.data.get(), list.key, element);
  const FieldInfo* const sized = find_field(record.type->fields, sizing_.list);
  if (sized == nullptr || !is_given_place(list, element)) return {};
  for (std::size_t k = 0; k < sized->size(record.data.get()); ++k) {
    if (sized->element(record.data.get(), k) == owner)
      return std::string(sized->key) + "[" + std::to_string(k + 1) + "]";
  }
  return {};
}

}  // namespace loadpath::project
