// `enfilade_gpu`: see command_line.h.

#include <exception>
#include <iostream>

#include "base/error.h"
#include "tools/gpu/command_line.h"

int main(int count, char** words) {
    try {
        return enfilade::tools::gpu::run({words + 1, words + count}, std::cout, std::cerr);
    } catch (const enfilade::InputError& error) {
        std::cerr << error.located() << "\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 3;
    }
}
