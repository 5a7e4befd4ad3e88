// The code of Boost.JSON, compiled here once as its headers offer: Debian's static library cannot be linked into a
// Python module, and a shared library costs start-up time in a command that runs for milliseconds.
#include <boost/json/src.hpp>
