# SPDX-License-Identifier: MIT
"""Sentences for wrong calls of what is written in Python, as the functions of the engine have them."""

import functools
import inspect
import types

from _boxreel import _refuse

_SPECIAL = ("__init__", "__new__", "__getitem__", "__setitem__")


def checked(function, name, is_method):
    """Returns the function with a sentence for arguments that it does not take."""
    signature = inspect.signature(function)
    names = [one.name for one in signature.parameters.values() if one.kind is not one.VAR_KEYWORD][is_method:]

    @functools.wraps(function)
    def call(*arguments, **keywords):
        try:
            return function(*arguments, **keywords)
        except TypeError:
            try:
                signature.bind(*arguments, **keywords)
            except TypeError:
                pass
            else:
                raise  # by what the function does
        owner = "" if not is_method or not arguments else arguments[0]
        owner = owner.__name__ if isinstance(owner, type) else type(owner).__name__ if is_method else ""
        full = owner if name in ("__init__", "__new__") else f"{owner}.{name}" if owner else name
        _refuse(full, names, *arguments[is_method:], **keywords)

    return call


class _ReadOnly(property):
    def __init__(self, name, member):
        super().__init__(member.fget)
        self.__doc__ = member.__doc__  # of a subclass, property keeps it by itself in some versions only
        self.name = name

    def __set__(self, item, value):
        raise AttributeError(f"{type(item).__name__}.{self.name} cannot be set")


def _check_class(one):
    for name, member in list(vars(one).items()):
        if name.startswith("_") and name not in _SPECIAL:
            continue
        function = member.__func__ if isinstance(member, staticmethod) and name == "__new__" else member
        if isinstance(function, types.FunctionType) and not hasattr(function, "__wrapped__"):
            setattr(one, name, checked(function, name, True))
        elif isinstance(member, property) and member.fset is None and not isinstance(member, _ReadOnly):
            setattr(one, name, _ReadOnly(name, member))


def check_calls(names):
    """Gives sentences to the functions and classes among the global names of a module."""
    for name, value in list(names.items()):
        if isinstance(value, types.FunctionType) and not name.startswith("_"):
            names[name] = checked(value, name, False)
        elif isinstance(value, type) and not name.startswith("_"):
            for one in value.__mro__:
                if one.__module__.partition(".")[0] in ("_boxreel", "Box2D", "boxreel"):
                    _check_class(one)
