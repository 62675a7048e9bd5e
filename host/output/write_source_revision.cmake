# cmake -D ROOT=... -D HEADER=... -P: writes a header with the revision and a digest of the sources that decide
# what the program computes. Run at every build; the file changes only when one of them does.
cmake_minimum_required(VERSION 3.21)

execute_process(COMMAND git describe --always --dirty --abbrev=12
  WORKING_DIRECTORY ${ROOT} OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT revision)
  set(revision unknown)
endif()

file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/common/* ${ROOT}/kernels/* ${ROOT}/device/* ${ROOT}/host/*)
list(FILTER sources INCLUDE REGEX "\\.(cpp|hpp|cmake|txt)$")
list(FILTER sources EXCLUDE REGEX "^host/(command_line|many_core)/")
list(SORT sources)
set(digests "")
foreach(source IN LISTS sources)
  file(SHA256 ${ROOT}/${source} digest)
  string(APPEND digests "${source} ${digest}\n")
endforeach()
string(SHA256 digest "${digests}")
string(SUBSTRING ${digest} 0 12 digest)

file(CONFIGURE OUTPUT ${HEADER} CONTENT "#pragma once

#define TENTPOLE_GIT_REVISION \"${revision}\"
#define TENTPOLE_SOURCE_DIGEST \"${digest}\"
" @ONLY)
