// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of a line definition. Outside its file they are named numbers, which panels, style files and the command
// line read from the registry; inside they are a struct. Both are declared in one place.
#pragma once

#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <fovea/base/check.h>

namespace fovea::line {

enum class Unit { none, degrees, pixels, millimeters, boolean };  // pixels: reference pixels; millimeters: on paper

/// Where a parameter can be set: per line set only, or with per-object overrides.
enum class Per { line_set, object };

/// Declaration of a numeric parameter.
struct Parameter {
    const char* name;
    const char* label;
    double value;  ///< default
    double low, high;
    Unit unit;
    const char* meaning;
    Per per = Per::line_set;
};

/// What a file says that a definition is given. What kinds of files there are say the classes that derive from it.
struct FileContent {
    FileContent() = default;
    FileContent(const FileContent&) = delete;
    FileContent& operator=(const FileContent&) = delete;
    virtual ~FileContent() = default;
};

/// By the paths that name them.
using Files = std::map<std::string, std::shared_ptr<const FileContent>>;

/// Declaration of a file that a definition is given; without one it finds nothing.
struct FileParameter {
    const char* name;
    const char* label;
    const char* suffix;  ///< of the file's name, in lower case
    const char* meaning;
};

/// A parameter as styles have it: a number, or the path of a file.
struct ParameterValue {
    double number = 0.0;
    std::string file = {};  ///< empty: it is a number

    ParameterValue() = default;
    ParameterValue(double value) : number(value) {}
    ParameterValue(std::string path) : file(std::move(path)) {}
    bool operator==(const ParameterValue&) const = default;
};

/// Values of a definition's parameters, in order of declaration, and what its file says.
class Values : public std::vector<double> {
   public:
    using std::vector<double>::vector;

    std::shared_ptr<const FileContent> file = {};  ///< null: there is none, or it could not be read

    bool operator==(const Values&) const = default;
};

/// A parameter and the member of the definition's struct P (double, int or bool) that stores it.
template <typename P>
struct ParameterOf {
    std::variant<double P::*, int P::*, bool P::*> member;
    Parameter declared;

    ParameterOf(double P::* to, const char* name, const char* label, double value, double low, double high, Unit unit,
                const char* meaning, Per per = Per::line_set)
        : member(to), declared{name, label, value, low, high, unit, meaning, per} {}
    ParameterOf(int P::* to, const char* name, const char* label, int value, int low, int high, const char* meaning)
        : member(to), declared{name, label, double(value), double(low), double(high), Unit::none, meaning} {}
    ParameterOf(bool P::* to, const char* name, const char* label, bool value, const char* meaning)
        : member(to), declared{name, label, value ? 1.0 : 0.0, 0.0, 1.0, Unit::boolean, meaning} {}
};

/// All parameters of a definition, in order.
template <typename P>
class Parameters {
   public:
    Parameters(std::initializer_list<ParameterOf<P>> all) : all_(all) {}

    /// A copy with more parameters appended.
    Parameters with(std::initializer_list<ParameterOf<P>> more) const {
        Parameters result = *this;
        result.all_.insert(result.all_.end(), more.begin(), more.end());
        return result;
    }

    /// The declarations, as in the registry.
    operator std::vector<Parameter>() const {
        std::vector<Parameter> declared;
        for (const ParameterOf<P>& parameter : all_) declared.push_back(parameter.declared);
        return declared;
    }

    P read(const Values& values) const {
        check(values.size() == all_.size(), "a line definition with " + std::to_string(all_.size()) +
                                                " parameters was given " + std::to_string(values.size()) + " values");
        P result{};
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const auto write = [&](auto member) {
                using Number = std::remove_reference_t<decltype(result.*member)>;
                // No member is larger than the struct; for instantiations with larger types gcc would warn.
                if constexpr (sizeof(Number) <= sizeof(P)) result.*member = static_cast<Number>(values[i]);
            };
            std::visit(write, all_[i].member);
        }
        return result;
    }

    /// Adapts a function that takes a P (among other arguments) to the registry's signature, with Values in its place.
    template <typename Function>
    auto of(Function function) const {
        return [function, parameters = *this](auto&&... given) { return function(parameters.passed(given)...); };
    }

   private:
    P passed(const Values& values) const { return read(values); }
    template <typename Other>
    Other& passed(Other& other) const {
        return other;
    }

    std::vector<ParameterOf<P>> all_;
};

}  // namespace fovea::line
