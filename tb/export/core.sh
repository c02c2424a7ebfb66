#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# core.sh DIRECTORY...: the FuseSoC description beside each export has the keys that CAPI2 knows, names files that are there
# and modules that are in them. Exit 77 without Python and its YAML.
set -euo pipefail
command -v python3 >/dev/null && python3 -c 'import yaml' 2>/dev/null || exit 77
exec python3 - "$@" <<'END'
import pathlib, re, sys
import yaml

# FuseSoC, fusesoc/capi2/json_schema.py of 2026.
KEYS = {"description", "license", "filesets", "generate", "generators", "name", "parameters", "provider", "scripts",
        "targets", "vpi", "virtual", "mapping"}
FILESET = {"file_type", "logical_name", "tags", "files", "depend"}
TARGET = {"default_tool", "description", "filesets", "parameters", "toplevel", "tools", "flow", "flow_options", "hooks",
          "generate", "vpi", "filters", "flags"}


def check(directory):
    path, = directory.glob("*.core")
    text = path.read_text()
    assert text.startswith("CAPI=2:\n"), "no CAPI=2"
    core = yaml.safe_load(text.split("\n", 1)[1])
    assert set(core) <= KEYS, set(core) - KEYS
    assert re.fullmatch(r"[\w-]+:[\w-]+:[\w-]+:\d+\.\d+\.\d+", core["name"]), core["name"]
    assert core["license"] == "Apache-2.0"
    listed = set()
    for name, fileset in core["filesets"].items():
        assert set(fileset) <= FILESET, name
        listed |= set(fileset["files"])
    there = {each.name for each in directory.iterdir() if each.suffix in (".v", ".vt", ".sdc")}
    assert listed == there, listed ^ there
    rtl = core["filesets"]["rtl"]["files"]
    assert rtl == (directory / (path.stem + ".f")).read_text().split()
    modules = set(re.findall(r"^module (\w+)", "".join((directory / each).read_text() for each in listed if ".v" in each), re.M))
    for name, target in core["targets"].items():
        assert set(target) <= TARGET, name
        for used in target["filesets"]:
            assert re.fullmatch(r"is_toplevel\? \((\w+)\)|(\w+)", used), used
            assert re.sub(r".*\((\w+)\)", r"\1", used) in core["filesets"], used
        assert target["toplevel"] in modules, target["toplevel"]
        assert set(target.get("parameters", [])) <= set(core.get("parameters", {}))
    assert {"default", "lint", "synth"} <= set(core["targets"])
    assert core["targets"]["default"]["filesets"][0] == "rtl"


for each in sys.argv[1:]:
    try:
        check(pathlib.Path(each))
    except AssertionError as error:
        sys.exit(f"{each}: {error}")
END
