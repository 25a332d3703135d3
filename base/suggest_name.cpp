#include "base/suggest_name.h"

#include <string>
#include <vector>

#include "base/did_you_mean.h"

namespace lray {

bool suggest_name(Diagnostic& diagnostic, std::string_view name,
                  std::span<const std::string_view> candidates) {
    const std::vector<std::string_view> near = nearest_names(name, candidates);
    if (near.empty()) return false;
    diagnostic.with_hint(did_you_mean(name, candidates));
    if (near.size() == 1) diagnostic.with_fix(diagnostic.span, std::string(near.front()));
    return true;
}

}  // namespace lray
