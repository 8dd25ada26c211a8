// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

namespace fovea::study {

/// The product of finite numbers. That of std::complex also looks for infinities, by a function of the compiler's own
/// library (native/standalone/libraries.cmake).
template <typename Real>
std::complex<Real> product(const std::complex<Real>& a, const std::complex<Real>& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace fovea::study
