// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/svg_path.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include <fovea/study/thin.h>

namespace fovea::study {
namespace {

using vector::Curve;

/// Reads path data command by command.
class Reader {
   public:
    explicit Reader(std::string_view data) : left_(data) {}

    std::vector<Curve> read() {
        char command = 0;
        while (true) {
            skip();
            if (left_.empty()) break;
            if (std::isalpha(static_cast<unsigned char>(left_[0]))) {
                command = left_[0];
                left_.remove_prefix(1);
                if (command == 'z' || command == 'Z') {
                    close();
                    continue;
                }
            } else if (command == 'z' || command == 'Z' || !command) {
                break;
            }
            if (!add(command)) break;
            if (command == 'M') command = 'L';
            if (command == 'm') command = 'l';
        }
        return std::move(curves_);
    }

   private:
    void skip() {
        const std::size_t at = left_.find_first_not_of(" \t\r\n\f,");
        left_.remove_prefix(std::min(at, left_.size()));
    }

    std::optional<double> number() {
        skip();
        if (!left_.empty() && left_[0] == '+') left_.remove_prefix(1);
        double value = 0.0;
        const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), value);
        if (error != std::errc() || !(std::abs(value) < 1e9)) return std::nullopt;
        left_.remove_prefix(std::size_t(end - left_.data()));
        return value;
    }

    /// A flag of an arc: one digit, which the next number may follow without a space.
    std::optional<double> flag() {
        skip();
        if (left_.empty() || (left_[0] != '0' && left_[0] != '1')) return std::nullopt;
        const double value = left_[0] - '0';
        left_.remove_prefix(1);
        return value;
    }

    static int numbers_of(char upper) {
        switch (upper) {
            case 'M':
            case 'L':
            case 'T':
                return 2;
            case 'H':
            case 'V':
                return 1;
            case 'S':
            case 'Q':
                return 4;
            case 'C':
                return 6;
            case 'A':
                return 7;
            default:
                return 0;
        }
    }

    bool add(char command) {
        const bool is_relative = std::islower(static_cast<unsigned char>(command));
        const char upper = char(std::toupper(static_cast<unsigned char>(command)));
        const int count = numbers_of(upper);
        std::array<double, 7> n{};
        for (int i = 0; i < count; ++i) {
            const auto value = upper == 'A' && (i == 3 || i == 4) ? flag() : number();
            if (!value) return false;
            n[std::size_t(i)] = *value;
        }
        if (!count || (curves_.empty() && upper != 'M')) return false;
        const dvec2 from = is_relative ? at_ : dvec2(0.0);
        const dvec2 a = from + dvec2(n[0], n[1]), b = from + dvec2(n[2], n[3]), c = from + dvec2(n[4], n[5]);
        // The control point that smooth commands go on from.
        const dvec2 cubic = 2.0 * at_ - (before_ == 'C' || before_ == 'S' ? control_ : at_);
        const dvec2 quadratic = 2.0 * at_ - (before_ == 'Q' || before_ == 'T' ? control_ : at_);
        switch (upper) {
            case 'M':
                move(a);
                break;
            case 'L':
                line(a);
                break;
            case 'H':
                line({from.x + n[0], at_.y});
                break;
            case 'V':
                line({at_.x, from.y + n[0]});
                break;
            case 'C':
                curve(a, b, c);
                break;
            case 'S':
                curve(cubic, a, b);
                break;
            case 'Q':
                bow(a, b);
                break;
            case 'T':
                bow(quadratic, a);
                break;
            default:
                arc({n[0], n[1]}, n[2], n[3] != 0.0, n[4] != 0.0, from + dvec2(n[5], n[6]));
        }
        before_ = upper;
        return true;
    }

    Curve& open() {
        if (curves_.back().closed) move(at_);
        return curves_.back();
    }

    void move(const dvec2& to) {
        curves_.emplace_back().points.push_back(to);
        at_ = to;
    }

    void line(const dvec2& to) {
        open().line_to(to);
        at_ = to;
    }

    void curve(const dvec2& a, const dvec2& b, const dvec2& to) {
        open().cubic_to(a, b, to);
        control_ = b, at_ = to;
    }

    void bow(const dvec2& control, const dvec2& to) {
        curve(at_ + 2.0 / 3.0 * (control - at_), to + 2.0 / 3.0 * (control - to), to);
        control_ = control;
    }

