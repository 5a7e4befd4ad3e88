#include "calculators/mechanism/results/results.hpp"

#include "calculators/mechanism/results/output.hpp"

#include <algorithm>

namespace loadpath::planar {

const Facts& Results::Line::facts() const { return output->what.facts; }

Kind Results::Line::kind() const { return facts().kind; }

Results::Results(const std::vector<Output>& outputs, const std::vector<account::Entry>& entries) {
  lines_.reserve(entries.size());
  for (std::size_t n = 0; n < entries.size(); ++n) lines_.push_back({&outputs[n], &entries[n]});
}

const account::Entry* Results::find(Kind kind, std::string_view name) const {
  const auto found = std::find_if(lines_.begin(), lines_.end(), [&](const Line& line) {
    return line.kind() == kind && (name.empty() || line.output->name == name);
  });
  return found == lines_.end() ? nullptr : found->entry;
}

}  // namespace loadpath::planar
