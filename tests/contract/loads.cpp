// Loads travel with what acts beside them, and with the factors that they hold.
#include "tests/contract/calculators.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <string>

namespace {

using namespace loadpath;

using Visit = std::function<void(std::span<const FieldInfo> beside, const FieldInfo& field, const std::string& path)>;

void for_each_field(std::span<const FieldInfo> fields, const std::string& prefix, const Visit& visit) {
  for (const FieldInfo& field : fields) {
    const std::string path = prefix + field.key;
    visit(fields, field, path);
    if (field.has_fields()) for_each_field(field.fields, path + ".", visit);
  }
}

/// Whether a part with this calculator can be loaded by another.
bool takes_loads(const Calculator& c) {
  bool takes = false;
  for_each_field(c.input->fields, "",
                 [&](auto, const FieldInfo& f, const std::string&) { takes = takes || f.is_load; });
  return takes;
}

bool minds_the_rest(const Calculator& c) {
  return std::any_of(c.modes.begin(), c.modes.end(), [](const ModeInfo& m) { return m.by_rest; });
}

}  // namespace

TEST_SUITE("contract") {
  TEST_CASE("what acts beside a load, and the factors that it holds, are fields of its calculator") {
    for (const Calculator* c : test::plain_calculators()) {
      for_each_field(c->result->fields, "", [&](auto beside, const FieldInfo& f, const std::string& path) {
        for (const std::string& key : listed_keys(f.companions))
          CHECK_MESSAGE(find_field(beside, key) != nullptr, c->id, " ", path, " with ", key);
        for (const std::string& key : listed_keys(f.factors)) {
          const FieldInfo* const factor = find_field(c->input->fields, key);
          CHECK_MESSAGE((factor != nullptr && factor->is_factor), c->id, " ", path, " holds ", key);
          CHECK_MESSAGE((f.is_load || f.role == Role::result), c->id, " ", path);
        }
      });
    }
  }

  TEST_CASE("a calculator that is loaded minds what comes along with its loads, or takes no such part") {
    // Beside them: a whole machine, whose parts are judged by their own calculators; bodies of dynamics; a machine's
    // energy; a wall under pressure; the cycle of a stress.
    const std::vector<std::string> alone{"dynamics.", "machine.", "drive.train", "vessel.",  "motion.",
                                         "belt.",     "chain.",   "gear.",       "fatigue.", "mechanism."};
    for (const Calculator* c : calculators()) {
      const bool is_alone = std::any_of(alone.begin(), alone.end(),
                                        [&](const std::string& id) { return std::string_view(c->id).starts_with(id); });
      if (takes_loads(*c) && !is_alone) CHECK_MESSAGE(minds_the_rest(*c), c->id);
    }
  }
}
