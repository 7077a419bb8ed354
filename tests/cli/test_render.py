# SPDX-License-Identifier: Apache-2.0
"""`wellstrat render` and `wellstrat merge`."""

import base64
import json
import math
import os
import re
import signal
import struct
import subprocess
import unittest

from support import PROGRAM, CliTest, MpiCase

SIZE = ("--size", "50x35")  # tiles that are cut off on both sides
SMALL = ("render", "cornell", *SIZE, "--spp", "24")
LONG = ("render", "cornell", "--size", "40x24", "--spp", "1000000", "--checkpoint", "part.exr",
        "--save-every", "0", "-o", "image.exr")


def with_option(arguments, option, value):
    changed = list(arguments)
    changed[changed.index(option) + 1] = str(value)
    return changed


class RenderCase(CliTest):
    def assert_same(self, *names):
        """The files have the same bytes."""
        for name in names[1:]:
            self.assertTrue(self.read(names[0]) == self.read(name), names)


class RenderTest(RenderCase):
    def test_list(self):
        text = self.output_of("render", "--list").decode()
        for name in ("cornell", "veach", "lens", "manylights", "spherelight"):
            self.assertRegex(text, rf"(?m)^{name} +\S")

    def test_examples_of_help(self):
        """Guards against examples that the options have left behind: --list reads them only."""
        examples = self.output_of("render", "--help").decode().partition("Examples:\n")[2]
        commands = [line.partition("wellstrat ")[2].split() for line in examples.splitlines()]
        commands = [command for command in commands if command]
        self.assertGreater(len(commands), 5)
        for command in commands:
            self.output_of(*command, *() if "--list" in command else ("--list",))

    def test_formats(self):
        text = self.output_of(*SMALL, "-o", "a.exr", "-o", "a.png", "-o", "a.hdr").decode()
        self.assertRegex(text, r"\Acornell: 50x35 pixels, 24 samples each, [\d.]+ s, [\d.]+ "
                               r"(million |thousand )?path segments a second\n\Z")
        self.assertEqual(self.files(), ["a.exr", "a.hdr", "a.png"])
        self.assertEqual(self.read("a.exr")[:4], b"\x76\x2f\x31\x01")
        self.assertEqual(self.read("a.png")[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(self.read("a.hdr")[:2], b"#?")
        self.assertNotIn(b"capDate\0string\0\x13", self.read("a.exr"))

    def test_default_size_has_the_shape_of_the_scene(self):
        text = self.output_of("render", "cornell", "--spp", "1", "-o", "a.png").decode()
        self.assertIn("256x256 pixels", text)

    def test_threads_change_no_bit(self):
        for threads in (1, 2, 7):
            self.output_of(*SMALL, "--threads", str(threads), "-o", f"{threads}.exr")
        self.assert_same("1.exr", "2.exr", "7.exr")

    def test_samples_that_know_of_each_other_are_exact(self):
        """Threads and parts change no bit of an image whose domains or pixels are stratified
        together."""
        for generator in ("joint", "long", "blue"):
            image = (*SMALL, "--generator", generator, "--split", "2")
            for threads in (1, 7):
                self.output_of(*image, "--threads", str(threads), "-o", f"{threads}.exr")
            for part in ("0:7", "7:24"):
                self.output_of(*image, "--samples", part, "-o", f"{part[0]}-part.exr")
            self.output_of("merge", "0-part.exr", "7-part.exr", "-o", "merged.exr")
            self.assert_same("1.exr", "7.exr", "merged.exr")

    def test_options_change_the_image(self):
        """Guards against options that reach nobody."""
        images = {}
        for arguments in ((), ("--seed", "1"), ("--generator", "random"),
                          ("--generator", "joint"), ("--generator", "long"),
                          ("--generator", "blue"), ("--depth", "1"), ("--split", "3"),
                          ("--split", "3", "--distrib"), ("--fov", "20"),
                          ("--camera", "2.5,2.5,-7"), ("--look-at", "1,2,0"),
                          ("--camera", "2.5,2.5,-7", "--look-at", "1,2,0", "--up", "1,0,0"),
                          ("--lens-radius", "0.3"), ("--lens-radius", "0.3", "--focus", "5")):
            self.output_of(*SMALL, *arguments, "-o", "a.hdr")
            images[self.read("a.hdr")] = arguments
        self.assertEqual(len(images), 15)

    def test_noise(self):
        noisy = (*with_option(SMALL, "--spp", 512), "--noise", "0.2")
        text = self.output_of(*noisy, "-o", "a.exr").decode()
        self.assertRegex(text, "16 to (256|512) samples each")
        self.output_of(*noisy, "--threads", "1", "-o", "b.exr")
        self.assert_same("a.exr", "b.exr")

    def test_time_limit(self):
        process = self.run_program(*LONG, "--time-limit", "1")
        self.assertEqual((process.returncode, process.stdout), (0, b""))
        self.assertRegex(process.stderr.decode(), r"\Awellstrat: time is up with \d+[^\n]+\n\Z")
        self.assert_same("image.exr", "part.exr")

    def test_bad_arguments(self):
        self.output_of(*SMALL, "-o", "a.exr")
        with open(self.path("text.exr"), "w", encoding="ascii") as file:
            file.write("text")
        image = ("cornell", "-o", "b.exr")
        for arguments, mentions in (
                ((), "a scene is required"),
                (("cornell",), "-o FILE.exr is required"),
                (("nothing", "-o", "b.exr"), "built-in scenes are cornell,"),
                (("text.exr", "-o", "b.exr"), "text.exr"),
                (("cornell", "-o", "b.gif"), ".exr, .png, .jpg, .jpeg, .hdr"),
                (("cornell", "-o", "none/b.exr"), "none/b.exr"),
                (("cornell", "-o", "b.exr", "-o", "b.exr"), "two outputs"),
                ((*image, "--spp", "0"), "--spp"), ((*image, "--spp", "1e3"), "--spp"),
                ((*image, "--spp", "10000000000"), "4294967295"),
                ((*image, "--spp", "4000000000", "--split", "2"), "--split 2"),
                ((*image, "--samples", "4"), "A:B"), ((*image, "--samples", "4:4"), "A:B"),
                ((*image, "--samples", "-1:4"), "A:B"), ((*image, "--samples", "4:"), "A:B"),
                ((*image, "--samples", "2:5", "--spp", "4"), "--samples 2:5 goes beyond the 4"),
                ((*image, "--checkpoint", "c.png"), "--checkpoint"),
                ((*image, "--checkpoint", "none/c.exr"), "none/c.exr"),
                ((*image, "--checkpoint", "b.exr"), "two outputs"),
                ((*image, "--samples", "1:4", "--noise", "0.1"), "--noise"),
                ((*image, "--size", "0x4"), "--size"), ((*image, "--size", "4"), "--size"),
                ((*image, "--size", "4x70000"), "65536"),
                ((*image, "--size", "65536x65536"), "GB of memory"),
                ((*image, "--generator", "sobl"), "pmj, random, long, blue, joint"),
                ((*image, "--depth", "-1"), "--depth"), ((*image, "--split", "0"), "--split"),
                ((*image, "--seed", "x"), "--seed"), ((*image, "--threads", "0"), "--threads"),
                ((*image, "--time-limit", "nan"), "--time-limit"),
                ((*image, "--noise", "0"), "--noise"), ((*image, "--noise", "-1"), "--noise"),
                ((*image, "--fov", "180"), "--fov"), ((*image, "--focus", "0"), "--focus"),
                ((*image, "--lens-radius", "-1"), "--lens-radius"),
                ((*image, "--lens-radius", "1e20"), "--lens-radius"),
                ((*image, "--focus", "1e20"), "--focus"), ((*image, "--camera", "1e19,1,1"), "1e"),
                ((*image, "--camera", "1,2"), "X,Y,Z"), ((*image, "--camera", "1,2,inf"), "X,Y,Z"),
                ((*image, "--camera", "1,2,3", "--look-at", "1,2,3"), "--camera"),
                ((*image, "--up", "0,0,0"), "wellstrat: --up:"),
                ((*image, "--environment", "none.hdr"), "none.hdr"),
                ((*image, "--environment", "text.exr"), "text.exr"),
                ((*image, "--environment-rotation", "9"), "no light from around"),
                ((*image, "--environment-strength", "-1"), "--environment-strength"),
                ((*image, "--environment", "a.exr", "--studio", "on"), "--studio on and"),
                ((*image, "--studio", "none"), "--studio"),
                ((*image, "--tonemap", "aces"), "--tonemap"),
                ((*image, "--exposure", "99"), "--exposure"),
                ((*image, *SIZE, "--resume", "a.exr", "--transparent"), "differs in: background"),
                ((*image, "--resume", "none.exr"), "none.exr"),
                ((*image, "--resume", "text.exr"), "text.exr"),
                ((*image, "--resume", "a.exr"), "50x35 pixels, not 256x256"),
                ((*image, *SIZE, "--resume", "a.exr", "--seed", "1"), "differs in: seed"),
                ((*image, *SIZE, "--resume", "a.exr", "--fov", "30"), "differs in: scene"),
                ((*image, *SIZE, "--resume", "a.exr", "--spp", "23"), "24 samples already"),
                ((*image, *SIZE, "--resume", "a.exr", "--samples", "2:99"), "samples from 2 on")):
            self.assert_fails("render", *arguments, mentions=mentions)

    def test_far_cameras_and_large_lenses(self):
        """The largest numbers that options take."""
        for arguments in (("--camera", "1e9,-1e9,1e9"), ("--lens-radius", "1e9"),
                          ("--focus", "1e9", "--fov", "179"), ("--focus", "1e-9"),
                          ("--camera", "1e9,1e9,1e9", "--look-at", "-1e9,1e9,1e9",
                           "--lens-radius", "1e9")):
            self.output_of("render", "cornell", "--size", "8x8", "--spp", "2", *arguments, "-o",
                           "a.exr")

    def write_obj(self):
        with open(self.path("a.obj"), "w", encoding="ascii") as file:
            file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")

    def test_notes_say_what_is_true(self):
        """Guards against notes on light and cameras that the options supply."""
        self.write_obj()
        self.output_of("render", "cornell", "--size", "8x4", "--spp", "1", "-o", "sky.hdr")
        image = ("render", "a.obj", "--size", "8x8", "--spp", "1", "-o", "a.exr")
        light, camera = "There is no light", "There is no camera"
        dark = "the picture is almost black"
        for arguments, notes in (((), (f"{camera}: the picture shows the whole scene", light)),
                                 (("--environment", "sky.hdr"), (camera,)),
                                 (("--camera", "0,0,5", "--look-at", "0,0,0"), (light,)),
                                 (("--fov", "5"), (f"{camera}: it stands in front", light)),
                                 (("--camera", "0,0,5", "--studio", "off"), (dark,)),
                                 (("--camera", "0,0,5", "--studio", "on"), ()),
                                 (("--camera", "0,0,5", "--environment", "sky.hdr"), ())):
            lines = self.run_program(*image, *arguments).stderr.decode().splitlines()
            self.assertEqual(len(lines), len(notes), lines)
            for line, note in zip(lines, notes):
                self.assertIn(note, line)

    def test_display(self):
        """Exposure and curve are of .png and .jpg alone, and those who have the .exr can choose
        them later."""
        pictures = set()
        for number, arguments in enumerate(((), ("--exposure", "1"), ("--tonemap", "filmic"),
                                            ("--exposure", "-1", "--tonemap", "filmic"))):
            names = [f"{number}{suffix}" for suffix in (".exr", ".hdr", ".png", ".jpg")]
            outputs = [word for name in names for word in ("-o", name)]
            self.output_of(*SMALL, *arguments, *outputs)
            self.output_of("merge", names[0], "-o", "merged.png", *arguments)
            self.assert_same(names[2], "merged.png")
            self.assert_same("0.exr", names[0])
            self.assert_same("0.hdr", names[1])
            pictures |= {self.read(names[2]), self.read(names[3])}
        self.assertEqual(len(pictures), 8)

    def test_almost_black_and_white(self):
        self.write_obj()
        image = ("render", "a.obj", "--camera", "0,0,5", "--size", "8x8", "--spp", "4", "--studio",
                 "on", "-o", "a.png")
        for exposure, text in (("-12", "almost black"), ("12", "almost white"), ("0", "")):
            process = self.run_program(*image, "--exposure", exposure)
            self.assertEqual(process.returncode, 0)
            self.assertIn(text, process.stderr.decode())
        self.assertEqual(process.stderr, b"")

    def test_transparent(self):
        """Parts of a transparent image are put together as those of others."""
        self.write_obj()
        image = ("render", "a.obj", "--size", "20x10", "--camera", "0,0,5", "--transparent",
                 "--studio", "on")
        self.output_of(*image, "--spp", "8", "-o", "all.exr", "-o", "all.png")
        self.output_of(*image, "--samples", "0:3", "-o", "a.exr")
        self.output_of(*image, "--samples", "3:8", "-o", "b.exr")
        self.output_of("merge", "a.exr", "b.exr", "-o", "merged.exr", "-o", "merged.png")
        self.assert_same("all.exr", "merged.exr")
        self.assert_same("all.png", "merged.png")
        self.assertEqual(self.read("all.png")[25], 6)  # the color type of PNG: with alpha

    def test_environments_are_turned_and_scaled(self):
        self.write_obj()
        self.output_of("render", "cornell", "--size", "8x4", "--spp", "1", "-o", "sky.hdr")
        image = ("render", "a.obj", "--size", "8x8", "--spp", "4", "--camera", "0,0,5")
        images = set()
        for arguments in (("--environment", "sky.hdr"), ("--studio", "on")):
            for more in ((), ("--environment-rotation", "90"), ("--environment-strength", "2")):
                self.output_of(*image, *arguments, *more, "-o", "a.hdr")
                images.add(self.read("a.hdr"))
        self.assertEqual(len(images), 6)

    def test_cameras_of_a_file(self):
        """By name and by number; the picture has the shape that the camera was made for."""
        quad = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
        gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3]}],
                "nodes": [{"mesh": 0}, {"camera": 0, "name": "wide", "translation": [0, 0, 5]},
                          {"camera": 1, "name": "tall", "translation": [0, 0, 5]},
                          {"camera": 0, "name": "wide", "translation": [0, 0, 9]}],
                "cameras": [{"type": "perspective",
                             "perspective": {"yfov": 0.5, "znear": 0.1, "aspectRatio": 2}},
                            {"type": "orthographic",
                             "orthographic": {"xmag": 1, "ymag": 4, "znear": 0, "zfar": 9}}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
                "bufferViews": [{"buffer": 0, "byteLength": 36}],
                "buffers": [{"byteLength": 36, "uri": "data:;base64," +
                             base64.b64encode(quad).decode()}]}
        with open(self.path("a.gltf"), "w", encoding="ascii") as file:
            json.dump(gltf, file)
        image = ("render", "a.gltf", "--spp", "1", "-o", "a.hdr")
        pictures = []
        for arguments, size in (((), b"-Y 256 +X 512"), (("--camera-name", "tall"), b"-Y 256 +X 64"),
                                (("--camera-number", "3"), b"-Y 256 +X 512"),
                                (("--camera-name", "wide", "--camera-number", "2"),
                                 b"-Y 256 +X 512")):
            self.assertEqual(self.run_program(*image, *arguments).returncode, 0)
            pictures.append(self.read("a.hdr"))
            self.assertIn(size, pictures[-1])
        self.assertNotEqual(pictures[0], pictures[2])
        self.assertEqual(pictures[2], pictures[3])
        self.assert_fails(*image, "--camera-name", "none",
                          mentions="it has no such camera, only 3: 'wide', 'tall', 'wide'")
        self.assert_fails("render", "cornell", "--camera-number", "2", "-o", "b.hdr",
                          mentions="are for scene files")

    def test_environment_maps_are_cleaned(self):
        self.write_obj()
        pixels = struct.pack("<8f", -math.inf, math.nan, 1, -1, 1e20, 1, 1, 1)
        with open(self.path("sky.pfm"), "wb") as file:
            file.write(b"Pf\n4 2\n-1.0\n" + pixels)
        process = self.run_program("render", "a.obj", "--camera", "0,0,5", "--size", "8x8", "--spp",
                                   "4", "--environment", "sky.pfm", "-o", "a.exr")
        self.assertEqual(process.returncode, 0)
        self.assertRegex(process.stderr.decode(),
                         r"\Awellstrat: Pixels of the environment map [^\n]+: 4\.\n\Z")

    def test_upper_case_suffix(self):
        self.output_of(*SMALL, "-o", "a.EXR", "-o", "a.exr")
        self.assert_same("a.EXR", "a.exr")

    def test_only_sums_can_be_resumed(self):
        picture = ("render", "cornell", *SIZE, "--spp", "1000000", "--time-limit", "0.1", "-o",
                   "a.png")
        self.assertNotIn("--resume", self.run_program(*picture).stderr.decode())
        for more in (("-o", "a.exr"), ("--checkpoint", "part.exr")):
            self.assertIn("--resume goes on", self.run_program(*picture, *more).stderr.decode())

    def test_absurd_counts_start_and_stop(self):
        """So many samples take for ever, and no memory."""
        process = self.run_program(*with_option(SMALL, "--spp", 4294967295), "--time-limit", "1",
                                   "-o", "a.exr")
        self.assertEqual(process.returncode, 0, process.stderr)

    def test_progress(self):
        if not hasattr(os, "openpty"):
            self.skipTest("no pseudo-terminal")
        main, terminal = self.open_terminal()
        with self.started(PROGRAM, *LONG, "--time-limit", "2", stdout=subprocess.DEVNULL,
                          stderr=terminal):
            os.close(terminal)
            shown = b""
            try:
                while data := os.read(main, 4096):
                    shown += data
            except OSError:
                pass  # as Linux says that the other end is closed
        os.close(main)
        self.assertRegex(shown.decode(), r"render \[[#.]{30}\] +\d+ %, \d+ samples, [\d:]+ left")


