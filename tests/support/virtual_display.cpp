#include "tests/support/virtual_display.h"

#include <X11/Xlib.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace lray::test {

namespace {

constexpr const char* kXvfb = "/usr/bin/Xvfb";
constexpr const char* kXdotool = "/usr/bin/xdotool";
constexpr const char* kEnv = "/usr/bin/env";

/// A field of the header of an XWD file: 32 bits, the most significant byte first.
std::size_t field(const std::string& file, std::size_t index) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = value << 8 | static_cast<unsigned char>(file.at(4 * index + i));
    }
    return value;
}

}  // namespace

bool VirtualDisplay::is_possible() {
    return access(kXvfb, X_OK) == 0 && access(kXdotool, X_OK) == 0;
}

VirtualDisplay::VirtualDisplay() {
    const std::string size = std::to_string(kWidth) + "x" + std::to_string(kHeight) + "x24";
    // It says which number was free, on the descriptor that becomes its output.
    server_ = std::make_unique<Process>(std::vector<std::string>{kXvfb, "-displayfd", "1",
                                                                 "-screen", "0", size, "-nolisten",
                                                                 "tcp", "-fbdir", files_.path()});
    for (int i = 0; i < 2000; ++i) {
        const std::string said = server_->out();
        if (said.ends_with('\n')) {
            name_ += ':';
            name_.append(said, 0, said.size() - 1);
            return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    throw std::runtime_error("Xvfb did not start");
}

Screenshot VirtualDisplay::screenshot() const {
    // Source: X11/XWDFile.h. Pixels are B G R and a byte that is not used.
    const std::string file = files_.read("Xvfb_screen0");
    const std::size_t header_size = field(file, 0);
    const std::size_t row_size = field(file, 12);
    constexpr std::size_t kColorSize = 12;
    const std::size_t begin = header_size + kColorSize * field(file, 19);
    Screenshot shot{static_cast<std::uint32_t>(field(file, 4)),
                    static_cast<std::uint32_t>(field(file, 5))};
    for (std::size_t y = 0; y < shot.height; ++y) {
        for (std::size_t x = 0; x < shot.width; ++x) {
            const std::size_t at = begin + y * row_size + 4 * x;
            for (const std::size_t channel : {2u, 1u, 0u}) {
                shot.bytes.push_back(static_cast<std::uint8_t>(file.at(at + channel)));
            }
        }
    }
    return shot;
}

std::string VirtualDisplay::hands(const std::vector<std::string>& commands) const {
    std::vector<std::string> command{kEnv, "DISPLAY=" + name_, kXdotool};
    command.insert(command.end(), commands.begin(), commands.end());
    const ProcessResult result = run_process(command);
    if (result.exit_code != 0) throw std::runtime_error("xdotool: " + result.err);
    return result.out;
}

void VirtualDisplay::ask_to_close(const std::string& title) const {
    const Window window = std::stoul(hands({"search", "--name", title}));
    Display* const display = XOpenDisplay(name_.c_str());
    if (display == nullptr) throw std::runtime_error("the display takes no connection");
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
    XSendEvent(display, window, False, NoEventMask, &event);
    XCloseDisplay(display);
}

void VirtualDisplay::vanish() {
    server_->send_signal(SIGKILL);
    server_->wait();
    server_.reset();
}

}  // namespace lray::test
