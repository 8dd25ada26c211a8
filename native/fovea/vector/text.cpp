// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/text.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace fovea::vector {
namespace {

constexpr char digits[] = "0123456789abcdef";

/// Bytes of the UTF-8 character that text begins with; 0: it begins with none, or with one that XML does not have.
std::size_t character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned first = byte(0);
    if (first < 0x80) return first >= 0x20 && first != 0x7f;
    const std::size_t size = first >= 0xc2 && first < 0xe0 ? 2 : first >= 0xe0 && first < 0xf0 ? 3 : 4;
    if (first < 0xc2 || first > 0xf4) return 0;
    for (std::size_t i = 1; i < size; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const unsigned second = byte(1);
    const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool surrogate = first == 0xed && second >= 0xa0, beyond = first == 0xf4 && second >= 0x90;
    const bool no_character = first == 0xef && second == 0xbf && byte(2) >= 0xbe;
    return overlong || surrogate || beyond || no_character ? 0 : size;
}

}  // namespace

std::int64_t thousandths(double value) { return std::llround(value * grid); }

std::string decimal(std::int64_t thousandths) {
    const std::uint64_t size = thousandths < 0 ? 0 - std::uint64_t(thousandths) : std::uint64_t(thousandths);
    std::string text = std::to_string(size / 1000);
    if (const auto rest = std::uint64_t(size % 1000)) {
        std::string part = std::to_string(1000 + rest).substr(1);
        while (part.back() == '0') part.pop_back();
        text = (text == "0" ? "." : text + ".") + part;
    }
    return thousandths < 0 ? "-" + text : text;
}

std::string number(double value) { return decimal(thousandths(value)); }

std::string hexadecimal(std::uint64_t value) {
    std::string text(16, '0');
    for (std::size_t i = 16; i-- > 0; value >>= 4) text[i] = digits[value & 15];
    return text;
}

std::string hex_color(double red, double green, double blue) {
    std::string text = "#";
    for (const double value : {red, green, blue}) {
        const auto byte = std::size_t(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
        text += {digits[byte >> 4], digits[byte & 15]};
    }
    return text;
}

std::u32string code_points(std::string_view text) {
    std::u32string found;
    while (!text.empty()) {
        const std::size_t size = character(text);
        const auto first = static_cast<unsigned char>(text[0]);
        char32_t code = size == 0 ? U'?' : size == 1 ? first : first & (0x7fu >> size);
        for (std::size_t i = 1; i < size; ++i) code = code << 6 | (static_cast<unsigned char>(text[i]) & 63u);
        found += code;
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return found;
}

std::string printable(std::string_view text) {
    std::string found;
    while (!text.empty()) {
        const std::size_t size = character(text);
        found += size ? text.substr(0, size) : "?";
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return found;
}

std::string xml(std::string_view text) {
    std::string escaped;
    for (const char letter : printable(text)) {
        switch (letter) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += letter;
        }
    }
    return escaped;
}

std::string dxf_text(std::string_view text) {
    const std::u32string codes = code_points(text);
    const auto begins = [&](std::size_t i, std::u32string_view word) {
        return codes.compare(i, word.size(), word) == 0;
    };
    std::string escaped;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        if (codes[i] >= 0x10000) {
            escaped += '?';
        } else if (codes[i] >= 0x80 || begins(i, U"\\U+") || begins(i, U"\\M+")) {
            escaped += "\\U+";
            for (const char digit : hexadecimal(codes[i]).substr(12)) escaped += char(std::toupper(digit));
        } else {
            escaped += codes[i] == U'^' ? "^ " : std::string(1, char(codes[i]));
        }
    }
    return escaped;
}

std::string base64(std::string_view bytes) {
    constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : letters[group >> (18 - 6 * k) & 63];
    }
    return text;
}

}  // namespace fovea::vector
