#!/usr/bin/python3
"""The source check finds each fault that it is there for, and no other."""
import pathlib
import tempfile
import unittest

import check_sources

HEADER = "#pragma once\n"


def faults_of(name, text):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / name
        file.parent.mkdir(parents=True)
        file.write_text(text)
        return list(check_sources.faults(pathlib.Path(folder)))


class CheckSources(unittest.TestCase):
    def assert_fault(self, name, text, part):
        found = faults_of(name, text)
        self.assertEqual(len(found), 1, found)
        self.assertIn(part, found[0])

    def assert_none(self, name, text):
        self.assertEqual(faults_of(name, text), [])

    def test_arrows(self):
        self.assert_fault("gmap/a.cpp", '#include "base/error.h"\n', "gmap may not include base")
        self.assert_fault("plans/a.cpp", '#include "gmap/map.h"\n', "plans may not include gmap")
        self.assert_fault("render/a.cpp", '#include <modeler/build.h>\n', "render may not include modeler")
        self.assert_fault("accel/a.h", HEADER + '#include "plans/plan.h"\n', "accel may not include plans")
        self.assert_fault("modeler/exports/a.cpp", '#include "render/walk.h"\n', "modeler may not include render")
        self.assert_none("modeler/exports/a.cpp", '#include "accel/scene.h"\n#include "gmap/map.h"\n#include <vector>\n')
        self.assert_none("tools/a.cpp", '#include "render/walk.h"\n#include "modeler/build.h"\n')

    def test_includes_from_the_root(self):
        self.assert_fault("plans/a.cpp", '#include "plan.h"\n', "from the root")

    def test_cgal(self):
        self.assert_fault("modeler/a.h", HEADER + "#include <CGAL/Arrangement_2.h>\n", "CGAL in a header")
        self.assert_fault("render/a.cpp", "#include <CGAL/Arrangement_2.h>\n", "built without CGAL")
        self.assert_none("modeler/a.cpp", "#include <CGAL/Arrangement_2.h>\n")
        self.assert_none("gmap/cgal.h", HEADER + "#include <CGAL/Arrangement_2.h>\n")

    def test_cli11(self):
        self.assert_fault("tools/command_build.cpp", "#include <CLI/CLI.hpp>\n", "tools/flags.h alone")
        self.assert_none("tools/flags.h", "#pragma once\n#include <CLI/CLI.hpp>\n")

    def test_printing_libraries(self):
        for line in ("std::cout << 1;", 'printf("x");', 'std::fprintf(stderr, "x");', "std::exit(1);", 'puts("x");'):
            self.assert_fault("plans/a.cpp", line + "\n", "neither print nor exit")
        self.assert_none("plans/a.cpp", 'std::snprintf(text, 3, "x");  // as printf("x") would\nscene.exit(3);\n')
        self.assert_none("tools/a.cpp", 'std::printf("x");\n')

    def test_headers(self):
        self.assert_fault("plans/a.h", "int x;\n", "#pragma once")

    def test_long_files(self):
        self.assert_fault("plans/a.cpp", "\n" * 501, "501 lines")
        self.assert_none("plans/a.cpp", "// Long because it is a table.\n" + "\n" * 501)

    def test_undone_things(self):
        self.assert_fault("plans/a.cpp", "// TO" + "DO: later\n", "undone")

    def test_compiler_flags(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "CMakeLists.txt").write_text("add_compile_options(-march=native)\n")
            self.assertEqual(len(list(check_sources.faults(pathlib.Path(folder)))), 1)


if __name__ == "__main__":
    unittest.main()
