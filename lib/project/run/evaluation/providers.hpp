// Inputs that are not typed but have a source: a row of a table, or a component of another input's load.
#pragma once

#include "lib/project/step.hpp"
#include "lib/table/tables.hpp"

namespace loadpath::project {

/// One such input of a step.
struct Provided {
  std::string path;
  const FieldInfo* field;
  std::string row;                      // table: the row's name, "C45E"
  std::vector<std::string> companions;  // companion: full paths of the load components
  table::Entry entry = {};              // table: the row itself
};

/// The result of looking up a table.
struct Lookup {
  double si = 0.0;  // NaN: not available, with the reason
  Origin origin;
  Message reason;
};

/// Rows of tables by their groups; one without a text is not known yet.
using Rows = std::map<std::string, Typed>;

/// The inputs of a step that the rows fill. Rows that do not exist, or do not have the column, become issues.
std::vector<Provided> provided_by_rows(const StepInput& input, const Rows& rows, std::vector<Issue>& issues);
/// Whether a row has a value for the input.
bool gives(const table::Entry& row, const FieldInfo& field);
/// The inputs provided by load components of other inputs.
std::vector<Provided> provided_by_companions(const StepInput& input, const Companions& companions);

/// Fills the lists of a record that take a row's values at all its sizes, and returns their origins by leaf.
std::map<std::string, Origin> fill_lists(const StepInput& input, const Rows& rows, const Record& record);

/// Rounds after which a size that follows from values of rows at that size is given up.
constexpr int most_size_rounds = 20;

/// The value of a table's row, at a size where it depends on one; none if that is not known (NaN).
Lookup look_up(const Provided& provided, double size);

/// The values of a stock in SI, ascending: "R20", "R40", "shaft"...; empty if the stock is unknown.
std::vector<double> stock_values(const table::Tables& tables, const std::string& stock);
/// The origin of a value that was taken from a stock: the stock's sources, or that one of its sizes is recalled.
Origin stock_origin(const table::Tables& tables, const std::string& stock, Message text);
/// The origin of an input that an expression gives, with those of the tables that it names.
Origin expression_origin(const table::Tables& tables, const Operand& operand);

}  // namespace loadpath::project
