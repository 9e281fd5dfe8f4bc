"""What is wrong with the links of a site: those that lead nowhere, and what a page would fetch from elsewhere."""
import os
import re
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

# Attributes that a browser follows by itself.
FETCHED = {("script", "src"), ("img", "src"), ("iframe", "src"), ("source", "src"), ("video", "src"), ("source", "srcset"),
           ("img", "srcset"), ("object", "data")}
STYLED = re.compile(r"url\(\s*['\"]?(https?:)?//|@import\s+['\"]?(https?:)?//")


class Page(HTMLParser):
    """Of one file: the ids of its elements, its links, and what it fetches."""

    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.fetched = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name == "id" or (tag == "a" and name == "name"):
                self.ids.add(value)
            elif tag == "a" and name == "href":
                self.links.append(value or "")
            elif (tag, name) in FETCHED:
                self.fetched.append(value or "")
        given = dict(attrs)
        if tag == "link" and set((given.get("rel") or "").split()) & {"stylesheet", "icon", "preload", "preconnect", "dns-prefetch"}:
            self.fetched.append(given.get("href") or "")


def pages_of(site):
    for folder, _, names in os.walk(site):
        for name in names:
            if name.endswith(".html") and name != "404.html":
                path = os.path.join(folder, name)
                with open(path, encoding="utf-8") as file:
                    yield path, Page(file.read())


def target_of(path, link):
    """(file, id) that a link of a page leads to; None for other servers."""
    parts = urlsplit(link)
    if parts.scheme or parts.netloc:
        return None
    found = os.path.normpath(os.path.join(os.path.dirname(path), unquote(parts.path))) if parts.path else path
    return os.path.join(found, "index.html") if os.path.isdir(found) else found, unquote(parts.fragment)


def faults(site):
    """As sentences."""
    pages, out = dict(pages_of(site)), []
    for path, page in sorted(pages.items()):
        name = os.path.relpath(path, site)
        for link in page.links + page.fetched:
            target = target_of(path, link)
            if target is None:
                if link in page.fetched and not link.startswith("data:"):
                    out.append(f"{name}: fetches {link} from another server")
                continue
            file, anchor = target
            if not os.path.isfile(file):
                out.append(f"{name}: {link} leads nowhere")
            elif anchor and file in pages and anchor not in pages[file].ids:
                out.append(f"{name}: {link}: there is no such heading")
    for folder, _, names in os.walk(site):
        for each in names:
            if each.endswith(".css"):
                with open(os.path.join(folder, each), encoding="utf-8") as file:
                    if STYLED.search(file.read()):
                        out.append(f"{os.path.relpath(os.path.join(folder, each), site)}: fetches from another server")
    return out
