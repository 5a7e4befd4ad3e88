#include "lib/project/read/read_record.hpp"

#include "lib/project/read/reader.hpp"
#include "lib/project/read/records.hpp"

namespace loadpath::project {

static Reading read_one(const toml::Tree& table, const RecordType& type, const Template* from,
                        const std::string& prefix, const std::vector<std::string>& reserved,
                        std::vector<Issue>& issues) {
  Reading reading;
  reading.record = Record(type);
  reading.place = table.place;
  std::vector<Part> parts{{type.fields, reading.record.data.get()}};
  if (from != nullptr) {
    from->lay_out(reading.record.data.get());
    reading.parameters = Record(*from->parameters);
    parts.insert(parts.begin(), {from->parameters->fields, reading.parameters.data.get()});
  }
  Reader(reading, issues, prefix).read_fields(table, parts, "", reserved);
  for (const FieldInfo& field : type.fields) {
    if (field.type == FieldInfo::Type::record && reading.faulty.contains(field.key)) mark_untyped(reading);
  }
  return reading;
}

Reading read_record(const toml::Tree& table, const RecordType& type, const Template* from, const std::string& prefix,
                    const std::vector<std::string>& reserved, std::vector<Issue>& issues) {
  const ReadOne read = [&](const toml::Tree& tree, std::vector<Issue>& found) {
    return read_one(tree, type, from, prefix, reserved, found);
  };
  return read_in_turn(table, prefix, read, issues);
}

void mark_untyped(Reading& reading) {
  for (const FieldInfo& field : reading.record.type->fields) {
    if (!reading.typed.contains(field.key)) reading.faulty.insert(field.key);
  }
}

}  // namespace loadpath::project
