# SPDX-License-Identifier: MIT
"""Films, pictures, snapshots and comparisons of the worlds of Box2D, with no screen.

    with boxreel.film("ball.mp4", size=(1280, 720), fps=60) as film:
        for _ in range(600):
            world.Step(1 / 60, 8, 3)
            film.add(world)

Sizes are in pixels, lengths in metres, times in seconds.
"""

import base64 as _base64
import os as _os
import threading as _threading
import warnings as _warnings

import _boxreel
from _boxreel import Camera, Error
from Box2D import b2World as _World
from Box2D._additions import _from_snapshot
from Box2D._calls import check_calls as _check_calls

__version__ = "0.1.0"

LAYERS = _boxreel._layers  #: names for layers=, as of `boxreel record --draw`
THEMES = _boxreel._themes  #: names for theme=

_local = _threading.local()
_kind = _boxreel._kind


def _require_world(world):
    if not isinstance(world, _World):
        raise TypeError(f"world: expected a b2World, not {_kind(world)}")


def _renderer(size, theme, scale):
    """Returns this thread's renderer of the size. A thread keeps the last four."""
    theme = _boxreel._text(theme, "theme")
    cache = _local.__dict__.setdefault("renderers", {})
    key = (int(size[0]), int(size[1]), theme, float(scale))
    renderer = cache.pop(key, None) or _boxreel._Renderer(*key)
    cache[key] = renderer
    while len(cache) > 4:
        del cache[next(iter(cache))]
    return renderer


def _pair(size):
    """Returns the size as two whole numbers."""
    try:
        width, height = (int(number) for number in size)
    except (TypeError, ValueError):
        raise TypeError(f"size: expected width and height in pixels, such as (1280, 720), not {size!r}") from None
    return width, height


def _path_of(path):
    if not isinstance(path, (str, _os.PathLike)):
        raise TypeError(f"path: expected the name of a file, not {_kind(path)}")
    text = _boxreel._text(_os.fspath(path), "path")
    if not text or "\0" in text:
        raise ValueError(f"path: expected the name of a file, not {text!r}")
    return text


def _size_of(size, camera):
    if camera is None:
        return _pair(size)
    if not isinstance(camera, Camera):
        raise TypeError(f"camera: expected a boxreel.Camera or None, not {_kind(camera)}")
    return camera.width, camera.height


def fit(world, size=(1280, 720), margin=0.06):
    """Returns the camera that shows all moving bodies and what is near them. `margin` is a fraction of the
    smaller side of the picture."""
    _require_world(world)
    return _boxreel._fit(world, *_pair(size), margin)


def render(world, size=(1280, 720), *, camera=None, theme="classic", scale=1.0, layers=None, trails=None):
    """Returns a picture of the world as an array (height, width, 4) of uint8: red, green, blue, opacity.

    camera: a Camera, by default fit(world); its size is that of the picture.
    theme: one of boxreel.THEMES.
    scale: factor of the widths of lines.
    layers: some of boxreel.LAYERS (default: shapes, joints).
    trails: paths to draw, each a sequence of points [m], oldest first.
    """
    _require_world(world)
    width, height = _size_of(size, camera)
    view = _boxreel._camera(camera, world, width, height)
    return _renderer((width, height), theme, scale).draw(world, view, layers, trails)


def shot(world, path, size=(1280, 720), *, camera=None, theme="classic", scale=1.0, layers=None, trails=None,
         overwrite=True):
    """Writes a picture (.png) or a figure (.svg, .pdf) of the world. Arguments as of render."""
    _require_world(world)
    path = _path_of(path)
    if path.endswith(".png"):
        _boxreel._write_png(path, render(world, size, camera=camera, theme=theme, scale=scale, layers=layers,
                                         trails=trails), overwrite)
    elif path.endswith((".svg", ".pdf")):
        width, height = _size_of(size, camera)
        view = _boxreel._camera(camera, world, width, height)
        _boxreel._figure(world, path, view, _boxreel._text(theme, "theme"), scale, layers, trails, overwrite)
    else:
        _boxreel._error(path, "has an unsupported extension", "use .png, .svg or .pdf")


