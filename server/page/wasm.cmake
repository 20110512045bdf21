# Debian's clang 19 with WASI's C library.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
# Static destructors are left out, because a module never exits. WASI's library also lacks the functions that destroy
# thread-local variables.
set(CMAKE_CXX_FLAGS_INIT "-fno-exceptions -fno-c++-static-destructors -msimd128")
# The stack lies before the data, so that a stack overflow traps. Behind the data, it would overwrite the data.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-mexec-model=reactor -s -Wl,--stack-first,-z,stack-size=1048576")
