#include "lib/calculator/trace.hpp"

namespace loadpath {

Trace::Scope::Scope(Trace& trace, const char* list, std::size_t i) : trace_(trace), outer_(trace.scope_) {
  trace.scope_ += (outer_.empty() ? "" : ".") + std::string(list) + "[" + std::to_string(i + 1) + "]";
}

Trace::Scope::~Scope() { trace_.scope_ = outer_; }

void Trace::add(const char* symbol, const char* formula, const char* why, double si, Dimension dimension) {
  lines_.push_back({scope_, symbol, formula, why, si, dimension});
}

}  // namespace loadpath
