#include "lib/draw/tikz/style.hpp"

#include "lib/draw/canvas/number.hpp"
#include "lib/draw/canvas/style.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <vector>

namespace loadpath::draw {
namespace {

constexpr std::string_view base_of_words = "text";

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(at), text.size());
    if (end > 0) parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

double number(std::string_view text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string points(double view_units) {
  std::string out;
  append_number(out, tikz_unit * view_units);
  return out + "bp";
}
std::string points(std::string_view view_units) { return points(number(view_units)); }

/// --ink: lpink
std::string name_of(const StyleColour& colour) { return "lp" + std::string(colour.variable.substr(2)); }
std::string name_of(const StyleRule& rule) { return std::string(rule.selector.substr(1)); }

/// The value of a declaration, empty if the rule has none of this name.
std::string_view declared(const StyleRule& rule, std::string_view name) {
  for (const std::string_view declaration : split(rule.rest, ';')) {
    const std::size_t colon = declaration.find(':');
    if (declaration.substr(0, colon) == name) return declaration.substr(colon + 1);
  }
  return {};
}

/// "7 4": on 5.25bp off 3bp
std::string dashes(std::string_view lengths) {
  std::string out;
  bool on = true;
  for (const std::string_view length : split(lengths, ' ')) {
    out += (out.empty() ? "" : " ") + std::string(on ? "on " : "off ") + points(length);
    on = !on;
  }
  return out;
}

std::string options_of(const StyleRule& rule) {
  std::string out;
  const auto add = [&](const std::string& key, const std::string& value) {
    if (!value.empty()) out += (out.empty() ? "" : ",") + key + "=" + value;
  };
  const auto length = [&](std::string_view name) {
    const std::string_view value = declared(rule, name);
    return value.empty() ? std::string() : points(value);
  };
  add("draw", rule.stroke != nullptr ? name_of(*rule.stroke) : std::string(declared(rule, "stroke")));
  add("fill", rule.fill != nullptr ? name_of(*rule.fill) : "");
  add("fill opacity", std::string(declared(rule, "fill-opacity")));
  add("line width", length("stroke-width"));
  add("dash pattern", dashes(declared(rule, "stroke-dasharray")));
  add("line join", std::string(declared(rule, "stroke-linejoin")));
  add("line cap", std::string(declared(rule, "stroke-linecap")));
  return out;
}

/// "12px", or the first word of "13px 'Helvetica Neue',...".
std::string size_of(const StyleRule& rule) {
  std::string_view size = declared(rule, "font-size");
  if (size.empty()) size = declared(rule, "font");
  if (size.find("px") == std::string_view::npos) return {};
  const double height = number(size);
  constexpr double leading = 1.2;
  return "font=\\sffamily\\fontsize{" + points(height) + "}{" + points(leading * height) + "}\\selectfont";
}

std::string options_of_words(const StyleRule& rule) {
  std::string out = rule.fill != nullptr ? "text=" + name_of(*rule.fill) : "";
  const std::string size = size_of(rule);
  return out + (out.empty() || size.empty() ? "" : ",") + size;
}

bool is_halo(const StyleRule& rule) { return !declared(rule, "paint-order").empty(); }
/// Whether a rule is for text only, or for the page itself, which remains unchanged.
bool is_of_no_element(const StyleRule& rule) {
  return rule.selector == ".page" || rule.selector == ".s" || rule.selector == ".u";
}

/// Whether a rule is for all text; rules after it may override it.
bool is_for_words(const StyleRule& rule) {
  const auto rules = style_rules();
  const auto base =
      std::find_if(rules.begin(), rules.end(), [](const StyleRule& r) { return r.selector == base_of_words; });
  return !is_halo(rule) && &rule > &*base;
}

std::string colours() {
  std::string out;
  std::set<std::string_view> seen;
  for (const StyleRule& rule : style_rules()) {
    for (const StyleColour* const colour : {rule.stroke, rule.fill}) {
      if (colour == nullptr || !seen.insert(colour->variable).second) continue;
      std::string digits(colour->fallback.substr(1));
      for (char& c : digits) c = c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
      out += "\\definecolor{" + name_of(*colour) + "}{HTML}{" + digits + "}\n";
    }
  }
  return out;
}

std::string line(const std::string& style, const std::string& options) {
  return options.empty() ? "" : "  " + style + "/.style={" + options + "},\n";
}

/// Letters are drawn twice: their outlines in the colour of the paper, and they themselves.
std::string halo(const StyleRule& rule) {
  std::string width;
  append_number(width, tikz_unit * number(declared(rule, "stroke-width")));
  return "\\makeatletter\n\\newcommand{\\lphalo}[1]{\\leavevmode\\rlap{\\pgfsys@invoke{q 1 1 1 RG " + width +
         " w 1 j 1 Tr}\\rlap{#1}\\pgfsys@invoke{0 Tr Q}}#1}\n\\makeatother\n";
}

template <class Use>
void for_each_class(std::string_view classes, const Use& use) {
  const auto wanted = split(classes, ' ');
  for (const StyleRule& rule : style_rules()) {
    for (const std::string_view name : wanted) {
      if (rule.selector.substr(1) == name) use(rule);
    }
  }
}

}  // namespace

std::string tikz_styles() {
  std::string out = colours(), halos, of_words;
  out += "\\tikzset{\n";
  out +=
      line("lp picture", "x=" + points(1.0) + ",y=-" + points(1.0) + ",line width=" + points(1.0) + ",miter limit=4");
  for (const StyleRule& rule : style_rules()) {
    if (is_of_no_element(rule)) continue;
    if (rule.selector == base_of_words) {
      of_words += line("lp words", "inner sep=0pt,outer sep=0pt," + options_of_words(rule));
    } else if (is_halo(rule)) {
      halos += halo(rule);
    } else {
      out += line("lp " + name_of(rule), options_of(rule));
      if (is_for_words(rule)) of_words += line("lp words " + name_of(rule), options_of_words(rule));
    }
  }
  return out + of_words + "}\n" + halos;
}

std::string tikz_style(std::string_view classes) {
  std::string out;
  for_each_class(classes, [&](const StyleRule& rule) {
    if (!options_of(rule).empty()) out += (out.empty() ? "lp " : ",lp ") + name_of(rule);
  });
  return out;
}

std::string tikz_words(std::string_view classes) {
  std::string out = "lp words";
  for_each_class(classes, [&](const StyleRule& rule) {
    if (is_for_words(rule) && !options_of_words(rule).empty()) out += ",lp words " + name_of(rule);
  });
  return out;
}

bool has_halo(std::string_view classes) {
  bool found = false;
  for_each_class(classes, [&](const StyleRule& rule) { found = found || is_halo(rule); });
  return found;
}

}  // namespace loadpath::draw
