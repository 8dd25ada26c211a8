// SPDX-License-Identifier: GPL-3.0-or-later
// Written by hand: libraries of Debian that make PDF files (Cairo, PoDoFo, libharu) have no optional content, or bring
// fonts and encryption along, for what is here a page of paths.
#include <fovea/vector/pdf.h>

#include <algorithm>
#include <map>
#include <zlib.h>

#include <fovea/base/check.h>
#include <fovea/color/png.h>
#include <fovea/stroke/strip.h>
#include <fovea/vector/text.h>

namespace fovea::vector {
namespace {

constexpr double points_per_mm = 72.0 / 25.4, points_per_px = 0.75;

std::string compressed(const std::string& bytes) {
    uLongf size = compressBound(uLong(bytes.size()));
    std::string out(size, '\0');
    const int done = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size()), 9);
    check(done == Z_OK, "vectors: memory is too small to compress the file");
    out.resize(size);
    return out;
}

/// A text string: UTF-16, as hexadecimal digits.
std::string text_of(std::string_view utf8) {
    std::string text = "<feff";
    const auto unit = [&](std::uint32_t value) { text += hexadecimal(value).substr(12); };
    for (const char32_t code : code_points(utf8)) {
        if (code < 0x10000) {
            unit(code);
        } else {
            unit(0xd800 + ((code - 0x10000) >> 10 & 1023));
            unit(0xdc00 + ((code - 0x10000) & 1023));
        }
    }
    return text + ">";
}

/// What bytes 0x80 to 0x9f stand for in WinAnsiEncoding (PDF 1.5, appendix D), in their order; 0: nothing.
constexpr char32_t win_ansi[] = {0x20ac, 0,      0x201a, 0x192,  0x201e, 0x2026, 0x2020, 0x2021, 0x2c6,  0x2030, 0x160,
                                 0x2039, 0x152,  0,      0x17d,  0,      0,      0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
                                 0x2013, 0x2014, 0x2dc,  0x2122, 0x161,  0x203a, 0x153,  0,      0x17e,  0x178};

/// The byte of a character in WinAnsiEncoding, of a font that has Latin letters alone; 0: there is none.
std::uint32_t latin(char32_t code) {
    if (code < 0x80 || (code >= 0xa0 && code < 0x100)) return code;
    const auto* found = std::ranges::find(win_ansi, code);
    return found == std::end(win_ansi) ? 0 : 0x80 + std::uint32_t(found - win_ansi);
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[std::size_t(i)]);
    return value;
}

/// Some of the values of a picture's pixels, from number `first` on, as an image: the compressed rows of a PNG are what
/// PDF reads, too. `more`: of its dictionary.
std::string image_object(const Image& image, int first, int count, const std::string& more = "") {
    const std::size_t pixels = image.values.size() / std::size_t(image.channels);
    Array<std::uint8_t> values(std::size_t(count) * pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        for (int c = 0; c < count; ++c) values[count * i + c] = image.values[image.channels * i + first + c];
    const std::string bytes = color::png_bytes(values, image.width, image.height, count);
    const std::string_view png = bytes;
    std::string rows;
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const std::size_t size = big_endian(png.substr(at));
        if (png.substr(at + 4, 4) == "IDAT") rows += png.substr(at + 8, size);
        at += size + 12;
    }
    const std::string width = std::to_string(image.width);
    return "<< /Type /XObject /Subtype /Image /Width " + width + " /Height " + std::to_string(image.height) +
           " /ColorSpace /Device" + (count == 1 ? "Gray" : "RGB") +
           " /BitsPerComponent 8 /Filter /FlateDecode /DecodeParms << /Predictor 15 /Colors " + std::to_string(count) +
           " /Columns " + width + " >> " + more + "/Length " + std::to_string(rows.size()) + " >>\nstream\n" + rows +
           "\nendstream";
}

class PdfWriter {
   public:
    explicit PdfWriter(const Document& document) : document_(document) {}

    std::string write() {
        const double scale = document_.in_pixels ? points_per_px : points_per_mm;
        content_ = real(scale) + " 0 0 " + real(scale) + " 0 0 cm\n" + number(stroke::mitre_length) + " M\n";
        ground();
        std::string order;
        for (const Layer& layer : document_.layers) order += add(layer);
        return file(scale, order);
    }

   private:
    /// More decimals than lengths have.
    static std::string real(double value) {
        const std::int64_t millionths = std::int64_t(value * 1e6 + 0.5);
        const std::string rest = std::to_string(1000000 + millionths % 1000000).substr(1);
        return std::to_string(millionths / 1000000) + "." + rest;
    }

    void numbers(std::initializer_list<double> values) {
        for (const double value : values) content_ += number(value) + " ";
    }

    void ground() {
        if (document_.paper) {
            numbers({document_.paper->x, document_.paper->y, document_.paper->z});
            content_ += "rg 0 0 " + number(document_.size.x) + " " + number(document_.size.y) + " re f\n";
        }
        if (!document_.image) return;
        const Image& image = *document_.image;
        content_ += "q " + number(image.size.x) + " 0 0 " + number(image.size.y) + " ";
        numbers({image.lower.x, image.lower.y});
        content_ += "cm /Ground Do Q\n";
    }

    /// Adds a layer; what an order of layers says of it.
    std::string add(const Layer& layer) {
        const std::size_t number = labels_.size();
        labels_.push_back(layer.label);
        content_ += "/OC /L" + std::to_string(number) + " BDC\n";
        for (const Path& path : layer.paths) add(path);
        for (const Caption& caption : layer.captions) add(caption);
        std::string inner;
        for (const Layer& part : layer.layers) inner += add(part);
        content_ += "EMC\n";
        return reference(number) + (inner.empty() ? "" : "[ " + inner + "] ");
    }

