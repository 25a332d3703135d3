#include "cli/named_file.h"

#include "base/assert.h"

namespace lray::cli {

std::string why_unread(const ReadResult& file) {
    switch (file.status) {
        case ReadStatus::ok:
            break;
        case ReadStatus::not_found:
            return "not found";
        case ReadStatus::outside:
        case ReadStatus::not_regular:
            return "not a file";
        case ReadStatus::too_large:
            return "too large";
        case ReadStatus::unreadable:
            return file.reason;
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::cli