    /// SVG 1.1, appendix F.6: from ends to the center, then in parts of a quarter turn at most.
    void arc(dvec2 radii, double degrees, bool is_large, bool is_positive, const dvec2& to) {
        radii = glm::abs(radii);
        if (radii.x == 0.0 || radii.y == 0.0 || to == at_) return line(to);
        const double turn = degrees * std::numbers::pi / 180.0, c = std::cos(turn), s = std::sin(turn);
        const auto unturned = [&](const dvec2& p) { return dvec2(c * p.x + s * p.y, c * p.y - s * p.x); };
        const auto turned = [&](const dvec2& p) { return dvec2(c * p.x - s * p.y, s * p.x + c * p.y); };
        const dvec2 half = unturned(0.5 * (at_ - to));
        const double over = glm::dot(half / radii, half / radii);
        if (over > 1.0) radii *= std::sqrt(over);
        const double far =
            std::sqrt(std::max(0.0, 1.0 / std::min(over, 1.0) - 1.0)) * (is_large == is_positive ? -1 : 1);
        const dvec2 middle = far * dvec2(radii.x * half.y / radii.y, -radii.y * half.x / radii.x);
        const dvec2 center = turned(middle) + 0.5 * (at_ + to);
        const auto angle = [&](const dvec2& p) { return std::atan2(p.y / radii.y, p.x / radii.x); };
        const double first = angle(half - middle);
        double sweep = angle(-half - middle) - first;
        if (is_positive && sweep < 0.0) sweep += 2.0 * std::numbers::pi;
        if (!is_positive && sweep > 0.0) sweep -= 2.0 * std::numbers::pi;
        const int parts = std::max(1, int(std::ceil(std::abs(sweep) / (0.5 * std::numbers::pi) - 1e-9)));
        const double step = sweep / parts, handle = 4.0 / 3.0 * std::tan(0.25 * step);
        for (int i = 0; i < parts; ++i) {
            const double t = first + i * step, u = t + step;
            const auto place = [&](double x, double y) { return center + turned(radii * dvec2(x, y)); };
            const dvec2 a = place(std::cos(t) - handle * std::sin(t), std::sin(t) + handle * std::cos(t));
            const dvec2 b = place(std::cos(u) + handle * std::sin(u), std::sin(u) - handle * std::cos(u));
            curve(a, b, i + 1 == parts ? to : place(std::cos(u), std::sin(u)));
        }
    }

    void close() {
        before_ = 'Z';
        if (curves_.empty() || curves_.back().closed) return;
        if (at_ != curves_.back().start()) line(curves_.back().start());
        curves_.back().closed = true;
    }

    std::string_view left_;
    std::vector<Curve> curves_;
    dvec2 at_{0.0}, control_{0.0};
    char before_ = 0;
};

/// Sets the pixels whose centers are inside of closed polylines (nonzero winding).
void fill(const std::vector<vector::Points>& outlines, Bitmap& bitmap) {
    double low = bitmap.height, high = 0.0;
    for (const auto& outline : outlines)
        for (const dvec2& p : outline) low = std::min(low, p.y), high = std::max(high, p.y);
    struct Crossing {
        double x;
        int turn;
    };
    std::vector<Crossing> crossings;
    for (int y = std::max(0, int(low)); y < std::min(double(bitmap.height), std::ceil(high)); ++y) {
        const double level = y + 0.5;
        crossings.clear();
        for (const auto& outline : outlines)
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const dvec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
                if ((a.y <= level) == (b.y <= level)) continue;
                crossings.push_back({a.x + (level - a.y) / (b.y - a.y) * (b.x - a.x), a.y < b.y ? 1 : -1});
            }
        std::ranges::sort(crossings, {}, &Crossing::x);
        int winding = 0;
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            winding += crossings[i].turn;
            if (!winding) continue;
            const int first = std::max(0, int(std::ceil(crossings[i].x - 0.5)));
            const int end = int(std::min(double(bitmap.width), std::ceil(crossings[i + 1].x - 0.5)));
            for (int x = first; x < end; ++x)
                bitmap.set[std::size_t(y) * std::size_t(bitmap.width) + std::size_t(x)] = 1;
        }
    }
}

void draw(const std::vector<vector::Points>& lines, Bitmap& bitmap) {
    std::vector<vec2> px;
    std::vector<std::int64_t> offsets{0};
    for (const auto& line : lines) {
        px.insert(px.end(), line.begin(), line.end());
        offsets.push_back(std::int64_t(px.size()));
    }
    const Bitmap drawn = pixels_of(px, offsets, bitmap.width, bitmap.height);
    for (std::size_t i = 0; i < drawn.set.size(); ++i) bitmap.set[i] |= drawn.set[i];
}

/// The polylines of a path in pixels from the lower left corner.
std::vector<vector::Points> flat(const SvgPath& path, int height) {
    std::vector<vector::Points> lines;
    const auto& m = path.transform;
    for (Curve& curve : curves_of(path.data)) {
        for (dvec2& p : curve.points) p = {m[0] * p.x + m[2] * p.y + m[4], height - (m[1] * p.x + m[3] * p.y + m[5])};
        const auto near = [](const dvec2& p) { return std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6; };
        if (std::ranges::all_of(curve.points, near)) lines.push_back(vector::flattened(curve, 0.1));
    }
    return lines;
}

}  // namespace

std::vector<Curve> curves_of(std::string_view data) { return Reader(data).read(); }

Bitmap pixels_of_svg(const std::vector<SvgPath>& paths, int width, int height) {
    Bitmap lines(width, height), areas(width, height);
    std::vector<vector::Points> drawn, outlines;
    for (const SvgPath& path : paths) {
        std::vector<vector::Points> found = flat(path, height);
        if (path.is_filled) fill(found, areas);
        auto& all = path.is_filled ? outlines : drawn;
        all.insert(all.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
    }
    draw(outlines, areas);  // areas may be narrower than pixels
    draw(drawn, lines);
    areas = thinned(std::move(areas));
    for (std::size_t i = 0; i < lines.set.size(); ++i) lines.set[i] |= areas.set[i];
    return lines;
}

}  // namespace fovea::study
