// Checks of records that come from outside (not in the paper). They find bytes that are wrong from the start, and make
// sure of what a view keeps in members, such as the sizes of its arrays. The bytes may change during a check and
// afterwards; what uses them is prepared for that (block.hpp). A wrong record may still give a wrong surface: its
// checksum is to find that.
#pragma once

#include "blocks/block_records.hpp"

namespace ciel {

// Throw Error, which names the block, if the view breaks a rule. `number`: that of the block. The views of other blocks
// are not needed: links to them are compared with `numbers`.
void check_cells(const Block& block, Index number, const BlockNumbers& numbers);
void check_around(const Block& block, const BlockAround& around, Index number, const BlockNumbers& numbers);
void check_mates(const Block& block, const BlockMates& mates, Index number, const BlockNumbers& numbers);

} // namespace ciel
