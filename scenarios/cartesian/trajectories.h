// Where the targets of Lee & Jeong 1998, Tables 1 and 2, are. The printed tables contradict the
// text; what is taken instead, and why:
//
// - Target 2 starts at y = -1.0 km. As printed it starts where target 1 does and they part at
//   once; with the minus they cross in the origin after 20 s, half-way.
// - Targets 5 and 6 fly 0.4 km/s. With the 4 km/s printed they leave the area within 5 s.
// - Target 8 turns by 30 degrees to the right at 20 m/s^2 from 10 s on, which takes 6.5 s, and
// flies
//   straight before and after. Table 2 does not say to which side: to the left it would cut the
//   path of target 7, 0.1 km away, and leave the area.
// - Target 9 gains 10 m/s^2 along its velocity from 1 to 35 s.
#pragma once

#include <vector>

#include "scenarios/spec.h"
#include "scenarios/world/scene.h"

namespace mda {

/// Numbers in Table 1, ascending, of the targets that there are.
[[nodiscard]] std::vector<int> target_numbers(PositionScene scene);

/// Whether Table 2 has a target of that number.
[[nodiscard]] bool manoeuvres(int number);

/// True states of the targets of a scene in the order of their numbers. Before time 0 they fly as
/// they do then. Exact (straight lines, a circle, a parabola). O(targets).
[[nodiscard]] std::vector<TargetState> true_states(const PositionTargets& targets, double time_s);

}  // namespace mda
