// The units of the kernel that gradient_bits.cpp calls, with plain vectors in the namespace ciel_plain
// (CMakeLists.txt). They are included, because clang_tidy_due.py needs each source of server/ at most once in
// compile_commands.json.
#include "blocks/record.cpp"
#include "fields/many_gradients.cpp"
#include "fields/stretched_cells.cpp"
#include "mesh/fail.cpp"
