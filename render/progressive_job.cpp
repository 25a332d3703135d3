#include "render/progressive_job.h"

#include <utility>

#include "base/assert.h"
#include "render/preview.h"
#include "render/tiles.h"

namespace lray::render {

namespace {

RenderOptions with_light(RenderOptions options, const PreparedScene& scene) {
    options.lit = scene.lit.get();
    return options;
}

/// Whether it makes a difference that squares take one sample of each light.
bool has_quick_rays(const RenderOptions& options) {
    return options.shading.shader == shade::Shader::full &&
           options.shading.integrator == scene::Integrator::whitted &&
           options.lit->lights.most_samples() > 1;
}

/// The side of a tile of squares, in squares: there must be enough tiles for all threads.
std::uint32_t tile_of_squares(std::uint32_t square) {
    return square > kBlockSize ? kBlockSize / 2 : kBlockSize;
}

std::uint64_t all_rays(const RayCounts& counts) {
    return counts.primary.rays + counts.light.onward.rays + counts.light.shadow.rays;
}

}  // namespace

/// What the threads of a step share.
struct ProgressiveJob::Step {
    /// A part of the picture that is kept back.
    struct Result {
        PixelRect part{};
        std::vector<Color> light{};
        std::uint32_t square = 1;
    };

    const StepControl& control;
    LivePicture& picture;
    std::mutex mutex{};
    BlockWork work{};
    bool is_stopped = false;
    std::vector<Result> kept_back{};

    bool should_stop() {
        if (!control.should_stop()) return false;
        const std::lock_guard lock(mutex);
        is_stopped = true;
        return true;
    }

    void take(const BlockWork& more) {
        const std::lock_guard lock(mutex);
        work += more;
    }

    void show(Result result) {
        if (std::chrono::steady_clock::now() < control.show_from) {
            const std::lock_guard lock(mutex);
            kept_back.push_back(std::move(result));
            return;
        }
        show_kept_back();
        picture.put(result.part, result.light, result.square);
    }

    void show_kept_back() {
        std::vector<Result> results;
        {
            const std::lock_guard lock(mutex);
            results.swap(kept_back);
        }
        for (const Result& result : results) picture.put(result.part, result.light, result.square);
    }
};

ProgressiveJob::ProgressiveJob(const PreparedScene& scene, const View& view,
                               std::uint32_t first_square, const std::atomic<bool>& cancel)
    : view_{view.camera, with_light(view.render_options, scene)},
      tracer_(scene.world, *scene.accel, view_.camera, view_.render_options, cancel),
      quick_tracer_(tracer_),
      has_quick_rays_(render::has_quick_rays(view_.render_options)),
      square_(first_square),
      // Passes show single pixels soon enough, but not around a crop.
      last_square_(has_quick_rays_ || view.render_options.crop ? 1 : 2) {
    quick_tracer_.limit_light_samples(1);
    if (square_ < last_square_) square_ = 0;
    tiles_.resize(Squares{view_.area(), kTileSize}.count());
}

StepOutcome ProgressiveJob::run_step(LivePicture& picture, const StepControl& control) {
    LRAY_ASSERT(!is_done_);
    const auto begin = std::chrono::steady_clock::now();
    Step step{control, picture};
    if (is_pass_next()) {
        run_pass(step);
    } else {
        run_squares(step);
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    const bool is_complete = !step.is_stopped && !step.work.is_cancelled;
    // What came of a step that took too long is shown all the same: there may be no better one.
    const bool is_late = std::chrono::steady_clock::now() >= control.show_from;
    if (!step.work.is_cancelled || is_late) step.show_kept_back();
    if (is_pass_next()) {
        pass_seconds_ += passed.count();
        finished_pixels_ += step.work.finished_pixels;
        const SampleLimits& limits = view_.render_options.limits;
        if (is_complete) {
            ++pass_count_;
            is_done_ = pass_count_ == pass_limit() ||
                       finished_pixels_ == view_.area().pixel_count() ||
                       (limits.seconds && pass_seconds_ >= *limits.seconds);
        }
    } else if (is_complete) {
        square_ = square_ > last_square_ ? square_ / 2 : 0;
    }
    return {is_complete, step.work.samples, all_rays(step.work.rays), passed.count()};
}

void ProgressiveJob::run_squares(Step& step) const {
    const Squares tiles{view_.whole(), tile_of_squares(square_) * square_};
    for_each_tile(tiles.count(), [&](std::uint64_t i) {
        if (step.should_stop()) return;
        const PixelRect part = tiles.at(i);
        const std::vector<FilmPlace> pixels = middles_of_squares(part, square_);
        Step::Result result{part, std::vector<Color>(pixels.size()), square_};
        BlockWork work;
        const std::uint32_t sample = view_.render_options.samples.begin;
        work.is_cancelled =
            !quick_tracer_.colors_of(pixels, sample, result.light, work.rays, step.control.cancel);
        if (!work.is_cancelled) {
            work.samples = pixels.size();
            step.show(std::move(result));
        }
        step.take(work);
    });
}

void ProgressiveJob::run_pass(Step& step) {
    const RenderOptions& options = view_.render_options;
    const BlockSettings settings{tracer_, options.samples, options.limits.noise,
                                 image::Display(options.display), step.control.cancel};
    const Squares tiles{view_.area(), kTileSize};
    const std::uint32_t end = options.samples.begin + pass_count_ + 1;
    for_each_tile(tiles.count(), [&](std::uint64_t i) {
        if (step.should_stop()) return;
        const PixelRect part = tiles.at(i);
        Tile& tile = tiles_[i];
        if (tile.empty()) {
            const Squares blocks{part, kBlockSize};
            for (std::uint64_t k = 0; k != blocks.count(); ++k) {
                tile.emplace_back(blocks.at(k), settings);
            }
        }
        BlockWork work;
        image::Image light(part.width(), part.height());
        for (Block& block : tile) {
            work += block.advance(end, settings);
            if (work.is_cancelled) break;
            block.resolve(part, light);
        }
        const bool is_new = work.samples > 0 && !work.is_cancelled;
        if (is_new) step.show({part, std::move(light.pixels), 1});
        step.take(work);
    });
}

}  // namespace lray::render
