#!/usr/bin/env python3
"""The extension for Blender is what its platform takes: a complete manifest, and all of it under its licence.

Usage: manifest_test.py ROOT. Blender's own judge, `blender --command extension validate`, comes with 4.2; where there is one in the
path, it is asked, too.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import zipfile

ROOT = pathlib.Path(sys.argv[1])
FOLDER = ROOT / "gen" / "apps" / "blender"
REQUIRED = {"schema_version": str, "id": str, "version": str, "name": str, "tagline": str, "maintainer": str, "type": str,
            "blender_version_min": str, "license": list}
OPTIONAL = {"blender_version_max": str, "website": str, "copyright": list, "tags": list, "platforms": list, "wheels": list,
            "permissions": dict, "build": dict}
PERMISSIONS = {"files", "network", "clipboard", "camera", "microphone"}
PLATFORMS = {"linux-x64", "macos-arm64", "macos-x64", "windows-arm64", "windows-x64"}
TAGS = {"3D View", "Add Curve", "Add Mesh", "Animation", "Bake", "Camera", "Compositing", "Development", "Game Engine",
        "Geometry Nodes", "Grease Pencil", "Import-Export", "Lighting", "Material", "Mesh", "Modeling", "Node", "Object", "Paint",
        "Physics", "Pipeline", "Render", "Rigging", "Scene", "Sculpt", "Sequencer", "System", "Text Editor", "Tracking",
        "User Interface", "UV"}
LICENCE = "GPL-3.0-or-later"


def faults(manifest):
    """What is wrong with a manifest."""
    known = {**REQUIRED, **OPTIONAL}
    for key in REQUIRED.keys() - manifest.keys():
        yield f"{key} is missing"
    for key, value in manifest.items():
        if key not in known:
            yield f"{key} is not known"
        elif not isinstance(value, known[key]) or not value:
            yield f"{key} is {value!r}"
    terse = [("tagline", manifest.get("tagline", ""))] + list(manifest.get("permissions", {}).items())
    for key, words in terse:
        if len(words) > 64 or not words or words != words.strip() or not (words[-1].isalnum() or words[-1] in ")]}"):
            yield f"{key}: {words!r} is longer than 64 characters or ends with a mark"
    for key, pattern in {"schema_version": r"1\.0\.0", "version": r"\d+\.\d+\.\d+", "blender_version_min": r"\d+\.\d+\.\d+",
                         "id": r"[A-Za-z]+(_[A-Za-z0-9]+)*", "type": "add-on|theme"}.items():
        if not re.fullmatch(pattern, str(manifest.get(key))):
            yield f"{key} is {manifest.get(key)!r}"
    for key, allowed in {"permissions": PERMISSIONS, "platforms": PLATFORMS, "tags": TAGS}.items():
        if wrong := set(manifest.get(key, ())) - allowed:
            yield f"{key}: {wrong} are none"
    for words in manifest.get("copyright", ()):
        if not re.fullmatch(r"\d{4}(-\d{4})? \S.*", words):
            yield f"copyright: {words!r} does not begin with a year"
    if manifest.get("license") != [f"SPDX:{LICENCE}"]:
        yield f"license is {manifest.get('license')!r}"


def check():
    with tempfile.TemporaryDirectory() as name:
        archive = pathlib.Path(name, "frond_blender.zip")
        subprocess.run([ROOT / "scripts" / "blender_extension.sh", "-o", archive], check=True, stdout=subprocess.DEVNULL)
        with zipfile.ZipFile(archive) as files:
            texts = {file: files.read(file).decode() for file in files.namelist()}
        assert set(texts) == {"LICENSE", "blender_manifest.toml", *(file.name for file in FOLDER.glob("*.py"))}, set(texts)
        found = list(faults(tomllib.loads(texts["blender_manifest.toml"])))
        assert not found, found
        for file, text in texts.items():
            if file != "LICENSE":
                assert text.startswith(f"# SPDX-License-Identifier: {LICENCE}\n"), file
        assert "GNU GENERAL PUBLIC LICENSE" in texts["LICENSE"] and "Version 3" in texts["LICENSE"]
        judge(archive)


def judge(archive):
    """Blender's own, where it has one."""
    try:
        version = subprocess.run(["blender", "--version"], capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return
    number = re.search(r"Blender (\d+)\.(\d+)", version)
    if number and (int(number[1]), int(number[2])) >= (4, 2):
        subprocess.run(["blender", "--command", "extension", "validate", archive], check=True)
        print("Blender's own validation passed")


def check_faults():
    """What is wrong is found."""
    good = tomllib.loads((FOLDER / "blender_manifest.toml").read_text())
    for key in REQUIRED:
        assert list(faults({k: v for k, v in good.items() if k != key})), key
    for change in ({"tagline": "It ends with a dot."}, {"tagline": "x" * 65}, {"permissions": {"disk": "Write"}}, {"tags": ["Plants"]},
                   {"version": "1.0"}, {"blender_version_min": "4.2"}, {"license": ["SPDX:MIT"]}, {"copyright": ["The authors"]},
                   {"platforms": ["linux"]}, {"id": "frond__blender"}, {"homepage": "x"}, {"permissions": {"files": "Reads."}}):
        assert list(faults({**good, **change})), change


check_faults()
check()
