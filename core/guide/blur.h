// Calming the guide before edges are sought in it.
#pragma once

#include <vector>

namespace ddt {

/// Mix every number of a width x height guide with its neighbours': `share` (0 to 1/4) of each on
/// the left and right, then of each above and below; at the rim the outermost repeat. The results
/// are multiples of 2^-12 again; what a non-finite number touches is 0.
///
/// A little of it takes single pixels' noise out of the choice of edges and moves no edge.
void blur_guide(std::vector<float>& guide, int width, int height, float share);

} // namespace ddt
