# SPDX-License-Identifier: MIT
"""Films, pictures, snapshots, scenes and comparisons of the package boxreel."""

import copy
import json
import os
import pickle
import re
import subprocess
import sys
import tempfile
import unittest

import numpy

import boxreel
import boxreel_golden
from Box2D import b2CircleShape, b2EdgeShape, b2Error, b2Filter, b2FixtureDef, b2World


def drop():
    world = b2World()
    world.CreateStaticBody(shapes=b2EdgeShape(vertices=[(-5, 0), (5, 0)]))
    world.CreateDynamicBody(position=(0, 3), fixtures=b2FixtureDef(shape=b2CircleShape(radius=1), density=1))
    return world


def step(world, count=1):
    for _ in range(count):
        world.Step(1 / 50, 8, 3)


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)


class Pictures(InFolder):
    def test_render_is_an_array_that_owns_its_pixels(self):
        world = drop()
        camera = boxreel.fit(world, (320, 180))
        first = boxreel.render(world, camera=camera)
        self.assertEqual((first.shape, first.dtype), ((180, 320, 4), numpy.uint8))
        kept = first.copy()
        step(world, 20)
        second = boxreel.render(world, camera=camera)
        self.assertTrue((first == kept).all())
        self.assertFalse((first == second).all())
        self.assertGreater(len(numpy.unique(first.reshape(-1, 4), axis=0)), 3)

    def test_render_uses_camera_and_theme(self):
        world = drop()
        camera = boxreel.Camera(200, 100, center=(0, 3), pixelsPerMeter=20)
        picture = boxreel.render(world, camera=camera, theme="print")
        self.assertEqual(picture.shape, (100, 200, 4))
        self.assertEqual(camera.to_pixel((0, 3)), (100, 50))
        self.assertEqual(camera.to_world((120, 50)), (1, 3))
        self.assertNotEqual(picture[50, 90].tolist(), picture[5, 5].tolist())
        with self.assertRaises(b2Error):
            boxreel.render(world, theme="printed")
        with self.assertRaises(b2Error):
            boxreel.render(world, layers=["shape"])
        with self.assertRaisesRegex(b2Error, "^theme .*okabe-ito.*'print'"):
            boxreel.render(world, theme="prnt")
        with self.assertRaises(TypeError):
            boxreel.render(None)

    def test_layers_have_the_names_of_draw(self):
        world = drop()
        step(world, 100)
        world.bodies[-1].name = "ball"
        plain = boxreel.render(world, (320, 180), layers=[])
        for layer in boxreel.LAYERS:
            with self.subTest(layer):
                boxreel.render(world, (320, 180), layers=[layer])
        for layer in ("shapes", "aabbs", "contacts", "normals", "masses", "centers", "names"):
            with self.subTest(layer):
                self.assertTrue((boxreel.render(world, (320, 180), layers=[layer]) != plain).any())

    def test_every_named_theme_draws(self):
        pictures = {boxreel.render(drop(), (64, 36), theme=theme).tobytes() for theme in boxreel.THEMES}
        self.assertEqual(len(pictures), len(boxreel.THEMES))

    def test_cameras_are_copied_and_pickled(self):
        camera = boxreel.Camera(200, 100, center=(0, 3))
        for twin in (camera.copy(), copy.copy(camera), pickle.loads(pickle.dumps(camera, 0))):
            self.assertEqual(twin, camera)

    def test_shot_writes_pictures_and_figures(self):
        world = drop()
        for name, start in (("a.png", b"\x89PNG"), ("a.svg", b"<svg"), ("a.pdf", b"%PDF")):
            boxreel.shot(world, self.path(name), (320, 180), theme="print", trails=[[(0, 0), (1, 2), (3, 2)]])
            with open(self.path(name), "rb") as file:
                self.assertIn(start, file.read(400))
        with self.assertRaises(boxreel.Error):
            boxreel.shot(world, self.path("a.bmp"))
        with self.assertRaises(boxreel.Error):
            boxreel.shot(world, self.path("a.svg"), overwrite=False)

    def test_wrong_trails_and_layers_are_named(self):
        world, path = drop(), [(0, 0), (1, 2)]
        for trails, culprit in ((5, "trails:"), ("abc", "trails:"), (path, r"trails\[0\]:"), ([path, None], r"trails\[1\]:"),
                                ([path, [5]], "trails:")):
            with self.assertRaisesRegex(TypeError, culprit):
                boxreel.shot(world, self.path("a.svg"), (320, 180), trails=trails)
        for layers in (5, "shapes"):
            with self.assertRaisesRegex(TypeError, "layers:"):
                boxreel.shot(world, self.path("a.svg"), (320, 180), layers=layers)
        boxreel.shot(world, self.path("a.svg"), (320, 180), trails=(numpy.array(path), iter(path)), layers=("shapes",))

    def test_jupyter_shows_a_world(self):
        self.assertTrue(drop()._repr_png_().startswith(b"\x89PNG"))

    def test_compare_finds_changed_pixels(self):
        world = drop()
        camera = boxreel.fit(world, (320, 180))
        first = boxreel.render(world, camera=camera)
        self.assertTrue(boxreel.compare(first, first))
        step(world, 10)
        result = boxreel.compare(first, boxreel.render(world, camera=camera))
        self.assertFalse(result)
        self.assertGreater(result.overTolerance, 100)
        self.assertEqual(result.difference.shape, (180, 320, 4))

    def test_compare_shows_worlds_in_one_view(self):
        worlds = [b2World(), b2World()]
        for world, place in zip(worlds, ((0, 0), (5, 9))):
            world.CreateDynamicBody(position=place, shapes=b2CircleShape(radius=1))
        self.assertTrue(boxreel.compare(worlds[0], worlds[0]))
        self.assertFalse(boxreel.compare(*worlds))
        self.assertFalse(boxreel.compare(*worlds, camera=boxreel.Camera(320, 180)))
        picture = boxreel.render(worlds[0], (320, 180))
        self.assertTrue(boxreel.compare(picture, worlds[0]))
        self.assertTrue(boxreel.compare(worlds[0], picture))


