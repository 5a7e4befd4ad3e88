// Inputs that nobody typed but that have a source: a row of a table, or what comes along with another input.
#pragma once

#include "lib/project/step.hpp"

namespace loadpath::project {

/// One such input of a step.
struct Provided {
  std::string path;
  Leaf leaf;
  std::string row;                      // table: the row's name, "C45E"
  std::vector<std::string> companions;  // companion: full paths of what comes along
};

/// What a table says.
struct Lookup {
  double si = 0.0;  // NaN: not available, with the reason
  std::vector<std::string> sources;
  bool recalled = false;
  Message reason;
};

/// The inputs of a step that its providers fill. Rows that do not exist, or lack the column, become issues.
std::vector<Provided> find_provided(const StepInput& input, const Companions& companions, std::vector<Issue>& issues);

/// Fills the lists that take a row's values at all its sizes, and says by leaf where these come from.
std::map<std::string, Origin> fill_lists(const StepInput& input);

/// The value of a table's row, at a size where it depends on one; none where that is not known (NaN).
Lookup look_up(const Provided& provided, double size);

/// The values of a stock in SI, ascending: "R20", "R40", "shaft"...; empty where the stock is unknown.
std::vector<double> stock_values(const std::string& stock);
std::vector<std::string> stock_names();
/// The origin of a value that was taken from a stock: the stock's sources, or that one of its sizes is recalled.
Origin stock_origin(const std::string& stock, Message text);

}  // namespace loadpath::project
