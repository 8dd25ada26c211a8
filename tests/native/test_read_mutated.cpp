// SPDX-License-Identifier: GPL-3.0-or-later
// Files with bytes changed, cut out, doubled or put in at random are read, or refused with their name; what is read is
// a mesh.
#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <tool/read_obj.h>
#include <tool/read_ply.h>

#include "model_files.h"
#include "refused.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::model_files;

namespace {

/// Bytes that mean something to one of the formats are likelier than others.
char some_byte(std::mt19937& random) {
    const std::string telling = "0123456789-+.e/\\ \n\r\tvfn#\xff" + std::string(1, '\0');
    return random() % 3 ? telling[random() % telling.size()] : char(random() % 256);
}

std::string mutated(std::string bytes, std::mt19937& random) {
    for (int changes = 1 + int(random() % 6); changes > 0 && !bytes.empty(); --changes) {
        const std::size_t at = random() % bytes.size(), size = std::min<std::size_t>(random() % 12, bytes.size() - at);
        switch (random() % 5) {
            case 0:
                bytes.erase(at, size);
                break;
            case 1:
                bytes.insert(at, bytes.substr(at, size));
                break;
            case 2:
                bytes.insert(at, 1, some_byte(random));
                break;
            default:
                bytes[at] = some_byte(random);
        }
    }
    return bytes;
}

/// Reads `count` mutants of a file; returns how many were a model.
template <typename Read>
int read_mutants(const std::string& bytes, unsigned seed, int count, const Read& read) {
    std::mt19937 random(seed);
    int models = 0;
    for (int i = 0; i < count; ++i) {
        const std::string changed = mutated(bytes, random);
        const std::string sentence = refused([&] {
            const auto surface = read("some.file", changed).surface();
            EXPECT_LE(surface->triangles.size(), 2 * changed.size());
            ++models;
        });
        EXPECT_TRUE(sentence.empty() || sentence.starts_with("some.file, ")) << "mutant " << i << ": " << sentence;
    }
    return models;
}

}  // namespace

TEST(ReadMutated, ObjFilesAreReadOrRefused) {
    const std::string more = "usemtl a\nf -1 -2 -3 -4 -5 -6\nf 1/2/3 2//2 \\\n 3\n";
    EXPECT_GT(read_mutants(cube_obj() + more, 1, 1000, tool::read_obj), 500);
}

TEST(ReadMutated, PlyFilesAreReadOrRefused) {
    int models = 0;
    for (const auto format : {tool::PlyFormat::ascii, tool::PlyFormat::little_endian, tool::PlyFormat::big_endian})
        for (const bool with_more : {false, true}) {
            const std::string bytes = cube_ply({.format = format, .with_more = with_more});
            models += read_mutants(bytes, unsigned(format) * 2 + with_more, 500, tool::read_ply);
        }
    EXPECT_GT(models, 400);
}
