#pragma once

#include <array>

/// Numbers that the kernels need once for each type.
namespace raylab::fast {

/// Added to a number of at most half its size, this rounds it to a whole one, and leaves that in its lowest bits.
template <class T>
inline constexpr T magic = 0x1.8p52;
template <>
inline constexpr float magic<float> = 0x1.8p23f;

/// e^-cut_off is nothing beside 1.
template <class T>
inline constexpr T cut_off = 80;
template <>
inline constexpr float cut_off<float> = 32;

/// log(2) in two parts: a few thousand times the first is still exact.
template <class T>
inline constexpr T log_2_high = 0x1.62e42feep-1;
template <>
inline constexpr float log_2_high<float> = 0x1.62ep-1f;
template <class T>
inline constexpr T log_2_low = 0x1.a39ef35793c76p-33;
template <>
inline constexpr float log_2_low<float> = 0x1.0bfbe8p-15f;

/// (2 atanh(s) - 2 s) / s^3 in powers of s^2, from the highest: 2/(2k + 1) for k down to 1. As far as it counts at
/// s = 0.2, the largest that is asked for.
template <class T>
inline constexpr std::array<T, 10> atanh_series = {2. / 21, 2. / 19, 2. / 17, 2. / 15, 2. / 13,
                                                   2. / 11, 2. / 9,  2. / 7,  2. / 5,  2. / 3};
template <>
inline constexpr std::array<float, 5> atanh_series<float> = {2.f / 11, 2.f / 9, 2.f / 7, 2.f / 5, 2.f / 3};

/// e^r in powers of r, from the highest: 1/k!. As far as it counts at r = log(2)/2.
template <class T>
inline constexpr std::array<T, 14> exponential_series = {
    1. / 6227020800, 1. / 479001600, 1. / 39916800, 1. / 3628800, 1. / 362880, 1. / 40320, 1. / 5040,
    1. / 720,        1. / 120,       1. / 24,       1. / 6,       1. / 2,      1.,         1.};
template <>
inline constexpr std::array<float, 8> exponential_series<float> = {1.f / 5040, 1.f / 720, 1.f / 120, 1.f / 24,
                                                                   1.f / 6,    1.f / 2,   1.f,       1.f};

}  // namespace raylab::fast
