# SPDX-License-Identifier: MIT
"""The type stubs name what the packages hold, and nothing else."""
import ast
import inspect
import pathlib
import unittest

import Box2D
import Box2D.b2
import boxreel


def stub_of(module, name="__init__"):
    """The statements of the stub beside a package."""
    path = pathlib.Path(module.__file__).with_name(f"{name}.pyi")
    return ast.parse(path.read_text(encoding="utf-8")).body


def names_in(statements):
    """What a stub defines; imports without `as` are for itself."""
    found = set()
    for one in statements:
        if isinstance(one, (ast.ClassDef, ast.FunctionDef)):
            if one.name != "_Settable":  # how the stubs type a property
                found.add(one.name)
        elif isinstance(one, ast.AnnAssign):
            if not one.target.id.startswith("_"):
                found.add(one.target.id)
        elif isinstance(one, ast.Assign):
            found.update(target.id for target in one.targets if not target.id.startswith("_"))
        elif isinstance(one, ast.ImportFrom):
            found.update(alias.asname for alias in one.names if alias.asname == alias.name)  # else not exported
    return found


def names_of(module):
    return {name for name, value in vars(module).items() if not name.startswith("_") and not inspect.ismodule(value)}


class Stubs(unittest.TestCase):
    def test_name_all_that_the_packages_hold(self):
        for module, name in ((Box2D, "__init__"), (boxreel, "__init__"), (Box2D.b2, "b2")):
            with self.subTest(module=module.__name__):
                self.assertEqual(names_in(stub_of(module, name)), names_of(module))

    def test_name_the_members_of_every_class(self):
        for module in (Box2D, boxreel):
            for statement in (one for one in stub_of(module) if isinstance(one, ast.ClassDef) and one.name != "_Settable"):
                one = getattr(module, statement.name)
                if getattr(one, "_fields", None):
                    continue  # of definitions: the fields are no members
                own = {name for name in vars(one) if not name.startswith("_")}
                with self.subTest(name=statement.name):
                    self.assertLessEqual(own, names_in(statement.body))
                    for name in names_in(statement.body):
                        self.assertTrue(hasattr(one, name) or name in ("__getattr__", "__setattr__"), name)

    def test_have_types_and_units(self):
        world = next(one for one in stub_of(Box2D) if isinstance(one, ast.ClassDef) and one.name == "b2World")
        place = next(i for i, one in enumerate(world.body) if isinstance(one, ast.AnnAssign) and one.target.id == "gravity")
        self.assertEqual(ast.unparse(world.body[place].annotation), "_Settable[b2BoundVec2]")
        self.assertIn("[m/s^2]", world.body[place + 1].value.value)


if __name__ == "__main__":
    unittest.main()
