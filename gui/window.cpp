#include "gui/window.h"

// The loader comes before any other header of OpenGL.
#include <GL/glew.h>

#include <GL/freeglut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "gui/gl_screen.h"
#include "gui/overlay_painter.h"
#include "gui/viewer.h"
#include "gui/x_display.h"

namespace lray::gui {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLargestShare = 0.9;     // of the screen, that a new window takes
constexpr double kKeyCheckSeconds = 0.1;  // between two looks at whether any key is down
constexpr double kNever = std::numeric_limits<double>::infinity();

class Window {
 public:
    Window(LoadedScene first, Program program, Clock::time_point start)
        : end_without_window_(program.end_without_window),
          display_(XDisplay::open()),
          title_(program.title),
          start_(start),
          size_(size_on_screen(first.view.render_options.resolution)),
          viewer_(std::move(first), std::move(program),
                  display_ ? display_->keyboard_layout() : KeyboardLayout::qwerty, kOverlayFont,
                  size_, now()) {}

    void open();
    void run();
    WindowResult result() const;

    void draw();
    void resize(int width, int height);
    void close();
    void wake(double seconds);
    void on_timer(int generation);
    void end_because(std::string_view why) const { end_without_window_(why); }

    Viewer& viewer() { return viewer_; }
    double now() const {
        const std::chrono::duration<double> passed = Clock::now() - start_;
        return passed.count();
    }

 private:
    scene::Resolution size_on_screen(scene::Resolution wanted) const;
    void tick();

