// Checks of records that come from outside (not in the paper). After them, cuts, gradients and the six operators stay
// in bounds and end, whatever the bytes are. A wrong record may still give a wrong surface: its checksum is to find
// that.
#pragma once

#include "blocks/block_records.hpp"

namespace ciel {

// Throw Error, which names the block, if the view breaks a rule. `number`: that of the block. The views of other blocks
// are not needed: links to them are compared with `numbers`.
void check_cells(const Block& block, Index number, const BlockNumbers& numbers);
void check_around(const Block& block, const BlockAround& around, Index number, const BlockNumbers& numbers);
void check_mates(const Block& block, const BlockMates& mates, Index number, const BlockNumbers& numbers);

} // namespace ciel
