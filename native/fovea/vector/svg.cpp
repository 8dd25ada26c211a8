// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/svg.h>

#include <fovea/color/png.h>
#include <fovea/stroke/strip.h>
#include <fovea/vector/text.h>

namespace fovea::vector {
namespace {

void attribute(std::string& out, const char* name, const std::string& value) {
    out += ' ';
    out += name;
    out += "=\"" + value + '"';
}

std::string hex(const dvec3& color) { return hex_color(color.x, color.y, color.z); }

/// Path data with relative coordinates: differences of rounded ones, so that errors do not add up.
class Data {
   public:
    Data(double height, std::string& out) : height_(height), out_(out) {}

    void add(const Curve& curve) {
        command(first_ ? 'M' : 'm');
        place(curve.start());
        first_ = false;
        x_ = next_x_;
        y_ = next_y_;
        const std::int64_t start_x = x_, start_y = y_;
        std::size_t left = curve.cubic.size();
        for_each_segment(curve, [&](const dvec2* p, bool cubic) {
            // The last line of a closed curve is drawn by closing it.
            if (--left == 0 && curve.closed && !cubic) return;
            if (cubic) {
                command('c');
                for (int k = 1; k <= 3; ++k) place(p[k]);
            } else {
                line_to(p[1]);
            }
            x_ = next_x_;
            y_ = next_y_;
        });
        if (!curve.closed) return;
        command('z');
        x_ = start_x;
        y_ = start_y;
    }

   private:
    /// Across and upright lines are one number.
    void line_to(const dvec2& p) {
        move_next(p);
        const std::int64_t dx = next_x_ - x_, dy = next_y_ - y_;
        command(dy == 0 ? 'h' : dx == 0 ? 'v' : 'l');
        if (dx != 0 || dy == 0) coordinate(dx);
        if (dy != 0) coordinate(dy);
    }

    void command(char letter) {
        if (letter != last_ || letter == 'm' || letter == 'M') out_ += letter;
        fresh_ = letter != last_ || letter == 'm' || letter == 'M';
        last_ = letter;
    }

    /// Adds a point, relative to where the segment begins.
    void place(const dvec2& p) {
        move_next(p);
        coordinate(next_x_ - x_);
        coordinate(next_y_ - y_);
    }

    void move_next(const dvec2& p) {
        next_x_ = thousandths(p.x);
        next_y_ = thousandths(height_ - p.y);
    }

    void coordinate(std::int64_t value) {
        const std::string text = decimal(value);
        if (!fresh_ && text[0] != '-') out_ += ' ';
        out_ += text;
        fresh_ = false;
    }

    double height_;
    std::string& out_;
    std::int64_t x_ = 0, y_ = 0, next_x_ = 0, next_y_ = 0;
    char last_ = 0;
    bool first_ = true, fresh_ = true;
};

class SvgWriter {
   public:
    explicit SvgWriter(const Document& document) : document_(document) {}

    std::string write() {
        head();
        ground();
        for (const Layer& layer : document_.layers) add(layer, 1);
        out_ += "</svg>\n";
        return std::move(out_);
    }

   private:
    void head() {
        const std::string width = number(document_.size.x), height = number(document_.size.y);
        const char* unit = document_.in_pixels ? "" : "mm";
        out_ +=
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\""
            " xmlns:xlink=\"http://www.w3.org/1999/xlink\""
            " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\""
            " xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\" version=\"1.1\"";
        attribute(out_, "width", width + unit);
        attribute(out_, "height", height + unit);
        attribute(out_, "viewBox", "0 0 " + width + " " + height);
        out_ += ">\n";
    }

    void ground() {
        if (!document_.paper && !document_.image) return;
        out_ +=
            "<g id=\"paper\" inkscape:groupmode=\"layer\" inkscape:label=\"%paper\" sodipodi:insensitive=\"true\">\n";
        if (document_.paper) {
            out_ += "<rect";
            attribute(out_, "width", number(document_.size.x));
            attribute(out_, "height", number(document_.size.y));
            attribute(out_, "fill", hex(*document_.paper));
            out_ += "/>\n";
        }
        if (document_.image) {
            const Image& image = *document_.image;
            out_ += "<image";
            attribute(out_, "x", number(image.lower.x));
            attribute(out_, "y", number(document_.size.y - image.lower.y - image.size.y));
            attribute(out_, "width", number(image.size.x));
            attribute(out_, "height", number(image.size.y));
            attribute(out_, "preserveAspectRatio", "none");
            attribute(out_, "xlink:href",
                      "data:image/png;base64," +
                          base64(color::png_bytes(image.values, image.width, image.height, image.channels)));
            out_ += "/>\n";
        }
        out_ += "</g>\n";
    }

    void add(const Layer& layer, int depth) {
        out_ += "<g";
        attribute(out_, "id", layer.id);
        attribute(out_, "inkscape:groupmode", "layer");
        attribute(out_, "inkscape:label", xml(layer.label));
        if (!layer.line_set.empty()) attribute(out_, "data-line-set", xml(layer.line_set));
        if (depth == 1) {
            attribute(out_, "fill", "none");
            attribute(out_, "stroke-linejoin", "miter");
            attribute(out_, "stroke-miterlimit", number(stroke::mitre_length));
        }
        out_ += ">\n";
        for (const Path& path : layer.paths) add(path);
        for (const Caption& caption : layer.captions) add(caption);
        for (const Layer& inner : layer.layers) add(inner, depth + 1);
        out_ += "</g>\n";
    }

    void add(const Path& path) {
        out_ += "<path";
        attribute(out_, "id", path.id);
        if (!path.kind.empty()) attribute(out_, "data-kind", xml(path.kind));
        if (!path.object.empty()) attribute(out_, "data-object", xml(path.object));
        if (path.invisibility) attribute(out_, "data-invisibility", std::to_string(path.invisibility));
        add(path.look);
        out_ += " d=\"";
        Data data(document_.size.y, out_);
        for (const Curve& curve : path.curves) data.add(curve);
        out_ += "\"/>\n";
    }

    void add(const Caption& caption) {
        out_ += "<text";
        attribute(out_, "id", caption.id);
        attribute(out_, "x", number(caption.place.x));
        attribute(out_, "y", number(document_.size.y - caption.place.y));
        attribute(out_, "font-family", "Helvetica, Arial, sans-serif");
        attribute(out_, "font-size", number(caption.size));
        attribute(out_, "fill", hex(caption.color));
        out_ += ">" + xml(caption.text) + "</text>\n";
    }

    void add(const Look& look) {
        const bool filled = look.width == 0.0;
        attribute(out_, filled ? "fill" : "stroke", hex(look.color));
        if (thousandths(look.opacity) < 1000)
            attribute(out_, filled ? "fill-opacity" : "stroke-opacity", number(look.opacity));
        if (filled) return;
        attribute(out_, "stroke-width", number(look.width));
        if (look.round_caps) attribute(out_, "stroke-linecap", "round");
        if (look.round_joins) attribute(out_, "stroke-linejoin", "round");
        if (look.dashes.empty()) return;
        std::string lengths;
        for (const double length : look.dashes) lengths += (lengths.empty() ? "" : " ") + number(length);
        attribute(out_, "stroke-dasharray", lengths);
        attribute(out_, "stroke-dashoffset", number(look.dash_start));
    }

    const Document& document_;
    std::string out_;
};

}  // namespace

std::string svg_bytes(const Document& document) { return SvgWriter(document).write(); }

}  // namespace fovea::vector
