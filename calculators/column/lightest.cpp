#include "calculators/column/lightest.hpp"

#include "calculators/column/families.hpp"
#include "lib/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath {

namespace {

using column::TableSection;
using Candidate = LightestColumn::Candidate;
using Failure = LightestColumn::Failure;
using Input = LightestColumn::Input;
using Result = LightestColumn::Result;

bool belongs(const TableSection& section, const Input& in) {
  const std::string_view own = column::family_of(section.name());
  const bool wanted = std::any_of(in.families.begin(), in.families.end(),
                                  [&](const LightestColumn::Family& f) { return f.family.view() == own; });
  return wanted && !(section.h > in.h_max) && !(section.b > in.b_max);
}

/// The input of column.buckling that the section stands for.
Buckling::Input bar_of(const Input& in, const TableSection& section) {
  Buckling::Input bar{in, section};
  if (bar.kind == column::Profile::unsaid) bar.kind = in.kind;
  return bar;
}

/// The effective lengths are the same for every section: the bar with its factors in place of ends and supports.
Input with_factors(Input in, const column::MemberResult& r) {
  in.ends_y = in.ends_z = column::Ends::unsaid;
  in.supports_y.clear(), in.supports_z.clear();
  in.beta_y = r.axes[0].beta, in.beta_z = r.axes[1].beta;
  return in;
}

double known(double x) { return std::isnan(x) ? 0.0 : x; }

bool out_of_range(const column::MemberResult& r) { return r.r_1 > 1.0 || r.r_0 > 1.0; }

/// The largest check or limit of column.buckling, each the more the worse and kept up to 1.
double demand_of(const column::MemberResult& r) {
  const double u = std::isnan(r.u) && !out_of_range(r) ? INFINITY : known(r.u);  // infinite: it has no buckling curve
  return std::max({u, known(r.r_lambda), known(r.r_1), known(r.r_0), known(r.r_class)});
}

Failure failure_of(const column::MemberResult& r) {
  if (r.u > 1.0) return Failure::load;
  if (out_of_range(r)) return Failure::range;
  if (r.r_lambda > 1.0) return Failure::slenderness;
  if (r.r_class > 1.0) return Failure::thin;
  return std::isnan(r.u) ? Failure::open : Failure::none;
}

Candidate candidate_of(const TableSection& section, const column::MemberResult& r) {
  Candidate c{section.name(), section.m, r.axis, r.lambda, r.sigma_cr, r.P_all, r.u};
  c.demand = demand_of(r), c.failure = failure_of(r);
  return c;
}

/// What is known of all sections: the best one, and the lists.
struct Search {
  const TableSection* best = nullptr;  // the first that carries the bar, else the one that lacks least
  double least = INFINITY;
  Length thickest = 0.0 * mm;  // of those up to the best one: heavier demands never lead to a thinner one
};

void take(const TableSection& section, const column::MemberResult& found, Search& search, Result& r) {
  const Candidate c = candidate_of(section, found);
  if (r.carrying == 0.0 && section.t_f > search.thickest) search.thickest = section.t_f;
  if (c.failure == Failure::none) {
    if (r.carrying == 0.0) search.best = &section;
    r.carrying += 1.0;
    if (r.candidates.size() < LightestColumn::Candidates::capacity()) r.candidates.push_back(c);
    return;
  }
  if (r.carrying > 0.0) return;
  if (search.best == nullptr || c.demand < search.least) search.best = &section, search.least = c.demand;
  if (r.lighter.size() == LightestColumn::Candidates::capacity()) r.lighter.pop_back();
  r.lighter.insert(r.lighter.begin(), c);
}

Search search_for(const Input& in, Result& r) {
  NoTrace quiet;
  Search search;
  Input member = in;
  for (const TableSection& section : column::sections_by_mass()) {
    if (!belongs(section, in)) continue;
    const column::MemberResult found = Buckling::evaluate(bar_of(member, section), quiet);
    if (r.sections == 0.0) member = with_factors(in, found);
    r.sections += 1.0;
    take(section, found, search, r);
  }
  for (auto* list : {&r.candidates, &r.lighter}) {
    for (Candidate& c : *list) c.excess = c.q / search.best->m - 1.0;
  }
  return search;
}

/// The values of the row that the calculation goes on with.
template <class Tracer>
void show(const TableSection& section, Tracer& trace) {
  trace.value("q", section.m, "of the section found");
  trace.value("A", section.A, "of the section found");
  trace.value("I_y", section.I_y, "of the section found");
  trace.value("I_z", section.I_z, "of the section found");
  if (section.I_min < section.I_z) trace.value("I_min", section.I_min, "of the section found");
}

std::string names_of(const LightestColumn::Families& families) {
  std::string names;
  for (const auto& f : families) names += (names.empty() ? "" : ", ") + std::string(f.family.view());
  return names;
}

/// The first family that the tables do not have; null where all are known.
const LightestColumn::Family* stranger(const Input& in) {
  const auto unknown = [](const LightestColumn::Family& f) {
    const auto& all = column::sections_by_mass();
    return std::none_of(all.begin(), all.end(),
                        [&](const TableSection& s) { return column::family_of(s.name()) == f.family.view(); });
  };
  const auto found = std::find_if(in.families.begin(), in.families.end(), unknown);
  return found == in.families.end() ? nullptr : &*found;
}

draw::Plot forces_over_mass(const Input& in, const Result& r) {
  constexpr double reach = 2.5;  // masses of the section found
  NoTrace quiet;
  const Input member = with_factors(in, r);
  draw::Plot plot;
  plot.x = {"q", "mass per length", kg_per_m.symbol};
  plot.y = {"P_all", "allowable force", kN.symbol};
  for (const auto& f : in.families) {
    draw::Curve& curve = plot.curves.emplace_back();
    curve.label = f.family.view();
    for (const TableSection& section : column::sections_by_mass()) {
      if (column::family_of(section.name()) != f.family.view() || !belongs(section, in)) continue;
      if (section.m > reach * r.q) break;
      curve.x.push_back(in_si(section.m));
      curve.y.push_back(in_si(Buckling::evaluate(bar_of(member, section), quiet).P_all));
    }
  }
  if (is_set(r.P_all)) plot.marks.push_back({in_si(r.q), in_si(r.P_all), std::string(r.section.view())});
  if (is_set(r.F)) plot.bounds.push_back({in_si(r.F), "F"});
  return plot;
}

Message remedy_of(Failure failure) {
  if (failure == Failure::open) return say("give the kind of these sections: kind = \"hot_hollow\"");
  if (failure == Failure::range)
    return say("take a method that holds for stocky bars too: tetmajer, johnson, ec3, aisc");
  return {};
}

Result quick(const Input& in) {
  NoTrace quiet;
  return LightestColumn::evaluate(in, quiet);
}

}  // namespace

