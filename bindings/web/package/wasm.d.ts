// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

import type { Wasm } from "dynamic-delaunay";

/** What a bundler makes of an import of one of the WebAssembly modules. */
declare const wasm: Wasm;
export default wasm;
