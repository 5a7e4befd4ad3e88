// Any text is a project or is told what is wrong; what can be read can be solved and written, without a number that is
// none.
#include "lib/project/project.hpp"

#include "calculators/catalogue.hpp"
#include "lib/export/csv.hpp"
#include "lib/export/json.hpp"
#include "lib/report/build.hpp"

#include <cstdint>
#include <cstdlib>

using namespace loadpath;

namespace {

/// Long cycles are slow under the fuzzer and find nothing more.
bool is_quick(std::string_view text) { return text.size() < 4096 && text.find("positions") == std::string_view::npos; }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (!is_quick(text)) return -1;
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, "a.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues);
  render(issues, [&](const std::string&) { return text; });
  if (has_errors(issues)) return 0;
  if (exports::json_of(project, "fuzz").find(": nan") != std::string::npos) std::abort();
  exports::csv_of(project);
  const report::Document document = report::build(project, "fuzz");
  if (report::html(document).empty() || report::markdown(document, "a").text.empty()) std::abort();
  return 0;
}
