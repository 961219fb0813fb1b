#!/usr/bin/python3
"""The report's page in headless Chromium, opened from its file: nothing is fetched, nothing complains, and a click on a
finding moves to its pin.

browser_test.py PAGE_WRITER [SCREENSHOT_FOLDER]. Ends with 77, and says so, where there is no browser.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select
except ImportError:
    print("skipped: no python3-selenium")
    sys.exit(77)
if not (shutil.which("chromium") and shutil.which("chromedriver")):
    print("skipped: no chromium with its chromedriver")
    sys.exit(77)

WRITER = sys.argv[1]
SCREENSHOTS = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
LAYERS = ["rooms", "names", "walls", "doors", "windows", "stairs", "furniture", "cells", "portals", "cuts", "graph", "grid", "pins"]


def start_browser():
    options = webdriver.ChromeOptions()
    for flag in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--force-prefers-reduced-motion"):
        options.add_argument(flag)
    options.binary_location = shutil.which("chromium")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        subprocess.run([WRITER, cls.folder.name], check=True)
        cls.browser = start_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.folder.cleanup()

    def open(self, name, width=1440, height=900, dark=False):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}, {"name": "prefers-reduced-motion", "value": "reduce"}]})
        self.browser.get("about:blank")
        self.browser.get_log("browser")
        self.browser.get(pathlib.Path(self.folder.name, name + ".html").as_uri())
        self.settle()

    def tearDown(self):
        if SCREENSHOTS and self.browser.current_url.startswith("file:"):
            SCREENSHOTS.mkdir(parents=True, exist_ok=True)
            self.browser.save_screenshot(str(SCREENSHOTS / (self._testMethodName + ".png")))

    def run_js(self, script, *words):
        return self.browser.execute_script(script, *words)

    def all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def settle(self):
        """Until what was asked for is painted, the drawing that rests included."""
        time.sleep(0.25)
        self.browser.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")

    def box(self, selector):
        return self.run_js("const r = document.querySelector(arguments[0]).getBoundingClientRect();"
                           "return {x: r.x, y: r.y, width: r.width, height: r.height, right: r.right, bottom: r.bottom}", selector)

    def click_finding(self, item):
        self.run_js("arguments[0].querySelector('.pick').click()", item)
        self.settle()

    def open_layers(self):
        self.run_js("document.querySelector('.layers').open = true")

    # ---- What the page is -------------------------------------------------------------------------------------------

    def test_nothing_complains_and_nothing_is_fetched(self):
        for name in ("house", "sound", "office", "odd", "stripped"):
            with self.subTest(name):
                self.open(name)
                self.run_js("window.scrollTo(0, document.body.scrollHeight)")
                self.settle()
                self.assertEqual(self.browser.get_log("browser"), [])
                self.assertEqual(self.run_js("return performance.getEntriesByType('resource').map((entry) => entry.name)"), [])
                self.assertEqual(self.run_js("return document.documentElement.className"), "js")

    def test_names_do_not_become_markup(self):
        self.open("odd")
        self.assertTrue(self.browser.title.startswith("</title><script>"), self.browser.title)
        self.assertEqual(self.one("h1").text, "</title><script>document.title = 'taken'</script>")
        self.assertEqual(len(self.all("script")), 2)
        texts = self.run_js("return [...document.querySelectorAll('#plan-0 .names text')].map((t) => t.textContent)")
        self.assertIn("🛋 客厅", " ".join(texts))
        self.assertEqual(self.run_js("return document.querySelector('#plan-0 .room[data-el=\"r\\\\\"1\"] title').textContent.split(',')[0]"), "</script><script>throw 1</script>")

    def test_names_lie_inside_their_rooms_and_apart(self):
        for name in ("house", "office"):
            self.open(name, 2400, 2000)
            self.run_js("for (const g of document.querySelectorAll('#plan-0 .names')) g.style.display = ''")
            boxes = self.run_js("return [...document.querySelectorAll('#plan-0 .names > g')].map((g) => { const r = g.getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom]; })")
            self.assertGreater(len(boxes), 6)
            for i, a in enumerate(boxes):
                for b in boxes[i + 1:]:
                    self.assertFalse(a[0] < b[2] - 1 and a[2] > b[0] + 1 and a[1] < b[3] - 1 and a[3] > b[1] + 1, (name, a, b))

    # ---- Findings ---------------------------------------------------------------------------------------------------

    def assert_shows_pin(self, number):
        pin, frame = self.box(f"#pin-{number}"), self.box(".sheet.active .frame")
        window = self.run_js("return [innerWidth, innerHeight]")
        self.assertGreater(pin["width"], 5)
        self.assertTrue(pin["x"] >= 0 and pin["y"] >= 0 and pin["right"] <= window[0] and pin["bottom"] <= window[1], (pin, window))
        # The tip of the pin is its place.
        self.assertAlmostEqual(pin["x"] + pin["width"] / 2, frame["x"] + frame["width"] / 2, delta=30)
        self.assertAlmostEqual(pin["bottom"], frame["y"] + frame["height"] / 2, delta=30)
        self.assertIn("selected", self.run_js("return document.getElementById(arguments[0]).getAttribute('class')", f"pin-{number}"))

    def test_a_click_on_a_finding_moves_to_its_pin(self):
        self.open("house")
        with_pins = [item for item in self.all(".finding") if self.all(f"#pin-{item.get_attribute('data-n')}")]
        storeys = set()
        for item in (with_pins[0], with_pins[-1], with_pins[len(with_pins) // 2]):
            self.click_finding(item)
            self.assert_shows_pin(item.get_attribute("data-n"))
            self.assertIn("selected", item.get_attribute("class"))
            storeys.add(self.one("[data-view=plan] [role=tab][aria-selected=true]").text)
            self.assertTrue(self.all(".plan .lit"), "the wall that it names is lit")
        self.assertEqual(len(storeys), 2, "both storeys were shown")

    def test_a_click_on_a_finding_of_a_large_drawing_moves_to_its_pin(self):
        self.open("office", 1100, 700)
        item = self.all(".finding")[3]
        self.click_finding(item)
        self.assert_shows_pin(item.get_attribute("data-n"))

    def test_a_click_on_a_pin_selects_its_finding(self):
        self.open("house")
        pin = [p for p in self.all("#plan-0 .pin") if p.is_displayed()][0]
        number = pin.get_attribute("data-n")
        self.run_js("const r = arguments[0].getBoundingClientRect(), options = {bubbles: true, clientX: r.x + r.width / 2, clientY: r.y + 5};"
                    "arguments[0].dispatchEvent(new PointerEvent('pointerdown', options));"
                    "arguments[0].dispatchEvent(new MouseEvent('click', options))", pin)
        self.settle()
        item = self.one(f"#finding-{number}")
        self.assertIn("selected", item.get_attribute("class"))
        entry, panel = self.box(f"#finding-{number}"), self.box(".findings")
        self.assertTrue(panel["y"] - 2 <= entry["y"] and entry["bottom"] <= panel["bottom"] + 2, (entry, panel))

    def test_findings_without_a_place_are_listed(self):
        self.open("house")
        item = [i for i in self.all(".finding") if not self.all(f"#pin-{i.get_attribute('data-n')}")][0]
        self.assertIn("no place", item.text)
        self.click_finding(item)
        self.assertIn("selected", item.get_attribute("class"))

    def test_keys_walk_the_list(self):
        self.open("house")
        items = self.all(".finding")
        self.run_js("arguments[0].focus()", items[0].find_element(By.CSS_SELECTOR, ".pick"))
        self.browser.switch_to.active_element.send_keys(Keys.ARROW_DOWN)
        self.browser.switch_to.active_element.send_keys(Keys.ARROW_DOWN)
        self.browser.switch_to.active_element.send_keys(Keys.ENTER)
        self.settle()
        self.assertIn("selected", items[2].get_attribute("class"))
        self.assertEqual(len(self.all(".pick[tabindex='0']")), 1, "one stop for the Tab key")

    def shown(self):
        return [item for item in self.all(".finding") if item.is_displayed()]

    def test_filters_leave_what_was_asked_for(self):
        self.open("house")
        total = len(self.shown())
        self.run_js("document.querySelector('[data-severity=error]').click()")
        left = self.shown()
        self.assertTrue(0 < len(left) < total)
        self.assertFalse([item for item in left if "error" in item.get_attribute("class").split()])
        hidden = self.run_js("return [...document.querySelectorAll('.pin.error')].filter((pin) => getComputedStyle(pin).display !== 'none').length")
        self.assertEqual(hidden, 0, "their pins go with them")
        self.run_js("document.querySelector('[data-severity=error]').click()")
        Select(self.one("#code")).select_by_value("G5")
        self.assertTrue(0 < len(self.shown()) < total)
        self.assertEqual({item.find_element(By.CSS_SELECTOR, ".code").get_attribute("textContent") for item in self.shown()}, {"G5"})
        Select(self.one("#code")).select_by_value("")
        self.one("#search").send_keys("whole fault")
        self.assertEqual([item.find_element(By.CSS_SELECTOR, ".sentence").text for item in self.shown()], ["The whole is at fault."])
        self.assertEqual(self.one("#shown").text, f"1 of {total} shown")

    def test_lists_sort(self):
        self.open("house")
        Select(self.one("#sort")).select_by_value("code")
        codes = self.run_js("return [...document.querySelectorAll('.finding .code')].map((code) => code.textContent)")
        self.assertEqual(codes, sorted(codes))

    def test_a_link_to_a_finding_opens_it(self):
        self.open("house")
        self.browser.get(self.browser.current_url + "#finding-3")
        self.browser.refresh()
        self.settle()
        self.assertIn("selected", self.one("#finding-3").get_attribute("class"))

    # ---- The drawing ------------------------------------------------------------------------------------------------

    def test_each_layer_is_switched(self):
        self.open("house")
        self.open_layers()
        for layer in LAYERS:
            display = lambda: self.run_js("return getComputedStyle(document.querySelector('#plan-0 .layer-' + arguments[0])).display", layer)
            box = self.one(f"[data-layer={layer}]")
            self.assertEqual(display() != "none", box.is_selected(), layer)
            before = display()
            box.click()
            self.assertNotEqual(display(), before, layer)
            box.click()
            self.assertEqual(display(), before, layer)

    def view(self):
        return [float(number) for number in self.one("#plan-0").get_dom_attribute("viewBox").split()]

    def test_wheel_keys_buttons_and_drags_move_the_view(self):
        self.open("house")
        fit = self.view()
        frame = self.box("#plan-0")
        at = (round(frame["x"] + frame["width"] / 4), round(frame["y"] + frame["height"] / 4))
        share = ((at[0] - frame["x"]) / frame["width"], (at[1] - frame["y"]) / frame["height"])
        under = lambda view: (view[0] + view[2] * share[0], view[1] + view[3] * share[1])
        self.run_js("document.querySelector('#plan-0').dispatchEvent(new WheelEvent('wheel', {deltaY: -120, clientX: arguments[0], clientY: arguments[1], bubbles: true, cancelable: true}))", *at)
        self.settle()
        zoomed = self.view()
        self.assertLess(zoomed[2], fit[2])
        for a, b in zip(under(fit), under(zoomed)):
            self.assertAlmostEqual(a, b, places=3, msg="what is under the pointer stays there")
        self.one("[data-view=plan] [data-zoom=fit]").click()
        self.settle()
        self.assertEqual(self.view(), fit)
        self.one("[data-view=plan] [data-zoom=in]").click()
        self.settle()
        self.assertLess(self.view()[2], fit[2])
        before = self.view()
        self.one("#plan-0").send_keys(Keys.ARROW_RIGHT)
        self.settle()
        self.assertGreater(self.view()[0], before[0])
        before = self.view()
        webdriver.ActionChains(self.browser).move_to_element(self.one("#plan-0")).click_and_hold().move_by_offset(100, 40).move_by_offset(20, 0).release().perform()
        self.settle()
        moved = self.view()
        self.assertAlmostEqual((before[0] - moved[0]) / before[2] * frame["width"], 120, delta=8)
        self.assertAlmostEqual((before[1] - moved[1]) / before[3] * frame["height"], 40, delta=8)

    def test_the_whole_building_is_seen_at_first(self):
        for name in ("house", "office"):
            self.open(name)
            frame, walls = self.box("#plan-0"), self.box("#plan-0 .wall:not(.low)")
            self.assertTrue(frame["x"] <= walls["x"] and walls["right"] <= frame["right"], (frame, walls))
            self.assertTrue(frame["y"] <= walls["y"] and walls["bottom"] <= frame["bottom"], (frame, walls))
            self.assertGreater(walls["height"] / frame["height"] + walls["width"] / frame["width"], 1)
            self.assertLessEqual(frame["bottom"], 900, "without scrolling")

    def test_storeys_change_together_with_their_graph(self):
        self.open("house")
        self.all("[data-view=plan] [role=tab]")[1].click()
        self.settle()
        self.assertTrue(self.one("#plan-1").is_displayed())
        self.assertFalse(self.one("#plan-0").is_displayed())
        self.run_js("document.querySelector('.graphs').scrollIntoView()")
        self.settle()
        self.assertTrue(self.one("#graph-1").is_displayed())
        self.assertGreater(len(self.all("#graph-1 .gnode")), 3)

    # ---- Other windows ----------------------------------------------------------------------------------------------

    def test_dark(self):
        self.open("house", dark=True)
        brightness = lambda selector, what: sum(int(part) for part in self.run_js(
            "return getComputedStyle(document.querySelector(arguments[0]))[arguments[1]]", selector, what).strip("rgb()").split(",")[:3])
        self.assertLess(brightness("body", "backgroundColor"), 120)
        self.assertGreater(brightness("h1", "color"), 550)
        self.assertGreater(brightness(".wall", "fill"), brightness(".room", "fill") + 200)

    def test_phone(self):
        self.open("house", 400, 850)
        self.assertLessEqual(self.run_js("return document.documentElement.scrollWidth"), 400)
        item = self.all(".finding")[4]
        self.run_js("arguments[0].scrollIntoView({block: 'center'})", item)
        self.click_finding(item)
        self.assert_shows_pin(item.get_attribute("data-n"))

    def test_paper_shows_every_storey(self):
        self.open("house")
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
        shown = self.run_js("return [...document.querySelectorAll('[data-view=plan] .sheet')].map((sheet) => getComputedStyle(sheet).display)")
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
        self.assertEqual(shown, ["block", "block"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
