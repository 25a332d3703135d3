#!/usr/bin/env python3
"""Compares the whole program with POV-Ray and Tachyon: from the scene file to the picture file.

whole_program.py --lray build/bench/lray --tools build/bench/bench --data DIRECTORY
                 [--bunny stanford-bunny.obj] [--scene NAME]... [--repeat K] [--size N]
                 [--shading full|flat] [--small] [--rivals-only] [--pictures]

Scenes are made by the tools, once, in the directory. All programs render with one thread, one ray
for each pixel, four levels of reflection and the same lights with shadows. Times are processor
time of the process, the system's included, the least of K runs; the programs take turns. A program
that is not installed is named and left out. lray's parts are seconds of the clock, of its quickest
run. Exit code 1 when a program fails. What lray should reach and does not changes nothing: run all
scenes on a quiet machine before you judge.
"""

import argparse
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import time
import typing

class Scene(typing.NamedTuple):
    name: str
    generator: str | None  # of make_spd; None: the bunny
    size: int
    is_large: bool = False
    is_mesh: bool = False  # triangles as one mesh, where the program has meshes


SCENES = [
    Scene("balls", "balls", 4),
    Scene("rings", "rings", 7),
    Scene("tetra", "tetra", 6),
    Scene("balls-large", "balls", 6, is_large=True),
    Scene("rings-large", "rings", 35, is_large=True),
    Scene("tetra-large", "tetra", 10, is_large=True),
    Scene("tetra-mesh", "tetra", 10, is_large=True, is_mesh=True),
    Scene("bunny", None, 0, is_mesh=True),
]
RIVALS = ["povray", "tachyon"]
# What lray should reach: against POV-Ray and Tachyon over all scenes, and in the worst of them.
AIMS = {"povray": 10.0, "tachyon": 5.0}
WORST_AIM = 4.0


def make_scene(arguments, scene):
    """Writes the scene for all three programs, unless it is there already."""
    base = arguments.data / scene.name
    if base.with_suffix(".done").exists():
        return base
    if scene.generator:
        source = base.with_suffix(".nff")
        maker = arguments.tools / "make_spd"
        subprocess.run([maker, scene.generator, str(scene.size), source], check=True)
    else:
        source = arguments.bunny
    command = [arguments.tools / "nff_to_scene", source]
    command += ["--mesh"] if scene.is_mesh else []
    for option, suffix in (("--lrs", ".lrs"), ("--pov", ".pov"), ("--tachyon", ".dat")):
        command += [option, base.with_suffix(suffix)]
    subprocess.run(command, check=True)
    base.with_suffix(".done").touch()
    return base


def command_of(arguments, program, base):
    size = str(arguments.size)
    picture = f"{base}-{program}.ppm"
    if program == "lray":
        return [arguments.lray, "-n", "1", "--threads", "1", "--accel", "boxes", "--shading",
                arguments.shading, "--size", f"{size}x{size}", "-i", f"{base}.lrs", "-o", picture,
                "--stats=json", "--quiet"]
    if program == "povray":
        return ["povray", f"+I{base}.pov", f"+O{picture}", "+FP", f"+W{size}", f"+H{size}", "-A",
                "-D", "-V", "-P", "+WT1"]
    # The highlight of all three is Phong's.
    return ["tachyon", f"{base}.dat", "-res", size, size, "-numthreads", "1", "-aasamples", "0",
            "-shade_phong", "-format", "PPM", "-o", picture]


def run(command):
    """Returns the processor time and the time by the clock in seconds, the largest memory in bytes
    (of small processes that of Python, from which they were made), and what went to stderr."""
    begin = time.monotonic()
    process = subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    )
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}\n{errors}")
    return {
        "cpu": usage.ru_utime + usage.ru_stime,
        "wall": time.monotonic() - begin,
        "bytes": 1024 * usage.ru_maxrss,
        "errors": errors,
    }


