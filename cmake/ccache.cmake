# A compiler cache, where the machine has one and nobody chose a launcher.
find_program(ENFILADE_CCACHE ccache)
mark_as_advanced(ENFILADE_CCACHE)
if(ENFILADE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${ENFILADE_CCACHE})
  set(CMAKE_CUDA_COMPILER_LAUNCHER ${ENFILADE_CCACHE})
endif()
