#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""stubs.py MODULE_FOLDER

Writes the type stubs of the packages Box2D and boxreel beside them, from the module in the folder that the build
made: python/Box2D/__init__.pyi, python/Box2D/b2.pyi and python/boxreel/__init__.pyi. Run it after a change of names:
python3 python/stubs.py build/release/python. A quick test compares the names.
"""
import inspect
import os
import pathlib
import re
import sys

os.environ["BOXREEL_SIGNATURES"] = "1"  # before the module is loaded: its texts then begin with the types
HEAD = '''# Made by python/stubs.py.
from typing import Any, Generic, Iterator, Sequence, TypeVar

_T = TypeVar("_T")

class _Settable(Generic[_T]):
    def __get__(self, one: Any, owner: Any = ...) -> _T: ...
    def __set__(self, one: Any, value: Any) -> None: ...

'''
PLAIN = {"bool", "int", "float", "str", "bytes", "None", "list", "tuple", "dict"}
SIGNATURE = re.compile(r"^(?:\w+)?\((.*)\)(?: -> (.+?))?$")
LISTS = {("b2World", "bodies"): "list[b2Body]", ("b2World", "joints"): "list[b2Joint]", ("b2World", "contacts"): "list[b2Contact]",
         ("b2Body", "fixtures"): "list[b2Fixture]", ("b2Body", "joints"): "list[b2JointEdge]",
         ("b2Body", "contacts"): "list[b2ContactEdge]"}
OPERATORS = {"__init__", "__len__", "__getitem__", "__setitem__", "__iter__", "__eq__", "__ne__", "__neg__", "__pos__", "__add__",
             "__radd__", "__sub__", "__rsub__", "__mul__", "__rmul__", "__truediv__", "__iadd__", "__isub__", "__imul__", "__itruediv__",
             "__abs__", "__bool__", "__contains__", "__hash__", "__enter__", "__exit__", "__call__"}


class Writer:
    def __init__(self, module, imported=()):
        self.module, self.lines = module, []
        self.public = {name: value for name, value in vars(module).items() if not name.startswith("_") and not inspect.ismodule(value)}
        self.classes = {value: name for name, value in self.public.items() if inspect.isclass(value)}
        self.imported = imported

    def type_of(self, text):
        """The name of a type in a text of pybind11's, Any if it takes any object."""
        name = re.sub(r"^boxreel::python::Handle<(\w+)>$", r"\1", text.strip()).rpartition(".")[2]
        return name if name in PLAIN or name in self.public or name in self.imported else "Any"

    def parameters(self, text, is_method):
        """The parameters of a signature; those that it cannot name are taken by place."""
        found = []
        depth, part = 0, ""
        for sign in text + ",":
            depth += (sign in "([<{") - (sign in ")]>}")
            if sign == "," and depth == 0:
                found.append(part.strip())
                part = ""
            else:
                part += sign
        shown, places = [], False
        for place, one in enumerate(one for one in found if one):
            name, _, rest = one.partition(":")
            kind, equals, _ = rest.partition(" = ")
            if is_method and place == 0:
                shown.append("self")
            elif name.startswith("*"):
                shown.append(f"{name}: Any")
            else:
                places = places or re.fullmatch(r"arg\d+", name) is not None
                shown.append(f"{name}: {self.type_of(kind)}{' = ...' if equals else ''}")
        return ", ".join(shown + ["/"] * (places and len(shown) > is_method and "*" not in text))

    def signature(self, function, is_method):
        """Of a function of C++ from its text, of one of Python by inspection."""
        lines = (inspect.getdoc(function) or "").splitlines()
        found = SIGNATURE.match(lines[0]) if lines else None
        if found and "Overloaded" not in "".join(lines[1:2]):
            return f"({self.parameters(found[1], is_method)}) -> {self.type_of(found[2] or 'Any')}", " ".join(lines[1:]).strip()
        text = " ".join(lines).strip() if not found else ""
        try:
            parameters = []
            for one in inspect.signature(function).parameters.values():
                stars = {one.VAR_POSITIONAL: "*", one.VAR_KEYWORD: "**"}.get(one.kind, "")
                if one.kind == one.KEYWORD_ONLY and not any(other.startswith("*") for other in parameters):
                    parameters.append("*")
                is_self = is_method and not parameters
                parameters.append("self" if is_self else f"{stars}{one.name}: Any{' = ...' if one.default is not one.empty else ''}")
            written = getattr(function, "__annotations__", {}).get("return")
            returned = "None" if function.__name__ == "__init__" else written.__name__ if written else "Any"
            return f"({', '.join(parameters)}) -> {returned}", text
        except (TypeError, ValueError):
            return f"({'self, ' * is_method}*args: Any, **kwargs: Any) -> Any", text

    def function(self, name, function, indent="", is_method=False):
        if name in ("__eq__", "__ne__"):
            self.lines.append(f"{indent}def {name}(self, other: object) -> bool: ...")
            return
        signature, text = self.signature(function, is_method)
        signature = re.sub(r"-> \w+$", "-> None", signature) if name == "__init__" else signature
        body = f'\n{indent}    """{text}"""\n{indent}    ...' if text and '"""' not in text and "\\" not in text else " ..."
        self.lines.append(f"{indent}def {name}{signature}:{body}")

    def property(self, name, value, owner):
        first = (inspect.getdoc(value.fget) or "").splitlines()
        found = SIGNATURE.match(first[0]) if first else None
        written = getattr(value.fget, "__annotations__", {}).get("return")  # of a property in Python
        kind = written.__name__ if written else self.type_of(found[2]) if found and found[2] else "Any"
        kind = LISTS.get((owner, name), "Any" if owner == "b2Color" and kind == "list" else kind)  # which has a member `list`
        text = re.sub(r"^\(.*?\) -> \S+\s*", "", inspect.getdoc(value) or "", flags=re.DOTALL).replace("\n", " ").strip()
        if value.fset and kind not in ("Any", "bool", "int", "float", "str"):  # a tuple is taken for a vector
            self.lines.append(f"    {name}: _Settable[{kind}]" + (f'\n    """{text}"""' if text else ""))
            return
        self.lines.append(f"    @property\n    def {name}(self) -> {kind}:" + (f'\n        """{text}"""\n        ...' if text else " ..."))
        if value.fset:
            self.lines.append(f"    @{name}.setter\n    def {name}(self, value: {kind}) -> None: ...")

    def class_of(self, name, one):
        bases = [base for base in one.__mro__[1:] if base in self.classes][:1]
        base = self.classes[bases[0]] if bases else "Exception" if issubclass(one, Exception) else ""
        self.lines.append(f"\nclass {name}{'(' + base + ')' if base else ''}:")
        text = inspect.cleandoc(one.__doc__ or "").replace("\n", " ")
        self.lines.append(f'    """{text}"""' if text and '"""' not in text else "    ...")
        members = {}
        for owner in reversed([one, *(base for base in one.__mro__[1:] if base not in self.classes and base.__module__.startswith(("Box2D", "boxreel")))]):
            members |= vars(owner)
        fields = getattr(one, "_fields", {})  # of definitions with their defaults, of named tuples without
        fields = fields if isinstance(fields, dict) else dict.fromkeys(fields)
        for key, default in fields.items():
            kind = type(default).__name__ if type(default) in (bool, int, float) else "Any"
            self.lines.append(f"    {key}: {kind}")
        if "__dict__" in vars(one) and not bases:  # programs add attributes of their own
            self.lines.append("    def __getattr__(self, name: str) -> Any: ...\n    def __setattr__(self, name: str, value: Any) -> None: ...")
        for key, value in members.items():
            if key.startswith("_") and key not in OPERATORS or key in fields:
                continue
            if isinstance(value, property):
                self.property(key, value, name)
            elif key == "__hash__" or inspect.isclass(value):
                continue
            elif callable(value) or isinstance(value, (staticmethod, classmethod)):
                is_static = isinstance(value, staticmethod)
                self.lines += ["    @staticmethod"] * is_static
                self.function(key, getattr(one, key) if is_static else getattr(value, "__func__", value), "    ", not is_static)
            elif type(value).__name__ in PLAIN:
                self.lines.append(f"    {key}: {type(value).__name__}")
            else:
                self.lines.append(f"    {key}: Any")

    def text(self):
        done = set()
        self.lines += [f"{name}: str" for name in ("__version__",) if hasattr(self.module, name)]
        for name, value in sorted(self.public.items(), key=lambda item: (len(item[1].__mro__) if inspect.isclass(item[1]) else 99, item[0])):
            if inspect.isclass(value):
                if value in done:
                    self.lines.append(f"\n{name} = {self.classes[value]}")
                    continue
                done.add(value)
                self.classes[value] = name
                self.class_of(name, value)
            elif callable(value):
                self.function(name, value)
            else:
                kind = type(value).__name__
                self.lines.append(f"{name}: {kind if kind in PLAIN else 'Any'}")
        return "\n".join(self.lines) + "\n"


def main():
    sys.path.insert(0, sys.argv[1])
    sys.dont_write_bytecode = True
    import Box2D.b2
    import boxreel
    here = pathlib.Path(__file__).resolve().parent
    (here / "Box2D/__init__.pyi").write_text(HEAD + Writer(Box2D).text(), encoding="utf-8")
    names = [(Box2D.b2._short(full), full) for full in Box2D.__all__ if Box2D.b2._short(full) in Box2D.b2.__all__]
    names += [("error", "b2Error"), ("globals_", "b2Globals"), ("globals", "b2Globals")]
    # Assignments, because an import under another name is not exported.
    (here / "Box2D/b2.pyi").write_text("# Made by python/stubs.py.\nimport Box2D as _box2d\n\n" + "".join(
        f"{short} = _box2d.{full}\n" for short, full in dict(names).items()), encoding="utf-8")
    ours = Writer(boxreel, ("b2World", "b2Body"))
    (here / "boxreel/__init__.pyi").write_text(HEAD + "from Box2D import b2Body, b2World\n" + ours.text(), encoding="utf-8")
    for package in ("Box2D", "boxreel"):
        (here / package / "py.typed").touch()


if __name__ == "__main__":
    main()
