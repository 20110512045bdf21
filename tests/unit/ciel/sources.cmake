# tests/wasm/cross builds the same tests for other machines.
set(kernel_tests
  assemble_test.cpp block_cuts_test.cpp cell_winding_test.cpp contour_options_test.cpp extract_test.cpp mesh_test.cpp
  meshes.cpp ownership_test.cpp parallel_test.cpp topology_test.cpp)
