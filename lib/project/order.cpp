#include "lib/project/order.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

class Ordering {
 public:
  Ordering(const Project& project, std::vector<Issue>& issues)
      : project_(project), issues_(issues), state_(project.steps.size(), State::fresh) {}

  std::vector<std::size_t> run() {
    for (std::size_t i = 0; i < state_.size(); ++i) visit(i);
    return std::move(order_);
  }

 private:
  enum class State { fresh, open, done, in_cycle };

  std::size_t index_of(std::string_view name) const {
    const auto found =
        std::find_if(project_.steps.begin(), project_.steps.end(), [&](const auto& s) { return s->name() == name; });
    return static_cast<std::size_t>(found - project_.steps.begin());
  }

  bool visit(std::size_t i) {
    if (state_[i] == State::done || state_[i] == State::in_cycle) return state_[i] == State::done;
    if (state_[i] == State::open) return name_cycle(i);
    state_[i] = State::open;
    path_.push_back(i);
    bool sound = true;
    for_each_reference(project_.steps[i]->input().reading, [&](const std::string& path) {
      const std::size_t other = index_of(std::string_view(path).substr(0, path.find('.')));
      if (other < state_.size() && !visit(other)) sound = false;
    });
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

  const Project& project_;
  std::vector<Issue>& issues_;
  std::vector<State> state_;
  std::vector<std::size_t> path_;
  std::vector<std::size_t> order_;
};

}  // namespace

std::vector<std::size_t> order_of_evaluation(const Project& project, std::vector<Issue>& issues) {
  return Ordering(project, issues).run();
}

}  // namespace loadpath::project
