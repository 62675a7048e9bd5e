# tentpole_cuda_toolkit(RESULT TOOLKIT): the CUDA toolkit that clang shall link images with. LLVM's offload runtime before
# 22 passes over images in the layout that CUDA 13 introduced, so that these get a view of the toolkit, in the build folder, whose
# nvlink writes the layout of CUDA 12.
function(tentpole_cuda_toolkit result toolkit)
  set(${result} ${toolkit} PARENT_SCOPE)
  execute_process(COMMAND ${toolkit}/bin/ptxas --version OUTPUT_VARIABLE version ERROR_QUIET)
  if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 22 OR NOT version MATCHES "release ([0-9]+)" OR CMAKE_MATCH_1 LESS 13)
    return()
  endif()
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(view ${PROJECT_BINARY_DIR}/cuda)
  file(REMOVE_RECURSE ${view})
  file(MAKE_DIRECTORY ${view}/bin)
  file(GLOB entries ${toolkit}/* ${toolkit}/bin/*)
  list(REMOVE_ITEM entries ${toolkit}/bin ${toolkit}/bin/nvlink)
  foreach(entry ${entries})
    string(REPLACE ${toolkit} ${view} link ${entry})
    file(CREATE_LINK ${entry} ${link} SYMBOLIC)
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/device/nvlink.in ${view}/bin/nvlink @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  set(${result} ${view} PARENT_SCOPE)
endfunction()
