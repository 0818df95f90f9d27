"""`report.html` as a person meets it: in Chromium, from a file, without a network."""

from __future__ import annotations

import colorsys
import io
import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from page_runs import HOSTILE, MOMENTS, Opened, run_of
from PIL import Image

from robolayout.assets import parts
from robolayout.program import read_program
from robolayout.run.result import Result
from robolayout.scene import Scene
from running import slow

Open = Callable[..., Opened]
GROUND = (0xF4, 0xF3, 0xEF)


def canvas_of(page) -> Image.Image:
    """Return what is drawn, once two pictures running are the same."""
    shots = [b"", page.locator("#canvas").screenshot()]
    while shots[-1] != shots[-2] and len(shots) < 50:
        page.wait_for_timeout(120)
        shots.append(page.locator("#canvas").screenshot())
    return Image.open(io.BytesIO(shots[-1])).convert("RGB")


def click_asset(page, name: str) -> None:
    box = page.locator("#canvas").bounding_box()
    x, y = page.evaluate("name => robolayout.project(name)", name)
    page.mouse.click(box["x"] + x, box["y"] + y)


def focused(page) -> str:
    return page.evaluate(
        "() => document.activeElement.dataset.asset ?? (document.activeElement.id || document.activeElement.tagName)"
    )


def test_it_opens_without_a_word_and_asks_for_nothing(opened: Open, run: Result) -> None:
    found = opened(run)
    assert found.page.evaluate("() => document.documentElement.dataset.ready") == "3d"
    assert found.page.evaluate("() => document.documentElement.dataset.three") == "187"
    assert found.page.title() == "bedroom - RoboLayout report"
    assert found.said == []
    assert len(found.asked) == 1 and found.asked[0].startswith("file://")


@pytest.mark.slow
def test_a_click_on_an_asset_says_what_it_is(opened: Open, run: Result) -> None:
    page = opened(run).page
    card = page.locator("#asset")
    for name in ("double_bed-0", "wardrobe-0", "armchair-0"):
        click_asset(page, name)
        assert card.locator("code").first.inner_text() == name
        text, asset = card.inner_text(), run.scene.by_name[name]
        assert asset.description in text
        depth, width, height = asset.size
        assert f"{width:.2f} wide, {depth:.2f} deep, {height:.2f} high (m)" in text
        about = [s for s in run.report.statements if name in s.sentence]
        assert card.locator(".statements li").count() == len(about) > 0
        assert all(statement.sentence in text and statement.text in text for statement in about)
        words = asset.variable.replace("_", " ")
        assert page.locator(f"#assets button[aria-pressed=true] >> text={words}").count() == 1


def test_met_and_unmet_statements_look_different(opened: Open, run: Result) -> None:
    page = opened(run).page
    click_asset(page, "double_bed-0")
    marks = page.locator("#asset .statements .mark").evaluate_all(
        "nodes => nodes.map(n => n.ariaLabel ?? n.getAttribute('aria-label'))"
    )
    assert marks == ["met", "met", "not met"]
    assert page.locator("#verdict").inner_text().strip().endswith("Not all demands are met")


@pytest.mark.slow
def test_the_keyboard_reaches_everything(opened: Open, run: Result) -> None:
    page = opened(run).page
    reached: list[str] = []
    while "0" not in reached and len(reached) < 40:
        page.keyboard.press("Tab")
        reached.append(focused(page))
        outline = page.evaluate("() => getComputedStyle(document.activeElement).outlineStyle")
        assert outline != "none", f"{reached[-1]} does not show that it has the focus"
    assert "canvas" in reached and "play" in reached and "step" in reached and reached[-1] == "0"
    page.keyboard.press("ArrowDown")
    assert focused(page) == "1"
    page.keyboard.press("Enter")
    assert page.locator("#asset h2").inner_text().lower() == "night stand 0"
    assert focused(page) == "asset"
    page.keyboard.press("Escape")
    assert page.locator("#asset").is_hidden() and focused(page) == "1"


@pytest.mark.slow
def test_arrow_keys_turn_the_room(opened: Open, run: Result) -> None:
    page = opened(run).page
    before = canvas_of(page)
    page.locator("#canvas").focus()
    for _ in range(4):
        page.keyboard.press("ArrowLeft")
    assert changed(before, canvas_of(page)) > 0.05


