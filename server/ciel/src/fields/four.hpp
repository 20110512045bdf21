// Four numbers in one object, and arithmetic on each of the four. Four is a vector type of GCC and Clang or, with
// CIEL_PLAIN_VECTORS, a struct for compilers without vector types. The results have the same bits. Not in the paper.
#pragma once

#include "ciel/vectors.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace ciel::detail {

// Overloads for double, so that templates over the number type serve one cell and four cells.

[[nodiscard]] inline double absolute(double a) { return std::abs(a); }
// Returns 1 / a where a > limit, else 0.
[[nodiscard]] inline double inverse_if_above(double a, double limit) { return a > limit ? 1.0 / a : 0.0; }

#ifndef CIEL_PLAIN_VECTORS

// An operation takes at most two instructions on any x86-64 or arm64.
using Four = double __attribute__((vector_size(32)));
using FourFloats = float __attribute__((vector_size(16)));
using FourFlags = decltype(Four{} > Four{});

[[nodiscard]] inline Four absolute(const Four& a) { return a < 0.0 ? -a : a; }
[[nodiscard]] inline Four inverse_if_above(const Four& a, const Four& limit) { return a > limit ? 1.0 / a : Four{}; }
[[nodiscard]] inline bool all(const FourFlags& flags) { return (flags[0] & flags[1] & flags[2] & flags[3]) != 0; }
[[nodiscard]] inline FourFloats to_floats(const Four& a) { return __builtin_convertvector(a, FourFloats); }

[[nodiscard]] inline Four first_three_rotated(const Four& a) { return __builtin_shufflevector(a, a, 1, 2, 0, 3); }
[[nodiscard]] inline Four last_repeated(const Four& a) { return __builtin_shufflevector(a, a, 3, 3, 3, 3); }
[[nodiscard]] inline Four even_interleaved(const Four& a, const Four& b) {
    return __builtin_shufflevector(a, b, 0, 4, 2, 6);
}
[[nodiscard]] inline Four odd_interleaved(const Four& a, const Four& b) {
    return __builtin_shufflevector(a, b, 1, 5, 3, 7);
}
[[nodiscard]] inline Four first_halves(const Four& a, const Four& b) {
    return __builtin_shufflevector(a, b, 0, 1, 4, 5);
}
[[nodiscard]] inline Four last_halves(const Four& a, const Four& b) {
    return __builtin_shufflevector(a, b, 2, 3, 6, 7);
}

#else

template <class Number>
struct FourOf {
    std::array<Number, 4> number;

    FourOf() = default; // FourOf{} has four zeros
    // Implicit: in arithmetic, a number stands for four equal numbers, as it does with vector types.
    FourOf(Number every) : number{every, every, every, every} {}
    FourOf(Number a, Number b, Number c, Number d) : number{a, b, c, d} {}
    [[nodiscard]] Number operator[](std::size_t i) const { return number[i]; }
};
using Four = FourOf<double>;
using FourFloats = FourOf<float>;
using FourFlags = FourOf<bool>;

template <class F>
[[nodiscard]] inline auto four_of(F&& f) {
    return FourOf<decltype(f(0))>(f(0), f(1), f(2), f(3));
}

[[nodiscard]] inline Four operator+(const Four& a, const Four& b) {
    return four_of([&](std::size_t i) { return a[i] + b[i]; });
}
[[nodiscard]] inline Four operator-(const Four& a, const Four& b) {
    return four_of([&](std::size_t i) { return a[i] - b[i]; });
}
[[nodiscard]] inline Four operator*(const Four& a, const Four& b) {
    return four_of([&](std::size_t i) { return a[i] * b[i]; });
}
[[nodiscard]] inline Four operator/(const Four& a, const Four& b) {
    return four_of([&](std::size_t i) { return a[i] / b[i]; });
}
[[nodiscard]] inline Four operator-(const Four& a) {
    return four_of([&](std::size_t i) { return -a[i]; });
}
inline Four& operator+=(Four& a, const Four& b) { return a = a + b; }
inline Four& operator-=(Four& a, const Four& b) { return a = a - b; }

[[nodiscard]] inline FourFlags operator>(const Four& a, const Four& b) {
    return four_of([&](std::size_t i) { return a[i] > b[i]; });
}
[[nodiscard]] inline FourFlags operator==(const Four& a, const Four& b) {
    return four_of([&](std::size_t i) { return a[i] == b[i]; });
}
[[nodiscard]] inline FourFlags operator&(const FourFlags& a, const FourFlags& b) {
    return four_of([&](std::size_t i) { return a[i] && b[i]; });
}

[[nodiscard]] inline Four absolute(const Four& a) {
    return four_of([&](std::size_t i) { return a[i] < 0.0 ? -a[i] : a[i]; });
}
[[nodiscard]] inline Four inverse_if_above(const Four& a, const Four& limit) {
    return four_of([&](std::size_t i) { return inverse_if_above(a[i], limit[i]); });
}
[[nodiscard]] inline bool all(const FourFlags& flags) { return flags[0] && flags[1] && flags[2] && flags[3]; }
[[nodiscard]] inline FourFloats to_floats(const Four& a) {
    return four_of([&](std::size_t i) { return static_cast<float>(a[i]); });
}

[[nodiscard]] inline Four first_three_rotated(const Four& a) { return {a[1], a[2], a[0], a[3]}; }
[[nodiscard]] inline Four last_repeated(const Four& a) { return {a[3], a[3], a[3], a[3]}; }
[[nodiscard]] inline Four even_interleaved(const Four& a, const Four& b) { return {a[0], b[0], a[2], b[2]}; }
[[nodiscard]] inline Four odd_interleaved(const Four& a, const Four& b) { return {a[1], b[1], a[3], b[3]}; }
[[nodiscard]] inline Four first_halves(const Four& a, const Four& b) { return {a[0], a[1], b[0], b[1]}; }
[[nodiscard]] inline Four last_halves(const Four& a, const Four& b) { return {a[2], a[3], b[2], b[3]}; }

#endif

using FourVectors = std::array<Four, 3>; // the x, y and z components of four vectors

// Without these, the overloads for four vectors would hide those for single vectors.
using ciel::cross;
using ciel::dot;

[[nodiscard]] inline FourVectors cross(const FourVectors& a, const FourVectors& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
[[nodiscard]] inline Four dot(const FourVectors& a, const FourVectors& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace ciel::detail
