// How often a test tries what depends on chance, or what others try as well.
#pragma once

namespace loadpath::test {

/// Under sanitizers, where a process takes ten times as long, a fifth of it.
constexpr int tries(int usual) {
#ifdef LOADPATH_SANITIZED
  return usual < 5 ? 1 : usual / 5;
#else
  return usual;
#endif
}

}  // namespace loadpath::test
