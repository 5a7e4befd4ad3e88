#include "calculators/mechanism/results/output.hpp"

namespace loadpath::planar {

std::string named(const char* path, const std::string& name) {
  std::string own = path;
  const std::size_t at = own.find("NAME");
  return at == std::string::npos ? own : own.replace(at, 4, name);
}

Output output(const Declaration& what, const std::string& name) {
  return {.what = what, .name = name, .path = named(what.pattern.path, name)};
}

}  // namespace loadpath::planar
