# SPDX-License-Identifier: Apache-2.0
"""`wellstrat render --frame`, `--frames` and `--orbit`: sequences of pictures."""

import os
import re
import signal
import subprocess
import unittest

from support import PROGRAM, CliTest, MpiCase

SCENE = ("render", "lens", "--size", "50x35", "--depth", "1")
SMALL = (*SCENE, "--spp", "3")
ORBIT = ("--orbit", "5")


class FramesCase(CliTest):
    def assert_same(self, *names):
        """The files have the same bytes."""
        for name in names[1:]:
            self.assertTrue(self.read(names[0]) == self.read(name), names)

    def merge(self, *names):
        """What `wellstrat merge` of these files to merged.exr complains about."""
        process = self.run_program("merge", *names, "-o", "merged.exr")
        self.assertEqual(process.returncode, 0, process.stderr)
        return process.stderr.decode()


class FramesTest(FramesCase):
    def test_frames_go_on_without_gaps(self):
        """For each generator, frames are the parts of one long picture."""
        for generator in ("pmj", "joint", "long", "blue", "random"):
            scene = (*SCENE, "--generator", generator, "--split", "2")
            self.output_of(*scene, "--spp", "3", "--frames", "4", "-o", "a.%02d.exr")
            self.output_of(*scene, "--spp", "12", "-o", "whole.exr")
            self.assertEqual(self.merge("a.02.exr", "a.00.exr", "a.03.exr", "a.01.exr"), "")
            self.assert_same("merged.exr", "whole.exr")

    def test_one_frame_is_that_of_the_sequence(self):
        for more in ((), ORBIT, (*ORBIT, "--look-at", "0,0.5,0", "--up", "0,1,0.2")):
            text = self.output_of(*SMALL, *more, "--frame", "1", "--frames", "3", "-o",
                                  "a.%04d.exr", "-o", "a.%04d.png").decode()
            self.assertEqual(re.findall(r"(?m)^lens, frame (\d+): 50x35 pixels, 3 samples", text),
                             ["1", "2", "3"])
            for frame in ("1", "2", "3"):
                text = self.output_of(*SMALL, *more, "--frame", frame, "-o", "b.exr", "-o",
                                      "b.png").decode()
                self.assertIn(f"lens, frame {frame}: ", text)
                self.assert_same("b.exr", f"a.000{frame}.exr")
                self.assert_same("b.png", f"a.000{frame}.png")
        self.assertEqual(self.files(), sorted(
            ["b.exr", "b.png", *(f"a.000{n}.{s}" for n in (1, 2, 3) for s in ("exr", "png"))]))

    def test_frame_0_is_the_picture(self):
        self.output_of(*SMALL, "-o", "a.exr")
        self.output_of(*SMALL, *ORBIT, "--frame", "0", "-o", "b.exr")
        self.assert_same("a.exr", "b.exr")

    def test_orbit_moves_the_camera(self):
        """Frames see other things; a whole turn later the camera is where it was."""
        turn = (*SMALL, "--orbit", "-90", "--frames", "5", "-o", "a.%01d.exr")
        self.output_of(*turn, "-o", "a.%01d.hdr")
        self.assertEqual(len({self.read(f"a.{n}.hdr") for n in range(5)}), 5)
        self.assert_fails("merge", "a.0.exr", "a.1.exr", "-o", "b.exr", mentions="scene")
        self.assertEqual(self.merge("a.0.exr", "a.4.exr"), "wellstrat: missing: samples 3:12\n")

    def test_orbit_keeps_what_it_looks_at(self):
        """A small lamp in the dark stays in the middle of the picture."""
        with open(self.path("a.mtl"), "w", encoding="ascii") as file:
            file.write("newmtl lamp\nKe 1 1 1\nnewmtl dark\nKd 0 0 0\n")
        with open(self.path("a.obj"), "w", encoding="ascii") as file:
            file.write("mtllib a.mtl\nv 4 0 0\nv 4.4 0.4 0\nv 4 0.4 0.4\nv 4.4 0 0.4\nv -9 0 0\n"
                       "v -8 0 0\nv -8 0 1\nusemtl lamp\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n"
                       "usemtl dark\nf 5 6 7\n")
        lamp = ("render", "a.obj", "--size", "7x7", "--depth", "0", "--spp", "64", "--camera",
                "9,1,9", "--look-at", "4.2,0.2,0.2")
        self.run_program(*lamp, "--frames", "4", "--orbit", "77", "-o", "a.%02d.hdr")
        for frame in range(4):
            bright = [i for i, b in enumerate(self.pixels(f"a.{frame:02}.hdr")) if b > 0]
            self.assertTrue(bright, frame)
            for i in bright:
                self.assertLess(abs(i % 7 - 3) + abs(i // 7 - 3), 3, (frame, bright))

    def pixels(self, name):
        """The exponents of a picture of Radiance's, 0 for black; below 8 columns it is flat."""
        body = self.read(name).partition(b"\n-Y 7 +X 7\n")[2]
        self.assertEqual(len(body), 7 * 7 * 4)
        return body[3::4]

    def test_parts_of_a_frame(self):
        """--samples counts from the frame's first one; nothing is missing before it."""
        frame = (*SCENE, *ORBIT, "--spp", "8", "--frame", "5")
        self.output_of(*frame, "-o", "whole.exr")
        for span in ("0:3", "3:8", "5:6"):
            self.output_of(*frame, "--samples", span, "-o", f"{span[0]}.exr")
        self.assertEqual(self.merge("3.exr", "0.exr"), "")
        self.assert_same("merged.exr", "whole.exr")
        self.assertEqual(self.merge("5.exr", "0.exr"),
                         "wellstrat: missing: samples 43:45\n")
        self.output_of(*frame, "--resume", "0.exr", "-o", "a.exr")
        self.assert_same("a.exr", "whole.exr")

    def test_bad_arguments(self):
        self.output_of(*SMALL, "--frame", "3", "-o", "3.exr")
        self.output_of(*SMALL, "--frame", "3", "--orbit", "1", "-o", "3-orbit.exr")
        place = "one place in a file name, such as %04d"
        for arguments, mentions in (
                (("--frames", "5", "-o", "a.exr"), place),
                (("--frames", "1", "-o", "a.exr"), place),
                (("--frames", "5", "-o", "a.%04d.exr", "-o", "a.png"), "'a.png'"),
                *((("--frames", "5", "-o", f"a.{wrong}.exr"), place)
                  for wrong in ("%d", "%4d", "%00d", "%0d", "%04x", "%", "%0", "%04", "%012d",
                                "%04d.%04d", "100%.%04d", "%04d%")),
                (("--frame", "5", "-o", "a.%d.exr"), place),
                (("--frame", "5", "-o", "a.exr", "--checkpoint", "c.%d.exr"), "--checkpoint"),
                (("--frames", "5", "-o", "none/a.%04d.exr"), "none/a.0000.exr"),
                (("--frames", "5", "-o", "%04d.exr", "--checkpoint", "0004.exr"), "two outputs"),
                (("--frames", "5", "-o", "%04d.exr", "--checkpoint", "%04d.exr"), "two outputs"),
                (("--frames", "5", "-o", "%04d.exr", "-o", "%04d.exr"), "two outputs"),
                (("--frames", "0", "-o", "%04d.exr"), "--frames"),
                (("--frames", "100001", "-o", "%04d.exr"), "100000"),
                (("--frame", "-1", "-o", "a.exr"), "--frame"),
                (("--frame", "4294967296", "-o", "a.exr"), "--frame"),
                (("--frame", "1431655765", "-o", "a.exr"), "frames 0 to 1431655764"),
                (("--frame", "1431655764", "--frames", "2", "-o", "%04d.exr"),
                 "frames 0 to 1431655764"),
                (("--frame", "4294967295", "--split", "4096", "-o", "a.exr"), "--split 4096"),
                (("--frame", "1", "--split", "4096", "--spp", "2000000", "--samples", "0:1", "-o",
                  "a.exr"), "--spp"),
                (("--frame", "1", "--samples", "1:4", "-o", "a.exr"), "goes beyond the 3"),
                (("--frame", "1", "--noise", "1", "-o", "a.exr"), "--noise"),
                (("--frames", "1", "--noise", "1", "-o", "%04d.exr"), "--noise"),
                (("--orbit", "1", "-o", "a.exr"), "--orbit"),
                (("--frame", "1", "--orbit", "361", "-o", "a.exr"), "--orbit"),
                (("--frame", "1", "--orbit", "nan", "-o", "a.exr"), "--orbit"),
                (("--frame", "4", "--resume", "3.exr", "-o", "a.exr"), "samples from 12 on"),
                (("--frames", "3", "--resume", "3.exr", "-o", "%02d.exr"), "samples from 0 on"),
                (("--frame", "3", "--orbit", "2", "--resume", "3-orbit.exr", "-o", "a.exr"),
                 "differs in: scene"),
                (("--frame", "3", "--spp", "2", "--resume", "3.exr", "-o", "a.exr"),
                 "samples from 6 on")):
            arguments = arguments if "--spp" in arguments else ("--spp", "3", *arguments)
            self.assert_fails(*SCENE, *arguments, mentions=mentions)

    def test_percent_signs_outside_of_sequences(self):
        self.output_of(*SMALL, "-o", "100%.%04d.png")
        self.assertEqual(self.files(), ["100%.%04d.png"])

    def test_the_last_frames_there_are(self):
        self.output_of(*SMALL, "--frame", "1431655764", "-o", "%09d.exr")
        self.assertEqual(self.files(), ["1431655764.exr"])
        self.assertEqual(self.merge("1431655764.exr"), "")


class UnfinishedFramesTest(FramesCase):
    def sequence(self, spp, *more):
        return (*SCENE, *ORBIT, "--spp", str(spp), "--frame", "2", "--frames", "3", "-o",
                "a.%04d.exr", *more)

    def test_killed_sequences_go_on(self):
        """The checkpoint is of the frame in work: the frames before it are done and stay so."""
        frames = [f"a.000{n}.exr" for n in (2, 3, 4)]
        command = self.sequence(400, "--checkpoint", "part.exr", "--save-every", "0")
        with self.started(PROGRAM, *command, stdout=subprocess.DEVNULL) as process:
            self.wait_until(lambda: os.path.exists(self.path(frames[0])))
            saved = os.stat(self.path("part.exr")).st_ino
            self.wait_until(lambda: os.stat(self.path("part.exr")).st_ino != saved)
            process.kill()
        self.assertNotIn(frames[2], self.files())
        with open(self.path(frames[0]), "wb") as file:
            file.write(b"kept")
        resumed = self.run_program(*command, "--resume", "part.exr")
        self.assertEqual((resumed.returncode, resumed.stderr), (
            0, b"wellstrat: goes on with frame 3; those before it stay as they are\n"))
        self.assertEqual(self.read(frames[0]), b"kept")
        done = [self.read(name) for name in frames[1:]]
        self.output_of(*self.sequence(400))
        self.assertEqual([self.read(name) for name in frames[1:]], done)

    def test_interrupt_writes_the_frame_in_work(self):
        command = self.sequence(1000000)
        with self.started(PROGRAM, *command, "--checkpoint", "part.%04d.exr", "--save-every", "0",
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
            self.wait_until(lambda: os.path.exists(self.path("part.0002.exr")))
            process.send_signal(signal.SIGINT)
            errors = process.communicate(timeout=100)[1].decode()
        self.assertEqual(process.returncode, 130)
        self.assertRegex(
            errors, r"\Awellstrat: interrupted in frame 2 with [^\n]+; --resume goes on\n\Z")
        self.assertEqual(self.files(), ["a.0002.exr", "part.0002.exr"])
        self.assert_same(*self.files())

    def test_time_limit_is_for_all_frames(self):
        process = self.run_program(*self.sequence(1000000), "--time-limit", "1")
        self.assertEqual(process.returncode, 0)
        self.assertRegex(process.stderr.decode(),
                         r"\Awellstrat: time is up in frame 2 with [^\n]+\n\Z")
        self.assertEqual(self.files(), ["a.0002.exr"])
        os.remove(self.path("a.0002.exr"))
        process = self.run_program(*SMALL, "--frames", "9999", "--time-limit", "1", "-o",
                                   "%04d.hdr")
        self.assertEqual(process.returncode, 0)
        names = self.files()
        self.assertEqual(names, [f"{frame:04}.hdr" for frame in range(len(names))])
        last = len(names) - 1
        self.assertRegex(process.stderr.decode(), rf"\Awellstrat: time is up (in frame {last} with|"
                                                  rf"after frame {last};) [^\n]+\n\Z")


class MpiFramesTest(MpiCase, FramesCase):
    def test_ranks_change_no_bit(self):
        self.output_of(*SMALL, *ORBIT, "--samples", "0:2", "--frame", "1", "-o", "start.exr")
        frames = ("--frames", "3", "-o")
        self.output_of(*SMALL, *ORBIT, *frames, "alone.%02d.exr")
        for resume in ((), ("--resume", "start.exr")):
            process = self.mpirun(3, *SMALL, *ORBIT, *resume, *frames, "shared.%02d.exr")
            self.assertEqual(process.returncode, 0, process.stderr)
            self.assertEqual(process.stdout.count(b"samples each"), 2 if resume else 3)
            for frame in ("01", "02") if resume else ("00", "01", "02"):
                self.assert_same(f"alone.{frame}.exr", f"shared.{frame}.exr")
                os.remove(self.path(f"shared.{frame}.exr"))

    def test_errors_are_said_once(self):
        process = self.mpirun(3, *SMALL, "--frames", "3", "-o", "a.exr")
        self.assertEqual(process.returncode, 2)
        self.assertEqual(process.stderr.count(b"one place in a file name"), 1)


if __name__ == "__main__":
    unittest.main()
