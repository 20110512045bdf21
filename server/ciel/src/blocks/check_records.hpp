// Checks of records that come from outside (not in the paper). They find bytes that are wrong when a record is first
// used, and verify the members of a view, such as the sizes of its arrays. The bytes may change during a check and
// afterwards; the code that uses them allows for that (block.hpp). A record that passes its check may still give a
// wrong surface. Only a checksum finds such a record; the code that stores records adds one.
#pragma once

#include "blocks/block_records.hpp"

namespace ciel {

// Throw Error, which names the block, if the view breaks a rule. `number`: index of the block. The views of other
// blocks are not needed, because links to them are compared with `numbers`.
void check_cells(const Block& block, Index number, const BlockNumbers& numbers);
void check_around(const Block& block, const BlockAround& around, Index number, const BlockNumbers& numbers);
void check_mates(const Block& block, const BlockMates& mates, Index number, const BlockNumbers& numbers);

} // namespace ciel
