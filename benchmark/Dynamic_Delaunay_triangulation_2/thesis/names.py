# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What people read in place of the names in the results of `./dev bench thesis`."""

EXACT = "circumcircle"
SCENARIOS = {"dam_break": "dam break", "spinning": "spinning", "explosion": "explosion",
             "static": "static"}
METHODS = {
    "circumcircle": "exact (default)",
    "circumcircle/splice": "circumcircle, splice",
    "safe_region": "safe region (exact)",
    "point_distance:0.7": "point distance 0.7",
    "inflation_aware:0.7": "inflation aware 0.7",
    "voronoi_circumcenter": "Voronoi circumcentre",
    "voronoi_circumcenter_estimated": "V. circumcentre, estimated",
    "voronoi_edge_length:1": "Voronoi edge length",
    "nearly_delaunay:0.05": "nearly Delaunay 0.05",
    "random:0.0025": "random 0.0025",
    "random:0.1": "random 0.1",
    "refined:point_distance:0.9+voronoi_circumcenter": "refined",
    "circumcircle/hybrid": "exact, hybrid policy",
    "static_insert": "CGAL's insertion",
    "static_fastest": "fastest static",
}
