// The viewer without its window: what keys, mouse and time do to the picture that is shown, to the
// scene and to what is drawn over it. No OpenGL; tested without a display.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gui/camera_history.h"
#include "gui/file_watch.h"
#include "gui/gestures.h"
#include "gui/held_keys.h"
#include "gui/key_bindings.h"
#include "gui/overlay.h"
#include "gui/panels.h"
#include "gui/program.h"
#include "gui/sliders.h"
#include "gui/worker.h"
#include "render/session.h"

namespace lray::gui {

/// What follows from a tick.
struct Tick {
    bool needs_redraw = false;
    double seconds_to_next = 0.1;
    std::optional<scene::Resolution> wanted_size{};  // of the window: that of the scene has changed
};

enum class ViewerState : std::uint8_t { open, closed, interrupted, out_of_memory };

/// Times are seconds from any begin. Positions are pixels of the window from its top left.
class Viewer {
 public:
    /// `size` is that of the window to come.
    Viewer(LoadedScene first, Program program, KeyboardLayout layout, const Font& font,
           scene::Resolution size, double now);
    ~Viewer();

    /// Ends what may be ended, and waits for pictures that are still to be saved.
    void finish();

    void resize(scene::Resolution size);
    void press(const Key& key, double now);
    void release(const Key& key, double now);
    /// For when the window has lost the keyboard.
    void release_all_keys(double now);
    bool has_held_keys() const { return held_.is_any_held() || repeated_.has_value(); }
    void press(MouseButton button, DVec2 at, bool is_shift, double now);
    void move(DVec2 at, double now);
    void release(MouseButton button, DVec2 at, double now);

    /// The window is gone, or cannot go on.
    void end(ViewerState state) {
        if (state_ == ViewerState::open) state_ = state;
    }

    /// To be called after each event, and when the time that the last tick named has passed.
    Tick tick(double now);

    ViewerState state() const { return state_; }
    bool is_loading() const { return is_loading_; }

    /// True if the picture is that of all that was asked for, and nothing will change by itself.
    bool is_at_rest() const;
    render::SessionStatus status() const { return session_.status(); }

    const render::Frame& frame() const { return frame_; }
    /// Returns the rows of the frame that changed since the last call.
    std::optional<render::RowRange> take_changed_rows();

    Overlay overlay() const;

 private:
    enum class Move : std::uint8_t { none, keys, drag, wheel, jump };

    double seconds_to_next_tick() const;

    // viewer_actions.cpp
    void act(Bound bound, double now);
    void jump_to(const scene::Camera& camera, double now);
    void step_through_history(bool is_undo, double now);
    void use_next_tone_map();
    void recall_view(int number, double now);
    void store_view(int number, double now);
    void pick(DVec2 at);
    void show_pick(const std::optional<render::Pick>& found);
    void save();
    void apply(const Gesture& gesture, double now);
    void repeat_actions(double now);
    void begin_move(Move move, double now);
    void set_camera(const scene::Camera& camera);
    void fly(const Motion& motion, double now);
    void show_volumes(int step, double now);
    void tell(std::string message, double now);

    // viewer_scene.cpp
    void load();
    void take(LoadedScene loaded);
    void take_sliders(std::vector<Slider> sliders);
    void use_sliders();
    void choose_shading(int step);
    void find_volumes();
    render::View shown_view() const;
    image::DisplaySettings shown_display() const;
    void show();
    void show_crop();
    void show_display();
    shade::Shader shader() const;

    // viewer_overlay.cpp
    HudState hud_state() const;
    void add_volumes(Overlay& overlay) const;
    void add_crop(Overlay& overlay) const;
    WindowSize window() const;

    Program program_;
    KeyboardLayout layout_;
    Font font_;
    ViewerState state_ = ViewerState::open;

    // The scene, as it was loaded last.
    render::View scene_view_{};
    Bounds bounds_{};
    std::string hierarchy_{};
    std::string messages_{};  // what is wrong with the file, if that is newer than what is shown
    FileWatch watch_;
    std::vector<ParamText> params_{};  // that differ from those of the file
    LoadedScene loaded_{};             // of the loader's thread while it is busy
    bool is_loading_ = false;
    bool is_load_wanted_ = false;

    // How it is looked at.
    scene::Camera camera_{};
    scene::Resolution size_{};
    std::optional<render::PixelRect> crop_{};
    std::size_t shading_ = 0;                  // 0: that of the scene; else one of the others
    double exposure_ = 0.0;                    // in stops, beside that of the scene
    std::optional<image::ToneMap> tonemap_{};  // in place of that of the scene
    bool is_flying_ = false;
    double speed_ = 1.0;
    CameraHistory history_{};
    StoredViews views_{};
    std::optional<std::uint32_t> volume_level_{};
    render::BoundingVolumes volumes_{};

    // What is going on.
    HeldKeys held_{};
    MouseGestures mouse_{};
    std::optional<Gesture> crop_drawn_{};
    Sliders sliders_{};
    std::map<std::string, std::string> slider_texts_{};  // what the scene was asked for, by name
    bool is_drag_remembered_ = false;
    Move last_move_ = Move::none;
    double last_move_time_ = 0.0;
    struct Repeated {
        Key key{};
        Bound bound{};
        double next = 0.0;
    };
    std::optional<Repeated> repeated_{};

    // What is shown over the picture.
    bool shows_hud_ = true;
    bool shows_help_ = false;
    std::string message_{};
    double message_end_ = 0.0;
    std::optional<PickedObject> picked_{};
    bool needs_redraw_ = true;

    render::Frame frame_{};
    std::optional<render::RowRange> changed_rows_{};
    std::optional<scene::Resolution> wanted_size_{};
    render::SessionStatus seen_{};  // by the last tick
    std::uint64_t change_ = 0;      // of the session, the last that was asked for
    double change_time_ = 0.0;      // when that was
    std::uint64_t loads_ = 0;       // scenes that were shown
    double now_ = 0.0;              // of the last event

    render::Session session_{};
    Worker picker_{};
    Worker saver_{};
    Worker loader_{};  // the last: it must end first
};

}  // namespace lray::gui
