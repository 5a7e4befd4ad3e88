// Errors of outputs by tolerances of dimensions and masses and by the clearance of pins, over the cycle
// (lib/mechanism/accuracy/tolerance.hpp).
#include "calculators/mechanism/accuracy/checks.hpp"
#include "calculators/mechanism/accuracy/tolerances.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::planar {

namespace {

using account::Cell;
using account::Quantity;
using account::Table;
using mechanism::OutputError;
using mechanism::Status;

/// Errors of all requested outputs, in the order of the project.
struct Errors {
  std::vector<std::vector<mechanism::OutputError>> at;  // errors of each output, at every position; `shares` in the
                                                        // order of `names`
  std::vector<Message> names;                           // names of the tolerances, then of the pins with clearance
};

bool is_force(Watched of) { return of == Watched::drive || of == Watched::force; }

/// Whether the position has numbers at all; corners that do not close are reported with them.
bool is_known(const OutputError& error) {
  return error.status == Status::closed || error.status == Status::does_not_close;
}

double worst_of(const OutputError& error) { return is_known(error) ? error.worst() : none; }
double statistical_of(const OutputError& error) { return is_known(error) ? error.statistical() : none; }

struct Measure {
  const char* unit;
  Dimension dimension;
};
Measure measure_of(const Mechanism::Input& in, const planar::Accuracy& wanted) {
  switch (wanted.of) {
    case Watched::x:
    case Watched::y:
      return {mm.symbol, mm.dimension()};
    case Watched::angle:
      return {deg.symbol, deg.dimension()};
    case Watched::force:
      return {N.symbol, N.dimension()};
    case Watched::drive:
      break;
  }
  const bool turns = !in.crank.joint.empty() && (wanted.joint.empty() || wanted.joint == in.crank.joint);
  return turns ? Measure{N_m.symbol, N_m.dimension()} : Measure{N.symbol, N.dimension()};
}

constexpr const char *worst_path = "accuracy.NAME.worst", *statistical_path = "accuracy.NAME.statistical";
constexpr const char* worst_doc = "maximum error with all tolerances and clearances, worst case";
constexpr const char* statistical_doc = "error of three standard deviations, of independent dimensions";

template <class Read>
Output output_at(const Mechanism::Input& in, std::size_t index, const char* path, const char* doc, Read read) {
  const planar::Accuracy& wanted = in.accuracy[index];
  const Measure measure = measure_of(in, wanted);
  Output error = output({{path, measure.unit, doc, ""}, measure.dimension, {}}, text(wanted.name));
  error.read_cycle = [index, read](const Solved& solved) {
    std::vector<double> values;
    bool open = false;
    for (const OutputError& at : solved.found.of<Errors>().at[index]) {
      values.push_back(read(at));
      open = open || std::isnan(values.back());
    }
    return Output::Values(std::move(values),
                          open ? say("at some positions there is a dead point, a jam or no force") : Message{});
  };
  return error;
}

/// The output in words, as a table names it.
Message output_words(const planar::Accuracy& wanted) {
  switch (wanted.of) {
    case Watched::x:
      return say("{1}: position of {2} along x", wanted.name.view(), wanted.point.view());
    case Watched::y:
      return say("{1}: position of {2} along y", wanted.name.view(), wanted.point.view());
    case Watched::angle:
      return say("{1}: angle of {2}", wanted.name.view(), wanted.link.view());
    case Watched::force:
      return say("{1}: force of {2}", wanted.name.view(), wanted.joint.view());
    case Watched::drive:
      break;
  }
  return say("{1}: effort of the drive", wanted.name.view());
}

/// An extreme of an error over the positions.
struct Peak {
  double value = none, at = none;
  std::size_t position = 0;
};
template <class Read>
Peak peak_of(const std::vector<OutputError>& errors, const Axis* axis, Read read) {
  Value series{{{}, axis}, {}};
  for (const OutputError& error : errors) series.si.push_back(read(error));
  if (axis != nullptr && std::none_of(series.si.begin(), series.si.end(), [](double e) { return std::isnan(e); })) {
    const Extreme peak = maximum(series);
    return {peak.value, peak.at, peak.nearest};
  }
  Peak peak;  // where some positions have none, of the others
  for (std::size_t k = 0; k < series.si.size(); ++k) {
    if (!std::isnan(series.si[k]) && !(series.si[k] <= peak.value))
      peak = {series.si[k], axis == nullptr ? none : axis->at[k], k};
  }
  return peak;
}

std::size_t count_of(const std::vector<OutputError>& errors, bool (*is)(const OutputError&)) {
  return static_cast<std::size_t>(std::count_if(errors.begin(), errors.end(), is));
}

/// Method of the numbers.
Message method_of(const std::vector<OutputError>& errors) {
  const auto unknown = count_of(errors, [](const OutputError& e) { return !is_known(e); });
  const auto open = count_of(errors, [](const OutputError& e) { return e.status == Status::does_not_close; });
  const auto solved_again = count_of(errors, [](const OutputError& e) { return e.recomputed; });
  const auto warned = [&](std::string_view id, std::size_t count) {
    return say(id, std::to_string(count), std::to_string(errors.size()));
  };
  if (open > 0) return warned("some corners do not close, at {1} of {2} positions", open);
  if (unknown > 0) return warned("not available at {1} of {2} positions: dead point, jam or no forces", unknown);
  if (solved_again > 0) return warned("corners solved again, at {1} of {2} positions", solved_again);
  return say("derivatives; two corners solved again at each position");
}

/// The dimension with the largest share, and which part of the worst case that is.
Cell largest_part(const Errors& errors, const OutputError& error) {
  double most = 0.0, sum = 0.0;
  std::size_t which = errors.names.size();
  for (std::size_t k = 0; k < error.shares.size(); ++k) {
    const double part = std::abs(error.shares[k]);
    sum += part;
    if (numerics::exceeds(part, most)) most = part, which = k;
  }
  if (which == errors.names.size() || !(sum > 0.0)) return std::string("–");
  return say("{1}, {2} %", errors.names[which], std::to_string(std::lround(100.0 * most / sum)));
}

Table largest_table(const Mechanism::Input& in, const Errors& errors, const Axis* axis) {
  Table table{say("Errors due to tolerances and clearance"), {say("output"), say("worst case, ±")}, {}};
  if (axis != nullptr) table.head.push_back(say("at"));
  table.head.push_back(say("statistical, ± 3 standard deviations"));
  if (axis != nullptr) table.head.push_back(say("at"));
  table.head.insert(table.head.end(), {say("maximum contribution there"), say("how")});
  for (std::size_t n = 0; n < in.accuracy.size(); ++n) {
    const auto& at = errors.at[n];
    const Measure measure = measure_of(in, in.accuracy[n]);
    const Peak worst = peak_of(at, axis, worst_of), statistical = peak_of(at, axis, statistical_of);
    std::vector<Cell> row{output_words(in.accuracy[n]), Quantity{worst.value, measure.unit, 4}};
    if (axis != nullptr) row.push_back(Quantity{worst.at, axis->unit});
    row.push_back(Quantity{statistical.value, measure.unit, 4});
    if (axis != nullptr) row.push_back(Quantity{statistical.at, axis->unit});
    row.push_back(largest_part(errors, at[worst.position]));
    row.push_back(method_of(at));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Share by share, at each output's worst position.
Table parts_table(const Mechanism::Input& in, const Errors& errors, const Axis* axis) {
  constexpr std::size_t most_columns = 6;
  const std::size_t columns = std::min<std::size_t>(in.accuracy.size(), most_columns);
  Table table{say("Contribution of each tolerance and clearance at the worst case of the output"), {say("of")}, {}};
  std::vector<const OutputError*> at;
  for (std::size_t n = 0; n < columns; ++n) {
    table.head.push_back(say("{1}", in.accuracy[n].name.view()));
    at.push_back(&errors.at[n][peak_of(errors.at[n], axis, worst_of).position]);
  }
  for (std::size_t k = 0; k < errors.names.size(); ++k) {
    std::vector<Cell> row{errors.names[k]};
    for (std::size_t n = 0; n < columns; ++n) {
      const auto& shares = at[n]->shares;
      const bool acts = k < shares.size() && std::abs(shares[k]) > 1e-9 * at[n]->worst();
      row.push_back(acts ? Cell(Quantity{shares[k], measure_of(in, in.accuracy[n]).unit, 3}) : Cell(std::string("–")));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Empty without a request. Positions without forces have no error of forces.
Errors errors_of(const Mechanism::Input& in, const mechanism::Model& model, const Cycle& cycle) {
  Errors errors;
  if (in.accuracy.empty()) return errors;
  for (const planar::Tolerance& t : in.tolerances) errors.names.push_back(say("{1}", t.name.view()));
  const auto tolerances = tolerances_of(in, model);
  const auto clearances = clearances_of(in);
  for (const mechanism::Clearance& c : clearances)
    errors.names.push_back(say("clearance in {1}", model.joints[c.joint].name));
  mechanism::ToleranceAnalysis analysis(model);
  const bool statics = leaves_out_inertia(in);
  for (const planar::Accuracy& wanted : in.accuracy) {
    const mechanism::Output output = output_of(in, model, wanted);
    auto& at = errors.at.emplace_back(cycle.positions.size());
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (cycle.closed[k] && (cycle.has_forces(k) || !is_force(wanted.of)))
        at[k] = analysis.find(cycle.positions[k], cycle.drives[k], output, tolerances, clearances, statics);
      else
        at[k].status = Status::singular;
    }
  }
  return errors;
}

void find(const Solved& solved, Findings& found) { found.add(errors_of(solved.in, solved.model, solved.cycle)); }

void add(const Mechanism::Input& in, const mechanism::Model&, std::vector<Output>& out) {
  for (std::size_t n = 0; n < in.accuracy.size(); ++n) {
    out.push_back(output_at(in, n, worst_path, worst_doc, worst_of));
    out.push_back(output_at(in, n, statistical_path, statistical_doc, statistical_of));
  }
}

void list(std::vector<ResultPattern>& patterns) {
  struct Of {
    const char *unit, *where;
  };
  for (const Of& of : {Of{mm.symbol, "accuracy of x, y"}, Of{deg.symbol, "accuracy of an angle"},
                       Of{N_m.symbol, "accuracy of a crank's drive"}, Of{N.symbol, "accuracy of forces"}}) {
    patterns.push_back({worst_path, of.unit, worst_doc, of.where});
    patterns.push_back({statistical_path, of.unit, statistical_doc, of.where});
  }
}

/// List of the tolerances.
void show_input(const Mechanism::Input& in, std::vector<account::Block>& blocks) {
  if (in.accuracy.empty()) return;
  Table table{say("Tolerances and clearance"),
              {say("name"), say("what"), say("of"), say("half width, ±"), say("standard deviations")},
              {}};
  for (const planar::Tolerance& t : in.tolerances) {
    std::string of = text(!t.link.empty() ? t.link : !t.joint.empty() ? t.joint : t.spring);
    if (!t.point.empty()) of += ": " + text(t.point);
    if (!t.to.empty()) of += " – " + text(t.to);
    const HalfWidth half = half_width(t);
    table.rows.push_back(
        {text(t.name), say(choice_of(t.of).doc), of, Quantity{half.si, half.unit}, Quantity{t.sigmas, "-"}});
  }
  for (const planar::Joint& j : in.joints) {
    if (in_si(j.clearance) == 0.0) continue;
    table.rows.push_back({say("clearance in {1}", text(j.name)), say("half the diametral clearance, in any direction"),
                          text(j.name), Quantity{0.5 * in_si(j.clearance), "mm"}, Quantity{3.0, "-"}});
  }
  blocks.emplace_back(std::move(table));
}

/// The largest errors, where they are and what contributes to them.
void show(const Solved& solved, const Results&, std::vector<account::Block>& blocks) {
  const auto& errors = solved.found.of<Errors>();
  if (errors.at.empty()) return;
  blocks.emplace_back(largest_table(solved.in, errors, solved.axis));
  blocks.emplace_back(parts_table(solved.in, errors, solved.axis));
}

void check_closing(const Mechanism::Input& in, const mechanism::Model& model, const mechanism::Structure& structure,
                   std::vector<FieldFault>& faults) {
  if (structure.redundant.empty() || in.accuracy.empty()) return;
  faults.push_back(
      {"accuracy",
       say("errors are not covered with redundant constraints: with other dimensions the joints would not close"),
       say("leave out what repeats the others: {1}", names_of(model.joints, structure.redundant[0]))});
}

bool is_asked(const Mechanism::Input& in, const mechanism::Structure&) { return !in.accuracy.empty(); }
constexpr std::array cited{Citation{"NIST", &is_asked}, Citation{"Torkia", &is_asked}};

}  // namespace

constinit const Aspect aspects::accuracy{.check_names = &check_accuracy,
                                         .check_values = &check_half_widths,
                                         .check_structure = &check_closing,
                                         .list = &list,
                                         .add_outputs = &add,
                                         .find = &find,
                                         .show_input = &show_input,
                                         .show = &show,
                                         .citations = cited};

}  // namespace loadpath::planar
