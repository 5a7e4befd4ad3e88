#include "lib/table/reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>

namespace loadpath::table {

namespace {

/// x * 10^ten, rounded once from its decimal text: 3.15 becomes 31.5 and not 31.499999999999996.
double shifted(double x, int ten) {
  std::array<char, 64> text{};
  char* end = std::to_chars(text.data(), text.data() + 40, x, std::chars_format::fixed).ptr;
  *end++ = 'e';
  end = std::to_chars(end, text.data() + text.size(), ten).ptr;
  double result = 0.0;
  std::from_chars(text.data(), end, result);
  return result;
}

std::vector<double> over_decades(const std::vector<double>& decade, double low, double high) {
  std::vector<double> members;
  for (int ten = static_cast<int>(std::floor(std::log10(low))); shifted(1.0, ten) <= high; ++ten) {
    for (const double x : decade) {
      const double member = shifted(x, ten);
      if (low <= member && member <= high) members.push_back(member);
    }
  }
  return members;
}

bool ascends(const std::vector<double>& numbers) {
  return numbers.front() > 0.0 &&
         std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>{}) == numbers.end();
}

}  // namespace

bool Reader::read_series(const Tree& tree, Series& series) {
  const std::size_t before = issues_.size();
  series.name = text_of(tree, "name", "", true);
  series.title = text_of(tree, "title", series.name);
  check_keys(tree, {"name", "title", "sizes", "decade", "within", "sources", "recalled"}, series.name);
  const auto* decade = tree.find("decade");
  const auto* listed = decade != nullptr ? decade : tree.find("sizes");
  if (listed == nullptr) {
    complain(tree.place, series.name, say("give 'sizes', or a 'decade' and the range 'within'"));
    return false;
  }
  const auto numbers = ascending(listed->value, series.name + "." + listed->key);
  series.members = decade != nullptr ? repeated(tree, numbers, series.name) : numbers;
  read_origin(tree, numbers, series);
  return issues_.size() == before;
}

std::vector<double> Reader::ascending(const Tree& tree, const std::string& key) {
  auto list = numbers(tree, key);
  if (!list.empty() && !ascends(list)) complain(tree.place, key, say("sizes must be positive and ascending"));
  return list;
}

std::vector<double> Reader::repeated(const Tree& tree, const std::vector<double>& decade, const std::string& name) {
  const auto* within = tree.find("within");
  const auto range = within != nullptr ? ascending(within->value, name + ".within") : std::vector<double>{};
  if (range.size() == 2 && ascends(range)) return over_decades(decade, range[0], range[1]);
  complain(tree.place, name, say("a decade needs its range: within = [0.1, 1000]"));
  return {};
}

void Reader::read_origin(const Tree& tree, const std::vector<double>& listed, Series& series) {
  if (const auto* named = tree.find("sources")) series.sources = sources(named->value, series.name + ".sources");
  const auto* recalled = tree.find("recalled");
  if (recalled != nullptr && recalled->value.type == Tree::Type::array) {
    series.recalled = numbers(recalled->value, series.name + ".recalled");
  } else if (recalled != nullptr && recalled->value.text == "true") {
    series.recalled = listed;
  } else if (series.sources.empty()) {
    complain(tree.place, series.name, say("'{1}' has no source", series.name),
             say("name it in 'sources', or write recalled = true where none was seen"));
  }
}

}  // namespace loadpath::table
