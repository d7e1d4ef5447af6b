#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Validates SARIF files: against the schema, and what a schema cannot say.

usage: check_sarif.py FILE...
"""
import json
import pathlib
import sys

import jsonschema

SCHEMA = pathlib.Path(__file__).with_name("sarif-2.1.0.schema.json")


def complaints(validator, log):
    for error in validator.iter_errors(log):
        yield f"{'/'.join(map(str, error.absolute_path))}: {error.message}"
    for run in log["runs"]:
        rules = [rule["id"] for rule in run["tool"]["driver"].get("rules", [])]
        if len(set(rules)) != len(rules):
            yield "a rule is listed twice"
        for result in run["results"]:
            index = result.get("ruleIndex", -1)
            if index >= len(rules) or (index >= 0 and rules[index] != result["ruleId"]):
                yield f"ruleIndex {index} is not that of {result['ruleId']}"


def main():
    schema = json.loads(SCHEMA.read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    wrong = 0
    for name in sys.argv[1:]:
        for complaint in complaints(validator, json.loads(pathlib.Path(name).read_text())):
            print(f"{name}: {complaint}")
            wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
