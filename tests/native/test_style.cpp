// SPDX-License-Identifier: GPL-3.0-or-later
// Styles: what is written is read again, what does not belong is named, and what lies between two.
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include <fovea/style/json.h>
#include <fovea/style/mix.h>

#include "refused.h"

namespace fovea::style {
namespace {

/// A style from what its file says beside the schema.
Style read(const std::string& parts) { return read_style(R"({"schema": 1, )" + parts + "}"); }

std::string said(const std::string& json) {
    return refused([&] { read_style(json); });
}

/// The digits of a number in a style's file.
std::string written(double number) {
    std::vector<Unknown> kept{{{"number"}, JsonValue::of(number).written(false)}};
    return kept[0].json;
}

TEST(Style, APenOutOfFocusIsAsTheOneInFocusButForWhatIsGiven) {
    const Style style = read(R"("line_sets": [{"pen_away": {"opacity": 0.1}, "pen": {"width": 7, "opacity": 0.5}}])");
    const std::optional<Pen>& away = style.line_sets[0].pen_away;
    ASSERT_TRUE(away.has_value());
    EXPECT_EQ(away->width, 7.0);
    EXPECT_EQ(away->opacity, 0.1);
    EXPECT_TRUE(style.has_away());
}

TEST(Style, WhatIsNotKnownIsKeptInItsPlaceAndNullIsNone) {
    const Style style = read(
        R"("moon": {"full": [1e2, 12345678901234567890123]}, "color": {"background": null}, "line_sets": [{"pen_away": null}])");
    EXPECT_FALSE(style.color.background.has_value() || style.has_away());
    ASSERT_EQ(style.kept.size(), 1u);
    EXPECT_EQ(dotted(style.kept[0].path), "moon");
    EXPECT_EQ(style.kept[0].json, R"({"full": [100.0, 12345678901234567890123]})");
    EXPECT_EQ(read_style(write_style(style)), style);
}

TEST(Style, AFileOfALineDefinitionIsRestoredAndMayNotLeaveTheFolder) {
    const auto with = [](const std::string& file) {
        return R"("line_sets": [{"kinds": {"learned_line": {"threshold": 0.5, "model": )" + file + "}}}]";
    };
    const Style style = read(with(R"("models/artist.json")"));
    const Parameters expected = {{"threshold", 0.5}, {"model", std::string("models/artist.json")}};
    EXPECT_EQ(style.line_sets[0].kinds[0].second, expected);
    EXPECT_TRUE(style.kept.empty());
    EXPECT_EQ(read_style(write_style(style)), style);
    const std::string where = "line_sets[0].kinds.learned_line.model must be the name of a file";
    for (const char* outside : {"../a.json", "/a.json", "models/../../a.json", "C:a.json", "..\\\\a.json", ".."})
        EXPECT_TRUE(refused([&] { read(with('"' + std::string(outside) + '"')); }).starts_with(where)) << outside;
    for (const char* no_file : {"3", "null", R"("")", R"("artist.png")", R"("a\n.json")"})
        EXPECT_TRUE(refused([&] { read(with(no_file)); }).starts_with(where)) << no_file;
    // Of Blender, where a style is no file.
    EXPECT_EQ(checked_parameters("learned_line", {{"model", std::string("/home/a.json")}}, "lines").size(), 1u);
    // Between two styles a file is that of the nearer one.
    const Style other = read(with(R"("other.json")"));
    EXPECT_EQ(mix(style, other, 0.4).line_sets[0].kinds[0].second, expected);
    EXPECT_EQ(mix(style, other, 0.6).line_sets[0].kinds[0].second[1].second.file, "other.json");
}

TEST(Style, WhatHasTheWrongTypeOrIsOutOfItsRangeIsNamed) {
    const auto of = [](const std::string& parts) { return said(R"({"schema": 1, "line_sets": [{}], )" + parts + "}"); };
    EXPECT_EQ(of(R"("paper": {"tooth": "sharp"})"), "paper.tooth must be a number");
    EXPECT_EQ(of(R"("paper": {"tooth": 1.5})"), "paper.tooth is 1.5, outside 0 to 1");
    EXPECT_EQ(of(R"("elision": {"frames": 1.5})"), "elision.frames must be a whole number");
    EXPECT_EQ(of(R"("color": {"shading": "phong"})"), "color.shading is 'phong'; it can be: plain, flat, smooth, toon");
    EXPECT_EQ(of(R"("paper": {"texture": "../ink"})"),
              "paper.texture is '../ink'; only letters, digits, _ and - are allowed");
    EXPECT_EQ(said(R"({"schema": 1, "line_sets": []})"), "line_sets must be a list of at least one line set");
    EXPECT_EQ(said(R"({"schema": 1, "line_sets": [{"pen": {"cap": 1}}]})"), "line_sets[0].pen.cap must be text");
    EXPECT_EQ(said(R"({"line_sets": [{}]})"), "schema is null, not the number of a schema: 1 to 1");
}

TEST(Style, JsonThatIsNoneOrMeansHarmIsRefusedWhereItIsWrong) {
    EXPECT_EQ(said("{"), "the style is not JSON at line 1, column 1");
    EXPECT_EQ(said("{\n  \"a\": 1,\n}"), "the style is not JSON at line 3, column 1");
    EXPECT_EQ(said(R"({"a": [0, {"b": 1e400}]})"), "a[1].b is 1e400, not a finite number");
    EXPECT_EQ(said(R"({"a": [{"b": 1, "b": 2}]})"), "a[0] gives 'b' twice");
    EXPECT_NE(said(std::string(100000, '[')).find("nested more than 32 levels deep"), std::string::npos);
    EXPECT_NE(said(std::string(2 << 20, ' ')).find("more than 1 MB"), std::string::npos);
}

TEST(Style, NumbersAreWrittenWithTheFewestDigitsThatAreReadAsTheSame) {
    EXPECT_EQ(written(0.0), "0.0");
    EXPECT_EQ(written(-0.0), "-0.0");
    EXPECT_EQ(written(2.0), "2.0");
    EXPECT_EQ(written(0.1), "0.1");
    EXPECT_EQ(written(0.1 + 0.2), "0.30000000000000004");
    EXPECT_EQ(written(-1234.5), "-1234.5");
    EXPECT_EQ(written(1e15), "1000000000000000.0");
    EXPECT_EQ(written(1e16), "1e+16");
    EXPECT_EQ(written(1.25e300), "1.25e+300");
    EXPECT_EQ(written(0.0001), "0.0001");
    EXPECT_EQ(written(0.00001), "1e-05");
    EXPECT_EQ(written(std::numeric_limits<double>::denorm_min()), "5e-324");
    for (double number = 1e-12; number < 1e12; number *= std::numbers::pi) {
        const JsonValue back = parse_json(written(number));
        EXPECT_EQ(back.number, number);
    }
}

TEST(Style, EveryMemberThatIsWrittenIsReadAgain) {
    Style style;
    style.line_sets[0].kinds = {{"crease", {{"angle", 45.0}}}, {"contour", {}}};
    style.line_sets[0].overshoot_away = 3.0;
    Pen& away = style.line_sets[0].pen_away.emplace();
    away.cap = Cap::butt;
    away.color = {0.25, 0.5, 1.0};
    style.line_sets[0].hidden.resize(2);
    style.line_sets[0].hidden[0].last = 2;
    style.line_sets[0].hidden[1].first = 4;
    style.line_sets[0].hidden[1].pen_away = Pen{};
    style.effects.blur.curve = {{0.0, 0.5}, {1.0, 0.25}};
    style.color.background = dvec3(0.5);
    style.focus.model = FocusModel::object;
    style.focus.points.resize(2);
    style.focus.points[0].object = "Caf\xc3\xa9";
    EXPECT_EQ(read_style(write_style(style)), style);
}

TEST(Style, ASentenceAboutAFileIsShortAndOnOneLine) {
    for (const std::string& text :
         {std::string(70000, 'x'), std::string(300, 'x') + "\\u0000\\n" + std::string(300, 'y')}) {
        const std::string sentence =
            said(R"({"schema": 1, "line_sets": [{}], "color": {"shading": ")" + text + R"("}})");
        EXPECT_LT(sentence.size(), 500u);
        EXPECT_EQ(sentence.substr(0, 24), "color.shading is 'xxxxxx");
        EXPECT_NE(sentence.find("it can be: plain"), std::string::npos);
        EXPECT_TRUE(std::ranges::none_of(sentence, [](unsigned char c) { return std::iscntrl(c); }));
    }
    std::string umlauts;
    for (int i = 0; i < 1000; ++i) umlauts += "\u00e4";
    const std::string sentence = said(R"({"schema": ")" + umlauts + R"("})");
    EXPECT_LT(sentence.size(), 500u);
    for (std::size_t i = 0; i < sentence.size(); ++i)
        if ((sentence[i] & 0xc0) == 0xc0) {
            EXPECT_EQ(sentence[++i] & 0xc0, 0x80) << "no letter is cut";
        }
}

TEST(Style, PensOfHiddenPartsStandInTheOrderOfTheirRangesWithWhatIsNotKnownOfThem) {
    const Style style = read(R"("line_sets": [{"hidden": [{"from": 4, "new": 4}, {"to": 2, "old": 1}]}])");
    EXPECT_EQ(style.line_sets[0].hidden[0].last, 2);
    ASSERT_EQ(style.kept.size(), 2u);
    EXPECT_EQ(dotted(style.kept[0].path), "line_sets[0].hidden[0].old");
    EXPECT_EQ(dotted(style.kept[1].path), "line_sets[0].hidden[1].new");
}

TEST(Style, BetweenAStyleAndItselfIsThatStyleAndTheEndsAreTheStyles) {
    Style one, other;
    one.line_sets[0].kinds = {{"crease", {{"angle", 20.0}}}};
    other.line_sets[0].kinds = {{"crease", {{"angle", 60.0}}}, {"contour", {}}};
    other.paper.scale = 3.0;
    EXPECT_EQ(mix(one, other, 0.0), one);
    EXPECT_EQ(mix(one, other, 1.0), other);
    EXPECT_EQ(mix(one, one, 0.3), one);
    const Style mixed = mix(one, other, 0.25);
    EXPECT_EQ(mixed.paper.scale, 1.5);
    ASSERT_EQ(mixed.line_sets.size(), 2u);
    EXPECT_EQ(mixed.line_sets[0].kinds[0].second[0].second, 30.0);
    EXPECT_EQ(mixed.line_sets[1].pen.opacity, 0.25);
}

TEST(Style, EveryMemberOfARecordHasANameOfItsOwnAndADefaultThatItMayHave) {
    const auto sound = []<Record S>(const S& record) {
        std::vector<std::string> names;
        for_each_field<S>([&]<typename V>(const Field<S, V>& field) {
            EXPECT_EQ(std::ranges::count(names, std::string(field.name)), 0) << field.name;
            names.emplace_back(field.name);
            if constexpr (std::is_arithmetic_v<V> && !std::is_same_v<V, bool>) {
                EXPECT_GE(record.*field.member, field.domain.least) << field.name;
                EXPECT_LE(record.*field.member, field.domain.most) << field.name;
                EXPECT_LE(field.domain.soft_most, field.domain.most) << field.name;
            }
        });
    };
    sound(Pen());
    sound(Hidden());
    sound(LineSet());
    sound(Paper());
    sound(Color());
    sound(Elision());
    sound(Animation());
    sound(Transfer());
    sound(Effects());
    sound(Distance());
    sound(FocusPlace());
}

}  // namespace
}  // namespace fovea::style
