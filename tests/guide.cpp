// docs/guide does what it says: its files, commands, outputs and pictures; and links lead somewhere, in all documents.
#include "tests/pages.hpp"

#include <algorithm>
#include <set>

using namespace loadpath;
using namespace loadpath::test;

namespace {

namespace fs = std::filesystem;

const fs::path guide = LOADPATH_ROOT "/docs/guide";

/// In their order, which is that of their names.
std::vector<fs::path> chapters() {
  std::vector<fs::path> pages;
  for (const auto& entry : fs::directory_iterator(guide)) {
    if (entry.path().extension() == ".md" && entry.path().filename() != "README.md") pages.push_back(entry.path());
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

/// The pictures of the guide's own folder that a page shows, by their names.
std::set<std::string> pictures_of(const std::string& page) {
  std::set<std::string> names;
  const std::string folder = "figures/";
  for (const Link& link : links_of(page)) {
    if (link.target.starts_with(folder)) names.insert(link.target.substr(folder.size()));
  }
  return names;
}

bool is_elsewhere(const std::string& target) { return target.find("://") != std::string::npos; }

/// Whether the file is there, and the heading in it.
bool leads_somewhere(const std::string& page, const std::string& target) {
  const std::size_t hash = std::min(target.find('#'), target.size());
  const fs::path root = LOADPATH_ROOT;
  const fs::path file = hash == 0 ? root / page : (root / page).parent_path() / target.substr(0, hash);
  if (!fs::exists(file)) return false;
  if (hash == target.size()) return true;
  const auto anchors = anchors_of(text_of(file));
  return std::find(anchors.begin(), anchors.end(), target.substr(hash + 1)) != anchors.end();
}

/// "[B19]" in a text, where it is not a link: the keys of sources.
std::vector<std::string> keys_of(const std::string& page) {
  std::vector<std::string> keys;
  for (const Block& block : blocks_of(page)) {
    if (!block.language.empty()) continue;
    const std::string& text = block.text;
    for (std::size_t at = text.find('['); at != std::string::npos; at = text.find('[', at + 1)) {
      const std::size_t end = text.find(']', at);
      if (end == std::string::npos || end - at > 6 || text.compare(end, 2, "](") == 0) continue;
      const std::string key = text.substr(at + 1, end - at - 1);
      if (key.size() > 1 && key.find_first_not_of("ABCD0123456789") == std::string::npos) keys.push_back(key);
    }
  }
  return keys;
}

}  // namespace

TEST_SUITE("guide") {
  TEST_CASE("a reader who follows it, chapter by chapter, gets what it shows, its pictures included") {
    const Desk desk;
    fs::create_directory_symlink(LOADPATH_ROOT "/examples", desk.folder() / "examples");
    std::set<std::string> shown, drawn;
    for (const fs::path& chapter : chapters()) {
      const std::string page = text_of(chapter);
      CAPTURE(chapter.filename().string());
      follow(desk, page);
      shown.merge(pictures_of(page));
    }
    CHECK(chapters().size() == 4);
    // A change of a picture is a decision: a command of a chapter rewrites it.
    for (const std::string& name : shown) {
      CAPTURE(name);
      CHECK(desk.get("figures/" + name) == text_of(guide / "figures" / name));
    }
    for (const auto& entry : fs::directory_iterator(guide / "figures")) drawn.insert(entry.path().filename().string());
    CHECK(drawn == shown);
  }

  TEST_CASE("it lists every chapter in its contents, and each leads to the next") {
    const auto links = links_of(text_of(guide / "README.md"));
    const auto pages = chapters();
    const auto leads_to = [](const std::vector<Link>& from, const fs::path& to) {
      return std::any_of(from.begin(), from.end(), [&](const Link& link) { return link.target == to.filename(); });
    };
    for (std::size_t i = 0; i < pages.size(); ++i) {
      CAPTURE(pages[i].string());
      CHECK(leads_to(links, pages[i]));
      if (i > 0) CHECK(leads_to(links_of(text_of(pages[i - 1])), pages[i]));
    }
  }

  TEST_CASE("the theory that it names is among the sources") {
    const std::string sources = text_of(LOADPATH_ROOT "/tables/sources.toml");
    std::set<std::string> named;
    for (const fs::path& chapter : chapters()) {
      for (const std::string& key : keys_of(text_of(chapter))) {
        CAPTURE(key);
        CHECK(sources.find("\n" + key + " = ") != std::string::npos);
        named.insert(key);
      }
    }
    for (const std::string key : {"A10", "B19", "C4", "D3"}) CHECK(named.count(key) == 1);
  }

  TEST_CASE("the gallery is that of scripts/gallery.sh, six small pictures at most") {
    const std::string script = text_of(LOADPATH_ROOT "/scripts/gallery.sh");
    std::set<std::string> shown, there;
    for (const Link& link : links_of(text_of(LOADPATH_ROOT "/docs/gallery/README.md"))) {
      const fs::path picture = link.target;
      if (picture.extension() == ".png") shown.insert(picture.stem().string());
    }
    for (const auto& entry : fs::directory_iterator(LOADPATH_ROOT "/docs/gallery")) {
      if (entry.path().extension() != ".png") continue;
      there.insert(entry.path().stem().string());
      CAPTURE(entry.path().string());
      CHECK(fs::file_size(entry.path()) < 150'000);
      CHECK(script.find("\npicture " + entry.path().stem().string() + " ") != std::string::npos);
    }
    CHECK(shown == there);
    CHECK(shown.size() <= 6);
  }

  TEST_CASE("every link of the documents leads to a file, and to a heading of it") {
    for (const std::string& page : documents()) {
      CAPTURE(page);
      for (const Link& link : links_of(text_of(std::string(LOADPATH_ROOT "/") + page))) {
        if (is_elsewhere(link.target)) continue;
        CAPTURE(link.target);
        CHECK(leads_somewhere(page, link.target));
      }
    }
  }

  TEST_CASE("a link that leads nowhere is reported") {
    CHECK(leads_somewhere("README.md", "docs/sweeps.md#on-a-cluster"));
    CHECK_FALSE(leads_somewhere("README.md", "docs/sweeps.md#on-a-custer"));
    CHECK_FALSE(leads_somewhere("README.md", "docs/sweep.md"));
  }

  TEST_CASE("an output that is shown and not printed is reported") {
    CHECK(difference("a\nb\n", "a\nb\n") == "");
    CHECK(difference("a\n...\nc\n", "a\nb\nc\n") == "");
    CHECK(difference("...\nb\n...\n", "a\nb\nc\n") == "");
    CHECK(difference("a\n...\n", "a\n") == "");
    CHECK(difference("...\nb\n", "b\na\nb\n") == "");
    CHECK(difference("a\n", "a\nb\n") != "");
    CHECK(difference("b\n", "a\nb\n") != "");
    CHECK(difference("a\n...\nb\n", "a\nb\nc\n") != "");
    CHECK(difference("...\nc\n...\nb\n...\n", "a\nb\nc\n") != "");
    CHECK(difference("a\n", "") != "");
  }
}
