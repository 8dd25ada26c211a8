// SPDX-License-Identifier: GPL-3.0-or-later
// The whole method as a program: from a scene and a view to strokes on paper. Each step fills the members that the next
// ones read; callers that need less than a picture stop at an earlier step and read its members.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fovea/color/layer.h>
#include <fovea/draw/backend.h>
#include <fovea/draw/by_light.h>
#include <fovea/draw/exposure.h>
#include <fovea/draw/found_lines.h>
#include <fovea/draw/line_passes.h>
#include <fovea/draw/options.h>
#include <fovea/draw/overrides.h>
#include <fovea/draw/pen_paints.h>
#include <fovea/draw/pens.h>
#include <fovea/elision/in_time.h>
#include <fovea/focus/focus.h>
#include <fovea/path/paths.h>
#include <fovea/scene/pose.h>
#include <fovea/scene/tracer.h>
#include <fovea/stroke/drawn_line.h>
#include <fovea/stroke/strokes.h>
#include <fovea/visibility/depth.h>
#include <fovea/visibility/runs.h>

namespace fovea::draw {

/// Color sources of a scene.
struct ColorSources {
    SceneColor surfaces;        ///< per placement
    std::vector<Light> lights;  ///< none: one at the eye
    vec3 world{0.0f};           ///< radiance of the sky
};

/// Input of one picture.
struct Job {
    std::shared_ptr<const Scene> scene;
    View view;
    style::Style style;
    Options options = {};
    Overrides overrides = {};
    Files files = {};  ///< that definitions of the style are given, by its paths; what is missing finds no lines
    std::shared_ptr<const Assets> assets = {};
    std::shared_ptr<Backend> backend = {};
    std::optional<ColorSources> colors = {};  ///< none: no color layer, whatever the style says
    /// Neighboring frames, for elision, visibility and marks over them; of a moment near a frame also this one, at 0.
    std::vector<LinesNear> near = {};
    Array<double> baked_marks = {};  ///< of the frame's lines of the view; empty: they are handed on
    int since_key = 0;               ///< how many frames before this one the last key of marks is (stroke/marks.h)
    std::shared_ptr<const Pose> before = {}, after = {};  ///< of the frames beside this one; null: lines do not move
    std::shared_ptr<const Exposure> exposure = {};        ///< ink in place of the frame's own; null: sharp
    std::shared_ptr<const Cancel> cancel = std::make_shared<Cancel>();
    /// Called before each stage with the fraction done, in [0, 1], and the stage's name.
    std::function<void(double, const std::string&)> progress = {};
};

/// Passes of width x height pixels, bottom row first, scene-linear and premultiplied; empty: not requested, or without
/// content.
struct Picture {
    Array<vec4> combined, lines;
    Array<vec4> color;   ///< the color layer alone
    Array<float> focus;  ///< in [0, 1], 0: in focus
    Array<float> depth;  ///< along the view axis; background_depth for background
    LinePasses of_lines;
};

/// The computation of one picture. Each step first runs the steps before it that have not run yet. May throw Cancelled,
/// and the exceptions of its parts.
class Frame {
   public:
    explicit Frame(Job job);

    void find();     ///< traces lines as paths, projects and clips them
    void see();      ///< visibility
    void filter();   ///< closes gaps, takes out folds, removes spurs; adds the hidden parts that pens draw
    void thin();     ///< elision: fades lines that crowd
    void shape();    ///< applies haloes and overshoot, chooses pens, makes strokes
    void ink();      ///< draws strokes
    void picture();  ///< composites over colors and paper; makes the passes

    // Filled by find():
    std::shared_ptr<const Tracer> tracer;
    std::shared_ptr<const Paths> paths;
    std::shared_ptr<const ClippedPaths> clipped;  ///< from filter() on without folds of contours, as the next two, and
                                                  ///< with its paths parted by light
    // By see():
    std::shared_ptr<const Runs> visible;
    Array<float> samples;  ///< visibility per atlas sample, for fading the ends of strokes; empty: sharp
    // By filter():
    std::shared_ptr<const Runs> runs;
    Array<float> focus, distance;  ///< per atlas sample, in [0, 1]; empty: no effect uses it
    // By thin():
    Array<float> shown;  ///< elision opacity per atlas sample, in [0, 1]; empty: 1
    // By shape():
    Array<float> seen;                  ///< share of the time per atlas sample, in [0, 1]; empty: 1
    std::shared_ptr<const Runs> drawn;  ///< with haloes and overshoot, and what is seen in frames near this one
    std::shared_ptr<const Strokes> strokes;
    Pens pens;
    // By picture(); its lines by ink():
    Picture passes;

