// SPDX-License-Identifier: GPL-3.0-or-later
// The whole method on one page: from a scene and a view to strokes on paper. Each step fills the members that the next
// ones read; whoever wants less than a picture stops earlier and reads the same members.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fovea/color/layer.h>
#include <fovea/draw/backend.h>
#include <fovea/draw/options.h>
#include <fovea/draw/overrides.h>
#include <fovea/draw/pens.h>
#include <fovea/elision/in_time.h>
#include <fovea/focus/focus.h>
#include <fovea/path/paths.h>
#include <fovea/scene/tracer.h>
#include <fovea/stroke/strokes.h>
#include <fovea/visibility/depth.h>
#include <fovea/visibility/runs.h>

namespace fovea::draw {

/// Where the colors of a scene come from.
struct ColorSources {
    SceneColor surfaces;        ///< by placement
    std::vector<Light> lights;  ///< none: one at the eye
    vec3 world{0.0f};           ///< radiance of the sky
};

/// What one picture is made of.
struct Job {
    std::shared_ptr<const Scene> scene;
    View view;
    style::Style style;
    Options options = {};
    Overrides overrides = {};
    std::shared_ptr<const Assets> assets = {};
    std::shared_ptr<Backend> backend = {};
    std::optional<ColorSources> colors = {};  ///< none: no color layer, whatever the style says
    std::vector<FrameNear> near = {};         ///< other frames, for elision smoothed in time
    std::shared_ptr<const Cancel> cancel = std::make_shared<Cancel>();
    /// Hears the share that is done before each stage, in [0, 1], and the stage's name.
    std::function<void(double, const std::string&)> progress = {};
};

/// Passes of width x height pixels, bottom row first, scene-linear and premultiplied; empty: not asked for, or nothing.
struct Picture {
    Array<vec4> combined, lines;
    Array<vec4> color;   ///< the color layer alone
    Array<float> focus;  ///< in [0, 1], 0: in focus
    Array<float> depth;  ///< along the view; background_depth where nothing is seen
};

/// One picture on its way. Every step first takes those before it that have not been taken. May throw Cancelled, and
/// what its parts throw.
class Frame {
   public:
    explicit Frame(Job job);

    void find();     ///< lines of the surfaces, as paths, projected and clipped
    void see();      ///< what of them is visible
    void filter();   ///< without gaps and spurs; with hidden parts, as far as pens draw them
    void thin();     ///< elision: what crowds fades
    void ink();      ///< haloes and overshoot, pens, strokes
    void picture();  ///< on paper, over colors, with its passes

    // Filled by find():
    std::shared_ptr<const Tracer> tracer;
    std::shared_ptr<const Paths> paths;
    std::shared_ptr<const ClippedPaths> clipped;
    // By see():
    std::shared_ptr<const Runs> visible;
    Array<float> samples;  ///< per atlas sample, by which the ends of strokes fade; empty: they are sharp
    // By filter():
    std::shared_ptr<const Runs> runs;
    Array<float> focus, distance;  ///< per atlas sample, in [0, 1]; empty: nothing answers to it
    // By thin():
    Array<float> shown;  ///< per atlas sample, in [0, 1], what elision leaves; empty: all
    // By ink():
    std::shared_ptr<const Runs> drawn;  ///< with haloes and overshoot
    std::shared_ptr<const Strokes> strokes;
    Pens pens;
    // By picture():
    Picture passes;

    const Job job;
    /// Milliseconds by stage, in the order in which they ran.
    std::vector<std::pair<std::string, double>> stages;

    /// Whether elision thins these lines: the style wants it, and what is visible is known before strokes are drawn.
    bool thins() const;
    /// The method of visibility and its quality in words.
    std::string visibility_in_words() const;
    /// What frames near by need to know of this one: what elision leaves of its lines. Takes the steps up to filter().
    ShownLines shown_lines();
    /// Focus of what each pixel shows; empty where all is in focus. Needs no other step.
    Array<float> focus_of_pixels();

    /// Strokes of the runs drawn, of which elision leaves so much at each sample. Once ink() is done.
    Strokes strokes_with(In<float> opacity) const;
    /// The places to look at, as this view has them.
    const Focus& focus_function();

    /// Layouts of its depth buffer in at most `most_side` texels along each axis: one, or tiles. Cores are looked out
    /// of by so many pixels, besides what a sample's own probes are apart.
    std::vector<DepthBuffer> depth_layouts(int most_side, int overlap_px) const;

    double scale() const { return job.view.reference_scale; }  ///< pixels of the image that are a reference pixel
    const Cancel& cancel() const { return *job.cancel; }

   private:
    enum class Step { none, find, see, filter, thin, ink, picture };
    bool has(Step step) const { return done_ >= step; }
    void stage(const char* name, double share, const std::function<void()>& body);
    Runs with_ends() const;
    std::pair<Runs, Array<Index>> outlined(const Runs& runs) const;
    Array<float> left(float cut);
    Array<float> focus_along_lines();
    Array<float> distance_along_lines() const;
    const Tracer& rays();
    const Array<float>& depth();
    Array<float> focus_of_fewer_pixels();
    bool colors_answer() const;
    void focus_colors();
    void put_on_paper();

    Array<Index> pen_of_run_;
    Step done_ = Step::none;
    double share_ = 0.0;
    Array<float> depth_;
    std::optional<Focus> focus_;
};

}  // namespace fovea::draw
