#include "cli/watch/page.hpp"

#include "lib/text/embedded.hpp"

#include <string_view>

namespace loadpath::cli {

namespace {

constexpr std::string_view before_any =
    "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
    "<meta name=\"color-scheme\" content=\"light dark\">\n<title>loadpath watch</title>\n<style></style>\n</head>\n"
    "<body>\n<main><p>The report comes once the project can be solved.</p></main>\n</body>\n</html>\n";

}  // namespace

std::string live_page(const Revision& revision) {
  std::string page = revision.page.empty() ? std::string(before_any) : revision.page;
  const std::string script = "<script id=\"live\" data-news=\"" + news_of(revision) + "\">\n" +
                             std::string(embedded::live()[0].text) + "</script>\n";
  return page.insert(page.rfind("</body>"), script);
}

std::string news_of(const Revision& revision) {
  return std::to_string(revision.number) + (revision.problem.empty() ? " solved" : " problem");
}

}  // namespace loadpath::cli
