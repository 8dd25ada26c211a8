// SPDX-License-Identifier: GPL-3.0-or-later
// How drawings follow each other in an animation: on ones or twos, the hand's boil, lines that write themselves, and
// how they come and go.
#pragma once

#include <fovea/style/field.h>

namespace fovea::style {

/// How a line comes and goes, whose place is seen for a part of the time.
enum class Vanish : std::uint8_t { fade, shrink, break_up, retract };
template <>
inline constexpr Choice choices_of<Vanish>[] = {
    {"fade", "Fade", "Their opacity is the share of the time for which they are seen"},
    {"shrink", "Shrink", "Their width is the share of the time for which they are seen"},
    {"break_up", "Break Up",
     "They break up through the texture of their pen, faint ink first; of solid pens into blots, which shrink"},
    {"retract", "Retract", "Their ends are where they are seen for half of the time"},
};

struct Animation {
    int hold = 1;
    double boil = 0.0;
    int boil_hold = 2;
    int boil_cycle = 3;
    int start_frame = 1;
    double written = 1.0;
    int visibility_frames = 0;
    Vanish vanish = Vanish::fade;
    int marks_frames = 0;
    bool marks_baked = false;
    bool motion_blur = false;
    int motion_samples = 8;

    bool operator==(const Animation&) const = default;
    /// The frame whose drawing stands at a frame.
    int held(int frame) const;
    /// The number of the boil's drawing at a frame, in its cycle; the first, 0, is drawn as without boil.
    int boil_drawing(int frame) const;
    /// How many frames before this one the last key of marks is (stroke/marks.h): below `marks_frames`.
    int since_key(int frame) const;

    static constexpr Domain frames = number(1, 1000, 12);
    static constexpr auto fields = each_of(
        Field{"hold", &Animation::hold, "Frames per Drawing",
              "For how many frames renders hold a drawing: 1 is on ones, 2 on twos; another camera ends it", frames},
        Field{"boil", &Animation::boil, "Boil",
              "How much the wobble and the noise of strokes change from one drawing of the boil to the next", share},
        Field{"boil_hold", &Animation::boil_hold, "Frames per Boil",
              "For how many frames a drawing of the boil stands, also where a drawing is held", frames},
        Field{"boil_cycle", &Animation::boil_cycle, "Boil Cycle",
              "Number of drawings after which the boil begins again", number(2, 1000, 12)},
        Field{"start_frame", &Animation::start_frame, "Start Frame",
              "Frame from which drawings are counted, whichever frames are rendered",
              number(-1048574, 1048574, 1048574)},
        Field{"written", &Animation::written, "Written",
              "How much of each line is drawn, from its start: keyed from 0 to 1, lines write themselves", share},
        Field{"visibility_frames", &Animation::visibility_frames, "Visibility Over Frames",
              "Renders draw lines by how long they are seen from so many frames before to as many after: a "
              "single one takes as many times as long, an animation little longer",
              number(0, 8, 8)},
        Field{"vanish", &Animation::vanish, "Come and Go", "What lines do that are seen for a part of that time"},
        Field{"marks_frames", &Animation::marks_frames, "Marks Over Frames",
              "For how many frames marks of lines of the view move with surfaces, such as dashes and grain of contours "
              "that are fixed to paths, until they have gone over to others: renders look at so many frames around "
              "one, a single one takes up to as many times as long, an animation little longer",
              number(0, 64, 32)},
        Field{"marks_baked", &Animation::marks_baked, "Baked Marks",
              "Renders take marks of lines of the view from the file beside the Blender file that Bake Marks wrote; "
              "those "
              "of frames that it lacks, or whose lines have changed, are handed on"},
        Field{"motion_blur", &Animation::motion_blur, "Motion Blur of Lines",
              "Renders draw lines at several moments while the scene's shutter is open, and average them, where the "
              "scene has motion blur on, too: it takes up to as many times as long"},
        Field{"motion_samples", &Animation::motion_samples, "Samples", "Number of moments while the shutter is open",
              number(2, 256, 32)});
};

}  // namespace fovea::style