bool LightestColumn::families_known(const Input& in) { return stranger(in) == nullptr; }

FieldFault LightestColumn::unknown_family(const Input& in) {
  const Family* const unknown = stranger(in);
  const auto known = column::families();
  return {"families[" + std::to_string(unknown - &in.families[0] + 1) + "].family",
          say("there is no family '{1}' in the section tables", unknown->family.view()),
          did_you_mean(unknown->family.view(), known, there_is(known))};
}

/// Which sections have a buckling curve is told of each.
bool LightestColumn::needs_of_method(const Input& in) { return column::lack(in, true).empty(); }
FieldFault LightestColumn::missing_for_method(const Input& in) { return column::missing_for_method(in, true); }

bool LightestColumn::one_carries(const Input& in) { return quick(in).carrying > 0.0; }

FieldFault LightestColumn::none_carries(const Input& in) {
  const Result r = quick(in);
  const std::string names = names_of(in.families);
  if (r.sections == 0.0)
    return {"", say("there is room for no section of {1}", names), say("give more by h_max, b_max")};
  const Failure failure = failure_of(r);
  if (failure == Failure::load) {
    return {"",
            say("no section of {1} carries {2}; the strongest is {3}", names, format_quantity(in_si(r.F), kN.symbol),
                r.section.view()),
            say("name heavier families, or hold the bar better")};
  }
  return {"",
          say("no section of {1} carries the bar: {2} comes nearest, and there {3}", names, r.section.view(),
              choice_of(failure).doc),
          remedy_of(failure)};
}

template <class Tracer>
Result LightestColumn::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const auto [best, least, thickest] = search_for(in, r);
  trace.value("sections", r.sections, "sections of these families that there is room for");
  trace.value("carrying", r.carrying, "of them carry the bar");
  if (best == nullptr) return r;
  show(*best, trace);
  static_cast<column::MemberResult&>(r) = Buckling::evaluate(bar_of(in, *best), trace);
  r.section = best->name();
  r.t = thickest;
  const auto q = r.q = best->m;
  const auto l = in.l;
  STEP(mass, q * l, "mass of the bar");
  r.mass = mass;
  if (r.u > 1.0) {
    const auto F = r.F, P_all = r.P_all;
    STEP(lack, 1.0 - P_all / F, "part of the force that even the strongest does not carry");
    r.lack = lack;
  }
  return r;
}

template Result LightestColumn::evaluate(const Input&, NoTrace&);
template Result LightestColumn::evaluate(const Input&, Trace&);

std::vector<draw::Figure> LightestColumn::figures(const Input& in, const Result& r) {
  const auto& all = column::sections_by_mass();
  const auto best = std::find_if(all.begin(), all.end(), [&](const TableSection& s) { return r.section == s.name(); });
  if (best == all.end()) return {};
  std::vector<draw::Figure> figures{
      {"allowable-force", "Allowable force over mass, local buckling and slenderness aside", forces_over_mass(in, r)}};
  for (draw::Figure& figure : Buckling::figures(bar_of(in, *best), r)) figures.push_back(std::move(figure));
  return figures;
}

template const Calculator& erased<LightestColumn>();

}  // namespace loadpath
