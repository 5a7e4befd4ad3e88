#include "lib/project/references/machine/repetitions.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace loadpath::project {

namespace {

constexpr const char* history = "sigma";  // of a step that counts its cycles, n_req times

const Operand* operand_of(const Step& step, const std::string& path) {
  const auto& whole = step.input().reading.whole;
  const auto found = std::ranges::find(whole, path, &Operand::path);
  return found != whole.end() ? &*found : step.input().reading.operand(path);
}

/// "force.csv", or the path of the series that it is computed from: "press.links.rod.N"; empty if it is typed.
std::string source_of_history(const Step& step) {
  const Operand* const operand = operand_of(step, history);
  if (operand != nullptr && !operand->expression.references().empty())
    return operand->expression.references().front().path;
  const auto typed = step.input().reading.typed.find(history);
  const bool is_file = typed != step.input().reading.typed.end() && !typed->second.part.empty();
  return is_file ? typed->second.text + ", " + typed->second.part : "";
}

/// Another step that counts the same history for a longer time.
void compare_histories(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const double own = own_value(step, project, "n_req");
  const std::string source = source_of_history(step);
  if (std::isnan(own) || source.empty()) return;
  for (const auto& other : project.steps) {
    if (other.get() == &step || other->input().calculator != step.input().calculator) continue;
    const double there = own_value(*other, project, "n_req");
    if (source_of_history(*other) != source || !(own < 0.99 * there)) continue;
    found.push_back(
        {"n_req", say("n_req = {1}, and '{2}' counts the same history {3} times; justify it: because.n_req = "
                      "\"...\"",
                      format_number(own, 6), other->name(), format_number(there, 6))});
    return;
  }
}

/// The history of one turn of a machine comes more than a few times.
void compare_turns(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double least = 1e3;
  const double own = own_value(step, project, "n_req");
  const std::string source = source_of_history(step);
  NotedReads::note(source);
  const Value* const series = project.value(source);
  if (!(own < least) || series == nullptr || !series->is_series() || !series->signature.axis->cyclic()) return;
  found.push_back({"n_req", say("n_req = {1}, and the history is one cycle of '{2}': give the cycles of its life, or "
                                "because.n_req = \"...\"",
                                format_number(own, 6), series->signature.axis->step)});
}

/// Blocks that all turn slower than the shaft which the bearing sits on.
void compare_blocks(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  double fastest = std::nan("");
  bool is_as_shaft = false;  // a block without a speed of its own
  for_each_leaf(step.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
    if (!path.starts_with("blocks") || !path.ends_with(".n") || !leaf.field->is_number()) return;
    const double n = own_value(step, project, path);
    is_as_shaft = is_as_shaft || std::isnan(n);
    fastest = std::fmax(fastest, std::abs(n));
  });
  if (is_as_shaft || std::isnan(fastest)) return;
  for (const Taken& record : step.input().reading.records) {
    const std::string shaft = split_step(record.source).first;
    const double n = std::abs(magnitude_at(project, shaft + ".n"));
    if (!(fastest < 0.99 * n)) continue;
    found.push_back({"blocks", say("all blocks are slower than '{1}' ({2}), the fastest has {3}; justify it: "
                                   "because.blocks = \"...\"",
                                   shaft, format_quantity(n, "rpm", 4), format_quantity(fastest, "rpm", 4))});
    return;
  }
}

}  // namespace

std::vector<ReducedLoad> repetitions_of_others(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  compare_histories(step, project, found);
  compare_turns(step, project, found);
  compare_blocks(step, project, found);
  return found;
}

}  // namespace loadpath::project
