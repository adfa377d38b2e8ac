#pragma once

#include <array>
#include <vector>

/// What was measured in test 2 of SPHERIC: the file test_case_2_exp_data.dat of its release, of one
/// sample each millisecond. Its columns H1 and H3 are swapped: the first to rise is that next to
/// the gate.
namespace sabo::spheric2_measured {

// Means over 20 ms, centred on 0.36 s and every 20 ms from there, Pa.
inline constexpr double pressure_start = 0.36, pressure_step = 0.02;  // s
inline const std::vector<double> measured_p1{-23,  -17,  5936, 9657, 8543, 7772, 7004, 6563, 6455,
                                             5986, 5628, 5193, 4817, 4460, 4108, 4042, 4058, 3959,
                                             3827, 3775, 3753, 3585, 3631, 3511, 3337, 3516, 3553,
                                             3490, 3488, 3076, 3087, 3121, 2846};
inline const std::vector<double> measured_p3{-49,  -48,  -53,  959,  5443, 6310, 5762, 5239, 5311,
                                             5115, 4934, 4554, 4167, 3895, 3679, 3608, 3598, 3653,
                                             3696, 3771, 3755, 3715, 3666, 3582, 3576, 3728, 3680,
                                             3567, 3465, 3345, 3288, 3270, 3118};
// Means over 50 ms, centred on 0 s and every 0.1 s from there, m.
inline constexpr double height_step = 0.1;  // s
inline const std::vector<double> measured_h1{0.000, 0.000, 0.012, 0.071, 0.099, 0.097, 0.114, 0.124,
                                             0.136, 0.147, 0.155, 0.159, 0.157, 0.156, 0.150, 0.144,
                                             0.138, 0.132, 0.125, 0.140, 0.145, 0.249, 0.292, 0.290,
                                             0.248, 0.269, 0.250, 0.235, 0.240, 0.242, 0.236};
inline const std::vector<double> measured_h2{0.001, 0.001, 0.001, 0.001, 0.046, 0.098, 0.120, 0.131,
                                             0.148, 0.166, 0.180, 0.187, 0.196, 0.206, 0.200, 0.238,
                                             0.253, 0.311, 0.332, 0.294, 0.286, 0.297, 0.293, 0.292,
                                             0.305, 0.281, 0.262, 0.241, 0.227, 0.213, 0.203};
inline const std::vector<double> measured_h3{0.000, 0.000, 0.000, 0.001, 0.001, 0.001, 0.001, 0.001,
                                             0.002, 0.006, 0.137, 0.185, 0.197, 0.318, 0.307, 0.336,
                                             0.392, 0.357, 0.298, 0.295, 0.290, 0.295, 0.294, 0.293,
                                             0.322, 0.322, 0.302, 0.268, 0.241, 0.233, 0.229};
inline const std::vector<double> measured_h4{0.547, 0.534, 0.511, 0.487, 0.459, 0.427, 0.395, 0.363,
                                             0.332, 0.303, 0.279, 0.254, 0.233, 0.214, 0.197, 0.182,
                                             0.170, 0.159, 0.148, 0.138, 0.130, 0.125, 0.118, 0.113,
                                             0.108, 0.104, 0.112, 0.124, 0.212, 0.200, 0.202};
// Of the samples themselves, one each millisecond.
// P1 passes a quarter of its highest value.
inline constexpr double p1_quarter = 2810, p1_arrival = 0.395;  // Pa, s
inline constexpr double p1_peak = 9862, p3_peak = 6320;         // Pa, greatest means over 20 ms
inline constexpr double p1_impulse = 2859, p3_impulse = 2357;   // Pa s, over 0.4-1.0 s
inline constexpr std::array face_means{4092.0, 3835.0, 3873.0, 3324.0};  // Pa, over 0.5-1.0 s

}  // namespace sabo::spheric2_measured
