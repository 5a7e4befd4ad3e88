#include "lib/project/order.hpp"

#include "lib/project/references.hpp"

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
    for (std::size_t i = 0; i < state_.size(); ++i) visit(i);
    project_.order = std::move(order_);
  }

 private:
  enum class State { fresh, open, done, in_cycle };

  std::size_t index_of(std::string_view name) const {
    const auto found =
        std::find_if(project_.steps.begin(), project_.steps.end(), [&](const auto& s) { return s->name() == name; });
    return static_cast<std::size_t>(found - project_.steps.begin());
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
    std::string members;
    for (auto i = std::find(path_.begin(), path_.end(), first); i != path_.end(); ++i)
      members += project_.steps[*i]->name() + " -> ";
    const std::string& name = project_.steps[first]->name();
    issues_.push_back({project_.steps[first]->input().place, name,
                       say("the steps refer to one another in a circle: {1}", members + name),
                       say("give one of them a value"), Severity::error});
    return false;
  }

  Project& project_;
  std::vector<Issue>& issues_;
  std::vector<State> state_;
  std::vector<std::vector<Edge>> edges_;
  std::vector<std::size_t> path_;
  std::vector<std::size_t> order_;
};

}  // namespace

void put_in_order(Project& project, std::vector<Issue>& issues) { Ordering(project, issues).run(); }

namespace {

constexpr int deepest = 32;  // inputs that refer to one another

std::optional<Value> value_of_input(const Project& project, const std::string& path, int depth) {
  const auto [name, rest] = split_step(path);
  const Step* const step = project.find(name);
  if (step == nullptr) {
    const Value* const shared = name == "values" ? project.values.fixed(rest) : nullptr;
    return shared == nullptr ? std::nullopt : std::optional(*shared);
  }
  if (depth == deepest) return std::nullopt;
  return step->value_beforehand(rest, depth > 0,
                                [&](const std::string& other) { return value_of_input(project, other, depth + 1); });
}

}  // namespace

std::optional<Value> value_beforehand(const Project& project, const std::string& path) {
  return value_of_input(project, path, 0);
}

}  // namespace loadpath::project
