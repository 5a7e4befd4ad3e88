#include "lib/project/references/order.hpp"

#include "lib/project/references/paths/circles.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/row_pairs.hpp"

#include <algorithm>
#include <set>

namespace loadpath::project {

namespace {

/// One step takes something of another.
struct Edge {
  std::size_t to;
  std::string path;
};

class Ordering {
 public:
  Ordering(Project& project, std::vector<Issue>& issues)
      : project_(project), issues_(issues), state_(project.steps.size(), State::fresh), edges_(project.steps.size()) {}

  void run() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      for_each_reference(project_.steps[i]->input().reading, [&](const std::string& path) {
        const std::size_t to = index_of(std::string_view(path).substr(0, path.find('.')));
        if (to < edges_.size()) edges_[i].push_back({to, path});
      });
    }
    take_beforehand();
    search_together();
    leave_open();
    put_behind_whole();
    for (std::size_t i = 0; i < state_.size(); ++i) visit(i);
    project_.order = std::move(order_);
    plan_passes();
  }

 private:
  enum class State { fresh, open, done, in_cycle };

  std::size_t index_of(std::string_view name) const {
    return project_.takers.find(name).value_or(project_.steps.size());
  }

  [[nodiscard]] bool reaches(std::size_t from, std::size_t to, std::set<std::size_t>& seen) const {
    if (from == to) return true;
    if (!seen.insert(from).second) return false;
    return std::any_of(edges_[from].begin(), edges_[from].end(),
                       [&](const Edge& edge) { return reaches(edge.to, to, seen); });
  }

