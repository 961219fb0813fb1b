#!/usr/bin/python3
"""npm_readers_test.py WRITE_EXPORTS FOLDER PLAN...: readers of other people take the exports, and find what is there.

Khronos' glTF validator; three.js' loaders of glTF and OBJ; the CityJSON loader of cityjson.org's viewer, whose triangles
have to cover the surfaces with their holes; Honeybee's schema. They are npm packages, installed into FOLDER; where npm or its
registry cannot be reached, the test says so and ends with 77 (skipped).
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys

WRITER, FOLDER, PLANS = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
PACKAGES = ["gltf-validator@2.0.0-dev.3.10", "three@0.187.0", "cityjson-threejs-loader@0.4.0", "honeybee-schema@1.5901.5",
            "reflect-metadata@0.2.2"]
# The CityJSON loader is written for bundlers: its imports lack their ".js".
HOOK = """
import { register } from 'node:module';
register('data:text/javascript,' + encodeURIComponent(
  'export async function resolve(s, c, next) { try { return await next(s, c); } catch (e) { return next(s + ".js", c); } }'));
"""
READER = """
import fs from 'fs';
import { createRequire } from 'module';
const require = createRequire(import.meta.url);
globalThis.self = globalThis;
globalThis.ProgressEvent ??= class {};
require('reflect-metadata');
const { Scene } = await import('three');
const { GLTFLoader } = await import('three/examples/jsm/loaders/GLTFLoader.js');
const { OBJLoader } = await import('three/examples/jsm/loaders/OBJLoader.js');
const { CityJSONParser } = await import('./node_modules/cityjson-threejs-loader/src/parsers/CityJSONParser.js');
const honeybee = require('honeybee-schema');
const stem = process.argv[2], found = {};

const glb = fs.readFileSync(stem + '.glb');
found.validator = (await require('gltf-validator').validateBytes(new Uint8Array(glb), {maxIssues: 20})).issues;

const gltf = await new GLTFLoader().parseAsync(glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.byteLength), '');
Object.assign(found, {names: [], lumen: 0, lights: 0, furniture: 0, glb_triangles: 0});
gltf.scene.traverse(o => {
  found.names.push(o.userData.name ?? o.name);
  if (o.isLight) { found.lights += 1; found.lumen += o.power; }
  if (o.userData.label === 'furniture') found.furniture += 1;
  else if (o.isMesh) found.glb_triangles += o.geometry.index.count / 3;
});

found.obj_triangles = 0;
new OBJLoader().parse(fs.readFileSync(stem + '.obj', 'utf8')).traverse(o => {
  if (o.isMesh) found.obj_triangles += o.geometry.attributes.position.count / 3;
});

const city = JSON.parse(fs.readFileSync(stem + '.city.json')), scene = new Scene();
const parser = new CityJSONParser();
parser.parse(city, scene);
found.city_area = 0;
scene.traverse(o => {
  if (!o.isMesh) return;
  const p = o.geometry.attributes.position, at = k => [p.getX(k), p.getY(k), p.getZ(k)];
  for (let k = 0; k < p.count; k += 3) {
    const o = at(k), [a, b] = [at(k + 1), at(k + 2)].map(v => v.map((x, i) => x - o[i]));
    found.city_area += Math.hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]) / 2;
  }
});

const model = JSON.parse(fs.readFileSync(stem + '.hbjson'));
const is_valid = async json => { try { return await honeybee.Model.fromJS(json).validate(); } catch { return false; } };
found.honeybee = await is_valid(structuredClone(model));
const spoiled = structuredClone(model);
spoiled.rooms[0].faces[0].face_type = 'Carpet';
found.spoiled = await is_valid(spoiled);
console.log(JSON.stringify(found));
"""


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def install():
    if not shutil.which("node") or not shutil.which("npm"):
        skip("there is no npm on this machine")
    if not (FOLDER / "node_modules/honeybee-schema").is_dir():
        try:
            done = subprocess.run(["npm", "install", "--silent", "--no-audit", "--no-fund", "--prefix", FOLDER, *PACKAGES],
                                  capture_output=True, text=True, timeout=240, check=False)
        except subprocess.TimeoutExpired:
            skip("the npm registry does not answer")
        if done.returncode != 0:
            skip(f"npm cannot install {', '.join(PACKAGES)}: {done.stderr.strip()[-200:]}")
    (FOLDER / "hook.mjs").write_text(HOOK)
    (FOLDER / "reader.mjs").write_text(READER)


def city_area(city):
    """The area of all surfaces, holes taken out, in the integers of the file."""
    total, points = 0.0, city["vertices"]
    for item in city["CityObjects"].values():
        for geometry in item["geometry"]:
            solids = [geometry["boundaries"]] if geometry["type"] == "Solid" else geometry["boundaries"]
            for surface in (surface for solid in solids for shell in solid for surface in shell):
                normal = [0, 0, 0]
                for ring in surface:
                    for p, q in zip((points[k] for k in ring), (points[k] for k in ring[1:] + ring[:1])):
                        for axis in range(3):
                            u, v = (axis + 1) % 3, (axis + 2) % 3
                            normal[axis] += p[u] * q[v] - p[v] * q[u]
                total += math.sqrt(sum(n * n for n in normal)) / 2
    return total


def check(plan):
    if "/" in plan and not pathlib.Path(plan).exists():
        skip(f"{plan} is not on this machine")
    stem = FOLDER / pathlib.Path(plan).stem
    subprocess.run([WRITER, plan, stem], check=True)
    done = subprocess.run(["node", "--import", "./hook.mjs", "reader.mjs", stem.name], cwd=FOLDER, capture_output=True,
                          text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    found = json.loads(done.stdout.splitlines()[-1])
    facts = json.loads(stem.with_suffix(".facts.json").read_text())
    issues = found["validator"]
    assert not issues["numErrors"] and not issues["numWarnings"], json.dumps(issues, indent=1)
    assert found["glb_triangles"] == found["obj_triangles"] == facts["triangles"], (plan, found["glb_triangles"])
    assert found["lights"] == facts["lights"] and found["furniture"] == facts["furniture"]
    assert math.isclose(found["lumen"], facts["lumen"], rel_tol=1e-6, abs_tol=1e-9)
    names = set(found["names"])
    for space in facts["spaces"]:
        if space["label"] == "room":
            assert space["name"] in names, f"{space['name']!r} is no node"
    area = city_area(json.loads(stem.with_suffix(".city.json").read_text()))
    assert math.isclose(found["city_area"], area, rel_tol=1e-4), f"{plan}: {found['city_area']} of {area}"
    assert found["honeybee"] is True, f"{plan}: honeybee-schema refuses the model"
    assert found["spoiled"] is False, "honeybee-schema takes anything"
    print(f"{plan}: {found['glb_triangles']:.0f} triangles, {found['lights']} lights, Honeybee model valid")


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    install()
    for plan in PLANS:
        check(plan)


if __name__ == "__main__":
    main()
