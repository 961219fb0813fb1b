#pragma once
// How the program ends (docs/commands.md).

namespace enfilade::tools {

enum ExitCode : int {
    exit_ok = 0,
    exit_defects = 1,    ///< the plan or model has errors, or a benchmark's goal is not met with --strict
    exit_bad_input = 2,  ///< a file, plan or flag is wrong
    exit_device = 3,     ///< a file or device would not do its part
};

}  // namespace enfilade::tools
