# All compiler flags of the project: warnings, architecture, OpenMP, device images, sanitizers.
#   tentpole_flags    every target links it
#   tentpole_offload  the same and the device images: only for code with target regions, which then compiles once more
#                     for each image. Executables get its link options through it or through tentpole_device.

# --- every build -----------------------------------------------------------------------------------------------------
add_library(tentpole_flags INTERFACE)
target_include_directories(tentpole_flags INTERFACE ${PROJECT_SOURCE_DIR})
# Compilers use 256-bit vectors on 512-bit machines unless told otherwise; the flag does nothing on narrower ones.
target_compile_options(tentpole_flags INTERFACE -Wall -Wextra -Wshadow -Werror
  -march=${TENTPOLE_MARCH} -mprefer-vector-width=512 -fopenmp)
target_link_options(tentpole_flags INTERFACE -fopenmp)

if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libomp.so
    OUTPUT_VARIABLE TENTPOLE_LIBOMP OUTPUT_STRIP_TRAILING_WHITESPACE)
  get_filename_component(TENTPOLE_LIBOMP ${TENTPOLE_LIBOMP} REALPATH)
  get_filename_component(TENTPOLE_LLVM_LIB ${TENTPOLE_LIBOMP} DIRECTORY)
  if(NOT EXISTS ${TENTPOLE_LLVM_LIB}/libomp.so)
    message(FATAL_ERROR "${CMAKE_CXX_COMPILER} finds no libomp.so. Install libomp-19-dev.")
  endif()
  target_link_options(tentpole_flags INTERFACE -Wl,-rpath,${TENTPOLE_LLVM_LIB})
else()
  # g++ 12 sees overlapping and oversized copies in `"text" + std::string` (GCC bugs 105651 and 105329, gone in 13), with
  # precompiled headers more often still.
  if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(tentpole_flags INTERFACE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
  target_compile_options(tentpole_flags INTERFACE -foffload=disable)
  target_link_options(tentpole_flags INTERFACE -foffload=disable)
endif()

# --- device images ---------------------------------------------------------------------------------------------------
include(${CMAKE_CURRENT_LIST_DIR}/cuda_toolkit.cmake)
add_library(tentpole_offload INTERFACE)
target_link_libraries(tentpole_offload INTERFACE tentpole_flags)

set(TENTPOLE_HAS_NVPTX OFF)
if(TENTPOLE_OFFLOAD)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "TENTPOLE_OFFLOAD needs clang++-19 (found ${CMAKE_CXX_COMPILER}). "
      "Use --preset virtual, or --preset host without devices.")
  endif()
  if(TENTPOLE_SANITIZER)
    message(FATAL_ERROR "TENTPOLE_SANITIZER=${TENTPOLE_SANITIZER} is for host builds: sanitizer calls in a device image "
      "do not link. Use --preset asan or --preset tsan.")
  endif()
  # Debian keeps the tools that pack and link device images in a package of their own that clang-19 only recommends.
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-prog-name=clang-linker-wrapper
    OUTPUT_VARIABLE linker_wrapper OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT EXISTS ${linker_wrapper} OR NOT EXISTS ${TENTPOLE_LLVM_LIB}/libomptarget.so)
    message(FATAL_ERROR "Device images need clang-linker-wrapper and ${TENTPOLE_LLVM_LIB}/libomptarget.so. "
      "Install clang-tools-19 and libomp-19-dev, or use --preset host without devices.")
  endif()

  set(images)
  if(TENTPOLE_VIRTUAL_DEVICE)
    list(APPEND images x86_64-pc-linux-gnu)
  endif()
  set(image_options)
  set(gpu_code_options)
  set(TENTPOLE_GPU_ARCH sm_90 CACHE STRING "architecture of the nvptx64 image")
  # A multiprocessor has 65536 registers: 128 keep 16 warps of a kernel resident. Local variables of a lane are its own
  # (cuda-mode): OpenMP would otherwise take them from a heap of 8 MB, which they do not fit.
  set(TENTPOLE_GPU_REGISTERS 128 CACHE STRING "registers of a GPU thread at most")
  set(gpu_runtime ${TENTPOLE_LLVM_LIB}/libomptarget-nvptx-${TENTPOLE_GPU_ARCH}.bc)
  find_program(PTXAS_PROGRAM ptxas HINTS /usr/local/cuda/bin)
  if(TENTPOLE_NVPTX AND PTXAS_PROGRAM)
    get_filename_component(cuda_program ${PTXAS_PROGRAM} REALPATH)
    get_filename_component(cuda_bin ${cuda_program} DIRECTORY)
    get_filename_component(TENTPOLE_CUDA ${cuda_bin} DIRECTORY)
    if(EXISTS ${TENTPOLE_CUDA}/nvvm/libdevice AND EXISTS ${gpu_runtime})
      set(TENTPOLE_HAS_NVPTX ON)
      tentpole_cuda_toolkit(cuda_path ${TENTPOLE_CUDA})
      list(APPEND images nvptx64-nvidia-cuda)
      # Clang warns of every toolkit newer than itself, though it only takes ptxas and libdevice from it. It looks for
      # the device runtime in LIBRARY_PATH alone, so the path is given.
      set(TENTPOLE_NVPTX_OPTIONS -Xopenmp-target=nvptx64-nvidia-cuda -march=${TENTPOLE_GPU_ARCH}
        --cuda-path=${cuda_path} -Wno-unknown-cuda-version --libomptarget-nvptx-bc-path=${gpu_runtime})
      list(APPEND image_options ${TENTPOLE_NVPTX_OPTIONS})
      set(gpu_code_options "SHELL:-fopenmp-cuda-mode -Xcuda-ptxas -maxrregcount=${TENTPOLE_GPU_REGISTERS}")
    endif()
  endif()
  if(NOT images)
    message(FATAL_ERROR "TENTPOLE_OFFLOAD needs a device image: set TENTPOLE_VIRTUAL_DEVICE=ON, or TENTPOLE_NVPTX=ON "
      "where a CUDA toolkit is (ptxas: ${PTXAS_PROGRAM}; device runtime: ${gpu_runtime}).")
  endif()
  message(STATUS "Tentpole: device images ${images}")

  list(JOIN images "," image_list)
  list(JOIN image_options " " image_options)
  set(image_flags "SHELL:-fopenmp-targets=${image_list} ${image_options}")
  target_compile_definitions(tentpole_offload INTERFACE TENTPOLE_OFFLOAD=1)
  target_compile_options(tentpole_offload INTERFACE ${image_flags} ${gpu_code_options})
  target_link_options(tentpole_offload INTERFACE ${image_flags} -L${TENTPOLE_LLVM_LIB})
