# SPDX-License-Identifier: Apache-2.0
"""What mkdocs does besides: the search of a site that is opened as a file, where a browser neither fetches an index nor starts a worker."""
import json
import pathlib


def on_post_build(config):
    site = pathlib.Path(config["site_dir"])
    index = (site / "search/search_index.json").read_text()
    worker = next(site.glob("assets/javascripts/workers/search.*.js")).read_text()
    (site / "search/offline.js").write_text(
        f"var __search = {{index: Promise.resolve({index}),\n"
        f"  worker: URL.createObjectURL(new Blob([{json.dumps(worker)}], {{type: 'text/javascript'}}))}};\n")