class Film:
    """A film; see film."""

    _film = None

    def __init__(self, path, size=None, fps=60, *, quality="standard", codec="", theme="classic", scale=1.0, overwrite=True):
        self._path = _path_of(path)
        width, height = (1280, 720) if size is None else _pair(size)
        # The program may change its folder before the film is closed.
        self._film = _boxreel._Film(_path_of(_os.path.abspath(self._path)), {
            "width": width, "height": height, "fps": fps, "quality": quality, "codec": codec, "theme": theme,
            "scale": scale, "overwrite": overwrite})
        self._film.size_is_given(size is not None)
        self._is_open = True

    def __del__(self):
        if self._film is not None and self._is_open:
            _warnings.warn(f"{self.path}: this film was dropped and is not written; call close, or use it in a with block",
                           ResourceWarning, source=self)

    def add(self, frame, *, camera=None, layers=None, trails=None):
        """Appends a frame: a world as it is now, or an array (height, width, 3 or 4) of uint8.

        camera: a Camera; by default one that keeps moving bodies in view. layers, trails: as of render.
        On a page the layers of the first frame are on at first; a reader can switch on those of later frames.
        """
        if isinstance(frame, _World):
            self._film.add_world(frame, camera, layers, trails)
        else:
            self._film.add_array(frame)

    def close(self):
        """Waits for the encoder and gives the film its name."""
        self._is_open = False
        self._film.close()

    @property
    def path(self):
        """The file."""
        return self._path

    @property
    def frames(self):
        """Number of frames added."""
        return self._film.frames

    @property
    def size(self):
        """Width and height [px]."""
        return self._film.size

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        if kind is None:
            self.close()
        else:
            self._is_open = False
            self._film.discard()  # no file under the final name

    def __repr__(self):
        return f"Film({self.path!r}, frames={self.frames})"

    def _repr_html_(self):
        """Plays the film in Jupyter."""
        kind = _os.path.splitext(self.path)[1][1:]
        if not _os.path.exists(self.path):
            return f"<p>{self!r}: not closed yet</p>"
        with open(self.path, "rb") as file:
            data = _base64.b64encode(file.read()).decode()
        if kind == "html":
            # The controls wrap where the page is narrow.
            width, height = max(self.size[0], 640), self.size[1] + 140
            return f'<iframe width="{width}" height="{height}" src="data:text/html;base64,{data}"></iframe>'
        if kind in ("gif", "apng", "webp"):
            return f'<img src="data:image/{kind};base64,{data}">'
        return f'<video controls loop width="{self.size[0]}" src="data:video/{kind};base64,{data}"></video>'


def film(path, size=None, fps=60, *, quality="standard", codec="", theme="classic", scale=1.0, overwrite=True):
    """Opens a film. The extension chooses the format: .mp4, .mkv, .webm, .gif, .apng, .webp, frames-####.png, or
    .html: a page that plays a world in a browser.

    size: width and height [px], by default 1280 x 720, or that of the first array.
    fps: frames per second, a number or a fraction such as "30000/1001".
    quality: draft, standard, high or lossless.

    Use it in a `with` block: an exception there leaves no film.
    """
    return Film(path, size, fps, quality=quality, codec=codec, theme=theme, scale=scale, overwrite=overwrite)


def state_hash(world):
    """Returns 16 hex digits of all bodies' poses and velocities, bit by bit."""
    _require_world(world)
    return _boxreel._state_hash(world)


def save(world):
    """Returns the world as bytes, for restore."""
    _require_world(world)
    return world._save()


def restore(world, snapshot):
    """Puts a world back to a snapshot. Bodies, fixtures and joints that were there keep their Python objects and
    their attributes as they are; those created later are destroyed."""
    _require_world(world)
    if not isinstance(snapshot, (bytes, bytearray)):
        raise TypeError(f"boxreel.restore: snapshot: expected the bytes of boxreel.save, not {_kind(snapshot)}")
    world._restore(bytes(snapshot))