class Films(InFolder):
    def frames_of(self, path):
        out = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames,width",
                              "-of", "csv=p=0", path], capture_output=True, text=True, check=True).stdout
        return [int(number) for number in out.strip().split(",")]

    def test_film_has_the_added_frames(self):
        world = drop()
        with boxreel.film(self.path("a.mp4"), size=(320, 180), fps=50, quality="draft") as film:
            for _ in range(30):
                step(world)
                film.add(world)
        self.assertEqual(film.frames, 30)
        self.assertEqual(self.frames_of(film.path), [320, 30])
        self.assertIn("<video", film._repr_html_())

    def test_the_first_frame_shows_the_ground_below(self):
        world = b2World(gravity=(0, -10))
        world.CreateStaticBody(shapes=b2EdgeShape(vertices=[(-12, 0), (12, 0)]))
        world.CreateDynamicBody(position=(0, 9), fixtures=b2FixtureDef(shape=b2CircleShape(radius=1), density=1))
        path = self.path("fall.mkv")
        with boxreel.film(path, size=(160, 90), fps=60) as film:
            film.add(world)
        pixels = subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                                capture_output=True, check=True).stdout
        rows = numpy.frombuffer(pixels, numpy.uint8).reshape(90, 160, 3).astype(int)
        is_green = rows[:, :, 1] > rows[:, :, 0] + 20
        self.assertGreater(is_green.any(axis=0).mean(), 0.9)

    def test_film_of_arrays_has_their_size(self):
        pixels = numpy.zeros((90, 160, 3), numpy.uint8)
        with boxreel.film(self.path("a.mkv"), fps=10, quality="lossless") as film:
            for i in range(5):
                pixels[:, : 20 * i] = 255
                film.add(pixels)
        self.assertEqual(self.frames_of(film.path), [160, 5])
        self.assertEqual(film.size, (160, 90))

    def test_page_has_the_added_frames_and_bodies(self):
        world = drop()
        world.bodies[-1].name = "the ball"
        with boxreel.film(self.path("a.html"), size=(320, 180), fps=50) as page:
            for _ in range(30):
                page.add(world, layers=["shapes", "joints", "velocities", "glyphs", "contacts"])
                step(world, 1)
        with open(page.path, encoding="utf-8") as file:
            text = file.read()
        head = json.loads(re.search(r'<script type="application/json" id="head">(.*?)</script>', text, re.DOTALL)[1])
        self.assertEqual([head[name] for name in ("width", "height", "frames", "framesPerSecond")], [320, 180, 30, 50])
        self.assertIn("the ball", text)
        self.assertEqual(page.frames, 30)
        self.assertIn("<iframe", page._repr_html_())

    def test_pages_show_worlds_and_have_no_codec(self):
        for options in ({"codec": "av1"}, {"quality": "high"}, {"scale": 2}):
            with self.assertRaises(b2Error):
                boxreel.film(self.path("a.html"), **options)
        with self.assertRaises(b2Error):
            with boxreel.film(self.path("a.html"), size=(32, 18)) as page:
                page.add(drop())
                page.add(numpy.zeros((18, 32, 3), dtype=numpy.uint8))
        self.assertEqual(os.listdir(self.folder), [])

    def test_films_are_where_they_were_opened(self):
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        for name in ("a.mp4", "a.html", "a-####.png"):
            with boxreel.Film(name, size=(32, 18)) as film:
                film.add(drop())
                os.chdir("/")
            os.chdir(self.folder)
            self.assertEqual(film.path, name)
        self.assertEqual(len([name for name in os.listdir(self.folder) if not name.endswith(".json")]), 3)

    def test_an_exception_leaves_no_film(self):
        with self.assertRaises(KeyError):
            with boxreel.film(self.path("a.mp4"), size=(320, 180)) as film:
                film.add(drop())
                raise KeyError
        self.assertEqual(os.listdir(self.folder), [])

    def test_wrong_calls_are_refused(self):
        with self.assertRaises(boxreel.Error):
            boxreel.film(self.path("a.avi"))
        with self.assertRaises(b2Error):
            with boxreel.film(self.path("a.mp4")):
                pass
        film = boxreel.film(self.path("b.mp4"), size=(320, 180))
        film.add(drop())
        for frame in (numpy.zeros((180, 320, 4), numpy.uint8), numpy.zeros((9, 9)), "pixels"):
            with self.assertRaises((b2Error, TypeError)):
                film.add(frame)
        film.close()
        with self.assertRaises(b2Error):
            film.add(drop())

    def refusal_of(self, name, **settings):
        """The error of a film whose first frame is added."""
        with self.assertRaises(boxreel.Error) as caught:
            with boxreel.film(self.path(name), **{"size": (32, 18), **settings}) as film:
                film.add(drop())
        error = caught.exception
        self.assertNotIn("--", str(error))
        self.assertNotIn("::", str(error))
        return error

    def test_errors_of_films_name_keywords(self):
        for name, settings, culprit in (("a.mp4", {"size": (321, 180)}, "size=(321, 180)"),
                                        ("a.mp4", {"fps": 2000}, "fps=2000/1"),
                                        ("a.mp4", {"codec": "vp9"}, 'codec="vp9"'),
                                        ("a.mkv", {"codec": "ffv1"}, 'codec="ffv1"'),
                                        ("d.gif", {"codec": "h264"}, 'codec="h264"'),
                                        ("a.y4m", {"quality": "lossless"}, 'quality="lossless"'),
                                        ("none/a.mp4", {}, self.path("none/a.mp4"))):
            with self.subTest(name=name, **settings):
                error = self.refusal_of(name, **settings)
                self.assertEqual((error.kind, error.culprit), ("unusable", culprit))
                self.assertNotIn("chroma =", str(error))  # no keyword of films

    def test_errors_of_films_advise_keywords(self):
        odd = self.refusal_of("a.mp4", size=(321, 180))
        self.assertIn("size=(322, 180)", odd.remedy)
        self.assertIn('quality="lossless"', odd.remedy)
        for name in ("b.mp4", "c.part.mp4"):  # a film, and one that was interrupted
            with open(self.path(name), "wb") as file:
                file.write(b"film")
        for name in ("b.mp4", "c.mp4"):
            error = self.refusal_of(name, overwrite=False)
            self.assertEqual((error.kind, error.culprit), ("unusable", self.path(name)))
            self.assertIn("overwrite=True", error.remedy)
            self.assertNotIn("resume", error.remedy)

    def test_errors_of_pages_name_keywords(self):
        for settings, culprit in (({"size": (0, 180)}, "size=(0, 180)"), ({"fps": 2000}, "fps=2000"),
                                  ({"fps": -3}, "fps=-3")):
            with self.subTest(**settings):
                error = self.refusal_of("a.html", **settings)
                self.assertEqual((error.kind, error.culprit), ("unusable", culprit))
        self.assertIn("overwrite=True", self.refusal_of_existing_page().remedy)
        self.assertIn(".html", self.refusal_of("a.xyz").remedy)

    def refusal_of_existing_page(self):
        with open(self.path("b.html"), "w") as file:
            file.write("mine")
        return self.refusal_of("b.html", overwrite=False)

    def test_half_surrogates_are_named(self):
        world = drop()
        world.bodies[0].name = "ball\udc80"
        for call, culprit in ((lambda: boxreel.render(world, layers=["names"]), "name"),
                              (lambda: boxreel.dump(world, self.path("a.json")), "name"),
                              (lambda: boxreel.film(self.path("a\udc80.mp4")), "path"),
                              (lambda: boxreel.render(world, theme="\udc80"), "theme"),
                              (lambda: boxreel.render(world, layers=["\udc80"]), "layers"),
                              (lambda: boxreel.scene("\udc80"), "name"),
                              (lambda: boxreel.compare(world, world, "\udc80"), "preset")):
            with self.assertRaisesRegex(b2Error, rf"^{culprit}: .*\\udc80.* UTF-8"):
                call()
        with self.assertRaisesRegex(TypeError, r"\\udc80"):
            b2Filter(**{"\udc80": 1})

    def test_errors_of_films_come_before_wrong_frames(self):
        film = boxreel.film(self.path("a.mp4"), size=(320, 180))
        with self.assertRaisesRegex(b2Error, "16 x 9 pixels.*320 x 180"):
            film.add(numpy.zeros((9, 16, 3), numpy.uint8))
        film.add(numpy.zeros((180, 320, 3), numpy.uint8))
        with self.assertRaisesRegex(b2Error, "16 x 9 pixels.*320 x 180"):
            film.add(numpy.zeros((9, 16, 3), numpy.uint8))
        film.close()

    def test_an_unclosed_film_warns_and_leaves_no_file(self):
        with self.assertWarnsRegex(ResourceWarning, "a.mp4"):
            boxreel.film(self.path("a.mp4"), size=(320, 180)).add(drop())
        self.assertEqual(os.listdir(self.folder), [])

    def test_wrong_calls_name_the_expected_arguments(self):
        for call, text in ((lambda: boxreel.Camera(640, 360, centre=(0, 0)), "^Camera: .*did you mean 'center'"),
                           (lambda: boxreel.fit(drop(), 3), "^size: expected width and height"),
                           (lambda: boxreel.film("a.mp4", "ab"), "^size: expected width and height"),
                           (lambda: boxreel.render(drop(), camera=3), "^camera: expected a boxreel.Camera"),
                           (lambda: boxreel.film(3), "^path: expected the name of a file, not 'int'$"),
                           (lambda: boxreel.scene(3), "^boxreel.scene: name: expected the name of a scene, not 'int'$"),
                           (lambda: boxreel.restore(drop(), None), "^boxreel.restore: snapshot: .*, not None$"),
                           (lambda: boxreel.render(b2World), "^world: expected a b2World, not the class b2World$")):
            with self.assertRaisesRegex(TypeError, text):
                call()
        for name in ("", "a\0.svg"):
            with self.assertRaisesRegex(ValueError, "^path: "):
                boxreel.shot(drop(), name)
        with self.assertRaisesRegex(b2Error, "boxreel.save"):
            boxreel.restore(drop(), b"none")
        with self.assertRaisesRegex(ValueError, "seed"):
            boxreel.scene("Pyramid", -1)
        with self.assertRaisesRegex(ValueError, "center"):
            boxreel.Camera(center=(float("nan"), 0))

    def test_the_same_film_has_the_same_bytes(self):
        contents = []
        for name in ("a.mp4", "b.mp4"):
            world = drop()
            with boxreel.film(self.path(name), size=(320, 180)) as film:
                for _ in range(20):
                    step(world)
                    film.add(world)
            with open(self.path(name), "rb") as file:
                contents.append(file.read())
        self.assertEqual(*contents)


