// Every command of the program with its words, and the requested action once they are read.
#pragma once

#include "cli/files/commands.hpp"
#include "cli/program/words.hpp"

#include <CLI/CLI.hpp>

namespace loadpath::cli {

/// The options that words are read into; a command takes its own.
struct Options {
  RunOptions run;
  SweepOptions sweep;
  WhyOptions why;
  WatchOptions watch;
  ListOptions list;
  DescribeOptions describe;
  ConvertOptions convert;
  VerifyOptions verify;
  TablesOptions tables;
  CalculateOptions calculate;
  CompletionOptions completion;
  InitOptions init;
  DiffOptions diff;
  FmtOptions fmt;
};

/// The commands refer to the members: it stays where it is made.
struct CommandLine {
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  ~CommandLine() = default;

  /// Sets up the words of a command that are made only once it is named; does nothing for the others.
  void set_up(const CLI::App& command);

  CLI::App app;
  Options options;
  Action action;  // action of the command that was read; none before
  Late late;
};

}  // namespace loadpath::cli
