#!/usr/bin/env python3
"""Measures what docs/report.md says: levels 1 to 3 and the three hierarchies, as Markdown tables.

usage: bench/report_timings.py [LRAY]      (build/release/lray; the window needs Xvfb and xdotool)
"""
import json
import math
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


def sphere_cloud(count):
    """Spheres anywhere in a cube, which cover as much of the picture however many they are."""
    return f"""lrs 1.0
camera {{ position: [0, 0, 3.2], look_at: [0, 0, 0], fov: 40 }}
for i in range({count}) {{
  sphere {{
    center: [rand_range(-1, 1, 1, i), rand_range(-1, 1, 2, i), rand_range(-1, 1, 3, i)]
    radius: {0.55 / math.cbrt(count):.8f}
    material {{ diffuse: hsv(360 * rand(4, i), 0.7, 0.9) }}
  }}
}}
"""


def hierarchies():
    """More and more spheres, painted flat, through each hierarchy."""
    print("| spheres | `none`, render s | `spheres`, build s | render s | `boxes`, build s | render s |")
    print("|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as directory:
        scene = os.path.join(directory, "cloud.lrs")
        for count in (100, 1_000, 10_000, 100_000, 1_000_000):
            Path(scene).write_text(sphere_cloud(count), encoding="utf-8")
            common = [scene, "-n", "2", "-ps", "1", "--size", "640x480"]
            repeat = 3 if count <= 100_000 else 1
            cells = [""]
            if count <= 10_000:
                cells = [seconds(stats(*common, "--accel", "none")["seconds"]["render"])]
            for accel in ("spheres", "boxes"):
                run = best(repeat, *common, "--accel", accel)
                assert object_count(run) == count
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
    subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--name", "lray"],
                   env=environment, capture_output=True, timeout=60, check=True)
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
