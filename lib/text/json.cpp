// The code of Boost.JSON, compiled here once as its headers offer: Debian's archive of it cannot stand in a module of
// Python, and a shared library is one to search in a command that lives for milliseconds.
#include <boost/json/src.hpp>
