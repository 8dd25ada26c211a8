// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_style.h"

#include <nlohmann/json.hpp>

#include <fovea/line/registry.h>

namespace fovea::fuzz {
namespace {

using nlohmann::ordered_json;

constexpr const char* names[] = {"", "Surface 1", "Surface 2", "nobody"};
constexpr const char* attributes[] = {"", "paint", "nothing"};

/// Gives members of records values, by their declarations.
class Chooser {
   public:
    Chooser(Choices& choices, double share) : choices_(choices), share_(share) {}

    template <typename V>
    void choose(const style::Domain& domain, V& value) {
        if constexpr (style::Record<V>)
            members(value);
        else if constexpr (std::is_same_v<V, bool>)
            value = choices_.chance(0.5);
        else if constexpr (std::is_enum_v<V>)
            value = static_cast<V>(choices_.below(int(std::size(style::choices_of<V>))));
        else if constexpr (std::is_same_v<V, int>)
            value = int(std::lround(std::clamp(choices_.between(domain.least, domain.soft_most), -1e6, 1e6)));
        else if constexpr (std::is_same_v<V, double>)
            value = number(domain);
        else if constexpr (std::is_same_v<V, std::string>)
            value = text(domain.names);
        else  // dvec2, dvec3
            for (int i = 0; i < V::length(); ++i) value[i] = choices_.between(0.0, 1.0);
    }
    template <typename V>
    void choose(const style::Domain& domain, std::optional<V>& value) {
        if (choices_.chance(0.7))
            choose(domain, value.emplace());
        else
            value.reset();
    }
    template <typename V>
    void choose(const style::Domain& domain, std::vector<V>& values) {
        values.resize(std::size_t(choices_.between(1, 3)));
        for (V& value : values) choose(domain, value);
        if constexpr (std::is_same_v<V, dvec2>) std::ranges::sort(values, {}, [](const dvec2& p) { return p.x; });
    }
    void choose(const style::Domain&, std::vector<style::Unknown>&) {}
    void choose(const style::Domain&, style::Definitions& kinds) {
        kinds.clear();
        const double share = choices_.one_of({0.02, 0.05, 0.1, 0.3});
        for (const LineDefinition* definition : line_definitions())
            if (choices_.chance(share)) kinds.emplace_back(definition->name, parameters(*definition));
        if (kinds.empty()) kinds.emplace_back("contour", style::Parameters());
    }

   private:
    template <style::Record S>
    void members(S& record) {
        style::for_each_field<S>([&]<typename V>(const style::Field<S, V>& field) {
            constexpr bool always = style::Record<V> || std::is_same_v<V, style::Definitions> ||
                                    std::is_same_v<V, std::vector<style::LineSet>>;
            if (always || choices_.chance(share_)) choose(field.domain, record.*field.member);
        });
    }
    style::Parameters parameters(const LineDefinition& definition) {
        style::Parameters chosen;
        for (const Parameter& p : definition.parameters) {
            if (!choices_.chance(0.2)) continue;
            const double value = choices_.between(p.low, p.high);
            chosen.emplace_back(p.name, p.unit == line::Unit::boolean ? std::round(value) : value);
        }
        return chosen;
    }
    double number(const style::Domain& domain) {
        switch (choices_.below(12)) {
            case 0:
                return domain.least;
            case 1:
                return domain.most;
            case 2:
                return choices_.between(domain.least, domain.most);
            default:
                return choices_.between(domain.least, domain.soft_most);
        }
    }
    std::string text(style::Names of) {
        switch (of) {
            case style::Names::texture:
                return choices_.one_of(textures);
            case style::Names::paper:
                return choices_.one_of(papers);
            case style::Names::datablock:
                return choices_.one_of(names);
            case style::Names::attribute:
                return choices_.one_of(attributes);
            default:
                return "Lines";
        }
    }

    Choices& choices_;
    double share_;
};

// Changes of JSON.

ordered_json nasty(Choices& choices) {
    switch (choices.below(12)) {
        case 0:
            return nullptr;
        case 1:
            return choices.chance(0.5);
        case 2:
            return ordered_json::array();
        case 3:
            return ordered_json::object();
        case 4:
            return ordered_json::array({1, 2, 3});
        case 5:
            return choices.one_of({"", "x", "solid", "../../etc/passwd", "a\nb", "\x7f", "ä", "C:\\x"});
        case 6:
            return std::string(std::size_t(choices.one_of({100, 1000, 70000})), 'x');
        case 7:
            return choices.one_of({0, 1, -1, 2, 100, 1000000, INT_MAX, INT_MIN});
        case 8:
            return choices.size(-300.0, 300.0);
        default:
            return choices.between(-2.0, 2.0);
    }
}

/// Calls change(parent, step) for one of the values inside.
template <typename Change>
void at_some_place(Choices& choices, ordered_json& json, const Change& change) {
    ordered_json* place = &json;
    for (int depth = choices.between(1, 6); place->is_structured() && !place->empty(); --depth) {
        auto chosen = std::next(place->begin(), choices.below(int(place->size())));
        if (depth == 1 || !chosen->is_structured() || chosen->empty()) return change(*place, chosen);
        place = &*chosen;
    }
}

void change_value(Choices& choices, ordered_json& json) {
    at_some_place(choices, json, [&](ordered_json& parent, const auto& chosen) {
        switch (choices.below(5)) {
            case 0:
                parent.erase(chosen);
                break;
            case 1:
                if (parent.is_object())
                    parent[choices.one_of({"new", "", "a.b", "[0]", "widht", "kept", "width"})] = nasty(choices);
                else
                    parent.push_back(ordered_json(parent.front()));
                break;
            case 2:
                if (chosen->is_number())
                    *chosen = chosen->template get<double>() * choices.one_of({-1.0, 0.0, 1.5, 10.0, 1e6});
                break;
            default:
                *chosen = nasty(choices);
        }
    });
}

void change_text(Choices& choices, std::string& text) {
    const std::size_t at = choices.bits() % (text.size() + 1), size = choices.bits() % 12;
    constexpr char telling[] = "0123456789-+.eE\"{}[]:, \n\\\xff";  // and the zero at its end
    switch (choices.below(4)) {
        case 0:
            text.erase(at, size);
            break;
        case 1:
            text.insert(at, text.substr(at, size));
            break;
        case 2:
            text.insert(at, choices.chance(0.1) ? 2000 : 1, choices.one_of({'[', '{', '"', '1', ' '}));
            break;
        default:
            if (at < text.size()) text[at] = telling[choices.bits() % sizeof(telling)];
    }
}

}  // namespace

style::Style random_style(Choices& choices) {
    style::Style style;
    Chooser(choices, choices.one_of({0.02, 0.1, 0.3})).choose({}, style);
    return style;
}

std::string mutated(Choices& choices, const std::string& json) {
    ordered_json data = ordered_json::parse(json);
    for (int changes = choices.below(4); changes > 0; --changes) change_value(choices, data);
    std::string text = data.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    for (int changes = choices.chance(0.3) ? choices.between(1, 4) : 0; changes > 0; --changes)
        change_text(choices, text);
    return text;
}

}  // namespace fovea::fuzz