    static std::string reference(std::size_t layer) { return std::to_string(first_layer + layer) + " 0 R "; }

    void add(const Path& path) {
        const Look& look = path.look;
        const bool filled = look.width == 0.0;
        const auto opacity = thousandths(look.opacity);
        opacities_[opacity];
        content_ += "/G" + std::to_string(opacity) + " gs ";
        numbers({look.color.x, look.color.y, look.color.z});
        content_ += filled ? "rg\n" : "RG ";
        if (!filled) {
            content_ += number(look.width) + " w " + (look.round_caps ? "1 J " : "0 J ") +
                        (look.round_joins ? "1 j [" : "0 j [");
            for (const double length : look.dashes) numbers({length});
            content_ += "] " + number(look.dash_start) + " d\n";
        }
        for (const Curve& curve : path.curves) add(curve);
        content_ += filled ? "f\n" : "S\n";
    }

    void add(const Curve& curve) {
        numbers({curve.start().x, curve.start().y});
        content_ += "m ";
        for_each_segment(curve, [&](const dvec2* p, bool cubic) {
            for (int k = 1; k <= (cubic ? 3 : 1); ++k) numbers({p[k].x, p[k].y});
            content_ += cubic ? "c " : "l ";
        });
        content_ += curve.closed ? "h\n" : "\n";
    }

    /// Letters that the font lacks are shown as question marks, and found and copied as what they are.
    void add(const Caption& caption) {
        has_text_ = true;
        std::string shown;
        bool lacks = false;
        for (const char32_t code : code_points(caption.text)) {
            const std::uint32_t byte = latin(code);
            shown += hexadecimal(byte ? byte : '?').substr(14);
            lacks |= !byte;
        }
        if (lacks) content_ += "/Span << /ActualText " + text_of(caption.text) + " >> BDC\n";
        numbers({caption.color.x, caption.color.y, caption.color.z});
        content_ += "rg BT /Text " + number(caption.size) + " Tf ";
        numbers({caption.place.x, caption.place.y});
        content_ += "Td <" + shown + "> Tj ET\n";
        if (lacks) content_ += "EMC\n";
    }

    std::string resources() const {
        std::string text = "<< /ExtGState << ";
        for (const auto& [opacity, unused] : opacities_) {
            const std::string value = decimal(opacity);
            text += "/G" + std::to_string(opacity) + " << /CA " + value + " /ca " + value + " >> ";
        }
        text += ">> /Properties << ";
        for (std::size_t i = 0; i < labels_.size(); ++i) text += "/L" + std::to_string(i) + " " + reference(i);
        if (document_.image) text += ">> /XObject << /Ground " + std::to_string(image_number) + " 0 R ";
        if (has_text_)
            text +=
                ">> /Font << /Text << /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >> ";
        return text + ">> >>";
    }

    std::string file(double scale, const std::string& order) {
        std::string all;
        for (std::size_t i = 0; i < labels_.size(); ++i) all += reference(i);
        object("<< /Type /Catalog /Pages 2 0 R /OCProperties << /OCGs [ " + all + "] /D << /Order [ " + order +
               "] /ON [ " + all + "] >> >> >>");
        object("<< /Type /Pages /Kids [ 3 0 R ] /Count 1 >>");
        object("<< /Type /Page /Parent 2 0 R /MediaBox [ 0 0 " + number(scale * document_.size.x) + " " +
               number(scale * document_.size.y) + " ] /Contents 4 0 R /Resources " + resources() + " >>");
        const std::string stream = compressed(content_);
        object("<< /Filter /FlateDecode /Length " + std::to_string(stream.size()) + " >>\nstream\n" + stream +
               "\nendstream");
        images();
        for (const std::string& label : labels_) object("<< /Type /OCG /Name " + text_of(label) + " >>");
        const std::string count = std::to_string(places_.size() + 1), start = std::to_string(out_.size());
        out_ += "xref\n0 " + count + "\n0000000000 65535 f \n";
        for (const std::size_t place : places_) out_ += std::to_string(10000000000 + place).substr(1) + " 00000 n \n";
        out_ += "trailer\n<< /Size " + count + " /Root 1 0 R >>\nstartxref\n" + start + "\n%%EOF\n";
        return std::move(out_);
    }

    /// The picture, and its alpha.
    void images() {
        const bool has_alpha = document_.image && document_.image->channels == 4;
        const std::string mask = has_alpha ? "/SMask " + std::to_string(image_number + 1) + " 0 R " : "";
        object(document_.image ? image_object(*document_.image, 0, 3, mask) : "null");
        object(has_alpha ? image_object(*document_.image, 3, 1) : "null");
    }

    void object(const std::string& body) {
        places_.push_back(out_.size());
        out_ += std::to_string(places_.size()) + " 0 obj\n" + body + "\nendobj\n";
    }

    static constexpr std::size_t image_number = 5, first_layer = 7;  // numbers of objects

    const Document& document_;
    std::string out_ = "%PDF-1.5\n%\xe2\xe3\xcf\xd3\n", content_;
    std::vector<std::string> labels_;
    std::map<std::int64_t, bool> opacities_;
    bool has_text_ = false;
    std::vector<std::size_t> places_;  // of objects
};

}  // namespace

std::string pdf_bytes(const Document& document) { return PdfWriter(document).write(); }

}  // namespace fovea::vector
