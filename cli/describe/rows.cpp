#include "cli/describe/rows.hpp"

#include "cli/fields/words.hpp"
#include "lib/report/terminal/layout.hpp"

#include <iostream>

namespace loadpath::cli {

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

void add_fields(std::span<const FieldInfo> fields, void* owner, const std::string& prefix, Rows& rows) {
  for (const FieldInfo& f : fields) {
    const std::string key = "  " + prefix + f.key + (*f.also_called == '\0' ? "" : std::string(", ") + f.also_called);
    if (f.type == FieldInfo::Type::record) rows.push_back({key, "record", "optional", f.doc});
    if (f.type == FieldInfo::Type::record) continue;
    if (f.is_leaf()) {
      const std::string rule = bounds_of(f);
      rows.push_back({key, type_of(f), f.role == Role::input ? default_of(f, owner) : "",
                      f.doc + (rule.empty() ? "" : " (" + rule + ")") + searched_of(f)});
      continue;
    }
    const bool list = f.type == FieldInfo::Type::list;
    rows.push_back({key + (list ? "[]" : ""), list ? list_of(f) : "table",
                    f.role == Role::input && !f.optional ? "required" : "", f.doc});
    void* inner = list ? f.push(owner) : f.element(owner, 0);
    add_fields(f.fields, inner, prefix + f.key + (list ? "[]." : "."), rows);
  }
}

void show_type(const char* title, const RecordType& type) {
  Record blank(type);
  Rows rows;
  add_fields(type.fields, blank.data.get(), "", rows);
  std::cout << title << "\n" << terminal::columns(rows) << "\n";
}

}  // namespace loadpath::cli
