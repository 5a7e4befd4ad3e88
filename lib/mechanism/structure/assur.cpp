#include "lib/mechanism/structure/assur.hpp"

#include "lib/mechanism/structure/group_class.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

#include <algorithm>
#include <array>

namespace loadpath::mechanism {
namespace {

constexpr std::size_t freedoms_of_link = 3;  // degrees of freedom of a link in the plane
constexpr int nobody = -2;

/// One constraint equation and the links in it. `ground` if there is none.
struct Equation {
  std::array<int, 2> links;
  int holds = nobody;  // the link that it was given to
};

std::vector<Equation> equations_of(const Model& model) {
  std::vector<Equation> equations;
  for (const Joint& joint : model.joints) {
    for (int k = 0; k < constraint_count(joint.kind); ++k) equations.push_back({{joint.i, joint.j}});
  }
  for (const Driver& driver : model.drivers) {
    const bool rotary = driver.kind == Driver::Kind::rotary;
    const Joint* joint = rotary ? nullptr : &model.joints[static_cast<std::size_t>(driver.joint)];
    equations.push_back({{rotary ? driver.i : joint->i, rotary ? driver.j : joint->j}});
  }
  return equations;
}

/// Assigns to every link three equations that involve it, by augmenting paths.
class Assignment {
 public:
  Assignment(std::vector<Equation>& equations, std::size_t links)
      : equations_(equations), held_(links), visited_(links) {}

  void run() {
    for (std::size_t e = 0; e < equations_.size(); ++e) {
      std::fill(visited_.begin(), visited_.end(), false);
      place(e);
    }
  }

 private:
  bool place(std::size_t e) {
    for (const int link : equations_[e].links) {
      if (link == ground || visited_[static_cast<std::size_t>(link)]) continue;
      const auto k = static_cast<std::size_t>(link);
      visited_[k] = true;
      if (held_[k].size() < freedoms_of_link) {
        held_[k].push_back(e);
        equations_[e].holds = link;
        return true;
      }
      for (std::size_t& other : held_[k]) {
        if (!place(other)) continue;
        other = e;
        equations_[e].holds = link;
        return true;
      }
    }
    return false;
  }

  std::vector<Equation>& equations_;
  std::vector<std::vector<std::size_t>> held_;
  std::vector<bool> visited_;
};

/// The number of the group of each link, counted in order of attachment.
std::vector<std::size_t> attachment_of(const std::vector<Equation>& equations, std::size_t links) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> needs(links);
  for (const Equation& equation : equations) {
    for (const int link : equation.links) {
      if (link == ground || link == equation.holds || equation.holds == nobody) continue;
      boost::add_edge(static_cast<std::size_t>(equation.holds), static_cast<std::size_t>(link), needs);
    }
  }
  // Numbered as they are completed: required links come first.
  std::vector<std::size_t> component(links);
  boost::strong_components(needs,
                           boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, needs)));
  return component;
}

}  // namespace

std::vector<Group> groups(const Model& model) {
  std::vector<Equation> equations = equations_of(model);
  Assignment(equations, model.links.size()).run();
  const std::vector<std::size_t> component = attachment_of(equations, model.links.size());

  std::vector<Group> found(component.empty() ? 0 : 1 + *std::max_element(component.begin(), component.end()));
  for (std::size_t k = 0; k < component.size(); ++k) found[component[k]].links.push_back(k);
  const auto last_of = [&](int i, int j) -> Group& {
    const auto number = [&](int link) { return link == ground ? 0 : component[static_cast<std::size_t>(link)]; };
    return found[std::max(number(i), number(j))];
  };
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    Group& group = last_of(model.joints[k].i, model.joints[k].j);
    group.joints.push_back(k);
    group.p5 += constraint_count(model.joints[k].kind) / 2;  // a rigid joint counts as one of each
    group.p4 += constraint_count(model.joints[k].kind) % 2;
  }
  for (std::size_t k = 0; k < model.drivers.size(); ++k) {
    const Equation& equation = equations[equations.size() - model.drivers.size() + k];
    last_of(equation.links[0], equation.links[1]).drivers.push_back(k);
  }
  for (Group& group : found) classify(model, group);
  return found;
}

}  // namespace loadpath::mechanism
