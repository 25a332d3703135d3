// The film of a render that goes on after it was interrupted (--resume), or whose film itself is
// asked for (-o x.film).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "base/file_access.h"
#include "cli/exit_code.h"
#include "cli/options.h"
#include "cli/view.h"
#include "render/film_file.h"
#include "render/kept_film.h"
#include "render/render.h"
#include "scene/scene.h"

namespace lray::cli {

/// Reads a film that the user named. Errors: why it cannot be, in words.
std::variant<render::StoredFilm, std::string> read_film_file(const std::string& path,
                                                             std::uint64_t max_pixels);

/// "image.png" -> "image.png.state": where a render with --resume keeps its film.
std::string state_path(std::string_view output_path);

class FilmRun {
 public:
    /// Begins with the film that an earlier run left, if there is one to go on with. Keeps no film
    /// if none is asked for.
    /// Errors: an output error for a state that cannot be read or is damaged; a usage error for
    /// that of another picture, or of more samples than are asked for.
    static std::variant<FilmRun, Failure> begin(const Options& options, const View& view,
                                                const scene::Scene& scene, const FileAccess& files);

    /// For render(); none if no film is kept.
    render::KeptFilm* kept() const { return kept_.get(); }

    /// True if an earlier run has written this picture, one of several frames, with as many
    /// samples, for the same display and in the same kind of file.
    bool is_done() const { return is_done_; }

    /// Writes the film as what the render asked for. Empty when it is in its file.
    std::optional<Failure> write(OutputFile output) const;

    /// After the picture was written, or could not be: removes the state if nothing is left to do,
    /// else saves it and says so. Of one of several frames a note that it is done remains.
    void end(const render::RenderResult& result, ExitCode exit_code) const;

 private:
    render::FilmDescription description_{};
    render::FilmDescription note_{};  // that a frame is done
    std::string state_path_{};        // empty: without --resume
    bool is_one_of_several_ = false;
    bool is_done_ = false;
    std::unique_ptr<render::KeptFilm> kept_{};
};

/// Removes the notes that frames are done, once all are.
void forget_frames(const Options& options);

}  // namespace lray::cli
