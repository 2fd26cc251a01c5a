# SPDX-License-Identifier: Apache-2.0
"""What mkdocs does besides: the tables of the dossier, and the search of a site that is opened as a file, where a browser neither fetches an index nor
starts a worker."""
import json
import pathlib
import re


def on_post_page(output, page, config):
    """Puts the tables of the dossier into their places."""
    tables = pathlib.Path(config["docs_dir"]) / ".tables"
    return re.sub(r'<div data-table="(\d+)"></div>', lambda place: (tables / f"{place[1]}.html").read_text(), output)


def on_post_build(config):
    site = pathlib.Path(config["site_dir"])
    index = json.loads((site / "search/search_index.json").read_text())
    # Thousands of checks would hide the pages that explain; the table of the dossier leads to them.
    index["docs"] = [page for page in index["docs"] if not page["location"].startswith("dossier/")]
    index = json.dumps(index, separators=(",", ":"))
    (site / "search/search_index.json").write_text(index)
    worker = next(site.glob("assets/javascripts/workers/search.*.js")).read_text()
    (site / "search/offline.js").write_text(
        f"var __search = {{index: Promise.resolve({index}),\n"
        f"  worker: URL.createObjectURL(new Blob([{json.dumps(worker)}], {{type: 'text/javascript'}}))}};\n")
