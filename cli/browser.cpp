#include "cli/browser.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>
#include <vector>

namespace loadpath::cli {

namespace fs = std::filesystem;

std::string find_browser() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
      const std::string file = (fs::path(folder) / name).string();
      if (access(file.c_str(), X_OK) == 0) return file;
    }
  }
  return {};
}

bool print_to_pdf(const std::string& html, const fs::path& path, Scratch& scratch) {
  const fs::path folder = scratch.create_folder();
  if (folder.empty()) return false;
  const fs::path page = folder / "report.html", target = fs::absolute(path);
  std::ofstream(page, std::ios::binary) << html;
  std::error_code error;
  if (target.has_parent_path()) fs::create_directories(target.parent_path(), error);
  std::vector<std::string> words{find_browser(),
                                 "--headless",
                                 "--disable-gpu",
                                 "--disable-quic",
                                 "--no-first-run",
                                 "--disable-background-networking",
                                 "--disable-component-update",
                                 "--disable-sync",
                                 "--user-data-dir=" + (folder / "profile").string(),
                                 "--no-pdf-header-footer",
                                 "--generate-pdf-document-outline",
                                 "--print-to-pdf=" + target.string(),
                                 "file://" + page.string()};
  if (geteuid() == 0) words.insert(words.begin() + 1, "--no-sandbox");  // Chromium refuses its sandbox to root
  return scratch.start(words) != 0 && scratch.wait() == 0 && fs::file_size(target, error) > 0 && !error;
}

}  // namespace loadpath::cli
