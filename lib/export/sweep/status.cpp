#include "lib/export/sweep/status.hpp"

#include "lib/export/json_writer.hpp"
#include "lib/export/sweep/folder.hpp"
#include "lib/export/sweep/lock.hpp"

#include <boost/json.hpp>

#include <fstream>
#include <iterator>

namespace loadpath::exports {

namespace {

namespace fs = std::filesystem;

Message damaged(const fs::path& folder) { return say("'{1}' is damaged", (folder / manifest_name).string()); }

/// The numbers of a manifest; they must be in order.
bool read_manifest(const boost::json::value& manifest, FolderStatus& status) {
  boost::system::error_code error;
  const auto number = [&](const char* name, std::uint64_t& to) {
    const auto* const value = manifest.is_object() ? manifest.get_object().if_contains(name) : nullptr;
    if (value != nullptr) to = value->to_number<std::uint64_t>(error);
    return value != nullptr && !error;
  };
  const auto* const project = manifest.is_object() ? manifest.get_object().if_contains("project") : nullptr;
  if (project == nullptr || !project->is_string()) return false;
  status.project = project->get_string().c_str();
  return number("points", status.points) && number("first", status.first) && number("end", status.end) &&
         number("rows", status.solved) && status.first <= status.end && status.end <= status.points &&
         status.solved <= status.end - status.first;
}

}  // namespace

Outcome<FolderStatus> status_of(const fs::path& folder) {
  const auto writer = FolderLock::writer_of(folder);
  std::ifstream in(folder / manifest_name, std::ios::binary);
  if (!in)
    return refused(folder, is_unbegun(folder) ? say("nothing is saved there yet") : say("no sweep in this folder"),
                   say("name the folder that a sweep was given by --out"));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  boost::system::error_code error;
  const boost::json::value manifest = boost::json::parse(text, error);
  FolderStatus status;
  if (error || !read_manifest(manifest, status)) return Fault{0, 1, damaged(folder), {}};
  if (writer) status.at_work = writer->message;
  return status;
}

std::string json_of(const FolderStatus& status) {
  const auto whole = [](std::uint64_t number) { return static_cast<std::int64_t>(number); };
  JsonWriter json;
  json.open_object();
  json.member("project", status.project);
  json.member("points", whole(status.points));
  json.member("first", whole(status.first));
  json.member("end", whole(status.end));
  json.member("solved", whole(status.solved));
  json.member("missing", whole(status.end - status.first - status.solved));
  json.member("state", status.is_done() ? "done" : "begun");
  json.member("at_work", !status.at_work.empty());
  json.close_object();
  return json.take();
}

}  // namespace loadpath::exports
