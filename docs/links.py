"""Checks that every link of the site leads to a file and a heading that are there: links.py SITE. `docs/site.sh` calls it."""

import re
import sys
from html.parser import HTMLParser
from pathlib import Path

# The page that simulates drops makes its own contents; those of mdBook hold every page again, or none.
PASSED_OVER = {"drop.html", "print.html", "toc.html", "404.html"}


class Page(HTMLParser):
    """Anchors and links of a page."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.anchors |= {attributes[name] for name in ("id", "name") if attributes.get(name)}
        self.links += [attributes[name] for name in ("href", "src") if attributes.get(name)]


def main(site):
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in site.rglob("*.html") if path.name not in PASSED_OVER}
    broken = []
    for path, page in pages.items():
        for link in page.links:
            if re.match(r"[a-z]+:", link):
                continue
            name, _, anchor = link.partition("#")
            target = (path.parent / name).resolve() if name else path
            missing = not target.exists() or (anchor and target in pages and anchor not in pages[target].anchors)
            if missing:
                broken.append(f"{path.relative_to(site)}: {link}")
    print(f"{sum(len(page.links) for page in pages.values())} links of {len(pages)} pages, {len(broken)} broken")
    sys.exit("\n".join(broken) or None)


main(Path(sys.argv[1]).resolve())