    const Job job;
    /// (stage, milliseconds), in the order in which they ran.
    std::vector<std::pair<std::string, double>> stages;

    /// Whether elision applies: the style enables it, and visibility is known before strokes are drawn.
    bool thins() const;
    /// Whether visibility counts over frames: the style says so, and it is known before strokes are drawn.
    bool lasts() const;
    /// Whether marks of lines of the view are handed on from frame to frame: the style says so, and a pen has some.
    bool hands_on() const;
    /// Whether lines answer to frames near this one.
    bool answers() const { return thins() || lasts() || hands_on(); }
    /// Name of the method of visibility, and its quality, for reports.
    std::string visibility_in_words() const;
    /// What is found of this frame's lines, without neighboring frames. Runs the steps up to filter().
    std::shared_ptr<const FoundLines> found_lines();
    /// Takes over what was found of a frame of the same content (content.h), style, options and backend: the steps up
    /// to filter() need not run.
    void take_over(std::shared_ptr<const FoundLines> same);
    /// Focus at each pixel; empty if all is in focus. Runs no other step.
    Array<float> focus_of_pixels();

    /// Effects of focus and distance on lines, with this elision opacity at each sample. Requires filter().
    stroke::Emphasis emphasis(In<float> opacity) const;
    /// What strokes of the drawn runs are made of, with this elision opacity at each sample. Borrows. Requires shape().
    Inking inking(In<float> opacity) const;
    /// Strokes of the drawn runs, with this elision opacity at each sample. Requires shape().
    Strokes strokes_with(In<float> opacity) const;
    /// What lies under the lines: colors on paper, bottom row first, scene-linear. Requires picture().
    Array<vec4> ground() const;
    /// The same without colors.
    Array<vec4> bare_paper() const;
    /// The lines that these pens (a flag for each of `pens`) draw in focus and out of it, as in the passes. Requires
    /// shape().
    Array<vec4> lines_of(In<std::uint8_t> pens);
    /// The focus field in the coordinates of this view.
    const Focus& focus_function();

    /// Layouts of its depth buffer of at most `most_side` texels along each axis: one, or tiles. Tiles overlap their
    /// cores by `overlap_px` pixels plus the extent of a sample's own probes.
    std::vector<DepthBuffer> depth_layouts(int most_side, int overlap_px) const;

    double scale() const { return job.view.reference_scale; }  ///< image pixels per reference pixel
    const Cancel& cancel() const { return *job.cancel; }

   private:
    enum class Step { none, find, see, filter, thin, shape, ink, picture };
    bool has(Step step) const { return done_ >= step; }
    void stage(const char* name, double share, const std::function<void()>& body);
    void unfold();
    void part_by_light(Runs& found);
    void leave_out_faint();
    Runs with_halos() const;
    Runs over_frames(Runs runs);
    Runs with_ends(const Runs& runs) const;
    std::pair<Runs, Array<Index>> outlined(const Runs& runs) const;
    std::vector<double> mark_lengths() const;
    std::shared_ptr<const ViewLines> lines_of_view() const;
    std::shared_ptr<const MarkedLines> marked(std::shared_ptr<const ViewLines> of_view) const;
    Array<float> left(float cut);
    Painted painted(const std::string& attribute) const;
    Array<float> focus_along_lines();
    Array<float> distance_along_lines() const;
    const Tracer& rays();
    const Array<float>& depth();
    Array<float> focus_of_fewer_pixels();
    bool colors_answer() const;
    void focus_colors();
    void put_on_paper(In<vec4> lines, In<vec4> colors, Array<vec4>& out) const;

    Array<Index> pen_of_run_;
    Array<float> at_ends_;  // as `samples`, where those are not of what is drawn
    std::shared_ptr<const FoundLines> found_;
    std::vector<Owners> owners_;          // of lines, by shade; empty: no line set asks for light
    Array<std::uint8_t> owners_of_path_;  // index into owners_
    PenPaints pen_paints_;
    Marks marks_;
    Step done_ = Step::none;
    double share_ = 0.0;
    Array<float> depth_;
    std::optional<Focus> focus_;
};

}  // namespace fovea::draw
