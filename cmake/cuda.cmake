# CUDA is no Debian package. AUTO: device code is compiled where nvcc is found; ON: it must be; OFF: it is not.
set(ENFILADE_CUDA AUTO CACHE STRING "Compile the device code with nvcc: AUTO (where it is found), ON or OFF")
set_property(CACHE ENFILADE_CUDA PROPERTY STRINGS AUTO ON OFF)
set(ENFILADE_HAVE_CUDA OFF)
if(ENFILADE_CUDA)
  include(CheckLanguage)
  check_language(CUDA)
  if(CMAKE_CUDA_COMPILER)
    # All cards that we build for, and PTX for those to come: what packages are built with (preset cuda).
    set(ENFILADE_CUDA_ALL_CARDS 75-real 80-real 86-real 89-real 90)
    if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
      # Some twenty files of kernels cost a minute of two cores a card: for oneself, the card of this machine; where
      # there is none, PTX, which drivers compile when the program first starts.
      execute_process(COMMAND nvidia-smi -L OUTPUT_VARIABLE cards ERROR_QUIET RESULT_VARIABLE answer)
      if(answer EQUAL 0 AND cards MATCHES "GPU")
        set(CMAKE_CUDA_ARCHITECTURES native)
      else()
        set(CMAKE_CUDA_ARCHITECTURES 75-virtual)
      endif()
    endif()
    enable_language(CUDA)
    if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION)  # CMake 3.25 does not know that nvcc speaks it
      set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20)
      set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION -std=c++20)
    endif()
    set(CMAKE_CUDA_STANDARD 20)
    set(CMAKE_CUDA_STANDARD_REQUIRED ON)
    set(ENFILADE_HAVE_CUDA ON)
    # The same rounding as on the host (1-architecture, decision 9); constexpr std calls on the device; GLM's warning,
    # and that of host functions in templates for both which only the host calls.
    target_compile_options(enfilade_options INTERFACE
      "$<$<COMPILE_LANGUAGE:CUDA>:--fmad=false;--expt-relaxed-constexpr;-diag-suppress=20012;-Xcompiler=-ffp-contract=off>")
  elseif(ENFILADE_CUDA STREQUAL "AUTO")
    message(STATUS "CUDA: skipped, no nvcc on this machine")
  else()
    message(FATAL_ERROR "ENFILADE_CUDA is ON and there is no nvcc: install CUDA, put nvcc into PATH, or set ENFILADE_CUDA=AUTO.")
  endif()
endif()
