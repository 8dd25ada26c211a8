// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs that `fovea fuzz` has tried, and what it finds broken.
#include <fstream>
#include <gtest/gtest.h>
#include <limits>

#include <fovea/style/json.h>

#include "fuzz/fuzz.h"
#include "fuzz/random_job.h"
#include "fuzz/rules.h"
#include "refused.h"

using namespace fovea;
using namespace fovea::fuzz;

namespace {

bool holds(const std::string& sentence) {
    try {
        check_sentence(sentence);
    } catch (const Broken&) {
        return false;
    }
    return true;
}

}  // namespace

TEST(Fuzz, TheInputsOfTheCorpusAreDrawnOrRefusedInASentence) {
    std::ifstream lines(FOVEA_CORPUS);
    int drawn = 0, told = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '#') continue;
        SCOPED_TRACE(line);
        std::string sentence;
        EXPECT_NO_THROW(sentence = run(Input::read(line)));
        ++(sentence.empty() ? drawn : told);
    }
    EXPECT_GT(drawn, 20);
    EXPECT_GT(told, 20);
}

TEST(Fuzz, AnInputIsTheSameEachTime) {
    for (const std::uint64_t seed : {3, 4, 5}) {
        Choices first(seed), second(seed);
        for (int i = 0; i < 100; ++i) EXPECT_EQ(first.bits(), second.bits());
    }
    EXPECT_EQ(Input::read("styles 12").text(), "styles 12");
    EXPECT_THROW(Input::read("pictures 12"), std::invalid_argument);
    EXPECT_THROW(Input::read("meshes"), std::invalid_argument);
}

TEST(Fuzz, ANumberThatIsNoneIsFoundInEveryArray) {
    const auto spoiled = [](const auto& spoil) {
        Frame frame(plain_job(style::read_style(
            R"({"schema": 1, "line_sets": [{"kinds": {"contour": {}, "crease": {}}, "least_length": 0}]})")));
        frame.picture();
        EXPECT_NO_THROW(check_arrays(frame));
        spoil(frame);
        EXPECT_THROW(check_arrays(frame), Broken);
    };
    constexpr float none_at_all = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    spoiled([](Frame& frame) { frame.passes.combined[7].g = none_at_all; });
    spoiled([](Frame& frame) { frame.passes.depth.back() = inf; });
    spoiled([](Frame& frame) { frame.passes.lines.pop_back(); });
    spoiled([](Frame& frame) {
        Strokes strokes = *frame.strokes;
        strokes.arc[3].y = -inf;
        frame.strokes = std::make_shared<Strokes>(strokes);
    });
    spoiled([](Frame& frame) {
        ClippedPaths clipped = *frame.clipped;
        clipped.arc_px[2] = inf;
        frame.clipped = std::make_shared<ClippedPaths>(clipped);
    });
    spoiled([](Frame& frame) {
        Runs drawn = *frame.drawn;
        drawn.end_px[0] = drawn.start_px[0];
        frame.drawn = std::make_shared<Runs>(drawn);
    });
}

TEST(Fuzz, ASentenceNamesSomethingAndNothingOfTheImplementation) {
    EXPECT_TRUE(holds("Surface 1: it has no faces to refine; give it some"));
    EXPECT_FALSE(holds("Surface 1: it has no faces to refine")) << "what shall one do?";
    EXPECT_FALSE(holds("Surface 1: corner_edges and corner_verts differ in length"));
    EXPECT_TRUE(holds("camera: its picture has no pixels; make it wider or higher"));
    EXPECT_TRUE(holds("line_sets[0].pen.width is 0, outside 0.01 to 1000"));
    EXPECT_TRUE(holds("options.probes is 17, outside 1 to 16"));
    EXPECT_FALSE(holds(""));
    EXPECT_FALSE(holds("something went wrong"));
    EXPECT_FALSE(holds("Surface 1: two must not be\nlines"));
    EXPECT_FALSE(holds("Surface 1: it must not end with."));
    EXPECT_FALSE(holds("Surface 1: there must be no Embree error 4"));
    EXPECT_FALSE(holds("vector::_M_range_check: __n (which is 8) >= this->size() (which is 8)"));
}

TEST(Fuzz, SentencesThatDifferInNumbersAndNamesAreOfOneKind) {
    EXPECT_EQ(kind_of_sentence("pen.width is 0.5, outside 1 to 2e3"),
              kind_of_sentence("pen.width is -3, outside 1 to 7"));
    EXPECT_EQ(kind_of_sentence("the style gives 'a' twice"), kind_of_sentence("the style gives 'bc' twice"));
    EXPECT_NE(kind_of_sentence("Surface 1: a"), kind_of_sentence("Surface 1: b"));
}
