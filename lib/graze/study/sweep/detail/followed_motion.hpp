// Follows a motion until it settles, and longer while it comes nearer to a repetition: slightly
// damped modes take thousands of forcing periods, which are wasted on a motion that never repeats.
#pragma once

#include "graze/orbit/search/settled.hpp"

namespace graze {

// Settles from `start` by `options`. A motion that has not repeated by then is followed further
// while it comes nearer to repeating every 1 .. `longest_period` forcing periods, up to about
// `most_periods` in all.
SettledMotion follow_while_nearing(const System& system, const State& start, SettleOptions options,
                                   int longest_period, long long most_periods);

// Whether the last periods of an unsettled motion come nearer to a repetition: the largest
// difference of states one repetition apart falls from each quarter of the states to the next.
bool is_nearing(const System& system, const SettledMotion& motion, int longest_period);

}  // namespace graze
