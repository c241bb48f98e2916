// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The bytes of a file beside a module, in a browser or in Node.
export async function read(address) {
  if (address.protocol === "file:") {
    return (await import("node:fs/promises")).readFile(address);
  }
  const response = await fetch(address);
  if (!response.ok) {
    throw new Error(`${address} cannot be loaded: ${response.status} ${response.statusText}`);
  }
  return response.arrayBuffer();
}
