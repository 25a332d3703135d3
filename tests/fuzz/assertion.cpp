// A failed assertion as fuzzers want it: libFuzzer keeps the input of a process that aborts, but
// not of one that leaves by _Exit. Linked before lray_base, this definition is the one taken.
#include <cstdio>
#include <cstdlib>

#include "base/assert.h"

namespace lray {

void assertion_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "assertion failed: %s (%s:%d)\n", condition, file, line);
    std::abort();
}

}  // namespace lray
