#pragma once
// Files compiled for a newer instruction set put their inline functions into a namespace of their own, so that the
// linker never lets a program without that set run them (render/CMakeLists.txt, kernel_fma.cpp).

#ifndef ENFILADE_ISA
#define ENFILADE_ISA portable
#endif