  /// Edges to inputs that close a cycle, and need not.
  void take_beforehand() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      std::erase_if(edges_[i], [&](const Edge& edge) {
        std::set<std::size_t> seen;
        if (!reaches(edge.to, i, seen) || !value_beforehand(project_, edge.path)) return false;
        project_.beforehand[edge.path] = {};
        return true;
      });
    }
  }

  /// Edges between two steps whose rows are searched for together: the first of them needs all that both need.
  void search_together() {
    for (const RowPair& pair : row_pairs(project_)) {
      cut(pair.b, pair.a, pair.of_a);
      cut(pair.a, pair.b, pair.of_b);
      const std::vector<Edge> of_a = edges_[pair.a];
      for (const Edge& edge : edges_[pair.b]) {
        if (edge.to != pair.a) edges_[pair.a].push_back({edge.to, {}});
      }
      for (const Edge& edge : of_a) {
        if (edge.to != pair.b) edges_[pair.b].push_back({edge.to, {}});
      }
    }
  }

  void cut(std::size_t from, std::size_t to, const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
      const std::string path = project_.steps[to]->name() + "." + input;
      std::erase_if(edges_[from], [&](const Edge& edge) { return edge.to == to && edge.path == path; });
      project_.beforehand[path] = {};
    }
  }

  /// Operands of a step that it may do without, and that take an input of a step which needs this one.
  void leave_open() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      std::erase_if(edges_[i], [&](const Edge& edge) {
        std::set<std::size_t> seen;
        if (edge.to == i || !reaches(edge.to, i, seen)) return false;
        const std::string operand = waiting_operand(i, edge);
        if (operand.empty()) return false;
        waits_[i].push_back({edge.to, operand});
        return true;
      });
    }
  }

  /// Steps that use results of a waiting step, but do not block it, follow its complete solution.
  void put_behind_whole() {
    for (const auto& entry : waits_) {
      const std::size_t waiting = entry.first;
      for (std::size_t x = 0; x < edges_.size(); ++x) {
        const bool takes =
            std::any_of(edges_[x].begin(), edges_[x].end(), [&](const Edge& e) { return e.to == waiting; });
        for (const Edge& wait : entry.second) {
          std::set<std::size_t> seen;
          if (takes && x != wait.to && !reaches(wait.to, x, seen)) edges_[x].push_back({wait.to, {}});
        }
      }
    }
  }

  /// The input of a step that takes the path, where it can wait; empty if none can.
  [[nodiscard]] std::string waiting_operand(std::size_t i, const Edge& edge) const {
    const std::string rest = split_step(edge.path).second;
    const Step& source = *project_.steps[edge.to];
    const FieldInfo* const given = source.field(rest);
    const bool is_input = given != nullptr && given->role == Role::input && !given->is_load && !given->is_factor;
    if (!is_input || source.input().calculator->result == nullptr || project_.steps[i]->input().from != nullptr)
      return {};
    std::string found;
    for (const Operand& operand : project_.steps[i]->input().reading.operands) {
      const auto& references = operand.expression.references();
      if (std::none_of(references.begin(), references.end(), [&](const auto& r) { return r.path == edge.path; }))
        continue;
      if (!found.empty() || !operand.leaf.field->optional || references.size() != 1) return {};
      found = operand.path;
    }
    return is_taken(project_.steps[i]->name() + "." + found) ? std::string() : found;
  }

  [[nodiscard]] bool is_taken(const std::string& path) const {
    return std::any_of(edges_.begin(), edges_.end(), [&](const auto& edges) {
      return std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) { return edge.path == path; });
    });
  }

  /// A waiting step is solved without these inputs, and again once they are available.
  void plan_passes() {
    std::set<std::size_t> solved;
    std::vector<std::size_t> again;
    for (const std::size_t i : project_.order) {
      Pass pass{i, {}};
      for (const Edge& wait : waits_[i])
        if (!solved.contains(wait.to)) pass.without.insert(wait.path);
      if (!pass.without.empty()) again.push_back(i);
      solved.insert(i);
      project_.passes.push_back(std::move(pass));
      std::erase_if(again, [&](std::size_t other) {
        const bool ready = std::all_of(waits_[other].begin(), waits_[other].end(),
                                       [&](const Edge& wait) { return solved.contains(wait.to); });
        if (ready && other != i) project_.passes.push_back({other, {}});
        return ready && other != i;
      });
    }
  }

  bool visit(std::size_t i) {
    if (state_[i] == State::done || state_[i] == State::in_cycle) return state_[i] == State::done;
    if (state_[i] == State::open) return name_cycle(i);
    state_[i] = State::open;
    path_.push_back(i);
    bool sound = true;
    for (const Edge& edge : edges_[i])
      if (!visit(edge.to)) sound = false;
    path_.pop_back();
    state_[i] = sound ? State::done : State::in_cycle;
    if (sound) order_.push_back(i);
    return sound;
  }

  bool name_cycle(std::size_t first) {
    std::string members, ways;
    Message row;
    for (auto i = std::find(path_.begin(), path_.end(), first); i != path_.end(); ++i) {
      members += project_.steps[*i]->name() + " -> ";
      const std::size_t next = i + 1 == path_.end() ? first : *(i + 1);
      const auto edge = std::find_if(edges_[*i].begin(), edges_[*i].end(),
                                     [&](const Edge& e) { return e.to == next && !e.path.empty(); });
      if (edge == edges_[*i].end()) continue;
      ways += (ways.empty() ? "" : ", ") + how_taken(*project_.steps[*i], edge->path).text();
      if (row.empty()) row = row_to_name(*project_.steps[next], edge->path);
    }
    const std::string& name = project_.steps[first]->name();
    issues_.push_back(
        {project_.steps[first]->input().place, name, say("circular reference between steps: {1}", members + name),
         row.empty() ? say("{1}: write a value instead of one of these references", ways) : say("{1}; {2}", ways, row),
         Severity::error});
    return false;
  }

  Project& project_;
  std::vector<Issue>& issues_;
  std::vector<State> state_;
  std::vector<std::vector<Edge>> edges_;
  std::map<std::size_t, std::vector<Edge>> waits_;  // by operands, not by references
  std::vector<std::size_t> path_;
  std::vector<std::size_t> order_;
};

}  // namespace

void put_in_order(Project& project, std::vector<Issue>& issues) { Ordering(project, issues).run(); }

namespace {

constexpr int deepest = 32;  // inputs that refer to one another

/// Whether a step has the path, or may have it: results of a mechanism depend on its model.
bool may_have(const Project& project, const std::string& path) {
  const auto [name, rest] = split_step(path);
  const Step* const step = project.find(name);
  return step != nullptr && (step->input().calculator->result == nullptr || step->field(rest) != nullptr);
}

std::optional<Value> value_of_input(const Project& project, const std::string& path, int depth) {
  const auto [name, rest] = split_step(path);
  const Step* const step = project.find(name);
  if (step == nullptr) {
    const Value* const shared = name == "values" ? project.values.fixed(rest) : nullptr;
    return shared == nullptr ? std::nullopt : std::optional(*shared);
  }
  if (depth == deepest) return std::nullopt;
  const auto value = [&](const std::string& other) { return value_of_input(project, other, depth + 1); };
  return step->value_beforehand(rest, depth > 0,
                                {value, [&](const std::string& other) { return may_have(project, other); }});
}

}  // namespace

std::optional<Value> value_beforehand(const Project& project, const std::string& path) {
  return value_of_input(project, path, 0);
}

}  // namespace loadpath::project
