# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Serves the built page on this computer alone.

    serve.py DIRECTORY [PORT]

Writes the address when it can be asked; without a port, or with 0, it takes a free one. The headers isolate the page from
others, for which browsers let it measure times finely.
"""

import functools
import http.server
import sys


class Handler(http.server.SimpleHTTPRequestHandler):
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map,
                      ".wasm": "application/wasm", ".mjs": "text/javascript", ".js": "text/javascript"}

    def do_GET(self):
        if self.path == "/favicon.ico":  # for which browsers ask where a page names no icon
            self.send_response(204)
            self.end_headers()
        else:
            super().do_GET()

    def end_headers(self):
        self.send_header("Cross-Origin-Opener-Policy", "same-origin")
        self.send_header("Cross-Origin-Embedder-Policy", "require-corp")
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def log_message(self, *_):
        pass


def server(directory, port=0):
    return http.server.ThreadingHTTPServer(("127.0.0.1", port), functools.partial(Handler, directory=directory))


if __name__ == "__main__":
    with server(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 0) as served:
        print(f"http://127.0.0.1:{served.server_port}/", flush=True)
        try:
            served.serve_forever()
        except KeyboardInterrupt:
            pass
