// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/dxf.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <fovea/vector/text.h>

namespace fovea::vector {
namespace {

constexpr std::size_t longest_name = 200;  // of at most 255 characters with what is added to it

constexpr int weights[] = {5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50, 53,
                           60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};  // 1/100 mm

int weight_of(double width) {
    const int wanted = int(std::lround(100.0 * std::clamp(width, 0.0, 3.0)));
    return *std::ranges::min_element(weights, {}, [&](int weight) { return std::abs(weight - wanted); });
}

/// A name of a layer, or the beginning of a long one: letters and digits of English, others as underscores.
std::string layer_name(const std::string& label) {
    std::string name;
    for (const char c : label) {
        const bool lower = c >= 'a' && c <= 'z', plain = lower || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (static_cast<unsigned char>(c) >= 0x80 && static_cast<unsigned char>(c) < 0xc0) continue;
        name += lower ? char(c - 'a' + 'A') : plain || c == '-' ? c : '_';
    }
    return name.substr(0, longest_name);
}

class DxfWriter {
   public:
    explicit DxfWriter(const Document& document) : document_(document) {}

    std::string write() {
        for (const Layer& layer : document_.layers) add(layer, "");
        std::string entities = std::move(out_);
        out_.clear();
        tables();
        blocks();
        std::string before = std::move(out_);
        out_.clear();
        header();
        out_ += before;
        section("ENTITIES");
        out_ += entities;
        end_section();
        objects();
        pair(0, "EOF");
        return std::move(out_);
    }

   private:
    void pair(int code, const std::string& value) { out_ += std::to_string(code) + "\n" + value + "\n"; }
    void pair(int code, int value) { pair(code, std::to_string(value)); }
    void point(const dvec2& p) {
        pair(10, number(p.x));
        pair(20, number(p.y));
    }
    void section(const char* name) {
        pair(0, "SECTION");
        pair(2, name);
    }
    void end_section() { pair(0, "ENDSEC"); }
    std::string handle(int value) const { return hexadecimal(std::uint64_t(value)).substr(8); }
    std::string next_handle() { return handle(handle_++); }

    void header() {
        section("HEADER");
        const auto variable = [&](const char* name, int code, const std::string& value) {
            pair(9, name);
            pair(code, value);
        };
        variable("$ACADVER", 1, "AC1015");
        variable("$HANDSEED", 5, handle(handle_));
        variable("$INSUNITS", 70, document_.in_pixels ? "0" : "4");
        variable("$MEASUREMENT", 70, "1");
        variable("$LWDISPLAY", 290, "1");
        pair(9, "$EXTMIN");
        point(dvec2(0.0));
        pair(9, "$EXTMAX");
        point(document_.size);
        end_section();
        section("CLASSES");
        end_section();
    }

    /// Begins an entry of a table.
    void record(const char* kind, const std::string& own, const std::string& owner, const char* subclass) {
        pair(0, kind);
        pair(5, own);
        pair(330, owner);
        pair(100, "AcDbSymbolTableRecord");
        pair(100, subclass);
    }

    void table(const char* name, int own, int count) {
        pair(0, "TABLE");
        pair(2, name);
        pair(5, handle(own));
        pair(330, "0");
        pair(100, "AcDbSymbolTable");
        pair(70, count);
    }
    void end_table() { pair(0, "ENDTAB"); }

    void tables() {
        section("TABLES");
        table("VPORT", 1, 0);
        end_table();
        line_types();
        table("LAYER", 3, int(layers_.size()) + 1);
        layer("0", 25);
        for (const auto& [name, weight] : layers_) layer(name, weight);
        end_table();
        text_styles();
        for (const auto& [name, own] : {std::pair("VIEW", 5), std::pair("UCS", 6)}) {
            table(name, own, 0);
            end_table();
        }
        table("APPID", 7, 1);
        record("APPID", next_handle(), handle(7), "AcDbRegAppTableRecord");
        pair(2, "ACAD");
        pair(70, 0);
        end_table();
        table("DIMSTYLE", 8, 0);
        pair(100, "AcDbDimStyleTable");
        end_table();
        block_records();
        end_section();
    }

    void line_types() {
        table("LTYPE", 2, 3);
        for (const char* name : {"ByBlock", "ByLayer", "Continuous"}) {
            record("LTYPE", next_handle(), handle(2), "AcDbLinetypeTableRecord");
            pair(2, name);
            pair(70, 0);
            pair(3, "");
            pair(72, 65);
            pair(73, 0);
            pair(40, "0");
        }
        end_table();
    }

    void text_styles() {
        table("STYLE", 4, has_text_ ? 2 : 1);
        text_style("Standard", "txt");
        if (has_text_) text_style(sans_serif, "arial.ttf");
        end_table();
    }

    void text_style(const char* name, const char* font) {
        record("STYLE", next_handle(), handle(4), "AcDbTextStyleTableRecord");
        pair(2, name);
        pair(70, 0);
        for (const int code : {40, 50, 71, 42}) pair(code, code == 42 ? 1 : 0);
        pair(41, 1);
        pair(3, font);
        pair(4, "");
    }

