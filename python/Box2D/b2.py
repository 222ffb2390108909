# SPDX-License-Identifier: MIT
"""The names of Box2D without their prefix: b2World is `world`, b2_pi is `pi`, b2AABB is `AABB`."""

import Box2D as _box2d


def _short(name):
    if not name.startswith("b2"):
        return name
    rest = name[2:].lstrip("_")
    return rest[0].lower() + rest[1:] if len(rest) > 1 and rest[1].islower() else rest


__all__ = []
for _name in _box2d.__all__:
    if _name not in ("b2Min", "b2Max", "b2Abs", "b2Error", "b2Globals"):  # of these, builtins have the short name
        vars()[_short(_name)] = getattr(_box2d, _name)
        __all__.append(_short(_name))
error = _box2d.b2Error
globals_ = globals = _box2d.b2Globals  # `globals` is not exported, because it would hide the builtin
__all__ += ["error", "globals_"]
