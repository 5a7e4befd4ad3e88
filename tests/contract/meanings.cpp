// What fields are, beyond their dimension: said of fields that are there, at words that their choices have.
#include "tests/contract/calculators.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace {

using namespace loadpath;

bool has_word(const Calculator& c, const char* choice, const std::string& word) {
  const FieldInfo* const field = find_field(c.input->fields, choice);
  return field != nullptr && std::any_of(field->choices.begin(), field->choices.end(),
                                         [&](const auto& known) { return word == known.key; });
}

}  // namespace

TEST_SUITE("contract" * test::by_element) {
  TEST_CASE("a meaning is of fields and words that are there, and each is given or taken by two") {
    for (const Calculator* c : test::calculators_taken()) {
      for (const Meaning& meaning : c->meanings) {
        INFO(std::string(c->id), " ", std::string(meaning.fields), ": ", std::string(meaning.what));
        for (const std::string& key : listed_keys(meaning.fields)) {
          const bool known = find_field(c->input->fields, key) != nullptr ||
                             (c->result != nullptr && find_field(c->result->fields, key) != nullptr);
          CHECK_MESSAGE(known, key);
        }
        CHECK((*meaning.choice == '\0') == listed_keys(meaning.words).empty());
        for (const std::string& word : listed_keys(meaning.words))
          CHECK_MESSAGE(has_word(*c, meaning.choice, word), word);
        CHECK(std::any_of(calculators().begin(), calculators().end(), [&](const Calculator* other) {
          return other != c && std::any_of(other->meanings.begin(), other->meanings.end(),
                                           [&](const Meaning& m) { return std::string(m.what) == meaning.what; });
        }));
      }
    }
  }
}
