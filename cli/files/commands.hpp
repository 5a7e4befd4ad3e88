// Commands about project files as texts: to begin one, to compare two, to lay one out.
#pragma once

#include <string>
#include <vector>

namespace loadpath::cli {

struct InitOptions {
  std::string starter;                // "shaft"; if missing, the user is prompted in a terminal
  std::string file;                   // "-": standard output; after the template where missing
  std::vector<std::string> settings;  // "T=80 N*m", "shaft.material=S355"
};
int init(const InitOptions& options);

/// Exit code 0: no difference; 1: they differ; 2: one of them is not a project.
struct DiffOptions {
  std::string before, after;
  bool json = false;
};
int diff(const DiffOptions& options);

/// Exit code 0: formatted, or already was; 1, with `check`: a file would change; 2: one of them is not TOML.
struct FmtOptions {
  std::vector<std::string> files;  // and folders; "-": standard input to standard output
  bool check = false;              // lists the files that would change, and writes nothing
};
int fmt(const FmtOptions& options);

}  // namespace loadpath::cli
