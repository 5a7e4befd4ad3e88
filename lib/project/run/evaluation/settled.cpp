#include "lib/project/run/evaluation/settled.hpp"

#include <bit>
#include <span>
#include <utility>

namespace loadpath::project {

namespace {

void add_state(std::span<const FieldInfo> fields, void* owner, RecordState& state) {
  for (const FieldInfo& field : fields) {
    if (field.get != nullptr) state.numbers.push_back(std::bit_cast<std::uint64_t>(field.get(owner)));
    if (field.series != nullptr) state.numbers.push_back(reinterpret_cast<std::uintptr_t>(field.series(owner)));
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

void SettledRecords::add(RecordState state, double from, double size) {
  last_[next_] = Settled{std::move(state), from, size};
  next_ = (next_ + 1) % last_.size();
}

std::optional<SettledRecords::Found> SettledRecords::find(const RecordState& state, double from) const {
  for (std::size_t i = 0; i < last_.size(); ++i) {
    const auto& one = last_[i];
    if (one && (one->from == from || one->size == from) && one->state == state)
      return Found{one->size, (i + 1) % last_.size() == next_};
  }
  return std::nullopt;
}

}  // namespace loadpath::project
