"""Draws docs/furnishing.svg: each relation of a rule, seen from above. Run it in this folder."""
WALL, PIECE, OTHER, CARPET = "#333", "#c9b79c", "#e79b7a", "#e8e6df"


def box(x, y, w, d, fill=PIECE, front=None, turn=0):
    """A piece whose middle is at (x, y); front: where it looks (0, 1 is down)."""
    parts = [f'<rect x="{x - w / 2:g}" y="{y - d / 2:g}" width="{w:g}" height="{d:g}" fill="{fill}" stroke="#444"/>']
    if front:
        parts.append(f'<line x1="{x:g}" y1="{y:g}" x2="{x + front[0] * w / 2:g}" y2="{y + front[1] * d / 2:g}" stroke="#a33"/>')
    body = "".join(parts)
    return f'<g transform="rotate({turn} {x:g} {y:g})">{body}</g>' if turn else body


def line(*points):
    return f'<polyline points="{" ".join(f"{x:g},{y:g}" for x, y in points)}" fill="none" stroke="{WALL}" stroke-width="4"/>'


DOWN, UP, LEFT, RIGHT = (0, 1), (0, -1), (-1, 0), (1, 0)
TOP = line((8, 12), (152, 12))
CELLS = {
    "against_wall": line((8, 40), (60, 12), (100, 12)) + '<path d="M100 12 A60 60 0 0 1 152 72" fill="none" stroke="#333" stroke-width="4"/>'
                    + box(39, 37, 34, 16, front=DOWN, turn=-28.3) + box(124, 39.5, 34, 16, front=DOWN, turn=45),
    "near_window": TOP + '<line x1="50" y1="12" x2="110" y2="12" stroke="#58c" stroke-width="5"/>' + box(80, 27, 50, 24, front=DOWN),
    "middle": line((8, 8), (152, 8), (152, 92), (8, 92), (8, 8)) + box(80, 50, 50, 28, front=DOWN),
    "rows": TOP + "".join(box(30 + 34 * c, 30 + 34 * r, 32, 14, front=DOWN) + box(30 + 34 * c, 44 + 34 * r, 11, 11, OTHER, UP)
                          for r in range(2) for c in range(3)),
    "on_wall": TOP + box(80, 16, 40, 4, OTHER, DOWN),
    "ceiling": line((8, 8), (152, 8), (152, 92), (8, 92), (8, 8)) + "".join(box(x, 50, 16, 16, "#ffe9a0") for x in (44, 116)),
    "beside": TOP + box(80, 48, 44, 68, front=DOWN) + box(46, 24, 20, 20, OTHER, DOWN) + box(114, 24, 20, 20, OTHER, DOWN),
    "in_front": TOP + box(80, 28, 60, 28, front=DOWN) + box(80, 55, 20, 20, OTHER, UP),
    "around": box(80, 50, 60, 30) + "".join(box(x, y, 16, 16, OTHER, f) for x, y, f in
              ((64, 25, DOWN), (96, 25, DOWN), (64, 75, UP), (96, 75, UP), (40, 50, RIGHT), (120, 50, LEFT))),
    "on_top": TOP + box(80, 34, 70, 38, front=DOWN) + box(80, 24, 24, 12, OTHER, DOWN) + box(106, 22, 9, 9, OTHER),
    "under": box(80, 50, 100, 66, CARPET) + box(80, 50, 46, 26),
    "above": TOP + box(80, 40, 60, 50, front=DOWN) + box(80, 17, 36, 5, OTHER, DOWN),
    "opposite": TOP + box(80, 22, 46, 14, front=DOWN) + line((8, 92), (152, 92)) + box(80, 76, 60, 26, OTHER, UP),
    "in_row": TOP + box(80, 27, 24, 26, front=DOWN) + "".join(box(x, 27, 24, 26, OTHER, DOWN) for x in (32, 56, 104, 128)),
}

columns, width, height = 5, 170, 132
rows = -(-len(CELLS) // columns)
with open("furnishing.svg", "w") as out:
    out.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {columns * width} {rows * height}" '
              f'font-family="sans-serif" font-size="13"><rect width="100%" height="100%" fill="#fff"/>\n')
    for k, (name, body) in enumerate(CELLS.items()):
        out.write(f'<g transform="translate({k % columns * width + 5} {k // columns * height + 6})">{body}'
                  f'<text x="80" y="116" text-anchor="middle">{name}</text></g>\n')
    out.write("</svg>\n")
