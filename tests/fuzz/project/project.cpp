// Any text is a project or has its errors reported; a readable project can be solved and written, at every position
// and with its full report, without NaN or infinity.
#include "lib/project/project.hpp"

#include "calculators/catalogue.hpp"
#include "lib/export/csv.hpp"
#include "lib/export/json.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/build/build.hpp"
#include "tests/fuzz/project/mutate.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace loadpath;

namespace {

constexpr std::size_t longest = 8192;
constexpr double most_positions = 100.0;

/// Long cycles are slow under the fuzzer and find nothing more.
bool is_quick(std::string_view text) {
  const std::string key = "positions = ";
  for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    if (std::strtod(std::string(text.substr(at + key.size(), 12)).c_str(), nullptr) > most_positions) return false;
  }
  return text.size() < longest;
}

bool stands_alone(std::string_view text, std::size_t at, std::size_t size) {
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[i])) || std::strchr("_/+", text[i]) != nullptr);
  };
  return (at == 0 || !is_letter(at - 1)) && !is_letter(at + size);
}

/// Whether it shows a value that is not a number, where the user typed none.
bool shows_no_number(std::string_view text, std::string_view project) {
  for (const std::string_view word : {"nan", "inf"}) {
    if (project.find(word) != std::string_view::npos) continue;
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      const bool said = text.substr(0, at).ends_with("may be ");  // the description of a field
      if (stands_alone(text, at, word.size()) && !said) return true;
    }
  }
  return false;
}

/// How many projects came as far as a report: said at the end.
struct Tally {
  long read = 0, reported = 0;
  Tally() = default;
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;
  ~Tally() { std::fprintf(stderr, "%ld projects, of which %ld were solved and reported\n", read, reported); }
};

void demand(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::abort();
}

std::size_t put(const std::string& text, std::uint8_t* data, std::size_t room) {
  const std::size_t size = std::min(text.size(), room);
  std::memcpy(data, text.data(), size);
  return size;
}

std::string text_of(const std::uint8_t* data, std::size_t size) { return {reinterpret_cast<const char*>(data), size}; }

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  fuzz::Random random(seed);
  return put(fuzz::mutated(text_of(data, size), random), data, room);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* a, std::size_t a_size, const std::uint8_t* b,
                                                 std::size_t b_size, std::uint8_t* out, std::size_t room,
                                                 unsigned seed) {
  fuzz::Random random(seed);
  return put(fuzz::crossed(text_of(a, a_size), text_of(b, b_size), random), out, room);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  if (!is_quick(text)) return -1;
  static Tally tally;
  ++tally.read;
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, "a.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues);
  const std::string told = render(issues, [&](const std::string&) { return text; });
  demand(issues.empty() == told.empty(), "every issue is told");
  if (has_errors(issues)) return 0;
  ++tally.reported;
  demand(!shows_no_number(exports::json_of(project, "fuzz"), text), "JSON holds numbers");
  for (const auto& [name, table] : exports::csv_of(project)) demand(!shows_no_number(table, text), "CSV holds numbers");
  const report::Document document = report::build(project, "fuzz");
  demand(!shows_no_number(report::html(document), text), "the report holds numbers");
  demand(!shows_no_number(report::markdown(document, "a").text, text), "the report in Markdown holds numbers");
  return 0;
}