def changed(before: Image.Image, after: Image.Image) -> float:
    """Return the share of pixels that are clearly another colour."""
    difference = np.abs(np.asarray(before, np.int16) - np.asarray(after, np.int16)).max(axis=-1)
    return float((difference > 16).mean())


@pytest.mark.slow
def test_toggles_show_and_hide(opened: Open, run: Result) -> None:
    page = opened(run).page
    before = canvas_of(page)
    for layer in ("free", "routes", "reach", "labels"):
        button = page.locator(f"[data-layer={layer}]")
        pressed = button.get_attribute("aria-pressed")
        button.click()
        page.mouse.move(440, 780)
        assert button.get_attribute("aria-pressed") != pressed
        assert changed(before, canvas_of(page)) > 0.003, layer
        button.click()
        page.mouse.move(440, 780)
        assert button.get_attribute("aria-pressed") == pressed
        assert changed(before, canvas_of(page)) < 0.0005, layer


def test_another_body_has_other_figures(opened: Open, run: Result) -> None:
    page = opened(run).page
    for number, report in ((1, run.report.agents[1]), (0, run.report.agents[0])):
        page.locator(f"[data-agent='{number}']").click()
        text = page.locator("#agent").inner_text()
        assert f"{report.navigation.free.area:.1f} m\u00b2" in text
        assert f"{report.usage.usable_share:.0%}" in text
        marks = page.locator("#assets .mark").evaluate_all("nodes => nodes.map(n => n.getAttribute('aria-label'))")
        assert marks.count("not met") == len(report.short)
    page.locator("[data-agent='0']").focus()
    page.keyboard.press("ArrowRight")
    assert page.locator("[data-agent='1']").get_attribute("aria-checked") == "true"
    assert focused(page) == "BUTTON"


def from_above(page) -> None:
    page.locator("[data-camera=top]").click()
    page.mouse.move(440, 780)
    page.wait_for_timeout(700)  # the flight of the eye


@pytest.mark.slow
def test_the_legend_covers_no_furniture(opened: Open, run: Result) -> None:
    page = opened(run).page
    page.locator("[data-layer=reach]").click()
    page.locator("#assets button").first.click()
    for seen_from in (lambda page: None, from_above):
        seen_from(page)
        box, view = page.locator("#legend").bounding_box(), page.locator("#canvas").bounding_box()
        assert page.locator("#legend li").count() >= 3 and box["width"] > 200
        page.evaluate("() => (document.getElementById('legend').style.visibility = 'hidden')")
        left, top = box["x"] - view["x"], box["y"] - view["y"]
        behind = canvas_of(page).crop((left, top, left + box["width"], top + box["height"]))
        assert behind.getcolors() == [(behind.width * behind.height, GROUND)]
        page.evaluate("() => (document.getElementById('legend').style.visibility = '')")


@pytest.mark.slow
def test_lamps_are_ghosts_from_above(opened: Open, run: Result) -> None:
    page = opened(run).page
    for layer in ("free", "routes", "labels"):
        page.locator(f"[data-layer={layer}]").click()
    from_above(page)
    picture = canvas_of(page)
    x, y = page.evaluate("name => robolayout.project(name)", "ceiling_lamp-0")
    lamp = np.asarray(picture.crop((round(x) - 12, round(y) - 12, round(x) + 12, round(y) + 12)), np.int16)
    colorful = (lamp.max(axis=-1) - lamp.min(axis=-1) > 25).mean()
    assert colorful > 0.5, "floor and rug shine through the white lamp"


@pytest.mark.slow
def test_the_layers_of_a_rug_do_not_fight_in_a_large_room(opened: Open, bedroom: Scene) -> None:
    room = replace(bedroom.room, vertices=((0, 0), (14, 0), (14, 12), (0, 12)), windows=())
    rug = replace(bedroom.by_name["rug-0"], description="")
    scene = replace(bedroom, room=room, assets=(rug,))
    page = opened(run_of(scene, {"rug-0": (7, 6, 0.005, 0)}, read_program("", scene))).page
    for layer in ("free", "routes", "labels"):
        page.locator(f"[data-layer={layer}]").click()
    from_above(page)
    picture = canvas_of(page)
    x, y = page.evaluate("name => robolayout.project(name)", "rug-0")
    picture = picture.crop((round(x) - 30, round(y) - 40, round(x) + 30, round(y) + 40))
    assert changed(picture, picture.transpose(Image.Transpose.ROTATE_180)) < 0.06, "a rug looks alike from both ends"


