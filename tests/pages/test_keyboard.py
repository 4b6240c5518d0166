"""A whole study by keys alone."""

import pytest


class Keys:
    """Hands on a keyboard."""

    def __init__(self, page):
        self.page = page

    def press(self, key, times=1):
        for _ in range(times):
            self.page.keyboard.press(key)

    def reach(self, selector):
        """Go to a control with the Tab key."""
        for _ in range(40):
            if self.page.evaluate("at => document.activeElement.matches(at)", selector):
                return
            self.press("Tab")
        raise AssertionError(f"Tab never reaches {selector}")

    def go(self, name, selector="button.main"):
        """Wait for a page, and press one of its buttons."""
        self.page.wait_for_function(
            "name => document.querySelector(`.page-${name} .sheet`) !== null", arg=name
        )
        self.reach(f".page-{name} {selector}")
        self.press("Enter")


def test_a_whole_study_needs_no_pointer(whole):
    with whole.visited() as guard:
        person = guard.open()
        keys = Keys(person.page)
        keys.go("language", "button[lang=en]")
        person.at("consent")
        keys.go("consent")
        assert person.page.inner_text(".missing") == "Please tick the box if you agree."
        keys.press("Space")  # the focus is on the box
        keys.go("consent")
        person.at("groups")
        keys.go("groups")
        assert person.page.inner_text(".missing") == "Please answer every question."
        keys.press("ArrowDown")
        for name in ("groups", "notes", "screen", "full"):
            keys.go(name)
        person.at("card")
        keys.press("ArrowRight", 20)
        keys.go("card")
        person.at("blind-spot")
        keys.press("Space", 6)
        person.at("gamma")
        keys.press("PageUp", 3)
        keys.go("gamma")
        keys.go("dark", ".patches button:nth-child(2)")
        person.at("contrast")
        keys.press("ArrowUp", 10)
        person.at("colour")
        keys.press("5", 7)
        given = []
        while (name := person.wait()) != "thanks":
            if name != "pair":
                keys.go(name)
                continue
            key, chosen = (("ArrowLeft", "left"), ("ArrowRight", "right"), ("=", "tie"))[
                len(given) % 3
            ]
            pair = person.page.wait_for_selector(".pair")
            person.page.wait_for_timeout(130)
            keys.press(key)
            pair.wait_for_element_state("hidden")
            given.append(chosen)
    session, answers = whole.stored()
    assert [row["chosen"] for row in answers] == given
    assert len(given) == 23
    assert session.screen["card"]["px_per_mm"] == pytest.approx((323.5 + 10) / 85.6, abs=0.01)
    assert session.screen["darkest_step"] == 4
    assert session.groups["trade"] in ("yes", "no")