def parts_of(result):
    """Returns the seconds of lray's stages by its statistics, the last line of stderr."""
    for line in reversed(result["errors"].splitlines()):
        if line.startswith("{"):
            return json.loads(line)["seconds"]
    return {}


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def print_table(programs, results):
    print(f"\n{'processor s':14}", *(f"{p:>10}" for p in programs), end="")
    print("".join(f"{'/ ' + p:>11}" for p in programs[1:]), end="")
    print("".join(f"{p + ' MB':>12}" for p in programs))
    ratios = {program: {} for program in programs[1:]}
    for name, times in results.items():
        print(f"{name:14}", *(f"{times[p]['cpu']:10.3f}" for p in programs), end="")
        for program in programs[1:]:
            ratios[program][name] = times[program]["cpu"] / times["lray"]["cpu"]
            print(f"{ratios[program][name]:11.2f}", end="")
        print("".join(f"{times[p]['bytes'] / 1e6:12.0f}" for p in programs))
    return ratios


def print_parts(results):
    stages = ["parse", "flatten", "build", "render", "write"]
    print(f"\n{'lray, wall s':14}", *(f"{stage:>9}" for stage in stages), f"{'all':>9}")
    for name, times in results.items():
        parts = parts_of(times["lray"])
        print(f"{name:14}", *(f"{parts.get(stage, math.nan):9.3f}" for stage in stages), end="")
        print(f" {times['lray']['wall']:9.3f}")


def print_summary(ratios):
    print()
    for program, of_scene in ratios.items():
        mean = geometric_mean(of_scene.values())
        worst = min(of_scene, key=of_scene.get)
        aim = AIMS[program]
        print(f"{program}: lray is {mean:.2f} times as fast in the geometric mean (aim {aim:g}:"
              f" {'reached' if mean >= aim else 'missed'}), {of_scene[worst]:.2f} in the worst,"
              f" {worst} (aim {WORST_AIM:g}:"
              f" {'reached' if of_scene[worst] >= WORST_AIM else 'missed'})")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lray", default="build/bench/lray")
    parser.add_argument("--tools", type=pathlib.Path, default="build/bench/bench")
    parser.add_argument("--data", type=pathlib.Path, default="build/bench-data/whole")
    parser.add_argument("--bunny", type=pathlib.Path, help="an OBJ; without it its row is left out")
    parser.add_argument("--scene", action="append", choices=[scene[0] for scene in SCENES])
    parser.add_argument("--small", action="store_true", help="without the large scenes")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--size", type=int, default=1024, help="pixels of a side")
    parser.add_argument("--shading", default="full", choices=["full", "flat"])
    parser.add_argument("--rivals-only", action="store_true", help="run lray not at all")
    parser.add_argument("--pictures", action="store_true", help="keep the pictures")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    arguments.data.mkdir(parents=True, exist_ok=True)
    programs = [] if arguments.rivals_only else ["lray"]
    for program in RIVALS:
        if shutil.which(program):
            programs.append(program)
        else:
            print(f"{program} is not installed: left out")
    results = {}
    for scene in SCENES:
        is_wanted = not arguments.scene or scene.name in arguments.scene
        is_there = scene.generator is not None or arguments.bunny is not None
        if not is_wanted or not is_there or arguments.small and scene.is_large:
            continue
        base = make_scene(arguments, scene)
        best = {}
        for _ in range(arguments.repeat):
            for program in programs:
                result = run(command_of(arguments, program, base))
                if program not in best or result["cpu"] < best[program]["cpu"]:
                    best[program] = result
        results[scene.name] = best
        shown = ", ".join(f"{p} {best[p]['cpu']:.3f} s" for p in programs)
        print(f"{scene.name}: {shown}", flush=True)
        if not arguments.pictures:
            for program in programs:
                pathlib.Path(f"{base}-{program}.ppm").unlink(missing_ok=True)
    if not results:
        sys.exit("no scene to run: the bunny wants --bunny")
    if not arguments.rivals_only:
        ratios = print_table(programs, results)
        print_parts(results)
        print_summary(ratios)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (RuntimeError, subprocess.CalledProcessError, OSError) as problem:
        sys.exit(str(problem))
