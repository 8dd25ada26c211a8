// SPDX-License-Identifier: GPL-3.0-or-later
// Textures by name: of one folder alone, whatever its files are.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include <fovea/base/files.h>
#include <fovea/color/png.h>
#include <fovea/draw/assets.h>

#include "refused.h"
#include "system_files.h"

using namespace fovea;
using namespace fovea::draw;
namespace fs = std::filesystem;

namespace {

/// A folder with one texture, and one beside it that is none of its, which are gone afterwards.
struct Folder {
    fs::path outside = own_path("assets");
    fs::path path = outside / "inside", textures = path / "textures";

    Folder() {
        fs::create_directories(textures);
        write("textures.json", R"({"gray": {"length_in_widths": 8}})");
        const std::uint8_t half[3] = {188, 188, 188};
        write("gray.png", png_bytes(half, 1, 1));
        fs::copy(textures / "gray.png", outside / "gray.png");
    }
    ~Folder() { fs::remove_all(outside); }
    void write(const char* name, const std::string& bytes) const {
        std::ofstream(textures / name, std::ios::binary) << bytes;
    }
    std::string said(const std::string& name) const {
        return refused([&] { Assets(path).texture(name); });
    }
    /// What is said of textures/NAME.png for a cause.
    std::string sentence(const std::string& name, const std::string& cause) const {
        return name_of(textures / (name + ".png")) + cause;
    }
};

/// The bytes of a PNG that says it is so large, and has a single pixel.
std::string png_of(std::uint32_t width, std::uint32_t height) {
    const std::uint8_t black[3] = {};
    std::string bytes = png_bytes(black, 1, 1);
    for (int i = 0; i < 4; ++i) {
        bytes[16 + i] = char(width >> (24 - 8 * i));
        bytes[20 + i] = char(height >> (24 - 8 * i));
    }
    std::uint32_t sum = ~0u;  // CRC-32 of the header's name and data
    for (std::size_t i = 12; i < 29; ++i) {
        sum ^= std::uint8_t(bytes[i]);
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0u);
    }
    for (int i = 0; i < 4; ++i) bytes[29 + i] = char(~sum >> (24 - 8 * i));
    return bytes;
}

}  // namespace

TEST(Assets, TexturesAreThoseOfTheFolderAndNamesLeadOutOfNone) {
    const Folder folder;
    const Assets assets(folder.path);
    EXPECT_EQ(assets.texture("solid"), nullptr);
    ASSERT_NE(assets.texture("gray"), nullptr);
    EXPECT_NEAR(assets.texture("gray")->ink.ink[0], 188 / 255.0, 1e-6);
    EXPECT_EQ(assets.texture("gray")->length_in_widths, 8.0);
    EXPECT_EQ(assets.texture("gray"), assets.texture("gray"));
    EXPECT_THROW(assets.texture("missing"), std::invalid_argument);
    EXPECT_THROW(assets.texture("../gray"), std::invalid_argument);
    EXPECT_THROW(assets.paper("a/b"), std::invalid_argument);
}

TEST(Assets, NoTextureIsReadThroughALinkThatLeadsOut) {
    const Folder folder;
    if (!make_link("../../gray.png", folder.textures / "far.png")) GTEST_SKIP() << "links cannot be made here";
    fs::create_symlink("gray.png", folder.textures / "near.png");
    EXPECT_EQ(folder.said("far"), folder.sentence("far", " leads out of its folder"));
    EXPECT_EQ(folder.said("near"), "");
    fs::rename(folder.textures, folder.outside / "textures");
    fs::create_symlink("../textures", folder.textures);
    EXPECT_NE(folder.said("gray").find(" leads out of its folder"), std::string::npos);
    const fs::path link = folder.outside / "link";  // to the folder itself
    fs::remove(folder.textures);
    fs::rename(folder.outside / "textures", folder.textures);
    fs::create_symlink("inside", link);
    EXPECT_NE(Assets(link).texture("gray"), nullptr);
}

TEST(Assets, APipeIsNotWaitedFor) {
    const Folder folder;
    if (!make_pipe(folder.textures / "pipe.png")) GTEST_SKIP() << "this system has no pipes among its files";
    EXPECT_EQ(folder.said("pipe"), folder.sentence("pipe", " cannot be read: it is no file"));
}

TEST(Assets, WhatIsNoFileIsNamed) {
    const Folder folder;
    fs::create_directory(folder.textures / "folder.png");
    EXPECT_EQ(folder.said("folder"), folder.sentence("folder", " cannot be read: it is no file"));
    EXPECT_EQ(folder.said("none"), folder.sentence("none", " cannot be read: No such file or directory"));
}

TEST(Assets, HugeTexturesAreRefusedByTheirSizeBeforeTheyAreRead) {
    const Folder folder;
    folder.write("wide.png", png_of(30000, 30000));
    folder.write("high.png", png_of(1, largest_side + 1));
    const std::string cause = ": it has more than " + std::to_string(largest_side) + " pixels along a side";
    EXPECT_EQ(folder.said("wide"), folder.sentence("wide", cause));
    EXPECT_EQ(folder.said("high"), folder.sentence("high", cause));
    folder.write("long.png", png_of(1, 1));
    fs::resize_file(folder.textures / "long.png", 200'000'000);
    EXPECT_EQ(folder.said("long"), folder.sentence("long", " cannot be read: it has more than 64 MB"));
}

TEST(Assets, BrokenTexturesAndSizesAreNamed) {
    const Folder folder;
    for (const std::string& bytes : {std::string(), std::string("no picture"), png_of(64, 64)}) {
        folder.write("broken.png", bytes);
        EXPECT_EQ(folder.said("broken").rfind(folder.sentence("broken", ": "), 0), 0u) << folder.said("broken");
        EXPECT_GT(folder.said("broken").size(), folder.sentence("broken", ": ").size()) << "the cause";
    }
    const std::string file = name_of(folder.textures / "textures.json");
    for (const char* sizes : {R"({"gray": {"length_in_widths": 0}})", R"({"gray": {"length_in_widths": -1}})",
                              R"({"gray": {"length_in_widths": "long"}})"}) {
        folder.write("textures.json", sizes);
        EXPECT_EQ(folder.said("gray"), file + ": gray has no length_in_widths above 0");
    }
    for (const std::string& sizes : {std::string("{"), std::string(100000, '['), std::string("[]")}) {
        folder.write("textures.json", sizes);
        EXPECT_EQ(folder.said("gray").rfind(file, 0), 0u) << folder.said("gray");
    }
}

TEST(Assets, WithoutAFolderNoneIsLookedFor) {
    EXPECT_EQ(refused([] { Assets({}).texture("gray"); }),
              "a style with textures needs their folder: name it by --assets");
}
