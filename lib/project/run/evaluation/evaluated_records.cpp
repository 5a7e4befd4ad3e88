#include "lib/project/run/evaluation/evaluated_records.hpp"

#include <bit>
#include <functional>
#include <span>
#include <utility>

namespace loadpath::project {

namespace {

/// One step of FNV-1a, by whole numbers.
std::uint64_t mixed(std::uint64_t sum, std::uint64_t number) {
  constexpr std::uint64_t prime = 0x100000001b3;
  sum = (sum ^ number) * prime;
  return sum ^ (sum >> 29);
}

constexpr std::uint64_t basis = 0xcbf29ce484222325;

std::uint64_t checksum(const Value* series) {
  if (series == nullptr) return 0;
  const auto axis = reinterpret_cast<std::uintptr_t>(series->signature.axis);
  std::uint64_t sum = mixed(mixed(basis, series->si.size()), axis);
  for (const double si : series->si) sum = mixed(sum, std::bit_cast<std::uint64_t>(si));
  return sum;
}

void add_state(std::span<const FieldInfo> fields, void* owner, RecordState& state) {
  for (const FieldInfo& field : fields) {
    if (field.get != nullptr) state.numbers.push_back(std::bit_cast<std::uint64_t>(field.get(owner)));
    if (field.series != nullptr) state.numbers.push_back(checksum(field.series(owner)));
    if (field.text != nullptr) state.words.append(field.text(owner)).append("\n");
    if (!field.has_fields()) continue;
    const std::size_t count = field.size(owner);
    state.numbers.push_back(count);
    for (std::size_t i = 0; i < count; ++i) add_state(field.fields, field.element(owner, i), state);
  }
}

}  // namespace

RecordState state_of(const Record& record, const std::vector<Provided>& provided) {
  RecordState state;
  add_state(record.type->fields, record.data.get(), state);
  for (const Provided& one : provided) state.words.append(one.row).append("\n");
  return state;
}

std::size_t EvaluatedRecords::Hash::operator()(const RecordState& state) const {
  std::uint64_t sum = mixed(basis, std::hash<std::string>()(state.words));
  for (const std::uint64_t number : state.numbers) sum = mixed(sum, number);
  return sum;
}

void EvaluatedRecords::add(RecordState state, Record result) {
  if (known_.size() >= most) known_.clear();
  known_.insert_or_assign(std::move(state), std::move(result));
}

const Record* EvaluatedRecords::find(const RecordState& state) const {
  const auto found = known_.find(state);
  return found == known_.end() ? nullptr : &found->second;
}

}  // namespace loadpath::project
