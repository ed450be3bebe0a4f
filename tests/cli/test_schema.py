"""The JSON schema for editors: it takes what yoke takes, and marks what is plainly wrong. Needs python3-jsonschema, python3-yaml."""
import glob
import json
import os
import re
import unittest

import jsonschema
import yaml

from harness import ROOT, Case, Run

# Faults of form, which a schema can see; the others need the meaning of names, units and numbers.
FORM = {200, 201, 202, 206, 207, 208, 210, 211, 215, 216, 217, 400, 450, 451}


class Reader(yaml.SafeLoader):
    """YAML 1.2, as editors read it: only true and false are truth values, so `on` is a key like any other."""


Reader.yaml_implicit_resolvers = {
    letter: [(tag, pattern) for tag, pattern in resolvers if tag != "tag:yaml.org,2002:bool"]
    for letter, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()}
Reader.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile("^(true|false)$"), list("tf"))


class Schema(Case):
    @classmethod
    def setUpClass(cls):
        with open(os.path.join(ROOT, "schema", "yoke.schema.json"), encoding="utf-8") as file:
            schema = json.load(file)
        jsonschema.Draft7Validator.check_schema(schema)
        cls.schema, cls.validator = schema, jsonschema.Draft7Validator(schema)

    def faults(self, path):
        with open(path, encoding="utf-8") as file:
            return [fault.message for fault in self.validator.iter_errors(yaml.load(file, Reader))]

    def test_every_example_passes(self):
        for path in glob.glob(os.path.join(ROOT, "examples", "*.yaml")):
            self.assertEqual(self.faults(path), [], path)

    def test_faults_of_form_are_marked(self):
        seen = set()
        for path in glob.glob(os.path.join(ROOT, "tests", "bad", "E*.yaml")):
            code = int(re.match(r"E(\d+)", os.path.basename(path)).group(1))
            if code in FORM:
                seen.add(code)
                self.assertNotEqual(self.faults(path), [], path)
        self.assertEqual(seen, FORM)

    def test_what_yoke_takes_the_schema_takes(self):
        for path in glob.glob(os.path.join(ROOT, "tests", "fuzz", "corpus", "model", "*")):
            if Run("check", path, "--quiet").code == 0:
                self.assertEqual(self.faults(path), [], path)

    def test_its_keys_are_those_of_the_program(self):
        """Every key of an object of the schema, wrongly spelled, is refused by yoke with the right one as its hint."""
        def keys(node, found):
            if isinstance(node, dict):
                found |= set(node.get("properties", {}) if isinstance(node.get("properties"), dict) else ())
                for value in node.values():
                    keys(value, found)
            elif isinstance(node, list):
                for value in node:
                    keys(value, found)
            return found
        sources = ""
        for path in glob.glob(os.path.join(ROOT, "src", "model", "**", "*.c"), recursive=True) + glob.glob(os.path.join(ROOT, "src", "part", "*.c")):
            with open(path, encoding="utf-8") as file:
                sources += file.read()
        lists = re.findall(r"const char \*const (?:\w*keys|turns|slides)\[\] = \{(.*?)\}", sources, re.S)
        known = set(re.findall(r'"([\w-]+)"', " ".join(lists))) | {"pin", "slide", "pin-slot", "weld", "free", "roller", "arm", "angle", "span"}
        self.assertEqual(keys(self.schema, set()), known)


class TaskSchema(Case):
    def test_every_task_passes_and_mistakes_are_marked(self):
        with open(os.path.join(ROOT, "schema", "task.schema.json"), encoding="utf-8") as file:
            schema = json.load(file)
        jsonschema.Draft7Validator.check_schema(schema)
        validator = jsonschema.Draft7Validator(schema)
        paths = glob.glob(os.path.join(ROOT, "examples", "tasks", "*.yaml"))
        self.assertGreater(len(paths), 6)
        for path in paths:
            with open(path, encoding="utf-8") as file:
                self.assertEqual([fault.message for fault in validator.iter_errors(yaml.load(file, Reader))], [], path)
        for kind in ("motion", "function", "stroke"):
            text = self.good("new", "--task", kind).out
            self.assertEqual([fault.message for fault in validator.iter_errors(yaml.load(text, Reader))], [], kind)
        for wrong in ("name: x", "synthesis: dance", "synthesis: stroke\ncolour: red"):
            self.assertNotEqual(list(validator.iter_errors(yaml.load(wrong, Reader))), [])

    def test_its_keys_are_those_of_the_program(self):
        with open(os.path.join(ROOT, "schema", "task.schema.json"), encoding="utf-8") as file:
            schema = json.load(file)
        with open(os.path.join(ROOT, "src", "synthesis", "tasks", "task.c"), encoding="utf-8") as file:
            keys = re.search(r"const char \*const keys\[\] = \{(.*?)\}", file.read(), re.S).group(1)
        self.assertEqual(set(schema["properties"]), set(re.findall(r'"(\w+)"', keys)))


if __name__ == "__main__":
    unittest.main()