endif()

# --- sanitizers ------------------------------------------------------------------------------------------------------
# TENTPOLE_TEST_ENVIRONMENT: what every test must find in its environment, at most one "NAME=value", because
# gtest_discover_tests takes lists apart.
set(TENTPOLE_TEST_ENVIRONMENT)
if(TENTPOLE_OFFLOAD)
  set(TENTPOLE_TEST_ENVIRONMENT OMP_TARGET_OFFLOAD=MANDATORY)
endif()
if(TENTPOLE_SANITIZER STREQUAL "address")
  target_compile_options(tentpole_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer)
  target_compile_definitions(tentpole_flags INTERFACE TENTPOLE_ADDRESS_SANITIZER=1)
  target_link_options(tentpole_flags INTERFACE -fsanitize=address,undefined)
  # Allocations that fail must throw as they do elsewhere, not end the program.
  set(TENTPOLE_TEST_ENVIRONMENT ASAN_OPTIONS=allocator_may_return_null=1)
elseif(TENTPOLE_SANITIZER STREQUAL "thread")
  # Archer, an OpenMP tool, tells the sanitizer what OpenMP's barriers order; without it every parallel loop looks like a
  # race. It finds the sanitizer only as a shared library, and libomp itself is not instrumented.
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libclang_rt.tsan-x86_64.so
    OUTPUT_VARIABLE sanitizer_library OUTPUT_STRIP_TRAILING_WHITESPACE)
  get_filename_component(sanitizer_folder ${sanitizer_library} DIRECTORY)
  target_compile_options(tentpole_flags INTERFACE -fsanitize=thread -g)
  target_compile_definitions(tentpole_flags INTERFACE TENTPOLE_THREAD_SANITIZER=1)
  target_link_options(tentpole_flags INTERFACE -fsanitize=thread -shared-libsan -Wl,-rpath,${sanitizer_folder})
  target_link_options(tentpole_flags INTERFACE -Wl,--no-as-needed ${TENTPOLE_LLVM_LIB}/libarcher.so)
  set(TENTPOLE_TEST_ENVIRONMENT TSAN_OPTIONS=ignore_noninstrumented_modules=1:allocator_may_return_null=1)
elseif(TENTPOLE_SANITIZER)
  message(FATAL_ERROR "TENTPOLE_SANITIZER is \"${TENTPOLE_SANITIZER}\"; it may be address, thread or empty.")
endif()
if(TENTPOLE_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "TENTPOLE_FUZZ needs clang++-19 (found ${CMAKE_CXX_COMPILER}). Use --preset fuzz.")
  endif()
  # Counters of coverage keep some loops marked "omp simd" from being vectorised, of which clang warns.
  target_compile_options(tentpole_flags INTERFACE -fsanitize=fuzzer-no-link -Wno-pass-failed)
endif()
