#include "base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace lray {

void assertion_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "lray: internal error: %s does not hold (%s:%d)\n", condition, file, line);
    std::_Exit(70);
}

}  // namespace lray
