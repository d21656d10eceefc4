#pragma once

#include <array>

/// Numbers that the kernels need once for each type.
namespace raylab::fast {

/// Added to a number of at most half its size, this rounds it to a whole one, and leaves that in its lowest bits.
template <class T>
inline constexpr T magic = 0x1.8p52;
template <>
inline constexpr float magic<float> = 0x1.8p23f;

/// e^-cut_off is nothing beside 1: less than a third of a rounding.
template <class T>
inline constexpr T cut_off = 38;
template <>
inline constexpr float cut_off<float> = 18;

/// log(2) in two parts: a few thousand times the first is still exact.
template <class T>
inline constexpr T log_2_high = 0x1.62e42feep-1;
template <>
inline constexpr float log_2_high<float> = 0x1.62ep-1f;
template <class T>
inline constexpr T log_2_low = 0x1.a39ef35793c76p-33;
template <>
inline constexpr float log_2_low<float> = 0x1.0bfbe8p-15f;

/// (2 atanh(s) - 2 s) / s^3 in powers of s^2, the constant first: the minimax polynomial for |s| up to 0.2, the largest that
/// is asked for, by Sollya's fpminimax(). With it the logarithm is off by 5e-19 of itself at most, in float by 9e-9, but for
/// rounding.
template <class T>
inline constexpr std::array<T, 8> atanh_polynomial = {0.6666666666666666,  0.40000000000009234, 0.2857142856688787,
                                                      0.222222230988127,   0.18181734299612953, 0.1538898418786238,
                                                      0.13207649237279442, 0.13623520647255843};
template <>
inline constexpr std::array<float, 3> atanh_polynomial<float> = {0.66666716f, 0.39978498f, 0.29969645f};

/// e^r in powers of r, the constant first: of the polynomials that begin with 1 + r the minimax one for |r| up to log(2)/2.
/// Found in the same way; off by 5e-18 of itself at most, in float by 4e-9, but for rounding.
template <class T>
inline constexpr std::array<T, 12> exponential_polynomial = {1,
                                                             1,
                                                             0.5000000000000013,
                                                             0.16666666666666496,
                                                             0.041666666666512156,
                                                             0.00833333333344191,
                                                             0.0013888888947644574,
                                                             0.00019841269618639897,
                                                             2.4801489434345362e-05,
                                                             2.75574874323254e-06,
                                                             2.7631428062931147e-07,
                                                             2.5031093056587605e-08};
template <>
inline constexpr std::array<float, 7> exponential_polynomial<float> = {
    1, 1, 0.49999988f, 0.16666518f, 0.041669652f, 0.00836895f, 0.0013745022f};

}  // namespace raylab::fast