    void block_records() {
        table("BLOCK_RECORD", 9, 2);
        for (const auto& [name, own] :
             {std::pair("*Model_Space", model_space), std::pair("*Paper_Space", paper_space)}) {
            record("BLOCK_RECORD", handle(own), handle(9), "AcDbBlockTableRecord");
            pair(2, name);
            pair(340, "0");
        }
        end_table();
    }

    void layer(const std::string& name, int weight) {
        record("LAYER", next_handle(), handle(3), "AcDbLayerTableRecord");
        pair(2, name);
        pair(70, 0);
        pair(62, 7);
        pair(6, "Continuous");
        pair(370, weight);
        pair(390, "0");
    }

    void blocks() {
        section("BLOCKS");
        for (const auto& [name, owner] :
             {std::pair("*Model_Space", model_space), std::pair("*Paper_Space", paper_space)}) {
            entity("BLOCK", handle(owner), "0", "AcDbBlockBegin");
            pair(2, name);
            pair(70, 0);
            point(dvec2(0.0));
            pair(30, "0");
            pair(3, name);
            pair(1, "");
            entity("ENDBLK", handle(owner), "0", "AcDbBlockEnd");
        }
        end_section();
    }

    void objects() {
        section("OBJECTS");
        const auto dictionary = [&](int own, const std::string& owner) {
            pair(0, "DICTIONARY");
            pair(5, handle(own));
            pair(330, owner);
            pair(100, "AcDbDictionary");
            pair(281, 1);
        };
        dictionary(root, "0");
        pair(3, "ACAD_GROUP");
        pair(350, handle(groups));
        dictionary(groups, handle(root));
        end_section();
    }

    void entity(const char* kind, const std::string& owner, const std::string& layer, const char* subclass) {
        pair(0, kind);
        pair(5, next_handle());
        pair(330, owner);
        pair(100, "AcDbEntity");
        pair(8, layer);
        pair(100, subclass);
    }

    void add(const Layer& layer, const std::string& outer) {
        const std::string label =
            layer_name(layer.line_set.empty() || !layer.paths.empty() ? layer.label : layer.line_set);
        const std::string wanted = outer.empty() ? label : outer + "_" + label;
        for (const Layer& inner : layer.layers) add(inner, wanted);
        if (layer.paths.empty()) return;
        std::string name = wanted;
        for (int k = 2; !names_.insert(name).second; ++k) name = wanted + "_" + std::to_string(k);
        double width = 0.0;
        for (const Path& path : layer.paths) width = std::max(width, path.look.width);
        const int weight = weight_of(document_.in_pixels ? 0.25 : width);
        layers_.emplace_back(name, weight);
        for (const Path& path : layer.paths)
            for (const Curve& curve : path.curves) add(curve, name);
        for (const Caption& caption : layer.captions) add(caption, name);
    }

    void add(const Caption& caption, const std::string& layer) {
        has_text_ = true;
        entity("TEXT", handle(model_space), layer, "AcDbText");
        point(caption.place);
        pair(30, "0");
        pair(40, number(capitals * caption.size));
        pair(1, dxf_text(caption.text));
        pair(7, sans_serif);
        pair(100, "AcDbText");
    }

    void add(const Curve& curve, const std::string& layer) {
        if (std::ranges::find(curve.cubic, 1) == curve.cubic.end())
            polyline(curve, layer);
        else
            spline(curve, layer);
    }

    void polyline(const Curve& curve, const std::string& layer) {
        entity("LWPOLYLINE", handle(model_space), layer, "AcDbPolyline");
        const std::size_t count = curve.points.size() - std::size_t(curve.closed);
        pair(90, int(count));
        pair(70, curve.closed ? 1 : 0);
        pair(43, "0");
        for (std::size_t i = 0; i < count; ++i) point(curve.points[i]);
    }

    /// Cubics one after the other: inner knots three times.
    void spline(const Curve& curve, const std::string& layer) {
        entity("SPLINE", handle(model_space), layer, "AcDbSpline");
        const int segments = int(curve.cubic.size());
        pair(70, curve.closed ? 9 : 8);
        pair(71, 3);
        pair(72, 3 * segments + 5);
        pair(73, 3 * segments + 1);
        pair(74, 0);
        for (int k = 0; k <= segments; ++k)
            for (int copy = 0; copy < (k == 0 || k == segments ? 4 : 3); ++copy) pair(40, k);
        const auto control = [&](const dvec2& p) {
            point(p);
            pair(30, "0");
        };
        control(curve.start());
        for_each_segment(curve, [&](const dvec2* p, bool cubic) {
            control(cubic ? p[1] : glm::mix(p[0], p[1], 1.0 / 3.0));
            control(cubic ? p[2] : glm::mix(p[0], p[1], 2.0 / 3.0));
            control(p[cubic ? 3 : 1]);
        });
    }

    static constexpr const char* sans_serif = "SansSerif";
    static constexpr int model_space = 16, paper_space = 17, root = 18, groups = 19;  // handles

    const Document& document_;
    std::string out_;
    int handle_ = 32;
    std::vector<std::pair<std::string, int>> layers_;  // name, weight
    std::set<std::string> names_;
    bool has_text_ = false;
};

}  // namespace

std::string dxf_bytes(const Document& document) { return DxfWriter(document).write(); }

}  // namespace fovea::vector