@pytest.mark.slow
def test_the_search_can_be_stepped_through_and_played(opened: Open, run: Result) -> None:
    page = opened(run).page
    slider, moment = page.locator("#step"), page.locator("#moment")
    assert moment.inner_text() == "result"
    slider.focus()
    page.keyboard.press("ArrowLeft")
    assert moment.inner_text() == f"search, step {10 * (MOMENTS - 1)}"
    assert slider.get_attribute("aria-valuetext") == moment.inner_text()
    page.keyboard.press("Home")
    middle = [page.evaluate("name => robolayout.project(name)", name) for name in ("wardrobe-0", "armchair-0")]
    assert abs(middle[0][0] - middle[1][0]) < 3, "at the first moment all things stand in the middle of the room"
    page.locator("#play").click()
    page.locator("#moment", has_text="result").wait_for()
    page.locator("#play[aria-label='Play the search']").wait_for()
    wardrobe = page.evaluate("name => robolayout.project(name)", "wardrobe-0")
    assert math.dist(wardrobe, middle[0]) > 50


def test_hostile_text_is_shown_and_does_nothing(opened: Open, strange_run: Result) -> None:
    found = opened(strange_run)
    page = found.page
    page.locator("#assets button").first.click()
    assert page.locator(".description").text_content() == HOSTILE
    for button in ("[data-agent='1']", "[data-layer=reach]", "[data-camera=top]"):
        page.locator(button).click()
    canvas_of(page)
    assert page.evaluate("() => [window.hacked ?? null, document.images.length, document.scripts.length]") == [
        None,
        0,
        3,
    ]
    assert found.said == [] and len(found.asked) == 1
    assert page.locator("#assets button").count() == len(strange_run.scene.assets)


@pytest.mark.slow
def test_colours_are_those_of_the_materials(opened: Open, run: Result) -> None:
    """Light takes from a colour and never turns it: hue and, nearly, saturation are those of the sRGB colour."""
    page = opened(run).page
    for layer in ("free", "routes", "labels"):
        page.locator(f"[data-layer={layer}]").click()
    picture = canvas_of(page)
    assert picture.getpixel((5, 400)) == GROUND
    x, y = page.evaluate("name => robolayout.project(name)", "armchair-0")
    hue, _, saturation = colorsys.rgb_to_hls(*(c / 255 for c in picture.getpixel((round(x), round(y)))))
    fabrics = {p.material.color for p in parts(run.scene.by_name["armchair-0"]) if "fabric" in p.material.name}
    wanted = [colorsys.rgb_to_hls(*color) for color in fabrics]
    assert any(abs(hue - h) < 0.06 and abs(saturation - s) < 0.12 for h, _, s in wanted), (hue, saturation, wanted)


def test_without_3d_the_figures_remain(opened: Open, run: Result) -> None:
    page = opened(run, "--disable-3d-apis").page
    assert page.evaluate("() => document.documentElement.dataset.ready") == "flat"
    assert page.locator("#message").inner_text().startswith("No 3D here: ")
    page.locator("#assets button").nth(2).click()
    assert page.locator("#asset code").first.inner_text() == "night_stand-1"


@pytest.mark.parametrize(("width", "height"), [slow(390, 844), (320, 640), slow(844, 390)])
def test_a_phone_needs_no_sideways_scrolling(opened: Open, run: Result, width: int, height: int) -> None:
    page = opened(run, width=width, height=height).page
    assert page.evaluate("() => document.documentElement.scrollWidth") <= width
    canvas = page.locator("#canvas").bounding_box()
    assert canvas["width"] <= width and canvas["height"] >= 0.4 * height
    page.locator("#assets button").nth(3).click()
    assert page.locator("#asset").bounding_box()["y"] < height
