// Checks records from a source that is not trusted, when they are first used (not in the paper). The bytes may change
// afterwards; the code that uses the bytes stays in bounds even then (block.hpp). A record that passes its check may
// still give a wrong surface. Therefore the code that stores records adds a checksum.
#pragma once

#include "blocks/block_records.hpp"

namespace ciel::detail {

// Throw Error, which names the block, if its record is not valid. Links to other blocks must fit `numbers`.
void check_cells(const Block& block, Index number, const BlockNumbers& numbers);
void check_around(const Block& block, const BlockAround& around, Index number, const BlockNumbers& numbers);
void check_mates(const Block& block, const BlockMates& mates, Index number, const BlockNumbers& numbers);

} // namespace ciel::detail
