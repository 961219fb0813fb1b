#!/usr/bin/python3
"""graph_readers_test.py WRITE_EXPORTS FOLDER PLAN...: Graphviz and networkx read the graphs, whole.

Where neither is on the machine, the test says so and ends with 77 (skipped).
"""
import json
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree

try:
    import networkx
except ImportError:
    networkx = None

WRITER, FOLDER, PLANS = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
NAMESPACE = "{http://graphml.graphdrawing.org/xmlns}"


def drawn(file):
    """Nodes (with their labels) and edges of a DOT file, as Graphviz's own parser says (dot -Tjson0)."""
    done = subprocess.run(["dot", "-Tjson0", file], capture_output=True, check=True)
    graph = json.loads(done.stdout)
    nodes = {o["name"]: o["label"] for o in graph["objects"] if not o["name"].startswith("cluster")}
    ids = {o["_gvid"]: o["name"] for o in graph["objects"]}
    return nodes, sorted(tuple(sorted((ids[e["tail"]], ids[e["head"]]))) for e in graph.get("edges", []))


def listed(file, graph_id):
    """The same of one graph of a GraphML file; networkx reads the first."""
    root = xml.etree.ElementTree.parse(file).getroot()
    graph = next(g for g in root.iter(NAMESPACE + "graph") if g.get("id") == graph_id)
    nodes = {n.get("id") for n in graph.iter(NAMESPACE + "node")}
    edges = sorted(tuple(sorted((e.get("source"), e.get("target")))) for e in graph.iter(NAMESPACE + "edge"))
    if networkx and graph_id == "spaces":
        read = networkx.read_graphml(file)
        assert set(read.nodes) == nodes and read.number_of_edges() == len(edges)
        assert networkx.is_connected(networkx.Graph(read)) or len(nodes) > 1
        assert all("area_m2" in data and "label" in data for _, data in read.nodes(data=True))
    return nodes, edges


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    has_dot = shutil.which("dot") is not None
    if not has_dot and not networkx:
        print("skipped: there is neither graphviz nor python3-networkx on this machine")
        sys.exit(77)
    for plan in PLANS:
        if "/" in plan and not pathlib.Path(plan).exists():
            print(f"skipped: {plan} is not on this machine")
            sys.exit(77)
        stem = str(FOLDER / pathlib.Path(plan).stem)
        subprocess.run([WRITER, plan, stem], check=True)
        facts = json.loads(pathlib.Path(stem + ".facts.json").read_text())
        for level, suffix in (("spaces", ".dot"), ("cells", ".cells.dot")):
            nodes, edges = listed(stem + ".graphml", level)
            if has_dot:
                drawn_nodes, drawn_edges = drawn(stem + suffix)
                assert set(drawn_nodes) == nodes and drawn_edges == edges, f"{plan}: DOT and GraphML differ ({level})"
            if level == "cells":
                assert len(nodes) == facts["cells"] and len(edges) == facts["portals"]
        print(f"{plan}: {facts['cells']} cells, {facts['portals']} portals")


if __name__ == "__main__":
    main()
