#!/usr/bin/env python3
# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `dev` does with its arguments, and what it says while it builds. Nothing is built and nothing installed.

Usage: dev_script.py DEV
"""

import re
import subprocess
import sys
import tempfile
import unittest

DEV = ""

# Functions of dev with stand-ins for all that builds, installs or starts a program.
STAND_INS = """
source "$1" help >/dev/null
root=$2
shift 2
need_for_building() { :; }
configure() { :; }
build() { :; }
ninja() { :; }
start_ranks() { printf '%s\\n' "$@"; }
"""


class Dev(unittest.TestCase):
    def call(self, commands: str, *arguments: str) -> "subprocess.CompletedProcess[str]":
        with tempfile.TemporaryDirectory() as root:
            return subprocess.run(
                ["bash", "-c", STAND_INS + commands, "bash", DEV, root, *arguments],
                stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False, timeout=60,
            )

    def started(self, *arguments: str) -> "list[str]":
        result = self.call('run "$@"', *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        ranks, program, *options = result.stdout.splitlines()
        return [ranks, program.rpartition("/")[2], *options]

    def refusal(self, *arguments: str) -> str:
        result = self.call('run "$@"', *arguments)
        self.assertEqual((result.returncode, result.stdout), (1, ""), arguments)
        self.assertEqual(result.stderr.count("\n"), 1)
        return result.stderr

    def test_ranks_stand_anywhere(self) -> None:
        dam_break = ["2", "distributed_dam_break", "--points", "100", "--quiet"]
        for words in (
            "--ranks 2 --points 100 --quiet",
            "dam_break --ranks 2 --points 100 --quiet",
            "--points 100 --ranks=2 --quiet dam_break",
            "--points 100 dam_break --quiet --ranks 2",
        ):
            self.assertEqual(self.started(*words.split()), dam_break, words)
        for words in ("--ranks 3 shear", "shear --ranks 3", "shear --ranks=3"):
            self.assertEqual(self.started(*words.split()), ["3", "distributed_shear"], words)
        self.assertEqual(
            self.started("--checkpoint", "shear", "--ranks", "4"),
            ["4", "distributed_dam_break", "--checkpoint", "shear"],
        )

    def test_what_cannot_run_on_ranks_is_refused(self) -> None:
        for scenario in ("brownian", "tracks.csv"):
            message = self.refusal(scenario, "--ranks", "2")
            self.assertIn(f"'{scenario}' does not run on ranks", message)
            self.assertIn("only dam_break and shear do", message)
        for number in ("0", "-1", "two", "10000", ""):
            self.assertIn("from 1 to 9999", self.refusal("dam_break", "--ranks", number))
        self.assertIn("from 1 to 9999", self.refusal("dam_break", "--ranks"))
        self.assertIn("twice", self.refusal("--ranks", "2", "--ranks=2"))
        self.assertIn("one scenario", self.refusal("dam_break", "shear", "--ranks", "2"))
        self.assertIn("takes no options", self.refusal("shear", "--ranks", "2", "--points", "9"))

    def test_a_long_build_says_how_far_it_is(self) -> None:
        steps = 'build() { for i in 1 2 3 4; do echo "[$i/40] Building X"; sleep 0.3; done; }; '
        result = self.call(steps + "seconds_between_lines=0.2; quietly build /folder --target run_scenario")
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        lines = result.stderr.splitlines()
        self.assertGreaterEqual(len(lines), 3)
        for line in lines:
            self.assertRegex(line, r"^Building run_scenario \.\.\. [1-4] of 40 \(\d+ s\)$")

    def test_a_short_build_says_nothing_and_a_failed_one_all(self) -> None:
        self.assertEqual(self.call("quietly build /folder").stderr, "")
        failed = self.call("build() { echo what is wrong; return 7; }; quietly build /folder || echo failed")
        self.assertEqual((failed.stdout, failed.stderr), ("failed\n", "what is wrong\n"))

    def test_nothing_holds_a_pipe_beyond_the_end(self) -> None:
        self.call("seconds_between_lines=600; quietly build /folder")  # call() reads to the ends of both pipes

    def test_help_lists_every_command(self) -> None:
        usage = self.call("usage").stdout
        with open(DEV, encoding="utf-8") as script:
            commands = re.findall(r"^([a-z]+)\)", script.read().rpartition("case $command in")[2], re.MULTILINE)
        self.assertGreaterEqual(len(commands), 7)
        for command in commands:
            self.assertIn(f"./dev {command}", usage)


if __name__ == "__main__":
    DEV = sys.argv.pop(1)
    unittest.main()
