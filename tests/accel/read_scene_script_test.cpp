// docs/read_scene.py is the format's executable description: it has to read what the library writes.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "accel/assemble.h"
#include "accel/scene_file.h"
#include "tests/support/synthetic_objects.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/temporary_folder.h"

namespace enfilade::accel {
namespace {

TEST(ReadSceneScript, ReadsWhatTheLibraryWrites) {
    std::string python;
    for (const std::string candidate : {"python3", "/usr/bin/python3"})
        if (python.empty() && std::system((candidate + " -c 'import numpy' 2>/dev/null").c_str()) == 0)
            python = candidate;
    if (python.empty()) GTEST_SKIP() << "there is no python3 with numpy (Debian: python3-numpy)";
    const test::TemporaryFolder folder;
    write(assemble(test::with_objects(test::synthetic_office({.rooms_per_row = 2, .rows = 2}), 1, 40)),
          folder.path() / "a.enf");
    const std::string command = python + " " ENFILADE_SOURCE_DIR "/docs/read_scene.py " +
                                (folder.path() / "a.enf").string() + " > " + (folder.path() / "out").string();
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ifstream file(folder.path() / "out");
    const std::string out(std::istreambuf_iterator<char>(file), {});
    EXPECT_NE(out.find("unit 0.00012207 m"), std::string::npos) << out;
    EXPECT_NE(out.find("1 cells    20.00 m2"), std::string::npos) << out;
    EXPECT_NE(out.find("40 objects of 4 meshes, 19 triangles"), std::string::npos) << out;
}

}  // namespace
}  // namespace enfilade::accel
