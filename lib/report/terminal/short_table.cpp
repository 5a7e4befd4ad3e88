#include "lib/report/terminal/short_table.hpp"

#include "lib/report/numbers/numbers.hpp"
#include "lib/report/terminal/words.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace loadpath::terminal {

namespace {

using report::Component;

constexpr std::size_t gap = 2, mark_width = 2;

/// Widths of the columns; without a width there is no such column.
struct Widths {
  std::size_t name = 0, size = 0, mode = 0, compared = 0, utilisation = 0;
  bool has_bar = true;
};

std::string compared_text(const Component& component) {
  if (!component.governing || !component.governing->compared) return {};
  const auto& both = *component.governing->compared;
  return report::short_pair(both.demand, both.capacity);
}

template <class Text>
std::size_t widest(std::span<const Component> components, std::size_t least, const Text& text) {
  for (const Component& component : components) least = std::max(least, text(component));
  return least;
}

std::size_t widest_size(const Component& component) {
  std::size_t most = 0;
  for (const std::string& size : component.sizes) most = std::max(most, length_of(size));
  return most;
}

Widths widths_of(std::span<const Component> components, const Look& look) {
  constexpr std::size_t with_bar = 16, without_bar = 11, wide = 100, usual = 43, enough = 22, most_name = 20,
                        most_size = 24, least_name = 12, least_size = 14;
  Widths w;
  w.name = std::min(most_name, widest(components, 9, [](const Component& c) { return length_of(c.name); }));
  w.size = std::min(most_size, widest(components, 4, widest_size));
  w.utilisation = with_bar;
  if (look.width >= wide)
    w.compared = widest(components, 17, [](const Component& c) { return length_of(compared_text(c)); });
  const auto rest = [&] {
    const std::size_t used =
        mark_width + w.name + gap + w.size + gap + (w.compared > 0 ? w.compared + gap : 0) + gap + w.utilisation;
    return look.width > used ? look.width - used : 0;
  };
  if (rest() < enough) w.has_bar = false, w.utilisation = without_bar;
  if (rest() < enough) w.size = std::min(w.size, least_size);
  if (rest() < enough) w.name = std::min(w.name, least_name);
  w.mode = std::min(usual, rest());
  return w;
}

std::string place_of(const account::Mode& mode) {
  const std::string location = report::location_of(mode);
  return location.empty() ? "" : ", " + location;
}

/// The title with its place, without it, without parentheses: the first that fits; else in lines.
std::vector<std::string> mode_lines(const Component& component, std::size_t width) {
  if (!component.governing) return {""};
  const std::string title = component.governing->title.text(), plain = report::plain_title(*component.governing);
  for (const std::string& text : {title + place_of(*component.governing), title, plain}) {
    if (length_of(text) <= width) return {text};
  }
  return lines_of(plain, width);
}

std::string utilisation_cell(const Component& component, const Widths& w, const Look& look) {
  constexpr double near = 0.9, limit = 1.0 + 1e-9;
  const double used = component.utilisation();
  if (std::isnan(used)) return component.fails() ? "fails" : "    -";
  std::string text = report::utilisation_text(used);
  if (w.has_bar) text += " " + bar(used, look);
  return used > limit ? in_colour(text, "31") : used > near ? in_colour(text, "33") : text;
}

std::string trimmed(std::string line) {
  line.resize(line.find_last_not_of(' ') + 1);
  return line;
}

std::string joined(const Widths& w, const std::string& name, const std::string& size, const std::string& mode,
                   const std::string& compared, const std::string& used) {
  const std::string space(gap, ' ');
  std::string line = padded(name, mark_width + w.name) + space + padded(size, w.size) + space + padded(mode, w.mode);
  if (w.compared > 0) line += space + padded(compared, w.compared);
  return trimmed(line + space + used);
}

void add_component(const Component& component, const Widths& w, const Look& look, std::vector<std::string>& lines) {
  const auto names = lines_of(component.name, w.name), modes = mode_lines(component, w.mode);
  std::vector<std::string> sizes;
  std::vector<bool> begins;  // where a size begins that a search has found
  for (const std::string& size : component.sizes) {
    for (const std::string& line : lines_of(size, w.size)) {
      begins.push_back(component.is_sized && line == lines_of(size, w.size).front());
      sizes.push_back(line);
    }
  }
  const std::size_t count = std::max({names.size(), modes.size(), sizes.size(), std::size_t{1}});
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [&](const std::vector<std::string>& all) { return i < all.size() ? all[i] : std::string(); };
    const std::string mark = i < begins.size() && begins[i] ? "* " : "  ";
    lines.push_back(joined(w, mark + at(names), at(sizes), at(modes), i == 0 ? compared_text(component) : "",
                           i == 0 ? utilisation_cell(component, w, look) : ""));
  }
}

}  // namespace

std::vector<std::string> component_lines(std::span<const Component> components, const Look& look) {
  if (components.empty()) return {};
  const Widths w = widths_of(components, look);
  const std::string mode = w.mode >= 22 ? "Governing failure mode" : w.mode >= 12 ? "Failure mode" : "Mode";
  std::vector<std::string> lines{joined(w, "  Component", "Size", mode, "Demand / capacity", "Utilisation")};
  for (const Component& component : components) add_component(component, w, look, lines);
  return lines;
}

std::vector<Component> most_telling(const std::vector<Component>& components, std::size_t most) {
  if (components.size() <= most) return components;
  std::vector<std::size_t> order(components.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) {
    const Component& c = components[i];
    const double used = std::isnan(c.utilisation()) ? -1.0 : c.utilisation();
    return c.fails() ? 1e9 + used : used;
  };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return rank(a) > rank(b); });
  order.resize(most);
  std::ranges::sort(order);
  std::vector<Component> shown;
  shown.reserve(order.size());
  for (const std::size_t i : order) shown.push_back(components[i]);
  return shown;
}

}  // namespace loadpath::terminal