class PartsTest(RenderCase):
    def parts(self, *spans):
        for span in spans:
            self.output_of("render", "cornell", *SIZE, "--samples", span, "-o",
                           f"{span.replace(':', '-')}.exr")

    def test_parts_make_the_whole(self):
        self.output_of(*SMALL, "-o", "whole.exr", "-o", "whole.png")
        self.parts("0:3", "3:16", "16:24")
        self.output_of("merge", "3-16.exr", "16-24.exr", "0-3.exr", "-o", "all.exr", "-o",
                       "all.png")
        self.assert_same("all.exr", "whole.exr")
        self.assert_same("all.png", "whole.png")
        self.output_of("render", "cornell", *SIZE, "--samples", "3:16", "--spp", "24", "-o",
                       "of-24.exr")
        self.assert_same("of-24.exr", "3-16.exr")
        self.output_of("merge", "0-3.exr", "3-16.exr", "-o", "some.exr")
        self.output_of("merge", "16-24.exr", "some.exr", "-o", "all.exr")
        self.assert_same("all.exr", "whole.exr")
        self.output_of("merge", "all.exr", "-o", "again.exr")
        self.assert_same("again.exr", "whole.exr")

    def test_missing_samples_are_named(self):
        self.parts("2:3", "5:9")
        process = self.run_program("merge", "5-9.exr", "2-3.exr", "-o", "all.exr")
        self.assertEqual((process.returncode, process.stderr),
                         (0, b"wellstrat: missing: samples 0:2, samples 3:5\n"))

    def test_what_does_not_belong_together_is_refused(self):
        self.parts("0:4", "3:6")
        for option in (("--seed", "1"), ("--depth", "2"), ("--generator", "random"),
                       ("--split", "2"), ("--distrib",), ("--fov", "30"), ("--noise", "1")):
            name = option[0].strip("-")
            self.output_of("render", "cornell", *SIZE, "--samples", "0:4", *option, "-o",
                           f"{name}.exr")
        self.output_of("render", "veach", *SIZE, "--samples", "4:8", "-o", "veach.exr")
        self.output_of("render", "cornell", "--size", "8x8", "--samples", "4:8", "-o", "8x8.exr")
        self.output_of("render", "cornell", *SIZE, "--samples", "4:8", "-o", "picture.png")
        for other, mentions in (
                ("0-4.exr", "both have samples 0:4"), ("3-6.exr", "both have samples 3:4"),
                ("seed.exr", "they differ in: seed (0, 1)"), ("depth.exr", "depth"),
                ("generator.exr", "generator (pmj, random)"), ("split.exr", "split"),
                ("distrib.exr", "distrib"), ("fov.exr", "scene"), ("noise.exr", "noise"),
                ("veach.exr", "scene"), ("8x8.exr", "50x35 pixels, the other 8x8"),
                ("picture.png", "`wellstrat render` wrote"), ("none.exr", "none.exr")):
            self.assert_fails("merge", "0-4.exr", other, "-o", "all.exr", mentions=mentions)
        for arguments, mentions in ((("0-4.exr",), "--output"), (("-o", "all.exr"), "images"),
                                    (("0-4.exr", "-o", "all.txt"), ".exr, .png, .hdr")):
            self.assert_fails("merge", *arguments, mentions=mentions)

    def test_damaged_files_are_found(self):
        self.parts("0:2")
        data = self.read("0-2.exr")
        for size in (0, 10, 400, len(data) // 2, len(data) - 1):
            with open(self.path("damaged.exr"), "wb") as file:
                file.write(data[:size])
            self.assert_fails("merge", "damaged.exr", "-o", "all.exr", mentions="damaged.exr")


class UnfinishedCase(RenderCase):
    def run_until(self, command, stop):
        """Runs `command` until its first checkpoint is there, calls stop(process), and gives the
        exit code and the standard error."""
        with self.started(*command, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE) as process:
            self.wait_until(lambda: os.path.exists(self.path("part.exr")))
            stop(process)
            errors = process.communicate(timeout=100)[1].decode()
            return process.returncode, errors

    def assert_goes_on(self, state):
        """From the file `state` on: the same bits as in one go."""
        missing = self.run_program("merge", state, "-o", "state.exr").stderr.decode()
        least = int(re.search(r"some samples of (\d+):1000000", missing)[1])
        arguments = with_option(LONG, "--spp", 2 * least + 5)  # passes double at most
        self.output_of(*with_option(arguments, "-o", "resumed.exr"), "--resume", state)
        self.output_of(*with_option(arguments, "-o", "whole.exr"))
        self.assert_same("resumed.exr", "whole.exr")


class InterruptTest(UnfinishedCase):
    def test_interrupt_writes_what_is_there(self):
        for stop in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            code, errors = self.run_until([PROGRAM, *LONG], lambda p, s=stop: p.send_signal(s))
            self.assertEqual(code, 130)
            self.assertRegex(errors, r"\Awellstrat: interrupted with [^\n]+; --resume goes on\n\Z")
            self.assertEqual(self.files(), ["image.exr", "part.exr"])
            self.assert_same("image.exr", "part.exr")
            self.assert_goes_on("image.exr")
            for name in self.files():
                os.remove(self.path(name))

    def test_killed_runs_go_on_from_the_last_checkpoint(self):
        code, _ = self.run_until([PROGRAM, *LONG], lambda process: process.kill())
        self.assertEqual(code, -signal.SIGKILL)
        self.assertFalse(os.path.exists(self.path("image.exr")))
        self.assert_goes_on("part.exr")

    def test_unfinished_parts_can_be_merged(self):
        _, errors = self.run_until([PROGRAM, *LONG], lambda p: p.send_signal(signal.SIGINT))
        self.assertIn("interrupted", errors)
        self.output_of("render", "cornell", "--size", "40x24", "--samples", "1000000:1000002",
                       "-o", "end.exr")
        process = self.run_program("merge", "end.exr", "part.exr", "-o", "all.exr")
        self.assertEqual(process.returncode, 0)
        self.assertRegex(process.stderr.decode(),
                         r"\Awellstrat: missing: some samples of \d+:1000000\n\Z")

    def test_resume_keeps_noise_decisions(self):
        arguments = with_option(LONG, "--spp", 2048) + ["--noise", "0.05"]
        self.run_until([PROGRAM, *arguments], lambda process: process.kill())
        self.output_of(*with_option(arguments, "-o", "resumed.exr"), "--resume", "part.exr")
        self.output_of(*with_option(arguments, "-o", "whole.exr"))
        self.assert_same("resumed.exr", "whole.exr")


class MpiTest(MpiCase, UnfinishedCase):
    def test_ranks_change_no_bit(self):
        self.output_of("render", "cornell", *SIZE, "--samples", "0:7", "-o", "start.exr")
        for more in (("--spp", "24"), ("--spp", "128", "--noise", "0.2"),
                     ("--spp", "24", "--resume", "start.exr")):
            arguments = ("render", "cornell", *SIZE, *more)
            self.output_of(*arguments, "-o", "alone.exr")
            for processes in (1, 2, 3, 5):
                process = self.mpirun(processes, *arguments, "-o", "shared.exr")
                self.assertEqual((process.returncode, process.stderr), (0, b""))
                self.assertEqual(process.stdout.count(b"samples each"), 1)
                self.assert_same("alone.exr", "shared.exr")

    def test_errors_are_said_once(self):
        process = self.mpirun(3, "render", "nothing", "-o", "a.exr")
        self.assertEqual(process.returncode, 2)
        self.assertEqual(process.stderr.count(b"wellstrat: there is no file 'nothing'"), 1)

    def test_interrupt_writes_what_is_there(self):
        _, errors = self.run_until(self.command(2, *LONG),
                                   lambda process: process.send_signal(signal.SIGINT))
        self.assertEqual(errors.count("--resume goes on"), 1)
        self.assert_goes_on("image.exr")

    def test_a_killed_rank_ends_all(self):
        code, errors = self.run_until(
            self.command(2, *LONG), lambda launcher: os.kill(self.rank(launcher, 1), signal.SIGKILL))
        self.assertNotEqual(code, 0)
        self.assertRegex(errors, r"rank \d+[^.]*signal 9")
        self.assert_goes_on("part.exr")


if __name__ == "__main__":
    unittest.main()