def _world_of(snapshot):
    content, names, steps = snapshot
    world = _from_snapshot(_World, content)
    for body in world.bodies:
        if body.number in names:
            body.name = names[body.number]
    world.steps = steps
    return world


def scenes():
    """Returns the names of the scenes and what each shows."""
    return _boxreel._scenes()


def scene(name, seed=1):
    """Returns the world of a scene at its start. Bodies with a name have it as `name`; `world.steps` are the
    arguments of Step that the scene prefers. What a scene steers in each step is not part of it."""
    if not isinstance(name, str):
        raise TypeError(f"boxreel.scene: name: expected the name of a scene, not {_kind(name)}")
    name = _boxreel._text(name, "name")
    if not hasattr(seed, "__index__"):
        raise TypeError(f"boxreel.scene: seed: expected a whole number, not {_kind(seed)}")
    try:
        return _world_of(_boxreel._scene(name, seed))
    except KeyError:
        import difflib

        by_lower = {known.lower(): known for known in scenes()}
        near = difflib.get_close_matches(name.lower(), by_lower, 1)
        if near and near[0] == name.lower():
            return _world_of(_boxreel._scene(by_lower[near[0]], seed))
        hint = f"; did you mean '{by_lower[near[0]]}'?" if near else "; boxreel.scenes() lists them"
        raise ValueError(f"there is no scene '{name}'{hint}") from None


def load(path):
    """Returns the world of a R.U.B.E. scene file; as of scene. `world.left_out` tells what could not be built."""
    snapshot, left_out = _boxreel._load_rube(_path_of(path))
    world = _world_of(snapshot)
    world.left_out = left_out
    return world


def dump(world, path):
    """Writes the world as a R.U.B.E. scene file. Returns what the format cannot say."""
    _require_world(world)
    text, left_out = _boxreel._rube_text(world)
    _boxreel._write_text(_path_of(path), text)
    return left_out


class Comparison:
    """The result of compare. True if the pictures are equal within the limits."""

    def __init__(self, verdict):
        if not isinstance(verdict, dict):
            raise TypeError("Comparison: it has no constructor; boxreel.compare makes these")
        self.__dict__.update(verdict)

    def __bool__(self):
        return self.equal

    def __repr__(self):
        return f"Comparison({self.text!r})"

    def _repr_png_(self):
        return _boxreel._png(self.difference)


def _pixels(picture):
    return _boxreel._read_png(_path_of(picture)) if isinstance(picture, (str, _os.PathLike)) else picture


def compare(expected, actual, preset="same-machine", *, camera=None):
    """Compares two pictures: arrays, PNG files or worlds. `preset` has the limits: exact, same-machine or
    cross-machine. The result has equal, text, differentPixels, overTolerance, largestDistance, difference.

    camera: for worlds; by default one for both, which shows the first of them in the size of the other picture.
    """
    preset = _boxreel._text(preset, "preset")
    pictures = [picture if isinstance(picture, _World) else _pixels(picture) for picture in (expected, actual)]
    worlds = [picture for picture in pictures if isinstance(picture, _World)]
    if worlds and camera is None:
        sizes = [picture.shape[1::-1] for picture in pictures if len(getattr(picture, "shape", ())) == 3]
        camera = fit(worlds[0], sizes[0] if sizes else (1280, 720))
    return Comparison(_boxreel._compare(*(render(picture, camera=camera) if isinstance(picture, _World) else picture
                                          for picture in pictures), preset))


_check_calls(globals())
_World._repr_png_ = lambda self: _boxreel._png(render(self, (640, 360)))

__all__ = ["LAYERS", "THEMES", "Camera", "Comparison", "Error", "Film", "compare", "dump", "film", "fit", "load", "render", "restore",
           "save", "scene", "scenes", "shot", "state_hash"]
