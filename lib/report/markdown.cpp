#include "lib/report/conclusion.hpp"
