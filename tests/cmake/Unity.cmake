# Defines chasles_unity, the Unity test framework with support for double, from the first of
#   1. the source tree named by CHASLES_UNITY_DIR (cache or environment variable),
#   2. an installed package,
#   3. the Python package pytest-unity, whose source archive carries Unity, through pip,
#   4. the upstream repository, through git.
# Downloads are checked against a hash, stay in the build tree and happen once.
set(CHASLES_UNITY_DIR "$ENV{CHASLES_UNITY_DIR}" CACHE PATH "Source tree of Unity, if it is not to be downloaded")

set(unity_archive pytest_unity-0.1.0)
set(unity_archive_hash sha256:cd3ceb4aeb4f7866f935957f91874999d8ae13ff014684464ade0b7071e28298)
set(unity_repository https://github.com/ThrowTheSwitch/Unity.git)
set(unity_commit b6763fbd9cedfacaa89e2ad9fd00d615a234e355) # 2.7.0, as in the archive
set(unity_download ${PROJECT_BINARY_DIR}/unity)

# Sets `failure` to what went wrong, or to nothing.
function(run_in directory seconds failure)
  file(MAKE_DIRECTORY ${directory})
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${directory} TIMEOUT ${seconds}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0)
    set(${failure} "" PARENT_SCOPE)
  else()
    string(STRIP "${output}" output)
    string(REGEX REPLACE "\n+" "\n    " output "${output}")
    set(${failure} "${result}: ${output}" PARENT_SCOPE)
  endif()
endfunction()

function(download_unity_by_pip failure)
  file(WRITE ${unity_download}/requirements.txt "pytest-unity==0.1.0 --hash=${unity_archive_hash}\n")
  run_in(${unity_download} 300 problem
    ${Python3_EXECUTABLE} -m pip --disable-pip-version-check --quiet --retries 1 --timeout 20
    download --no-deps --no-binary pytest-unity --require-hashes --requirement requirements.txt)
  if(NOT problem)
    file(ARCHIVE_EXTRACT INPUT ${unity_download}/${unity_archive}.tar.gz DESTINATION ${unity_download})
  endif()
  set(${failure} "${problem}" PARENT_SCOPE)
endfunction()

function(download_unity_by_git failure)
  set(git ${CMAKE_COMMAND} -E env GIT_TERMINAL_PROMPT=0 git)
  foreach(arguments "init --quiet ." "fetch --quiet --depth 1 ${unity_repository} ${unity_commit}"
      "checkout --quiet ${unity_commit}")
    separate_arguments(arguments UNIX_COMMAND "${arguments}")
    run_in(${unity_download}/git 120 problem ${git} ${arguments})
    if(problem)
      break()
    endif()
  endforeach()
  set(${failure} "${problem}" PARENT_SCOPE)
endfunction()

# A cached answer is not searched for again; a missing one is, after each attempt to get it.
function(find_unity_source)
  find_path(CHASLES_UNITY_SOURCE unity.c NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH PATH_SUFFIXES src
    PATHS ${CHASLES_UNITY_DIR} ${unity_download}/${unity_archive}/vendor/unity ${unity_download}/git)
  mark_as_advanced(CHASLES_UNITY_SOURCE)
endfunction()

function(find_unity_package)
  find_package(unity CONFIG QUIET GLOBAL)
  if(NOT TARGET unity::framework)
    return()
  endif()
  set(program ${PROJECT_BINARY_DIR}/unity_double.c)
  file(WRITE ${program} [[
#include <unity.h>
void setUp(void) {}
void tearDown(void) {}
int main(void) { TEST_ASSERT_DOUBLE_WITHIN(1.0, 0.0, 0.0); return 0; }
]])
  try_compile(CHASLES_UNITY_PACKAGE ${PROJECT_BINARY_DIR}/unity_double ${program}
    COMPILE_DEFINITIONS -DUNITY_INCLUDE_DOUBLE LINK_LIBRARIES unity::framework)
endfunction()

find_unity_source()
if(CHASLES_UNITY_DIR AND NOT CHASLES_UNITY_SOURCE)
  message(FATAL_ERROR "CHASLES_UNITY_DIR is ${CHASLES_UNITY_DIR}, but there is no src/unity.c in it.")
endif()
if(NOT CHASLES_UNITY_SOURCE)
  find_unity_package()
endif()
if(NOT CHASLES_UNITY_SOURCE AND NOT CHASLES_UNITY_PACKAGE)
  message(STATUS "Downloading the test framework Unity")
  download_unity_by_pip(pip_failure)
  if(pip_failure)
    download_unity_by_git(git_failure)
  endif()
  find_unity_source()
endif()

if(CHASLES_UNITY_SOURCE)
  message(STATUS "Unity: ${CHASLES_UNITY_SOURCE}")
  add_library(chasles_unity STATIC ${CHASLES_UNITY_SOURCE}/unity.c)
  target_include_directories(chasles_unity SYSTEM PUBLIC ${CHASLES_UNITY_SOURCE})
  target_compile_definitions(chasles_unity PUBLIC UNITY_INCLUDE_DOUBLE)
  target_compile_options(chasles_unity PRIVATE -w) # its warnings are not ours to mend
elseif(CHASLES_UNITY_PACKAGE)
  message(STATUS "Unity: installed package in ${unity_DIR}")
  add_library(chasles_unity INTERFACE)
  target_link_libraries(chasles_unity INTERFACE unity::framework)
  target_compile_definitions(chasles_unity INTERFACE UNITY_INCLUDE_DOUBLE)
else()
  message(FATAL_ERROR
    "The tests need the test framework Unity 2.7.0, which is not installed and could not be downloaded.\n"
    "  pip ended with ${pip_failure}\n"
    "  git ended with ${git_failure}\n"
    "Either configure again with a network connection, or get Unity's source tree in some other way and name it: "
    "-DCHASLES_UNITY_DIR=/where/Unity/is. The library and the host program need no Unity: "
    "cmake --workflow --preset compare")
endif()
