#include "cli/describe/templates.hpp"

#include "calculators/catalogue.hpp"
#include "cli/describe/rows.hpp"
#include "lib/report/terminal/terminal.hpp"

#include <iostream>

namespace loadpath::cli {

namespace {

/// The names of list elements that a template has laid out, and of those within them.
void add_names(std::span<const FieldInfo> fields, void* owner, const std::string& prefix, Rows& rows) {
  for (const FieldInfo& f : fields) {
    if (f.type != FieldInfo::Type::list || f.size(owner) == 0) continue;
    const FieldInfo* name = find_field(f.fields, "name");
    if (name == nullptr) continue;  // elements by number: a template gives no further details
    std::vector<std::string> names;
    for (std::size_t i = 0; i < f.size(owner); ++i) names.emplace_back(name->text(f.element(owner, i)));
    rows.push_back({"  " + prefix + f.key, joined(names)});
    for (std::size_t i = 0; i < names.size(); ++i)
      add_names(f.fields, f.element(owner, i), prefix + f.key + "." + names[i] + ".", rows);
  }
}

}  // namespace

void show_template(const Calculator& calculator, const Template& t) {
  std::cout << calculator.id << "." << t.id << ": " << t.title << "\n\n" << terminal::paragraph(t.doc) << "\n";
  show_type("Parameters, in addition to the fields of the calculator", *t.parameters);
  Record laid(*calculator.input);
  t.lay_out(laid.data.get());
  Rows rows;
  add_names(laid.type->fields, laid.data.get(), "", rows);
  std::cout << "Makes\n" << terminal::columns(rows) << "\nExample, a project file that runs:\n\n" << t.example;
}

void show_templates(const Calculator& calculator) {
  Rows rows;
  for (const Template* t : calculator.templates) {
    std::vector<std::string> keys;
    for (const FieldInfo& f : t->parameters->fields) keys.emplace_back(f.key);
    rows.push_back({std::string("  ") + t->id, t->title, joined(keys)});
  }
  std::cout << "Templates, template = \"NAME\" with its parameters in place of what it makes\n"
            << terminal::columns(rows) << "  `loadpath describe " << calculator.id << ".NAME` shows one\n\n";
}

const Template* template_of(const std::string& id, const Calculator*& calculator) {
  for (const Calculator* c : calculators()) {
    const std::string prefix = std::string(c->id) + ".";
    const Template* const t = id.starts_with(prefix) ? find_template(*c, id.substr(prefix.size())) : nullptr;
    if (t == nullptr) continue;
    calculator = c;
    return t;
  }
  return nullptr;
}

}  // namespace loadpath::cli
