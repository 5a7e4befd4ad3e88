// The designs of a sweep: which of them hold, with which probability, and what governs those that fail.
#pragma once

#include "lib/project/sweep/statistics.hpp"
#include "lib/report/document.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::report {

/// "20 of 29 designs pass in all 200 samples; 4 fail in some, 5 in all"; "FAIL: 0 of 3 designs pass; 3 fail".
std::string count_of_designs(const project::SweepPlan& plan, const project::SweepStatistics& found);

/// At most `most` of them, those that always pass first.
Table design_table(const project::SweepPlan& plan, const project::SweepStatistics& found, std::size_t most);

/// The first of the designs that always pass, with its values; nothing if there is none.
std::optional<Paragraph> chosen_design(const project::SweepPlan& plan, const project::SweepStatistics& found);

/// The designs that no other beats in every objective, of those that satisfy the demands; with scatter at the quantile
/// of each objective.
Table front_of_designs(const project::SweepPlan& plan, const project::SweepStatistics& found);

/// "'strut passes', 'mass <= 5 kg'": the demands on a Pareto set.
std::string demands_in_words(const project::SweepStatistics& found);

/// Where no design satisfies all demands on a Pareto set: how many satisfy each.
std::optional<Paragraph> unmet_demands(const project::SweepStatistics& found);

/// What a sweep prints if no more is asked for.
std::vector<Block> sweep_answer(const project::Project& project, const project::SweepPlan& plan,
                                const project::SweepStatistics& found);

/// The point of the first design of this answer, of its Pareto set if it has one: with samples the worst of them.
/// Nothing if no point has a utilisation.
std::optional<std::uint64_t> point_of_answer(const project::SweepStatistics& found);

}  // namespace loadpath::report
