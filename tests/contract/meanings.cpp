// Meanings of fields, beyond their dimension: defined for existing fields, at existing words of their choices.
#include "calculators/column/member/length_factor.hpp"
#include "calculators/gear/rated_mesh.hpp"
#include "calculators/load/limit_meanings.hpp"
#include "calculators/vessel/wall.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "tests/contract/calculators.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace {

using namespace loadpath;

bool has_word(const Calculator& c, const std::string& choice, const std::string& word) {
  const FieldInfo* const field = find_field(c.input->fields, choice);
  return field != nullptr && std::any_of(field->choices.begin(), field->choices.end(),
                                         [&](const auto& known) { return word == known.key; });
}

/// "bending/cast-aluminium" of the choices "loading, group": a word of each, in their order.
bool has_words(const Calculator& c, const char* choices, const std::string& words) {
  std::size_t at = 0;
  for (const std::string& choice : listed_keys(choices)) {
    if (at > words.size()) return false;
    const std::size_t end = std::min(words.find('/', at), words.size());
    if (!has_word(c, choice, words.substr(at, end - at))) return false;
    at = end + 1;
  }
  return at == words.size() + 1;
}

/// "tau_adm", or "segments.tau_adm" of the elements of a list.
bool has_field(std::span<const FieldInfo> fields, const std::string& key) {
  const std::size_t dot = key.find('.');
  const FieldInfo* const field = find_field(fields, key.substr(0, dot));
  if (field == nullptr || dot == std::string::npos) return field != nullptr;
  return find_field(field->fields, key.substr(dot + 1)) != nullptr;
}

/// Meanings that one calculator has: a value of another meaning is refused, or the steps of the project are compared.
bool is_of_one(const std::string& what) {
  return what == fatigue::notch_in_bending || what == fatigue::notch_in_torsion || what == speed_of_run ||
         what == moment_of_motor || what == inertia_of_flywheel || what == gear::flanks_ground ||
         what == gear::flanks_not_ground || what == vessel::radius_when_open || what == column::factor_of_higher_mode;
}

}  // namespace

TEST_SUITE("contract" * test::by_element) {
  TEST_CASE("bounds and notches refer to fields that exist") {
    for (const Calculator* c : test::calculators_taken()) {
      for (std::size_t i = 0; i < c->bounds.size(); ++i) {
        INFO(std::string(c->id), " ", std::string(c->bounds[i].field));
        CHECK(has_field(c->input->fields, c->bounds[i].field));
      }
      for (const NotchClaim& claim : c->notches) {
        for (const std::string& key : listed_keys(claim.fields))
          CHECK_MESSAGE((c->result != nullptr && has_field(c->result->fields, key)), key);
        CHECK(has_field(c->result->fields, claim.factor));
        if (*claim.shape != '\0') CHECK(has_field(c->input->fields, claim.shape));
      }
    }
  }

  TEST_CASE("a meaning refers to fields and words that exist, and each is given or taken by two") {
    for (const Calculator* c : test::calculators_taken()) {
      for (const Meaning& meaning : c->meanings) {
        INFO(std::string(c->id), " ", std::string(meaning.fields), ": ", std::string(meaning.what));
        for (const std::string& key : listed_keys(meaning.fields)) {
          const bool known =
              has_field(c->input->fields, key) || (c->result != nullptr && has_field(c->result->fields, key));
          CHECK_MESSAGE(known, key);
        }
        CHECK((*meaning.choice == '\0') == listed_keys(meaning.words).empty());
        for (const std::string& word : listed_keys(meaning.words))
          CHECK_MESSAGE(has_words(*c, meaning.choice, word), word);
        if (strength_bound_of(meaning.what) != nullptr) continue;  // held against a material
        if (is_of_one(meaning.what)) continue;
        CHECK(std::any_of(calculators().begin(), calculators().end(), [&](const Calculator* other) {
          return other != c && std::any_of(other->meanings.begin(), other->meanings.end(),
                                           [&](const Meaning& m) { return std::string(m.what) == meaning.what; });
        }));
      }
    }
  }
}