class States(InFolder):
    def test_restore_continues_with_the_same_hash(self):
        world = drop()
        step(world, 5)
        snapshot, before = boxreel.save(world), boxreel.state_hash(world)
        step(world, 50)
        after = boxreel.state_hash(world)
        self.assertNotEqual(before, after)
        boxreel.restore(world, snapshot)
        self.assertEqual(boxreel.state_hash(world), before)
        step(world, 50)
        self.assertEqual(boxreel.state_hash(world), after)

    def test_scenes_are_listed_and_made(self):
        self.assertIn("Pyramid", boxreel.scenes())
        world = boxreel.scene("pyramid")
        self.assertGreater(world.bodyCount, 20)
        world.Step(*world.steps)
        with self.assertRaisesRegex(ValueError, "Pyramid"):
            boxreel.scene("Pyramit")

    def test_scene_files_restore_the_world(self):
        world = drop()
        world.bodies[1].name = "ball"
        self.assertEqual(boxreel.dump(world, self.path("a.json")), [])
        twin = boxreel.load(self.path("a.json"))
        self.assertEqual([body.position for body in twin], [body.position for body in world])
        self.assertEqual((twin.bodies[1].name, twin.left_out), ("ball", []))
        with self.assertRaises(boxreel.Error):
            boxreel.load(self.path("b.json"))

    def test_golden_checks_and_accepts_worlds(self):
        world = drop()
        options = {"references": self.path("references"), "output": self.path("output")}
        with self.assertRaises(AssertionError):
            boxreel_golden.check(world, "drop", **options)
        boxreel_golden.check(world, "drop", accept="all", **options)
        boxreel_golden.check(world, "drop", **options)
        step(world)
        with self.assertRaisesRegex(AssertionError, "drop"):
            boxreel_golden.check(world, "drop", **options)


if __name__ == "__main__":
    unittest.main()
