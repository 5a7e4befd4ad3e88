#include "lib/draw/canvas/style.hpp"

namespace loadpath::draw {
namespace {

namespace colour {
constexpr StyleColour ink{"--ink", "#1b2530"}, muted{"--muted", "#56616d"}, grid{"--grid", "#dfe4ea"},
    paper{"--paper", "#ffffff"}, accent{"--accent", "#0b5fa5"}, accent2{"--accent2", "#b4451c"},
    accent3{"--accent3", "#2a7a48"};
}

constexpr std::string_view crisp = "stroke-width:1;shape-rendering:crispEdges;vector-effect:non-scaling-stroke";
constexpr StyleRule sheet[] = {
    {".page", nullptr, &colour::paper, ""},
    {".grid", &colour::grid, nullptr, crisp},
    {".axis", &colour::muted, nullptr, crisp},
    {".zero", &colour::ink, nullptr, crisp},
    {".bound", &colour::ink, nullptr, "stroke-width:1.3;stroke-dasharray:7 4"},
    {".curve", nullptr, nullptr, "stroke-width:1.9;stroke-linejoin:round;stroke-linecap:round"},
    {".d1", nullptr, nullptr, "stroke-dasharray:9 5"},
    {".d2", nullptr, nullptr, "stroke-dasharray:.1 4.5;stroke-width:2.4"},
    {".d3", nullptr, nullptr, "stroke-dasharray:11 4.5 .1 4.5"},
    {".area", nullptr, nullptr, "stroke:none;fill-opacity:.13"},
    {".thin", &colour::ink, nullptr, "stroke-width:1"},
    {".light", &colour::muted, nullptr, "stroke-width:1"},
    {".bar", &colour::ink, nullptr, "stroke-width:4;stroke-linecap:round;stroke-linejoin:round"},
    {".plate", &colour::ink, &colour::muted, "stroke-width:2.2;stroke-linejoin:round;fill-opacity:.16"},
    {".pin", &colour::ink, &colour::paper, "stroke-width:1.7;stroke-linejoin:round"},
    {".outline", &colour::ink, nullptr, "stroke-width:1.6;stroke-linejoin:round"},
    {".wheel", &colour::ink, &colour::muted, "stroke-width:1.6;fill-opacity:.06"},
    {".body", nullptr, &colour::muted, "fill-opacity:.1"},
    {".liquid", nullptr, &colour::accent, "fill-opacity:.13"},
    {".worn", nullptr, &colour::accent2, "fill-opacity:.2"},
    {".belt", &colour::accent, nullptr, "stroke-width:3;stroke-linejoin:round"},
    {".contact", &colour::accent2, nullptr, "stroke-width:3.4;stroke-linecap:round"},
    {".rail", &colour::ink, nullptr, "stroke-width:2.2;stroke-linecap:round"},
    {".dot", nullptr, &colour::muted, ""},
    {".image", &colour::muted, &colour::muted, "stroke-width:1;stroke-linejoin:round;fill-opacity:.08"},
    {".solid", nullptr, &colour::ink, ""},
    {".force", nullptr, nullptr, "stroke-width:2"},
    {".dash", nullptr, nullptr, "stroke-dasharray:5 3.5"},
    {".centre", &colour::muted, nullptr, "stroke-width:1;stroke-dasharray:14 3 2.5 3"},
    {".passing", &colour::accent, nullptr, "stroke-width:4.4;stroke-linecap:round"},
    {".failing", &colour::accent2, nullptr, "stroke-width:1.1"},
    {".ring", &colour::muted, nullptr, "stroke-width:5;stroke-linecap:round"},
    {".hole", &colour::paper, nullptr, "stroke-width:2.8;stroke-linecap:round"},
    {".front", &colour::ink, nullptr, "stroke-width:5.6;stroke-linecap:round"},
    {".hatch", &colour::accent2, nullptr, "stroke-width:.8"},
    {".speckle", &colour::muted, nullptr, "stroke-width:1.6;stroke-linecap:round"},
    {".level", &colour::accent, nullptr, "stroke-width:1.2;stroke-linejoin:round"},
    {".limit", &colour::ink, nullptr, "stroke-width:2;stroke-linejoin:round"},
    {".here", &colour::ink, nullptr, "stroke-width:2"},
    {"text", nullptr, &colour::ink, "font:13px 'Helvetica Neue',Arial,'Liberation Sans',sans-serif;stroke:none"},
    {".halo", &colour::paper, nullptr, "stroke-width:4;stroke-linejoin:round;paint-order:stroke"},
    {".quiet", nullptr, &colour::muted, "font-size:12px"},
    {".c0", &colour::accent, nullptr, ""},
    {".c1", &colour::accent2, nullptr, ""},
    {".c2", &colour::accent3, nullptr, ""},
    {".f0", nullptr, &colour::accent, ""},
    {".f1", nullptr, &colour::accent2, ""},
    {".f2", nullptr, &colour::accent3, ""},
    {".s", nullptr, nullptr,
     "font-family:'STIX Two Text',STIX,Cambria,'Times New Roman',serif;font-style:italic;font-size:1.14em"},
    {".u", nullptr, nullptr, "font-size:.74em"},
};

// `var` is in a second declaration, so that viewers without CSS variables keep the first.
void append_colour(std::string& out, std::string_view property, const StyleColour* given) {
  if (given == nullptr) return;
  for (const bool variable : {false, true}) {
    out.append(property).append(":");
    if (variable) out.append("var(").append(given->variable).append(",");
    out.append(given->fallback).append(variable ? ");" : ";");
  }
}

}  // namespace

std::span<const StyleRule> style_rules() { return sheet; }

std::string style_sheet() {
  std::string css;
  for (const StyleRule& rule : sheet) {
    css.append(".lp ").append(rule.selector).append("{");
    append_colour(css, "stroke", rule.stroke);
    append_colour(css, "fill", rule.fill);
    css.append(rule.rest).append("}");
  }
  return css;
}

}  // namespace loadpath::draw
