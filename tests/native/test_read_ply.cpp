// SPDX-License-Identifier: GPL-3.0-or-later
// PLY files of every format and type hold the same cube; broken ones are refused with the place.
#include <algorithm>
#include <gtest/gtest.h>
#include <tool/read_ply.h>

#include "model_files.h"
#include "refused.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::model_files;
using tool::PlyFormat;

namespace {

constexpr PlyFormat all_formats[] = {PlyFormat::ascii, PlyFormat::little_endian, PlyFormat::big_endian};

tool::Model read(const std::string& bytes) { return tool::read_ply("a.ply", bytes); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

void expect_cube(const tool::Model& model) {
    const tool::Model cube = read(cube_ply());
    EXPECT_EQ(model.positions, cube.positions);
    EXPECT_EQ(model.corner_verts, cube.corner_verts);
    EXPECT_EQ(model.polygon_offsets, cube.polygon_offsets);
    EXPECT_EQ(model.polygons.count, 0u);
}

}  // namespace

TEST(ReadPly, ACubeHasEightVerticesTwelveEdgesAndSixFacets) {
    const auto surface = read(cube_ply()).surface();
    EXPECT_EQ(surface->vertex_count(), 8u);
    EXPECT_EQ(surface->mesh_edges, 12u);
    EXPECT_EQ(surface->facet_count(), 6u);
    EXPECT_EQ(surface->report().inconsistent_edges, 0u);
    EXPECT_EQ(surface->positions[6], vec3(0, 1, 1));
}

TEST(ReadPly, EveryFormatTypeAndLineEndHoldsTheSameCube) {
    for (const PlyFormat format : all_formats)
        for (const char* coordinate : {"float", "double", "char", "ushort", "int32"})
            for (const char* count : {"uchar", "char", "ushort", "uint"})
                for (const char* index : {"int", "uint", "uint8", "short"})
                    for (const bool with_more : {false, true})
                        for (const char* line_end : {"\n", "\r\n"})
                            expect_cube(read(cube_ply({format, coordinate, count, index, with_more, line_end})));
}

TEST(ReadPly, TextNeedsNoLastLineEndNorOneElementPerLine) {
    std::string text = cube_ply();
    expect_cube(read(text.substr(0, text.find_last_not_of(" \n") + 1)));
    const std::size_t begin = text.find("end_header\n") + 11;
    std::replace(text.begin() + begin, text.end(), '\n', '\t');
    expect_cube(read(text));
}

TEST(ReadPly, TheListMayBeCalledVertexIndexAndFacesMayComeFirst) {
    expect_cube(read(replaced(cube_ply(), "vertex_indices", "vertex_index")));
    const tool::Model model = read(
        "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex 3\n"
        "property float x\nproperty float y\nproperty float z\nend_header\n3 0 1 2\n0 0 0 1 0 0 0 1 0\n");
    EXPECT_EQ(model.polygon_count(), 1u);
}

TEST(ReadPly, FacesThatNameNoVertexAreLeftOutAndCounted) {
    for (const char* corner : {"8", "-1", "4000000000", "1.5", "nan"}) {
        const tool::Model model =
            read(replaced(cube_ply({.index = "double"}), "4 4 5 7 6", std::string("4 4 5 7 ") + corner));
        EXPECT_EQ(model.polygon_count(), 5u) << corner;
        EXPECT_EQ(model.polygons.count, 1u);
        EXPECT_EQ(model.polygons.first, "line 20: a polygon names a vertex that is not there");
    }
    EXPECT_EQ(read(replaced(cube_ply(), "4 4 5 7 6", "0")).polygons.first,
              "line 20: a polygon has fewer than three corners");
}

TEST(ReadPly, CoordinatesThatAreNotFiniteAreCountedByTheSurface) {
    const auto surface = read(replaced(cube_ply(), "1 1 1 \n", "nan inf 1\n")).surface();
    EXPECT_EQ(surface->report().non_finite_vertices, 1u);
    EXPECT_EQ(surface->facet_count(), 3u);
}

TEST(ReadPly, AFileCutAnywhereIsRefusedInASentenceWithThePlace) {
    for (const PlyFormat format : all_formats) {
        const std::string bytes = cube_ply({.format = format});
        const std::size_t last = format == PlyFormat::ascii ? bytes.find_last_not_of(" \n") : bytes.size();
        for (std::size_t size = 0; size < last; ++size) {
            const std::string sentence = refused([&] { read(bytes.substr(0, size)); });
            EXPECT_TRUE(sentence.starts_with("a.ply, line ") || sentence.starts_with("a.ply, byte "))
                << size << sentence;
        }
    }
}

TEST(ReadPly, WhatIsWrongIsNamedWithItsPlace) {
    const std::string text = cube_ply(), binary = cube_ply({.format = PlyFormat::little_endian});
    const std::pair<std::string, const char*> broken[] = {
        {"", "a.ply, line 1: the file ends before its header does"},
        {"solid x\n", "a.ply, line 1: a PLY file begins with a line 'ply'"},
        {replaced(text, "ascii", "ebcdic"), "a.ply, line 2: there is no format 'ebcdic'"},
        {replaced(text, "format ascii 1.0\n", ""), "a.ply, line 9: the header ends without a format"},
        {replaced(text, "float", "real"), "a.ply, line 5: there is no type 'real'"},
        {replaced(text, "list uchar", "list list"), "a.ply, line 9: there is no type 'list'"},
        {replaced(text, "element vertex 8\n", ""), "a.ply, line 4: a property comes before any element"},
        {replaced(text, "vertex 8", "vertex -8"), "a.ply, line 4: '-8' is no number of elements 'vertex'"},
        {replaced(text, "comment", "komment"), "a.ply, line 3: a PLY header has no 'komment'"},
        {replaced(text, "float z", "float w"),
         "a.ply, line 10: the header ends without an element 'vertex' with x, y and z"},
        {replaced(text, "0 1 0", "0 l 0"), "a.ply, line 13: here is no number where there should be one"},
        {replaced(text, "4 0 2", "-4 0 2"), "a.ply, line 19: a list has no whole number of values"},
        {replaced(text, "4 1 3 7 5", "9 1 3 7 5"),
         "a.ply, line 24: the file ends before a list of 'vertex_indices' can"},
        {replaced(text, "vertex 8", "vertex 18446744073709551615"),
         "a.ply, line 11: the header says 18446744073709551615 of 'vertex', and there is room for 20"},
        {replaced(binary, "face 6", "face 4000000000"),
         "a.ply, byte 289: the header says 4000000000 of 'face', and there is room for 102"},
    };
    for (const auto& [bytes, sentence] : broken) EXPECT_EQ(refused([&] { read(bytes); }), sentence);
}

TEST(ReadPly, ElementsWithoutPropertiesTakeNoTimeHoweverManyThereAre) {
    expect_cube(read(replaced(cube_ply(), "element vertex", "element ghost 18446744073709551615\nelement vertex")));
}
