# Debian's clang 19 with WASI's C library.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
# A module never exits, and the library lacks what would destroy a thread's variables there.
set(CMAKE_CXX_FLAGS_INIT "-fno-exceptions -fno-c++-static-destructors -msimd128")
# A stack that lies first traps when it overflows; behind the data it would overwrite them.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-mexec-model=reactor -s -Wl,--stack-first,-z,stack-size=1048576")
