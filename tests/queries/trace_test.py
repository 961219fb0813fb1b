#!/usr/bin/python3
"""trace_test.py ENFILADE SOURCES: `enfilade trace` as people with numpy use it, and docs/trace_rays.py with it."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy as np
except ImportError:
    print("skipped: there is no numpy (Debian: python3-numpy)")
    sys.exit(77)

ENFILADE, SOURCES = sys.argv[1], pathlib.Path(sys.argv[2])
sys.dont_write_bytecode = True
sys.path.insert(0, str(SOURCES / "docs"))
import read_scene  # noqa: E402
import trace_rays  # noqa: E402

NONE = trace_rays.NONE


def run(*words):
    return subprocess.run([ENFILADE, *map(str, words)], capture_output=True, text=True, check=False)


def build(folder, plan, name, *flags):
    done = run("build", plan, "-o", folder / name, "-q", "--keep-going", *flags)
    assert done.returncode in (0, 1), done.stderr
    return folder / name


class Trace(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = folder = pathlib.Path(cls.scratch.name)
        done = run("generate", "--rooms", 12, "--storeys", 2, "--oblique", 0.2, "-o", folder / "plan.json")
        assert done.returncode == 0, done.stderr
        cls.scene = build(folder, folder / "plan.json", "scene.enf")
        cls.stripped = build(folder, folder / "plan.json", "stripped.enf", "--strip")
        cls.arrays = read_scene.read_scene(cls.scene)
        cls.points, cls.names = trace_rays.room_points(cls.arrays)
        random = np.random.default_rng(7)
        starts = np.repeat(cls.points, 300, axis=0)
        cls.rays = np.hstack([starts, random.normal(size=starts.shape)])

        cls.furnished = build(folder, folder / "plan.json", "furnished.enf", "--furnish")

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def nearest(self, rays, *flags, scene=None):
        return trace_rays.nearest(ENFILADE, scene or self.scene, rays, *flags)

    def passages(self, rays, *flags, scene=None):
        return trace_rays.passages(ENFILADE, scene or self.scene, rays, *flags)

    def test_rays_meet_furniture(self):
        bare = self.nearest(self.rays, "--no-objects", scene=self.furnished)
        hits = self.nearest(self.rays, scene=self.furnished)
        np.testing.assert_array_equal(bare, self.nearest(self.rays))
        self.assertTrue((bare["object"] == NONE).all())
        met = hits["object"] != NONE
        self.assertGreater(met.sum(), len(met) // 50)
        self.assertTrue((hits["face"][met] == NONE).all())
        self.assertTrue((hits["triangle"][met] != NONE).all())
        self.assertTrue((hits["status"][met] == trace_rays.HIT).all())
        self.assertTrue((hits["distance"][met] <= bare["distance"][met] + 1e-4).all())
        np.testing.assert_array_equal(hits[~met], bare[~met])
        along = np.einsum("ij,ij->i", hits["normal"][met], self.rays[met, 3:6])
        self.assertTrue((along <= 0).all())
        lengths = np.linalg.norm(hits["normal"][met], axis=1)
        np.testing.assert_allclose(lengths, 1, atol=1e-5)
        double = self.nearest(self.rays, "--real", "double", scene=self.furnished)
        self.assertGreater((double["object"] == hits["object"]).mean(), 0.999)
        plain = self.nearest(self.rays, "--object-accel", "plain", scene=self.furnished)
        self.assertGreater((plain["object"] == hits["object"]).mean(), 0.999)
        octree = self.nearest(self.rays, "--object-accel", "octree", scene=self.furnished)
        np.testing.assert_array_equal(octree["object"], plain["object"])
        np.testing.assert_array_equal(octree["triangle"], plain["triangle"])
        ends = self.rays[:, :3] + 3 * self.rays[:, 3:6]
        self.assertGreater(trace_rays.blocked(ENFILADE, self.furnished, self.rays[:, :3], ends).sum(),
                           trace_rays.blocked(ENFILADE, self.scene, self.rays[:, :3], ends).sum())


    def test_the_plan_has_an_origin_of_its_own(self):
        self.assertTrue((self.arrays["origin"] != 0).any(), "else frames are not told apart here")

    def test_hits_lie_on_their_faces(self):
        hits = self.nearest(self.rays)
        self.assertEqual(hits.shape, (len(self.rays),))
        self.assertTrue(np.isin(hits["status"], [trace_rays.HIT, trace_rays.SKY]).all())
        unit = self.rays[:, 3:] / np.linalg.norm(self.rays[:, 3:], axis=1, keepdims=True)
        at = self.rays[:, :3] + hits["distance"][:, None] * unit - self.arrays["origin"]
        faces = self.arrays["source_faces"][hits["face"]]
        corner = self.arrays["vertices"][faces["first_vertex"]].astype(float)
        off_plane = np.abs(np.einsum("ij,ij->i", at - corner, hits["normal"]))
        self.assertLess(off_plane.max(), 1e-3)
        self.assertLess(np.einsum("ij,ij->i", unit, hits["normal"]).max(), 0)
        self.assertTrue((hits["surface"] == faces["surface"]).all())
        self.assertTrue((hits["material"] == faces["material"]).all())
        cells = self.arrays["cells"][hits["cell"]]
        self.assertTrue((hits["space"] == cells["space"]).all() and (hits["label"] == cells["label"]).all())
        self.assertTrue(((hits["status"] == trace_rays.SKY) == (hits["surface"] == 11)).all())

    def test_double_and_float_meet_the_same_faces(self):
        single, double = self.nearest(self.rays), self.nearest(self.rays, "--real", "double")
        self.assertGreater((single["face"] == double["face"]).mean(), 0.999)
        same = single["face"] == double["face"]
        self.assertLess(np.abs(single["distance"] - double["distance"])[same].max(), 1e-2)

    def test_tracers_and_threads_give_the_same_bytes(self):
        first = self.nearest(self.rays, "--threads", "1").tobytes()
        self.assertEqual(first, self.nearest(self.rays, "--threads", "3").tobytes())
        scalar, simd = (self.nearest(self.rays, "--tracer", name) for name in ("scalar", "simd"))
        self.assertGreater((scalar["face"] == simd["face"]).mean(), 0.999)
        rows, offsets = self.passages(self.rays, "--threads", "1")
        more_rows, more_offsets = self.passages(self.rays, "--threads", "3")
        self.assertTrue((offsets == more_offsets).all() and rows.tobytes() == more_rows.tobytes())

    def test_float32_is_taken(self):
        narrow = self.nearest(self.rays.astype("<f4"))
        self.assertGreater((narrow["face"] == self.nearest(self.rays)["face"]).mean(), 0.99)

    def test_distances_end_rays(self):
        free = self.nearest(self.rays)["distance"]
        limits = np.where(np.arange(len(free)) % 2, 0.9, 1.1) * free
        limited = self.nearest(np.hstack([self.rays, limits[:, None]]))
        short = np.arange(len(free)) % 2 == 1
        self.assertTrue((limited["status"][short] == trace_rays.REACHED).all())
        self.assertTrue((limited["distance"][short] == limits[short]).all())
        self.assertTrue((limited["face"][short] == NONE).all())
        self.assertTrue((limited["status"][~short] != trace_rays.REACHED).all())

    def test_any_says_what_nearest_says(self):
        a, b = np.meshgrid(np.arange(len(self.points)), np.arange(len(self.points)))
        pairs = (a != b).ravel()
        starts, ends = self.points[a.ravel()[pairs]], self.points[b.ravel()[pairs]]
        blocked = trace_rays.blocked(ENFILADE, self.scene, starts, ends)
        hits = self.nearest(trace_rays.segments(starts, ends))
        self.assertTrue((blocked == (hits["status"] == trace_rays.HIT)).all())
        self.assertTrue(blocked.any())

    def test_passages_cover_segments_and_reverse(self):
        random = np.random.default_rng(8)
        starts = self.points[random.integers(len(self.points), size=2000)] + random.uniform(-0.3, 0.3, (2000, 3))
        ends = self.points[random.integers(len(self.points), size=2000)] + random.uniform(-0.3, 0.3, (2000, 3))
        there, offsets = self.passages(trace_rays.segments(starts, ends))
        back, back_offsets = self.passages(trace_rays.segments(ends, starts))
        lengths = trace_rays.sum_per_ray(there["leave"] - there["enter"], offsets)
        self.assertLess(np.abs(lengths - np.linalg.norm(ends - starts, axis=1)).max(), 1e-9)
        self.assertTrue((offsets == back_offsets).all())
        solids = 0
        for i in range(len(starts)):
            mine, reverse = there[offsets[i]:offsets[i + 1]], back[offsets[i]:offsets[i + 1]][::-1]
            for one, other in (("cell", "cell"), ("space", "space"), ("label", "label"), ("entered", "left")):
                self.assertTrue((mine[one] == reverse[other]).all(), (i, one))
            thick = np.abs((mine["leave"] - mine["enter"]) - (reverse["leave"] - reverse["enter"]))
            self.assertLess(thick.max(), 3e-3)  # between solids of one gap: grid units over the angle
            solids += (mine["cell"] == NONE).sum()
        self.assertGreater(solids, 2000)

    def test_the_first_solid_is_what_nearest_hits(self):
        rows, offsets = self.passages(self.rays)
        hits = self.nearest(self.rays, "--real", "double")
        for i in np.flatnonzero(hits["status"] == trace_rays.HIT)[:2000]:
            mine = rows[offsets[i]:offsets[i + 1]]
            first = mine[mine["cell"] == NONE][0]
            self.assertEqual(first["face_in"], hits["face"][i])
            self.assertAlmostEqual(first["enter"], hits["distance"][i], 9)

    def test_solids_have_the_names_of_walls_and_slabs(self):
        rows, _ = self.passages(self.rays)
        solids = rows[(rows["cell"] == NONE) & (rows["leave"] > rows["enter"])]
        self.assertTrue((solids["space"] != NONE).all())
        self.assertTrue((self.arrays["spaces"]["label"][solids["space"]] == solids["label"]).all())
        self.assertEqual(set(np.unique(solids["label"])) & {1, 2}, {1, 2})
        stripped, _ = self.passages(self.rays, scene=self.stripped)
        gaps = stripped[stripped["cell"] == NONE]
        self.assertTrue((gaps["space"] == NONE).all())
        self.assertEqual(set(np.unique(gaps["label"])) & {1, 2}, {1, 2})

    def test_shut_doors_are_solids_without_thickness(self):
        plan = json.loads((self.folder / "plan.json").read_text())
        shut = 0
        for storey in plan["storeys"]:
            for opening in storey["openings"]:
                if opening["kind"] == "door":
                    opening.pop("open_angle_deg", None)
                    opening["open_angle"] = 0
                    shut += 1
        self.assertGreater(shut, 0)
        (self.folder / "shut.json").write_text(json.dumps(plan))
        scene = build(self.folder, self.folder / "shut.json", "shut.enf")
        rows, _ = self.passages(self.rays, scene=scene)
        leaves = rows[(rows["cell"] == NONE) & (rows["label"] == 3)]
        self.assertGreater(len(leaves), 50)
        self.assertEqual((leaves["leave"] - leaves["enter"]).max(), 0)
        self.assertTrue((leaves["surface_in"] == 7).all() and (leaves["surface_out"] == 7).all())

    def test_rays_may_start_on_faces_in_walls_and_beyond_the_site(self):
        hits = self.nearest(self.rays)
        inside = hits["status"] == trace_rays.HIT
        unit = self.rays[:, 3:] / np.linalg.norm(self.rays[:, 3:], axis=1, keepdims=True)
        at = self.rays[:, :3] + hits["distance"][:, None] * unit
        normal = hits["normal"].astype(float)
        mirrored = unit - 2 * np.einsum("ij,ij->i", unit, normal)[:, None] * normal
        onward = self.nearest(np.hstack([at, mirrored])[inside])
        self.assertTrue((onward["status"] != trace_rays.WALL).all(), "a point of a face is a start")
        self.assertTrue((onward["face"] != hits["face"][inside]).all())
        deep = self.nearest(np.hstack([at + 0.03 * unit, unit])[inside])
        self.assertGreater((deep["status"] == trace_rays.WALL).mean(), 0.9)
        self.assertTrue(np.isnan(deep["distance"][deep["status"] == trace_rays.WALL]).all())
        far = np.array([[1e5, 2e4, 3e4, 0, 0, 0], [1e5, 2e4, 3e4, 1, 0, 0]])
        far[0, 3:] = self.points[0] - far[0, :3]
        hits = self.nearest(far)
        self.assertEqual(list(hits["status"]), [trace_rays.HIT, trace_rays.SKY])
        self.assertGreater(hits["distance"][0], 1e5)
        self.assertEqual(hits["distance"][1], np.inf)

    def test_what_is_no_ray_is_refused(self):
        rays = np.hstack([np.tile(self.rays[:1], (6, 1)), np.full((6, 1), 5.0)])
        rays[0, 0], rays[1, 3:6], rays[2, 6], rays[3, 6], rays[4, 4] = np.nan, 0, -1, np.nan, np.inf
        self.assertEqual(list(self.nearest(rays)["status"][:5]), [trace_rays.REFUSED] * 5)
        self.assertNotEqual(self.nearest(rays)["status"][5], trace_rays.REFUSED)
        self.assertEqual(list(trace_rays.trace(ENFILADE, self.scene, rays, "any")[:5]), [3] * 5)
        rows, offsets = self.passages(rays)
        self.assertEqual(list(offsets[:6]), [0] * 6)
        self.assertEqual(offsets[6], len(rows))

    def test_directions_have_any_length(self):
        expected = self.nearest(self.rays[:100])["face"]
        for length in (1e-300, 1e-18, 1e18, 1e300):
            scaled = self.rays[:100] * [1, 1, 1, length, length, length]
            self.assertGreater((self.nearest(scaled)["face"] == expected).mean(), 0.98, length)

    def test_no_rays_give_no_answers(self):
        self.assertEqual(len(self.nearest(np.zeros((0, 6)))), 0)
        rows, offsets = self.passages(np.zeros((0, 7)))
        self.assertEqual((len(rows), list(offsets)), (0, [0]))

    def test_json_counts_every_ray(self):
        np.save(self.folder / "rays.npy", self.rays)
        for query in ("nearest", "any", "all"):
            done = run("trace", self.scene, self.folder / "rays.npy", "-o", self.folder / "out.npy", "--query", query, "--json")
            report = json.loads(done.stdout)
            self.assertEqual(report["rays"], len(self.rays))
            self.assertEqual(report["leaks"], 0)
            ends = ("buried",) if query == "all" else ("hits",)
            kinds = ends + ("sky", "reached", "refused")
            self.assertEqual(sum(report[kind] for kind in kinds) + (query != "all") * report["in_walls"], len(self.rays))

    def test_bad_files_and_flags_are_said_in_one_sentence(self):
        out = self.folder / "kept.npy"
        out.write_bytes(b"kept")
        bad = self.folder / "bad.npy"
        np.save(bad, np.array([{}, {}], dtype=object))
        cases = [((self.scene, bad), "objects")]
        for name, array, word in (("f", np.asfortranarray(self.rays), "ascontiguousarray"), ("i", np.ones((3, 6), int), "float64"),
                                  ("s", self.rays[:, :5], "(n, 6)"), ("b", self.rays.astype(">f8"), "<f8")):
            np.save(self.folder / (name + ".npy"), array)
            cases.append(((self.scene, self.folder / (name + ".npy")), word))
        np.savez(self.folder / "z.npz", self.rays)
        np.save(self.folder / "good.npy", self.rays)
        good = (self.scene, self.folder / "good.npy")
        cases += [((self.scene, self.folder / "z.npz"), "archive"), ((*good, "--real", "double", "--tracer", "simd"), "scalar"),
                  ((*good, "--query", "all", "--real", "float"), "double"), ((*good, "-o", self.folder / "good.npy"), "read")]
        for words, expected in cases:
            words = words if "-o" in words else (*words, "-o", out)
            done = run("trace", *words)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
            self.assertIn(expected, done.stderr)
        self.assertEqual(run("trace", *good, "-o", self.folder / "hits.txt").returncode, 2)
        self.assertEqual(run("trace", *good, "-o", self.folder / "none" / "hits.npy").returncode, 3)
        self.assertEqual(run("trace", self.scene, self.folder / "absent.npy", "-o", out).returncode, 3)
        self.assertEqual(out.read_bytes(), b"kept")
        self.assertEqual(list(self.folder.glob(".enfilade-*")), [])

    def test_the_snippets_of_the_page_run(self):
        page = (SOURCES / "docs" / "queries.md").read_text()
        snippets = re.findall(r"```python\n(.*?)```", page, re.S)
        self.assertEqual(len(snippets), 2)
        trace = [ENFILADE, "trace", self.scene, "links.npy", "-o", "passages.npy", "--query", "all", "-q"]
        for code, words in zip(snippets, (trace, ["true"])):
            done = subprocess.run([sys.executable, "-c", code], cwd=self.folder, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            subprocess.run(words, cwd=self.folder, check=True)
        self.assertRegex(done.stdout, r"\[.*\d.*\] dB, \[\d \d\] panes of glass")

    def test_the_script_of_the_page_runs(self):
        done = subprocess.run([sys.executable, "-B", SOURCES / "docs" / "trace_rays.py", ENFILADE, self.scene],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("mean free path", done.stdout)
        self.assertIn("dB", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
