# SPDX-License-Identifier: MIT
"""Each member of a C++ definition and each setting of the C++ world has its counterpart in Python."""
import pathlib
import re
import unittest

import Box2D

HEADERS = pathlib.Path(__file__).resolve().parents[2] / "engine/include/Box2D"
# Set by the class of the definition, or by Python.
NOT_GIVEN = {"b2JointDef": {"type", "userData"}, "b2BodyDef": {"userData"}, "b2FixtureDef": {"userData"}}
# Callbacks have other names in Python: SetRenderer, and the listeners are properties.
NO_SETTING = {"DestructionListener", "ContactFilter", "ContactListener", "DebugDraw"}
# Names of pybox2d in their place: SetMotorEnabled, SetMaxMotorForce.
OTHER_NAMES = {"EnableLimit": "SetLimitEnabled", "EnableMotor": "SetMotorEnabled", "SetMotorForce": "SetMaxMotorForce"}


def members_in(text):
    """Definitions and their data members: statements of a struct that are no functions."""
    text = re.sub(r"//.*", "", text)
    for struct, body in re.findall(r"^struct (b2\w+Def)\b[^;{]*\{\n(.*?)^\};", text, re.M | re.S):
        body = re.sub(r"\)[^;{}]*\{[^}]*\}", ");", body)  # functions without their bodies
        statements = (re.sub(r"[={].*", "", one, flags=re.S).strip() for one in body.split(";"))
        yield struct, {re.search(r"\w+$", one)[0] for one in statements if one and "(" not in one}


def definitions():
    found = {}
    for header in sorted((HEADERS / "Dynamics").rglob("*.h")):
        found.update(members_in(header.read_text(encoding="utf-8")))
    return found


class Counterparts(unittest.TestCase):
    def test_definitions_have_all_members(self):
        found = definitions()
        self.assertEqual(len([name for name in found if name.endswith("JointDef")]), 12)
        self.assertIn("maxMotorTorque", found["b2RevoluteJointDef"])
        for name, members in found.items():
            with self.subTest(name):
                self.assertTrue(members)
                self.assertEqual(members - NOT_GIVEN.get(name, set()) - set(getattr(Box2D, name)._fields), set())

    def test_the_world_has_all_settings(self):
        text = (HEADERS / "Dynamics/b2World.h").read_text(encoding="utf-8")
        settings = set(re.findall(r"^    void Set(\w+)\(", text, re.M)) & set(re.findall(r"\bGet(\w+)\(", text))
        self.assertIn("RestitutionThreshold", settings)
        for name in settings - NO_SETTING:
            with self.subTest(name):
                self.assertIn(name[0].lower() + name[1:], dir(Box2D.b2World))
                self.assertIn("Set" + name, dir(Box2D.b2World))

    def test_joints_have_all_functions(self):
        for header in sorted((HEADERS / "Dynamics/Joints").glob("b2*Joint.h")):
            name = header.stem
            text = header.read_text(encoding="utf-8")
            public = text[text.index(f"class {name}"):].partition("\nprotected:")[0]
            for function in re.findall(r"^    void (Set\w+|Enable\w+)\(", public, re.M):
                with self.subTest(f"{name}.{function}"):
                    known = dir(getattr(Box2D, name))
                    self.assertTrue(function in known or OTHER_NAMES.get(function) in known)


if __name__ == "__main__":
    unittest.main()
