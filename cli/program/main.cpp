#include "calculators/catalogue.hpp"
#include "cli/parts/parts.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/refusals.hpp"

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace loadpath::cli {

namespace {

/// The words typed; the id of a calculator, shaft.torsion, as two words.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const Calculator* const named = words.empty() ? nullptr : find_calculator(calculators(), words[0]);
  if (named == nullptr) return words;
  words[0] = name_in_element(*named);
  words.insert(words.begin(), std::string(named->element()));
  return words;
}

int dispatch(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "--version") {  // called often by scripts: nothing is set up
    std::cout << program() << "\n";
    return passed;
  }
  CommandLine line;
  const std::vector<std::string> typed = words_of(argc, argv);
  std::vector<std::string> words(typed.rbegin(), typed.rend());  // as CLI11 takes them
  try {
    line.app.parse(std::move(words));
  } catch (const CLI::Success& success) {  // --help, --version
    return line.app.exit(success);
  } catch (const CLI::ParseError& error) {
    return wrong_words(line.app, error, typed);
  }
  if (line.action && line.app.remaining().empty()) return line.action();
  return unknown_command(line.app, deepest(line.app));
}

int guarded(int argc, char** argv) {
  try {
    const int code = dispatch(argc, argv);
    if (std::cout.flush()) return code;
    std::cerr << "loadpath: standard output cannot be written\n";
    return fault;
  } catch (const std::exception& error) {
    std::cerr << "loadpath: internal error: " << error.what() << "\n";
    return fault;
  }
}

/// A command lives for milliseconds: memory of tables and pages that it has done with is used again, not returned to
/// the system, which would have to clear it for the next page.
void reuse_memory() {
#ifdef __GLIBC__
  constexpr int most = 64 << 20;  // bytes
  mallopt(M_MMAP_THRESHOLD, most);
  mallopt(M_TRIM_THRESHOLD, most);
#endif
}

}  // namespace

std::string program() { return "loadpath " LOADPATH_VERSION; }

}  // namespace loadpath::cli

int main(int argc, char** argv) {
  std::signal(SIGINT, [](int) { std::_Exit(loadpath::cli::interrupted); });
  return loadpath::cli::run_program([&] {
    loadpath::cli::reuse_memory();
    return loadpath::cli::guarded(argc, argv);
  });
}
