// In place of window.cpp where lray is built without the viewer (LRAY_VIEWER).
#include "cli/console.h"
#include "cli/window.h"

namespace lray::cli {

ExitCode show_window(const Options&) {
    return report_failure({ExitCode::unbuilt, "this lray was built without the window",
                           "write a picture instead: `-o image.png`"});
}

}  // namespace lray::cli