    std::function<void(std::string_view)> end_without_window_;
    std::unique_ptr<XDisplay> display_;  // whose end may need the one before
    std::string title_;
    Clock::time_point start_;
    scene::Resolution size_{1, 1};
    Viewer viewer_;
    std::optional<GlScreen> screen_{};
    int generation_ = 0;   // of the timer that counts; those before it are outdated
    double due_ = kNever;  // when it rings
    double next_key_check_ = 0.0;
    bool is_over_ = false;
    WindowStats stats_{};
};

// GLUT's callbacks reach nothing but globals.
Window* g_window = nullptr;

/// Calls what a callback does: nothing thrown may pass through GLUT.
template <class Work>
void guarded(const Work& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    g_window->viewer().end(ViewerState::out_of_memory);
    glutLeaveMainLoop();
}

std::string formatted(const char* format, va_list arguments) {
    std::array<char, 512> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    return text.data();
}

extern "C" {

void on_glut_error(const char* format, va_list arguments) {
    g_window->end_because("the window cannot be opened: " + formatted(format, arguments));
}

void on_glut_warning(const char*, va_list) {}

void on_draw() {
    guarded([] { g_window->draw(); });
}

void on_resize(int width, int height) {
    guarded([&] { g_window->resize(width, height); });
}

void on_timer(int generation) {
    guarded([&] { g_window->on_timer(generation); });
}

void on_close() {
    g_window->close();
}

}  // extern "C"

SpecialKey special_key(int key) {
    switch (key) {
        case GLUT_KEY_LEFT:
            return SpecialKey::left;
        case GLUT_KEY_RIGHT:
            return SpecialKey::right;
        case GLUT_KEY_UP:
            return SpecialKey::up;
        case GLUT_KEY_DOWN:
            return SpecialKey::down;
        case GLUT_KEY_PAGE_UP:
            return SpecialKey::page_up;
        case GLUT_KEY_PAGE_DOWN:
            return SpecialKey::page_down;
        case GLUT_KEY_HOME:
            return SpecialKey::home;
        case GLUT_KEY_END:
            return SpecialKey::end;
        case GLUT_KEY_INSERT:
            return SpecialKey::insert;
        case GLUT_KEY_DELETE:
            return SpecialKey::del;
        default:
            break;
    }
    static_assert(GLUT_KEY_F12 - GLUT_KEY_F1 == 11);
    if (key < GLUT_KEY_F1 || key > GLUT_KEY_F12) return SpecialKey::none;
    return static_cast<SpecialKey>(static_cast<int>(SpecialKey::f1) + key - GLUT_KEY_F1);
}

bool is_shift_down() {
    return (glutGetModifiers() & GLUT_ACTIVE_SHIFT) != 0;
}

/// With Ctrl, letters come as control codes that other keys have too: Ctrl-3 is Escape.
bool is_control_down() {
    return (glutGetModifiers() & GLUT_ACTIVE_CTRL) != 0;
}

std::optional<MouseButton> button_of(int button) {
    constexpr int kWheelUp = 3;  // as freeglut numbers them where no callback takes the wheel
    constexpr int kWheelDown = 4;
    switch (button) {
        case GLUT_LEFT_BUTTON:
            return MouseButton::left;
        case GLUT_MIDDLE_BUTTON:
            return MouseButton::middle;
        case GLUT_RIGHT_BUTTON:
            return MouseButton::right;
        case kWheelUp:
            return MouseButton::wheel_up;
        case kWheelDown:
            return MouseButton::wheel_down;
        default:
            return std::nullopt;
    }
}

void press(const Key& key) {
    if (is_control_down()) return;
    guarded([&] { g_window->viewer().press(key, g_window->now()); });
    g_window->wake(0.0);
}

void release(const Key& key) {
    guarded([&] { g_window->viewer().release(key, g_window->now()); });
    g_window->wake(0.0);
}

extern "C" {

void on_key(unsigned char character, int, int) {
    press({SpecialKey::none, static_cast<char>(character), is_shift_down()});
}

void on_key_up(unsigned char character, int, int) {
    release({SpecialKey::none, static_cast<char>(character), is_shift_down()});
}

void on_special_key(int key, int, int) {
    if (const SpecialKey special = special_key(key); special != SpecialKey::none) {
        press({special, '\0', is_shift_down()});
    }
}

void on_special_key_up(int key, int, int) {
    if (const SpecialKey special = special_key(key); special != SpecialKey::none) {
        release({special, '\0', is_shift_down()});
    }
}

void on_button(int button, int state, int x, int y) {
    const auto which = button_of(button);
    if (!which) return;
    guarded([&] {
        Viewer& viewer = g_window->viewer();
        if (state == GLUT_DOWN) {
            viewer.press(*which, {x, y}, is_shift_down(), g_window->now());
        } else {
            viewer.release(*which, {x, y}, g_window->now());
        }
    });
    g_window->wake(0.0);
}

void on_mouse(int x, int y) {
    guarded([&] { g_window->viewer().move({x, y}, g_window->now()); });
    g_window->wake(0.0);
}

}  // extern "C"

void Window::open() {
    XDisplay::when_lost([this] { end_because("the display went away"); });
    glutInitErrorFunc(on_glut_error);
    glutInitWarningFunc(on_glut_warning);
    int count = 1;
    std::string name = "lray";
    std::array<char*, 2> arguments{name.data(), nullptr};
    glutInit(&count, arguments.data());
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION);
    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE);
    glutInitWindowSize(static_cast<int>(size_.width), static_cast<int>(size_.height));
    glutCreateWindow((title_ + " - lray").c_str());
    if (glGetString(GL_VERSION) == nullptr) end_because("the display has no OpenGL");
    glewInit();  // without its functions, what every OpenGL has is enough
    screen_.emplace();
    glutIgnoreKeyRepeat(1);
    glutDisplayFunc(on_draw);
    glutReshapeFunc(on_resize);
    glutCloseFunc(on_close);
    glutKeyboardFunc(on_key);
    glutKeyboardUpFunc(on_key_up);
    glutSpecialFunc(on_special_key);
    glutSpecialUpFunc(on_special_key_up);
    glutMouseFunc(on_button);
    glutMotionFunc(on_mouse);
    wake(0.0);
}

