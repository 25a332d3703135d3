// The steps around the pipeline of main.cpp: what is said, when it ends early, what is written.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/output_file.h"
#include "base/source.h"
#include "cli/exit_code.h"
#include "cli/film_run.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/view.h"
#include "render/render.h"

namespace lray::cli {

/// Returns access to what the scene may read: -I and LRAY_PATH are searched too, --allow is not.
FileAccess file_access(const Options& options);

/// Returns what loading is to do: limits, definitions, the frame, and where printed lines go. Among
/// diagnostics for machines they have no place.
parser::LoadSettings load_settings(const Options& options);

/// How progress is told on stderr.
ProgressStyle progress_style(const Options& options);

/// Prints what the command line asked for in vain, and what makes the render slow.
void print_notes(const View& view, const scene::World& world, const Options& options);

/// Opens the output.
/// Errors: a usage error if it is the scene itself, an output error if it cannot be written.
std::variant<OutputFile, Failure> open_output(const Options& options,
                                              std::span<const std::string> files_read);

/// Builds the hierarchy, on the threads that rendering uses too.
std::unique_ptr<bvh::Accel> build_hierarchy(const scene::World& world, const Options& options,
                                            Progress& progress);

/// Makes ready what full shading needs beside the hierarchy; none for other shadings.
std::unique_ptr<shade::LitWorld> prepare_light(const View& view, const scene::World& world,
                                               const bvh::Accel& accel, const Options& options);

/// Renders with progress on stderr, until done or interrupted, and brings the picture to its
/// display. `kept` as of render::render().
render::RenderResult render_view(const View& view, const scene::World& world,
                                 const bvh::Accel& accel, const shade::LitWorld* lit,
                                 const Options& options, Progress& progress,
                                 render::KeptFilm* kept);

/// Returns the pixels that the format of the options holds of light.
image::Image for_file(image::Image light, const image::DisplaySettings& display,
                      const Options& options);

/// Writes a picture as for_file() returned it. Empty when it is in its file.
std::optional<Failure> write_picture(OutputFile output, const image::Image& picture,
                                     image::Gamma gamma, image::Metadata metadata,
                                     const Options& options);

/// Writes the picture, or the film if that is asked for; or what there is of the picture beside the
/// output if it was interrupted, and says so.
ExitCode save_picture(OutputFile output, const render::RenderResult& result, const View& view,
                      image::Metadata metadata, const FilmRun& film, const Options& options);

/// "a/image.png" -> "a/image.partial.png".
std::string partial_path(std::string_view output_path);

}  // namespace lray::cli
