#!/usr/bin/env python3
"""Measures what docs/report.md says: levels 1 to 3 and the three hierarchies, as Markdown tables.

usage: bench/report_timings.py [LRAY]      (build/release/lray; the window needs Xvfb and xdotool)
"""
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LRAY = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build/release/lray")
EXAMPLES = ROOT / "examples"
DISPLAY = ":87"


def stats(*arguments):
    """Renders, and returns what --stats=json says of it."""
    with tempfile.TemporaryDirectory() as directory:
        output = os.path.join(directory, "image.ppm")
        command = [LRAY, *arguments, "-o", output, "--stats=json", "--quiet"]
        run = subprocess.run(command, capture_output=True, text=True, check=True)
    return json.loads(run.stderr.strip().splitlines()[-1])


def seconds(value):
    return f"{value:.3f}" if value < 1 else f"{value:.2f}"


def best(repeat, *arguments):
    """The quickest of some runs, by the time of rendering."""
    runs = [stats(*arguments) for _ in range(repeat)]
    return min(runs, key=lambda run: run["seconds"]["render"])


def object_count(run):
    return sum(run["primitives"].values())


def hierarchies():
    """The sphereflake of more and more spheres, flat, through each hierarchy."""
    print("| spheres | `none`, render s | `spheres`, build s | render s | `boxes`, build s | render s |")
    print("|---|---|---|---|---|---|")
    for generations in range(1, 7):
        common = [str(EXAMPLES / "sphereflake.lrs"), "-D", f"generations={generations}", "-n", "2",
                  "-ps", "1", "--shading", "flat", "--size", "640x480"]
        cells = []
        boxes = best(3, *common, "--accel", "boxes")
        count = object_count(boxes)
        if count <= 10_000:
            cells.append(seconds(best(1, *common, "--accel", "none")["seconds"]["render"]))
        else:
            cells.append("")
        for run in (best(3, *common, "--accel", "spheres"), boxes):
            cells += [seconds(run["seconds"]["build"]), seconds(run["seconds"]["render"])]
        print(f"| {count} | " + " | ".join(cells) + " |", flush=True)


def levels():
    """Each example as levels 1 and 2 make it, and without a level."""
    print("| scene | objects | `-n 1`, s | `-n 2 -ps 16`, s | no level, `-ps 16`, s |")
    print("|---|---|---|---|---|")
    for name in ("primitives", "sphereflake", "still_life", "chess", "forest", "glass"):
        scene = str(EXAMPLES / f"{name}.lrs")
        size = ["--size", "320x240"]
        runs = [best(1, "-n", "1", scene, *size), best(1, "-n", "2", "-ps", "16", scene, *size),
                best(1, "-ps", "16", scene, *size)]
        cells = [seconds(run["seconds"]["build"] + run["seconds"]["render"]) for run in runs]
        print(f"| {name} | {object_count(runs[0])} | " + " | ".join(cells) + " |", flush=True)


def window(scene, environment):
    """Looks at a scene for some seconds; returns what the window says of itself."""
    command = [LRAY, "-n", "3", "-i", scene, "--size", "640x480", "--stats=json"]
    process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--pid", str(process.pid)],
                   env=environment, capture_output=True, timeout=60, check=False)
    subprocess.run(["xdotool", "mousemove", "100", "100"], env=environment, check=False)
    time.sleep(8)
    subprocess.run(["xdotool", "key", "Escape"], env=environment, check=False)
    _, errors = process.communicate(timeout=60)
    return json.loads(errors.strip().splitlines()[-1])


def windows():
    """Level 3: until there is something to see, and passes over the picture in a second."""
    server = subprocess.Popen(["Xvfb", DISPLAY, "-screen", "0", "1024x768x24", "-nolisten", "tcp"],
                              stderr=subprocess.DEVNULL)
    try:
        time.sleep(2)
        environment = dict(os.environ, DISPLAY=DISPLAY)
        print("| scene | first pixels after s | passes in a second |")
        print("|---|---|---|")
        for name in ("primitives", "sphereflake", "still_life", "chess", "forest", "glass"):
            run = window(str(EXAMPLES / f"{name}.lrs"), environment)
            rate = run["passes"] / max(run["pass_seconds"], 1e-9)
            print(f"| {name} | {run['first_picture_seconds']:.2f} | {rate:.2f} |", flush=True)
    finally:
        server.kill()


def main():
    print("## Hierarchies\n")
    hierarchies()
    print("\n## Levels 1 and 2\n")
    levels()
    print("\n## Level 3\n")
    windows()


if __name__ == "__main__":
    main()