void Window::run() {
    glutMainLoop();
}

scene::Resolution Window::size_on_screen(scene::Resolution wanted) const {
    if (!display_) return wanted;
    const auto [width, height] = display_->screen_size();
    const double shrink = std::min(
        {1.0, kLargestShare * width / wanted.width, kLargestShare * height / wanted.height});
    const auto shrunk = [&](std::uint32_t pixels) {
        return std::max(static_cast<std::uint32_t>(std::lround(shrink * pixels)), 1u);
    };
    return {shrunk(wanted.width), shrunk(wanted.height)};
}

void Window::resize(int width, int height) {
    size_ = {static_cast<std::uint32_t>(std::max(width, 1)),
             static_cast<std::uint32_t>(std::max(height, 1))};
    viewer_.resize(size_);
    wake(0.0);
}

/// The window is about to go, by the user or by the end of the main loop.
void Window::close() {
    is_over_ = true;
    stats_.frames = screen_->counts().frames;
    stats_.upload_seconds = screen_->counts().seconds;
    screen_.reset();  // while there is its context
    viewer_.end(ViewerState::closed);
}

/// Asks for a tick at that time, unless one comes before.
void Window::wake(double seconds) {
    const double at = now() + seconds;
    if (at >= due_) return;
    due_ = at;
    glutTimerFunc(static_cast<unsigned>(std::lround(1e3 * seconds)), gui::on_timer, ++generation_);
}

void Window::on_timer(int generation) {
    if (generation != generation_ || is_over_) return;
    due_ = kNever;
    tick();
}

void Window::tick() {
    const double time = now();
    if (viewer_.has_held_keys() && display_ && time >= next_key_check_) {
        next_key_check_ = time + kKeyCheckSeconds;
        if (!display_->is_any_key_down()) viewer_.release_all_keys(time);
    }
    const Tick next = viewer_.tick(time);
    if (viewer_.state() != ViewerState::open) {
        is_over_ = true;
        glutLeaveMainLoop();
        return;
    }
    if (next.wanted_size) {
        const scene::Resolution size = size_on_screen(*next.wanted_size);
        glutReshapeWindow(static_cast<int>(size.width), static_cast<int>(size.height));
    }
    if (next.needs_redraw) glutPostRedisplay();
    wake(next.seconds_to_next);
}

void Window::draw() {
    if (is_over_) return;
    if (const auto rows = viewer_.take_changed_rows()) {
        screen_->upload(viewer_.frame(), *rows);
        if (stats_.first_picture_seconds == 0.0) stats_.first_picture_seconds = now();
    }
    screen_->draw(viewer_.frame(), size_);
    paint(viewer_.overlay(), size_);
    glutSwapBuffers();
}

WindowResult Window::result() const {
    WindowResult result;
    switch (viewer_.state()) {
        case ViewerState::open:
        case ViewerState::closed:
            result.end = WindowEnd::closed;
            break;
        case ViewerState::interrupted:
            result.end = WindowEnd::interrupted;
            break;
        case ViewerState::out_of_memory:
            result.end = WindowEnd::out_of_memory;
            break;
    }
    result.is_loading = viewer_.is_loading();
    result.stats = stats_;
    const render::SessionStatus status = viewer_.status();
    result.stats.passes = status.total_passes;
    result.stats.pass_seconds = status.total_pass_seconds;
    return result;
}

}  // namespace

bool has_display() {
    return XDisplay::open() != nullptr;
}

WindowResult show_window(LoadedScene first, Program program, Clock::time_point start) {
    auto window = std::make_unique<Window>(std::move(first), std::move(program), start);
    g_window = window.get();
    window->open();
    window->run();
    window->viewer().finish();
    const WindowResult result = window->result();
    // Its loader cannot be told to stop, and would be waited for.
    if (result.is_loading) window.release();  // NOLINT(bugprone-unused-return-value)
    return result;
}

}  // namespace lray::gui
