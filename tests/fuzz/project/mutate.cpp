#include "tests/fuzz/project/mutate.hpp"

#include "tests/fuzz/project/seeds.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <utility>
#include <vector>

namespace loadpath::fuzz {

namespace {

using Lines = std::vector<std::string>;

std::size_t below(std::size_t count, Random& random) { return count == 0 ? 0 : random() % count; }
template <class List>
const auto& any(const List& list, Random& random) {
  return list[below(list.size(), random)];
}

struct Span {
  std::size_t from, size;
};

/// Positions of numbers in a text that are not part of a name.
std::vector<Span> numbers_in(const std::string& text) {
  std::vector<Span> found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!std::isdigit(static_cast<unsigned char>(text[i]))) continue;
    const bool in_name = i > 0 && (std::isalnum(static_cast<unsigned char>(text[i - 1])) || text[i - 1] == '_');
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", i), text.size());
    if (!in_name) found.push_back({i, end - i});
    i = end;
  }
  return found;
}

/// Positions of texts between quotes.
std::vector<Span> quoted_in(const std::string& text) {
  std::vector<Span> found;
  for (std::size_t i = text.find('"'); i != std::string::npos; i = text.find('"', i + 1)) {
    const std::size_t end = text.find('"', i + 1);
    if (end == std::string::npos) break;
    found.push_back({i, end + 1 - i});
    i = end;
  }
  return found;
}

std::string scaled(const std::string& number, double factor) {
  return std::to_string(std::strtod(number.c_str(), nullptr) * factor);
}

void change_number(Lines& lines, Random& random) {
  std::string& line = lines[below(lines.size(), random)];
  const auto places = numbers_in(line);
  if (places.empty()) return;
  const auto [from, size] = any(places, random);
  static constexpr std::array ends{"0",    "-0",     "1",     "-1",    "2",      "0.5",    "1e-9",  "1e9", "1e-30",
                                   "1e30", "1e-300", "1e300", "1e308", "5e-324", "0.9999", "1e-15", "90",  "180",
                                   "360",  "45",     "1000",  "3",     "17",     "-0.001", "100",   "1e-4"};
  static constexpr std::array factors{-1.0, 0.1, 0.5, 0.9, 0.99, 1.001, 1.1, 2.0, 3.0, 10.0, 1e3, 1e-3};
  const std::string other =
      random() % 2 == 0 ? any(ends, random) : scaled(line.substr(from, size), any(factors, random));
  line.replace(from, size, other);
}

/// The value of a key from another project; of another key where no other has this one.
void change_value(Lines& lines, Random& random) {
  std::string& line = lines[below(lines.size(), random)];
  const std::string key = halves(line).first;
  if (key.empty()) return;
  const auto same = seeds().values.find(key);
  const bool by_key = same != seeds().values.end() && random() % 8 != 0;
  line = key + " = " + (by_key ? any(same->second, random) : halves(any(seeds().lines, random)).second);
}

/// A key of an inline table, or a word or quantity between quotes, in place of another one.
void change_word(Lines& lines, Random& random) {
  std::string& line = lines[below(lines.size(), random)];
  const std::string& other = any(seeds().lines, random);
  const auto here = quoted_in(line), there = quoted_in(other);
  if (here.empty() || there.empty()) return;
  const Span to = any(here, random), with = any(there, random);
  line.replace(to.from, to.size, other.substr(with.from, with.size));
}

/// Replacements of a value: a search, an expression of itself.
void change_form(Lines& lines, Random& random) {
  std::string& line = lines[below(lines.size(), random)];
  const auto places = quoted_in(line);
  if (places.empty()) return;
  const Span to = any(places, random);
  const std::string inner = line.substr(to.from + 1, to.size - 2);
  switch (random() % 5) {
    case 0:
      line.replace(to.from, to.size, "\"?\"");
      break;
    case 1:
      line.replace(to.from, to.size, "\"=" + inner + "\"");
      break;
    case 2:
      line.replace(to.from, to.size, "\"=" + inner + " - " + inner + "\"");
      break;
    case 3:
      line.replace(to.from, to.size, "\"=sqrt((" + inner + ")^2)*0.001\"");
      break;
    default:
      line.replace(to.from, to.size, "\"=-(" + inner + ")\"");
      break;
  }
}

/// An element of an inline table or list taken away, or put there twice.
void change_element(Lines& lines, Random& random) {
  std::string& line = lines[below(lines.size(), random)];
  std::vector<std::size_t> commas;
  for (std::size_t i = line.find(", "); i != std::string::npos; i = line.find(", ", i + 1)) commas.push_back(i);
  if (commas.empty()) return;
  const std::size_t from = any(commas, random);
  const std::size_t to = std::min(line.find_first_of(",}]", from + 1), line.size());
  if (random() % 2 == 0)
    line.erase(from, to - from);
  else
    line.insert(from, line.substr(from, to - from));
}

void change_lines(Lines& lines, Random& random) {
  const auto at = static_cast<std::ptrdiff_t>(below(lines.size(), random));
  switch (random() % 5) {
    case 0:
      lines.insert(lines.begin() + at, Lines(lines)[below(lines.size(), random)]);
      break;
    case 1:
    case 2:
      if (lines.size() > 2) lines.erase(lines.begin() + at);
      break;
    case 3:
      lines.insert(lines.begin() + at, any(seeds().lines, random));
      break;
    default:
      std::swap(lines[static_cast<std::size_t>(at)], lines[below(lines.size(), random)]);
      break;
  }
}

using Change = void (*)(Lines&, Random&);
constexpr std::array<Change, 10> changes{change_number, change_number, change_number,  change_value, change_value,
                                         change_word,   change_form,   change_element, change_lines, change_lines};

}  // namespace

std::string mutated(std::string text, Random& random) {
  if (text.find("calculator") == std::string::npos || random() % 32 == 0) text = any(seeds().projects, random);
  Lines lines = lines_of(text);
  const std::size_t count = random() % 4 == 0 ? 2 : 1;  // more than that is seldom read without a fault
  for (std::size_t i = 0; i < count && !lines.empty(); ++i) any(changes, random)(lines, random);
  return joined(lines);
}

std::string crossed(const std::string& a, const std::string& b, Random& random) {
  Lines lines = lines_of(a);
  const Lines others = lines_of(b);
  if (lines.empty() || others.empty()) return a;
  const std::size_t from = below(others.size(), random), to = from + below(others.size() - from, random);
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size(), random)),
               others.begin() + static_cast<std::ptrdiff_t>(from), others.begin() + static_cast<std::ptrdiff_t>(to));
  return joined(lines);
}

}  // namespace loadpath::fuzz
