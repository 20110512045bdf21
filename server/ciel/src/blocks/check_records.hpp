// Checks records from a source that is not trusted (not in the paper). The checks find wrong bytes when a record is
// first used. They also verify the members of a view, such as the sizes of its arrays. The bytes may change during a
// check and afterwards. The code that uses the bytes stays in bounds even then (block.hpp). A record that passes its
// check may still give a wrong surface. Only a checksum can detect such a record; the code that stores records adds a
// checksum.
#pragma once

#include "blocks/block_records.hpp"

namespace ciel {

// Throw Error with a message that names the block, if the view is not valid. `number`: index of the block. The views of
// other blocks are not needed, because links to them are compared with `numbers`.
void check_cells(const Block& block, Index number, const BlockNumbers& numbers);
void check_around(const Block& block, const BlockAround& around, Index number, const BlockNumbers& numbers);
void check_mates(const Block& block, const BlockMates& mates, Index number, const BlockNumbers& numbers);

} // namespace ciel
