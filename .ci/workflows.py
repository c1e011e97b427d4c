#!/usr/bin/env python3
"""Prints the names of the jobs of .ci/run that the workflows start, one a line.

Reading them all also shows that each is valid YAML.
"""

import pathlib

import yaml

names = set()
for path in sorted(pathlib.Path(".github").rglob("*.yml")):
    document = yaml.safe_load(path.read_text(encoding="utf-8"))
    for job in document.get("jobs", {}).values():
        names.update(job.get("strategy", {}).get("matrix", {}).get("job", []))
print("\n".join(sorted(names)))
