"use strict";
// The report's behaviour. Without it the page shows everything, one thing under the other.
(() => {
  document.documentElement.classList.add("js");
  const data = JSON.parse(document.getElementById("data").textContent);
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const one = (selector, root = document) => root.querySelector(selector);
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  const byNumber = new Map(data.findings.map((f) => [f.n, f]));
  const state = { storey: 0, selected: 0 };

  // ---- Views: what part of a drawing is seen, as its middle and the metres that a pixel covers. -------------------
  const heavy_from = 5000;
  class View {
    constructor(svg) {
      this.svg = svg;
      this.frame = svg.parentNode;
      // What takes its size in pixels: it alone is told the scale, since a whole large drawing takes long to style anew.
      this.scaled = all(".layer-pins, .gnodes", svg);
      // Large drawings are moved as a picture, and drawn anew when they rest.
      this.heavy = svg.getElementsByTagName("*").length > heavy_from;
      this.seen = svg.classList.contains("plan");
      const [x, y, width, height] = svg.dataset.box.split(" ").map(Number);
      this.box = { x, y, width, height };
      this.fitted = true;
      this.pointers = new Map();
      this.names = all(".names", svg).map((group) => ({ group, size: Number(group.dataset.size) }));
      this.pins = all(".pin", svg);
      this.bar = one(".scalebar", svg);
      this.listen();
    }

    get size() {
      return { width: this.frame.clientWidth || 1, height: this.frame.clientHeight || 1 };
    }
    fitScale() {
      const { width, height } = this.size;
      return Math.max(this.box.width / width, this.box.height / height);
    }
    fit() {
      this.fitted = true;
      this.set(this.box.x + this.box.width / 2, this.box.y + this.box.height / 2, this.fitScale());
    }
    set(x, y, scale) {
      const fit = this.fitScale();
      this.scale = Math.min(Math.max(scale, fit / 400, 0.0002), fit * 4);
      // The drawing never leaves the sheet wholly.
      const b = this.box;
      this.x = Math.min(Math.max(x, b.x - b.width), b.x + 2 * b.width);
      this.y = Math.min(Math.max(y, b.y - b.height), b.y + 2 * b.height);
      this.draw();
    }
    draw() {
      clearTimeout(this.resting);
      if (!this.heavy || !this.settled) return this.settle();
      const at = this.settled, s = this.scale;
      this.svg.style.transform = `translate(${(at.x - this.x) / s}px, ${(at.y - this.y) / s}px) scale(${at.scale / s})`;
      this.resting = setTimeout(() => this.settle(), 160);
    }
    settle() {
      const { width, height } = this.size;
      const w = width * this.scale, h = height * this.scale;
      this.settled = { x: this.x, y: this.y, scale: this.scale };
      this.svg.style.transform = "";
      this.svg.setAttribute("viewBox", `${this.x - w / 2} ${this.y - h / 2} ${w} ${h}`);
      this.drawBar();
      if (this.drawn === this.scale) return;
      this.drawn = this.scale;
      for (const group of this.scaled) group.style.setProperty("--k", this.scale);
      for (const { group, size } of this.names) group.style.display = size / this.scale < 5.5 ? "none" : "";
      this.gather();
    }
    drawBar() {
      if (!this.bar) return;
      const { width, height } = this.size, s = this.scale;
      const most = 130 * s, power = 10 ** Math.floor(Math.log10(most));
      const metres = power * (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1);
      this.bar.setAttribute("transform", `translate(${this.x + (16 - width / 2) * s} ${this.y + (height / 2 - 16) * s})`);
      one("path", this.bar).setAttribute("d", `M0 ${-6 * s}V0H${metres}V${-6 * s}`);
      const text = one("text", this.bar);
      text.textContent = metres >= 1 ? `${metres} m` : `${Math.round(metres * 100)} cm`;
      text.setAttribute("x", metres + 6 * s);
      text.style.setProperty("--size", `${12 * s}px`);
    }

    /// Pins that would hide each other become one, which says how many it stands for; the more there are in sight, the
    /// further apart they stay.
    gather() {
      if (!this.pins.length || !this.scale) return;
      const order = this.pins.map((pin) => ({ pin, f: byNumber.get(Number(pin.dataset.n)), more: 0 }));
      order.sort((a, b) => (b.f.n === state.selected) - (a.f.n === state.selected) || a.f.n - b.f.n);
      const { width, height } = this.size, s = this.scale;
      const sees = ({ f }) => Math.abs(f.at[0] - this.x) * 2 < width * s && Math.abs(f.at[1] - this.y) * 2 < height * s;
      for (const pixels of [23, 34, 50, 75]) {
        this.near = pixels * s;
        if (this.gatherWithin(order).filter(sees).length <= 90) break;
      }
      for (const { pin, more } of order) {
        let label = one(".more-here", pin);
        if (!more) {
          if (label) label.remove();
          continue;
        }
        if (!label) {
          label = document.createElementNS(this.svg.namespaceURI, "text");
          label.setAttribute("class", "more-here");
          label.setAttribute("x", "15");
          label.setAttribute("y", "-26");
          one(".k", pin).append(label);
        }
        label.textContent = `+${more}`;
      }
    }

    /// Those that stay: for each other one of them is nearer than `near`.
    gatherWithin(order) {
      const near = this.near, leaders = new Map(), key = (i, j) => `${i} ${j}`;
      for (const at of order) {
        at.more = 0;
        if (at.pin.classList.contains("filtered")) continue;
        const [x, y] = at.f.at, i = Math.floor(x / near), j = Math.floor(y / near);
        let leader = null;
        for (let di = -1; di <= 1 && !leader; ++di)
          for (let dj = -1; dj <= 1 && !leader; ++dj)
            leader = (leaders.get(key(i + di, j + dj)) || []).find((l) => Math.hypot(l.f.at[0] - x, l.f.at[1] - y) < near);
        at.pin.classList.toggle("covered", !!leader);
        if (leader) leader.more += 1;
        else leaders.set(key(i, j), [...(leaders.get(key(i, j)) || []), at]);
      }
      return [...leaders.values()].flat();
    }

    toMetres(event) {
      const rect = this.frame.getBoundingClientRect(), { width, height } = this.size;
      return [this.x + (event.clientX - rect.left - width / 2) * this.scale, this.y + (event.clientY - rect.top - height / 2) * this.scale];
    }
    zoomAt(x, y, factor) {
      this.fitted = false;
      const before = this.scale, fit = this.fitScale();
      const scale = Math.min(Math.max(before * factor, fit / 400, 0.0002), fit * 4);
      const share = scale / before;
      this.set(x + (this.x - x) * share, y + (this.y - y) * share, scale);
    }
    /// Goes there in a quarter of a second.
    go(x, y, scale) {
      this.fitted = false;
      cancelAnimationFrame(this.flight);
      if (calm.matches || !this.frame.clientWidth) return this.set(x, y, scale);
      const from = { x: this.x, y: this.y, scale: this.scale }, start = performance.now();
      const step = (now) => {
        const t = Math.min(1, (now - start) / 250), e = 1 - (1 - t) ** 3;
        this.set(from.x + (x - from.x) * e, from.y + (y - from.y) * e, from.scale * (scale / from.scale) ** e);
        if (t < 1) this.flight = requestAnimationFrame(step);
      };
      this.flight = requestAnimationFrame(step);
    }

    listen() {
      const svg = this.svg, frame = this.frame;
      frame.addEventListener("wheel", (event) => {
        event.preventDefault();
        cancelAnimationFrame(this.flight);
        this.zoomAt(...this.toMetres(event), Math.exp(Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY), 120) / 480));
      }, { passive: false });
      frame.addEventListener("pointerdown", (event) => {
        if (event.button > 0) return;
        this.pointers.set(event.pointerId, event);
        this.moved = 0;
        cancelAnimationFrame(this.flight);
      });
      frame.addEventListener("pointermove", (event) => this.move(event));
      for (const name of ["pointerup", "pointercancel"])
        frame.addEventListener(name, (event) => {
          this.pointers.delete(event.pointerId);
          frame.classList.remove("moving");
        });
      frame.addEventListener("dblclick", (event) => this.zoomAt(...this.toMetres(event), event.shiftKey ? 2 : 0.5));
      svg.addEventListener("keydown", (event) => {
        const { width, height } = this.size, s = this.scale;
        const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
        if (steps[event.key]) this.fitted = false, this.set(this.x + steps[event.key][0] * width * s / 8, this.y + steps[event.key][1] * height * s / 8, s);
        else if (event.key === "+" || event.key === "=") this.zoomAt(this.x, this.y, 0.8);
        else if (event.key === "-") this.zoomAt(this.x, this.y, 1.25);
        else if (event.key === "0") this.fit();
        else return;
        event.preventDefault();
      });
      new ResizeObserver(() => this.show()).observe(frame);
      if (this.seen) return;
      new IntersectionObserver(([at], watcher) => {
        if (!at.isIntersecting) return;
        watcher.disconnect();
        this.seen = true;
        this.show();
      }, { rootMargin: "200px" }).observe(frame);
    }
    move(event) {
      const before = this.pointers.get(event.pointerId);
      if (!before) return;
      const others = [...this.pointers.values()].filter((p) => p.pointerId !== event.pointerId);
      const dx = event.clientX - before.clientX, dy = event.clientY - before.clientY;
      this.moved += Math.abs(dx) + Math.abs(dy);
      // A finger or a mouse that trembles still clicks.
      if (this.moved < 5 && !others.length) return;
      if (!this.frame.hasPointerCapture(event.pointerId)) this.frame.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, event);
      this.frame.classList.add("moving");
      this.fitted = false;
      this.set(this.x - dx * this.scale / (others.length + 1), this.y - dy * this.scale / (others.length + 1), this.scale);
      if (others.length !== 1) return;
      const apart = (p) => Math.hypot(p.clientX - others[0].clientX, p.clientY - others[0].clientY) || 1;
      const middle = { clientX: (event.clientX + others[0].clientX) / 2, clientY: (event.clientY + others[0].clientY) / 2 };
      this.zoomAt(...this.toMetres(middle), apart(before) / apart(event));
    }
    /// After the sheet has become visible or changed its size.
    show() {
      if (!this.seen || !this.frame.clientWidth) return;
      this.drawn = NaN;
      this.settled = null;
      if (this.fitted || !this.scale) this.fit();
      else this.set(this.x, this.y, this.scale);
    }
  }

  const views = new Map(all(".drawing").map((svg) => [svg, new View(svg)]));
  const viewOf = (kind, storey = state.storey) => views.get(document.getElementById(`${kind}-${storey}`));

  // ---- Storeys ---------------------------------------------------------------------------------------------------
  function showStorey(storey) {
    state.storey = storey;
    for (const sheet of all(".sheet")) sheet.classList.toggle("active", Number(sheet.dataset.storey) === storey);
    for (const tab of all("[role=tab]")) {
      const active = Number(tab.dataset.storey) === storey;
      tab.setAttribute("aria-selected", active);
      tab.tabIndex = active ? 0 : -1;
    }
    for (const kind of ["plan", "graph"]) viewOf(kind, storey)?.show();
  }
  for (const tabs of all("[role=tablist]")) {
    tabs.addEventListener("click", (event) => {
      const tab = event.target.closest("[role=tab]");
      if (tab) showStorey(Number(tab.dataset.storey));
    });
    tabs.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!step) return;
      const count = data.storeys.length;
      showStorey((state.storey + step + count) % count);
      one("[aria-selected=true]", tabs).focus();
      event.preventDefault();
    });
  }
  for (const stage of all(".stage[data-view]"))
    stage.addEventListener("click", (event) => {
      const button = event.target.closest("[data-zoom]"), view = viewOf(stage.dataset.view);
      if (!button || !view) return;
      if (button.dataset.zoom === "fit") view.fit();
      else view.zoomAt(view.x, view.y, button.dataset.zoom === "in" ? 0.67 : 1.5);
    });

  // ---- Layers ----------------------------------------------------------------------------------------------------
  const planStage = one(".stage[data-view=plan]");
  for (const box of all("[data-layer]")) {
    const apply = () => planStage.classList.toggle(`hide-${box.dataset.layer}`, !box.checked);
    box.addEventListener("change", apply);
    apply();
  }
  document.addEventListener("click", (event) => {
    for (const menu of all("details.layers[open]")) if (!menu.contains(event.target)) menu.open = false;
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") for (const menu of all("details.layers[open]")) menu.open = false, one("summary", menu).focus();
  });

  // ---- Where the pointer is ----------------------------------------------------------------------------------------
  const status = one(".status");
  planStage?.addEventListener("pointermove", (event) => {
    const view = viewOf("plan");
    if (!event.target.closest(".frame")) return;
    const [x, y] = view.toMetres(event), title = event.target.closest(".room")?.querySelector("title");
    status.textContent = `x ${(data.origin[0] + x).toFixed(2)}  y ${(data.origin[1] - y).toFixed(2)} m` + (title ? `  ·  ${title.textContent}` : "");
  });

  // ---- Findings --------------------------------------------------------------------------------------------------
  const list = document.getElementById("findings"), search = document.getElementById("search");
  const codeBox = document.getElementById("code"), sortBox = document.getElementById("sort");
  const entries = all(".finding", list).map((item) => ({
    item, pick: one(".pick", item), finding: byNumber.get(Number(item.dataset.n)), text: item.textContent.toLowerCase(),
  }));
  const entryOf = new Map(entries.map((entry) => [entry.finding.n, entry]));
  const pinOf = new Map(all(".pin").map((pin) => [Number(pin.dataset.n), pin]));
  const drawn = new Map();
  for (const shape of all(".plan [data-el]")) drawn.set(shape.dataset.el, [...(drawn.get(shape.dataset.el) || []), shape]);
  let shown = entries;

  function filter() {
    const severities = new Set(all("[data-severity]").filter((box) => box.checked).map((box) => box.dataset.severity));
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean), code = codeBox.value;
    const order = {
      n: (a, b) => a.n - b.n,
      code: (a, b) => (a.code < b.code ? -1 : a.code > b.code ? 1 : a.n - b.n),
      storey: (a, b) => (a.storey ?? 1e9) - (b.storey ?? 1e9) || a.n - b.n,
    }[sortBox.value];
    shown = [];
    for (const entry of entries) {
      const f = entry.finding;
      const keep = severities.has(f.severity) && (!code || f.code === code) && words.every((word) => entry.text.includes(word));
      entry.item.hidden = !keep;
      pinOf.get(f.n)?.classList.toggle("filtered", !keep);
      if (keep) shown.push(entry);
    }
    shown.sort((a, b) => order(a.finding, b.finding));
    if (filter.sorted !== sortBox.value) {
      filter.sorted = sortBox.value;
      list.append(...[...entries].sort((a, b) => order(a.finding, b.finding)).map((entry) => entry.item));
    }
    document.getElementById("shown").textContent = shown.length === entries.length ? "" : `${shown.length} of ${entries.length} shown`;
    for (const entry of entries) entry.pick.tabIndex = -1;
    const first = entryOf.get(state.selected);
    if (shown.length) (shown.includes(first) ? first : shown[0]).pick.tabIndex = 0;
    viewOf("plan")?.gather();
  }

  function light(finding) {
    for (const shape of all(".lit")) shape.classList.remove("lit");
    const lit = finding.elements.flatMap((id) => drawn.get(id) || []);
    for (const shape of lit) shape.classList.add("lit");
    return lit;
  }
  /// Around shapes of one storey, in metres of the page.
  function boundsOf(shapes) {
    let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
    for (const shape of shapes) {
      const b = shape.getBBox();
      x0 = Math.min(x0, b.x / 1000), x1 = Math.max(x1, (b.x + b.width) / 1000);
      y0 = Math.min(y0, -(b.y + b.height) / 1000), y1 = Math.max(y1, -b.y / 1000);
    }
    return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, width: x1 - x0, height: y1 - y0 };
  }
  function moveTo(finding, lit) {
    const view = viewOf("plan");
    if (!view) return;
    const close = Math.min(view.scale, view.fitScale(), Math.max(11, view.box.width / 12) / view.size.width);
    if (finding.at) return view.go(finding.at[0], finding.at[1], close);
    const here = lit.filter((shape) => view.svg.contains(shape));
    if (!here.length) return;
    const bounds = boundsOf(here), { width, height } = view.size;
    view.go(bounds.x, bounds.y, Math.min(view.fitScale(), Math.max(bounds.width / width, bounds.height / height, 0.01) * 1.6));
  }

  function select(n, fromPin) {
    const entry = entryOf.get(n);
    if (!entry) return;
    const before = entryOf.get(state.selected);
    if (before) before.item.classList.remove("selected"), before.pick.removeAttribute("aria-current"), before.pick.tabIndex = -1;
    pinOf.get(state.selected)?.classList.remove("selected");
    state.selected = n;
    entry.item.classList.add("selected");
    entry.pick.setAttribute("aria-current", "true");
    for (const other of shown) other.pick.tabIndex = -1;
    entry.pick.tabIndex = 0;
    const pin = pinOf.get(n), lit = light(entry.finding);
    if (pin) pin.classList.add("selected"), pin.parentNode.append(pin);
    const storey = entry.finding.storey ?? state.storey;
    if (storey !== state.storey) showStorey(storey);
    entry.item.scrollIntoView({ block: "nearest", behavior: fromPin && !calm.matches ? "smooth" : "auto" });
    if (!fromPin) moveTo(entry.finding, lit);
    viewOf("plan")?.gather();
    const stageBox = planStage?.getBoundingClientRect();
    if (!fromPin && stageBox && (stageBox.bottom < 120 || stageBox.top > innerHeight - 120)) planStage.scrollIntoView({ block: "start" });
  }

  list.addEventListener("click", (event) => {
    const pick = event.target.closest(".pick");
    if (pick) select(Number(pick.parentNode.dataset.n), false);
  });
  list.addEventListener("keydown", (event) => {
    const at = shown.findIndex((entry) => entry.pick === document.activeElement);
    if (at < 0) return;
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: shown.length - 1, PageDown: at + 10, PageUp: at - 10 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const next = shown[Math.min(Math.max(to, 0), shown.length - 1)];
    shown[at].pick.tabIndex = -1;
    next.pick.tabIndex = 0;
    next.pick.focus();
  });
  planStage?.addEventListener("click", (event) => {
    const pin = event.target.closest(".pin"), view = viewOf("plan");
    if (!pin || view.moved >= 5) return;
    const n = Number(pin.dataset.n), here = byNumber.get(n);
    if (n !== state.selected) return select(n, true);
    // A second click goes on to what the pin stands for as well.
    const near = view.near;
    const group = shown.map((entry) => entry.finding).filter((f) => f.at && f.storey === here.storey && Math.hypot(f.at[0] - here.at[0], f.at[1] - here.at[1]) < near);
    if (group.length > 1) select(group[(group.findIndex((f) => f.n === n) + 1) % group.length].n, true);
  });
  search.addEventListener("input", filter);
  for (const box of [codeBox, sortBox, ...all("[data-severity]")]) box.addEventListener("change", filter);
  for (const button of all("[data-code]"))
    button.addEventListener("click", () => {
      codeBox.value = button.dataset.code;
      filter();
      one(".workspace").scrollIntoView();
    });

  // ---- Plans and findings fill what the header leaves of the window. ------------------------------------------------
  const header = one(".top");
  new ResizeObserver(() => one(".workspace").style.setProperty("--top", `${header.offsetHeight}px`)).observe(header);

  // ---- Paper -------------------------------------------------------------------------------------------------------
  addEventListener("beforeprint", () => {
    for (const view of views.values()) {
      view.svg.setAttribute("viewBox", view.svg.dataset.box);
      view.svg.style.transform = "";
      for (const group of view.scaled) group.style.setProperty("--k", Math.max(view.box.width, view.box.height) / 900);
    }
  });
  addEventListener("afterprint", () => { for (const view of views.values()) view.drawn = NaN, view.show(); });

  filter.sorted = "n";
  showStorey(0);
  filter();
  const wanted = /^#finding-(\d+)$/.exec(location.hash);
  if (wanted) requestAnimationFrame(() => select(Number(wanted[1]), false));
})();
