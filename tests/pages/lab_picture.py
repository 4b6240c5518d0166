"""The picture of the laboratory in docs/experimenters.md; all observers in it are simulated.

python -m tests.pages.lab_picture docs/pictures/laboratory.png
"""

import re
import sys
import tempfile
from pathlib import Path

from tests.pages.browser import chromium
from tests.study.test_demo import running


def main(output: str) -> None:
    """Take the picture of the scale of the demonstration."""
    with (
        tempfile.TemporaryDirectory() as temporary,
        running(Path(temporary)) as (_, lines),
        chromium() as browser,
    ):
        said = "\n".join(lines)
        found = re.search(r"(http://\S+)/lab +name: (\S+) +password: (\S+)", said)
        if found is None:
            raise SystemExit(said)
        url, name, password = found.groups()
        page = browser.new_page(viewport={"width": 1120, "height": 760}, locale="en-GB")
        page.goto(f"{url}/lab#scale")
        page.fill("#name", name)
        page.fill("#password", password)
        page.keyboard.press("Enter")
        page.check("#whose-simulated")
        page.wait_for_selector("svg.chart.simulated")
        page.wait_for_load_state("networkidle")
        page.screenshot(path=output)


if __name__ == "__main__":
    main(sys.argv[1])
