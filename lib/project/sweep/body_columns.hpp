// Bodies of several steps at many points at once: at each point the sizes and the facts of one body are compared, as
// after the solution of one design (lib/project/solving/bodies.hpp, body_facts.hpp).
#pragma once

#include "lib/project/solving/bodies.hpp"
#include "lib/project/solving/body_facts.hpp"
#include "lib/project/sweep/axes.hpp"
#include "lib/project/sweep/points/column_step.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::project {

/// The steps that the inputs affect, and those that look for a size of a body of which one of them has to look again.
/// Of a project that was solved at one point.
std::set<std::string> affected_with_bodies(const Project& project, const std::vector<SweptInput>& inputs);

using Bodies = std::vector<std::vector<Step*>>;
/// The bodies of affected steps, each in order of evaluation; none if a step between theirs takes from them.
Bodies separable_bodies(const Project& project, const std::set<std::string>& affected);
/// The body that a step is of; null if there is none.
const std::vector<Step*>* body_with(const Step& step, const Bodies& bodies);

class BodyColumns {
 public:
  /// Of a project that was solved at one point. False if its bodies have to be solved point by point.
  bool lay_out(const Project& project, const std::set<std::string>& affected);
  /// Full paths of the numbers that are compared.
  [[nodiscard]] const std::set<std::string>& paths() const { return paths_; }
  /// Takes the kernel of a step; false if it does not give the numbers that are compared, or cannot keep to a size.
  bool take(const Step& step, PointStep* kernel);

  /// Before the kernels solve a batch: every step is free in its size.
  void start();
  /// Behind the kernels: whether they must solve the batch again, since a body requires larger sizes at some points.
  bool require_sizes(PointColumns& points);
  /// In the end a point whose steps contradict one another is another's.
  void leave_contradicting(PointColumns& points);

 private:
  /// A number that is read at each point.
  struct Number {
    std::string path;
    Value value;
  };
  struct Size {
    const Step* step;
    std::string key;
    std::optional<Number> number;  // none: the same at every point
    double si;
    bool is_found;
    ColumnStep* kernel = nullptr;    // of one that is found
    std::vector<double> least = {};  // at each point, if the body requires more at one of them
  };
  /// The numbers of a statement that vary.
  struct Fact {
    std::optional<Number> input, result, factor;
    double same_factor;
  };
  struct Compared {
    BodyStatements stated;
    std::vector<Fact> facts;  // of each statement
  };
  /// What the other steps require of one where the project was solved.
  struct Kept {
    Step* step;
    std::map<std::string, BodySize> sizes;
    std::optional<BodyFacts> facts;
  };

  std::optional<Number> number(const Project& project, const Step& step, const std::string& key, bool is_result);
  bool add_sizes(const Project& project);
  bool add_facts(const Project& project);
  std::optional<Fact> fact_of(const Project& project, const std::string& name, const Statement& stated);
  static double read(std::optional<Number>& number, double same, std::size_t point, PointColumns& points);
  bool is_one_body(std::size_t point, PointColumns& points);

  const std::set<std::string>* affected_ = nullptr;  // while it is laid out
  bool is_sound_ = true;
  std::set<std::string> paths_, members_;
  std::vector<Kept> kept_;
  std::vector<std::vector<Size>> sizes_;
  std::vector<Compared> compared_;
};

}  // namespace loadpath::project
