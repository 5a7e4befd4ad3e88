#include "calculators/column/lightest/lightest.hpp"

#include "calculators/column/lightest/parts.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <utility>

namespace loadpath::column {

namespace {

using Candidate = Lightest::Candidate;
using Failure = Lightest::Failure;
using Input = Lightest::Input;
using Result = Lightest::Result;

/// The effective lengths are the same for every section: the bar with its factors in place of ends and supports.
Input with_factors(Input in, const MemberResult& r) {
  in.ends_y = in.ends_z = Ends::unsaid;
  in.supports_y.clear(), in.supports_z.clear();
  in.beta_y = r.axes[0].beta, in.beta_z = r.axes[1].beta;
  return in;
}

Candidate candidate_of(const TableSection& section, const Buckling::Input& bar, const MemberResult& r) {
  Candidate c{section.name(), section.m, r.axis, r.lambda, r.sigma_cr, r.P_all, r.u};
  c.demand = demand_of(r), c.failure = failure_of(bar, r);
  return c;
}

/// Whether a section is nearer to passing: those that the method judges come before the others.
bool nearer(const Candidate& a, const Candidate& b) {
  const auto rank = [](const Candidate& c) {
    const bool unjudged = c.failure == Failure::open || c.failure == Failure::beyond || c.failure == Failure::strength;
    return std::pair(unjudged, c.demand);
  };
  return rank(a) < rank(b);
}

/// Data of all sections: the best one, and the lists.
struct Search {
  const TableSection* best = nullptr;  // the first that carries the bar, else the one nearest to passing
  Candidate nearest;
};

void take(const TableSection& section, const Candidate& c, Search& search, Result& r) {
  if (c.failure == Failure::none) {
    if (r.carrying == 0.0) search.best = &section;
    r.carrying += 1.0;
    if (r.candidates.size() < Lightest::Candidates::capacity()) r.candidates.push_back(c);
    return;
  }
  if (r.carrying > 0.0) return;
  if (search.best == nullptr || nearer(c, search.nearest)) search.best = &section, search.nearest = c;
  if (r.lighter.size() == Lightest::Candidates::capacity()) r.lighter.pop_back();
  r.lighter.insert(r.lighter.begin(), c);
}

Search search_for(const Input& in, Result& r) {
  NoTrace quiet;
  Search search;
  Input member = in;
  for (const TableSection& section : sections_by_mass()) {
    if (!belongs(section, in)) continue;
    const Buckling::Input bar = bar_of(member, section);
    const MemberResult found = Buckling::evaluate(bar, quiet);
    if (r.sections == 0.0) member = with_factors(in, found);
    r.sections += 1.0;
    take(section, candidate_of(section, bar, found), search, r);
  }
  for (auto* list : {&r.candidates, &r.lighter}) {
    for (Candidate& c : *list) c.excess = c.q / search.best->m - 1.0;
  }
  return search;
}

/// The values of the row that the calculation continues with.
template <class Tracer>
void show(const Input& in, const TableSection& section, Tracer& trace) {
  trace.value("q", section.m, "of the section found");
  trace.value("A", section.A, "of the section found");
  trace.value("I_y", section.I_y, "of the section found");
  trace.value("I_z", section.I_z, "of the section found");
  if (section.I_min < section.I_z) trace.value("I_min", section.I_min, "of the section found");
  if (!in.strengths.empty()) trace.value("R_e", strength_of(in, section.t_f), "at its thickness");
}

figure::Plot forces_over_mass(const Input& in, const Result& r) {
  constexpr double reach = 2.5;  // masses of the section found
  NoTrace quiet;
  const Input member = with_factors(in, r);
  figure::Plot plot;
  plot.x = {"q", "mass per length", kg_per_m.symbol};
  plot.y = {"P_all", "allowable force", kN.symbol};
  for (const auto& f : in.families) {
    figure::Curve& curve = plot.curves.emplace_back();
    curve.label = f.family.view();
    for (const TableSection& section : sections_by_mass()) {
      if (!begins_with(section.name(), f.family.view()) || !belongs(section, in)) continue;
      if (section.m > reach * r.q) break;
      curve.x.push_back(in_si(section.m));
      curve.y.push_back(in_si(Buckling::evaluate(bar_of(member, section), quiet).P_all));
    }
  }
  if (is_set(r.P_all)) plot.marks.push_back({in_si(r.q), in_si(r.P_all), std::string(r.section.view())});
  if (is_set(r.F)) plot.bounds.push_back({in_si(r.F), "F"});
  return plot;
}

}  // namespace

template <class Tracer>
Result Lightest::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const TableSection* const best = search_for(in, r).best;
  trace.value("sections", r.sections, "sections of the families within the size limits");
  trace.value("carrying", r.carrying, "of them carry the bar");
  if (best == nullptr) return r;
  show(in, *best, trace);
  static_cast<MemberResult&>(r) = Buckling::evaluate(bar_of(in, *best), trace);
  r.section = best->name();
  const auto q = r.q = best->m;
  STEP_TO(r, mass, q * in.l, "mass of the bar");
  if (r.u > 1.0) {
    STEP_TO(r, lack, 1.0 - r.P_all / r.F, "part of the force that even the strongest does not carry");
  }
  return r;
}

template Result Lightest::evaluate(const Input&, NoTrace&);
template Result Lightest::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Lightest::figures(const Input& in, const Result& r) {
  const auto& all = sections_by_mass();
  const auto best = std::find_if(all.begin(), all.end(), [&](const TableSection& s) { return r.section == s.name(); });
  if (best == all.end()) return {};
  std::vector<figure::Figure> figures{
      {"allowable-force", "Allowable force over mass, local buckling and slenderness aside", forces_over_mass(in, r)}};
  for (figure::Figure& figure : Buckling::figures(bar_of(in, *best), r)) figures.push_back(std::move(figure));
  return figures;
}

}  // namespace loadpath::column

template const loadpath::Calculator& loadpath::erased<loadpath::column::Lightest>();
