#include "lib/project/run/search/candidates.hpp"

#include "lib/account/rows.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::project {

Candidates candidates_of(const Evaluation& evaluation, const Search& wanted) {
  const table::Tables& tables = *evaluation.step().input().tables;
  Candidates all{wanted, evaluation.inputs().leaf(wanted.path), {}, {}};
  if (all.leaf) {
    all.sizes = stock_values(tables, wanted.stock);
    const FieldInfo& field = *all.leaf.field;  // typed, an unusual size would be warned of: none is found
    std::erase_if(all.sizes, [&](double size) { return !field.bounds.holds(size) || !field.plausible.holds(size); });
  } else {
    const auto rows = tables.ordered_rows(wanted.path, wanted.stock, wanted.where);  // its text has been checked
    for (const table::Entry& row : *rows) all.rows.push_back(row.row->name);
  }
  return all;
}

Message Candidates::name(std::size_t i) const {
  return leaf ? say("{1}", format_quantity(sizes[i], leaf.field->unit)) : say("{1}", rows[i]);
}

const std::string& Candidates::source() const { return wanted.stock.empty() ? wanted.path : wanted.stock; }

void Candidates::take(Inputs& inputs, std::size_t i) const {
  if (leaf) return leaf.set(sizes[i]);
  std::vector<Issue> lacks;
  inputs.take_row(wanted.path, rows[i], lacks);
}

void Candidates::keep_to_body(const BodySize& body) {
  std::erase_if(sizes, [&](double size) {
    const bool is_it = std::abs(size - body.si) <= 1e-9 * body.si;
    return body.is_given ? !is_it : size < account::least_candidate(body.si);
  });
}

void Candidates::leave_open(Inputs& inputs, Message why, std::vector<account::TriedSize> tried) const {
  if (leaf)
    inputs.leaf(wanted.path).set(std::nan(""));
  else
    inputs.clear_row(wanted.path);
  inputs.set_origin(wanted.path, {.text = std::move(why), .sources = {}, .searched = true, .tried = std::move(tried)});
}

}  // namespace loadpath::project
