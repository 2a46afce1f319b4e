#!/usr/bin/env python3
"""The known answers through the command line: usage corpus_test.py FROND CORPUS.json."""

import hashlib
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

frond, corpus = sys.argv[1], json.loads(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8"))
faults = []


def rule(case):
    text = case["pred"]
    if "cond" in case:
        text += f" : {case['cond']}"
    text += f" ->({case['prob']}) " if "prob" in case else " -> "
    text += case["succ"]
    return {"rule": text, "limit": case["limit"]} if "limit" in case else text


def grammar(case):
    """A case in the form of a grammar file, field by field."""
    form = {"axiom": case["axiom"], "steps": case["n"], "rules": [rule(r) for r in case["rules"]]}
    for ours, theirs in [("angle", "angle_deg"), ("constants", "constants"), ("ignore", "ignore"), ("ring", "ring"),
                         ("mode", "mode"), ("symbols", "multi_char_symbols"),
                         ("interpretation_depth", "homomorphism_depth")]:
        if theirs in case:
            form[ours] = case[theirs]
    for ours, theirs in [("decomposition", "decomposition"), ("interpretation", "homomorphism")]:
        if theirs in case:
            form[ours] = [rule(r) for r in case[theirs]]
    for name, symbol in case.get("draw_as", {}).items():
        form.setdefault("interpretation", []).append(f"{name} -> {symbol}")
    pull = case.get("turtle_options", {})
    if "tropism" in pull:
        form["tropism"] = {"vector": pull["tropism"], "elasticity": pull["e"]}
    if "start" in case:
        form["length"] = case["start"].get("step", 1)
        form["start"] = {key: value for key, value in case["start"].items() if key in ("position", "heading")}
    if "guide" in case:
        form["guide"] = case["guide"]
    return form


def run(command, form, *options):
    with tempfile.NamedTemporaryFile("w", suffix=".json", encoding="utf-8") as file:
        json.dump(form, file)
        file.flush()
        done = subprocess.run([frond, command, file.name, *options], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def expect(name, what, holds):
    if not holds:
        faults.append(f"{name}: {what}")


def numbers(text):
    return [float(x) for x in re.findall(r"[(,](-?[\d.]+(?:e[+-]?\d+)?)(?=[,)])", text)]


def close(a, b, tolerance):
    return len(a) == len(b) and all(math.isclose(x, y, rel_tol=1e-9, abs_tol=tolerance) for x, y in zip(a, b))


def check_word(case):
    expected, name = case["expected"], case["name"]
    word = run("derive", grammar(case)).rstrip("\n")
    if "names_sha256" in expected:
        names = re.sub(r"\([^()]*\)", "", word)
        expect(name, "names", hashlib.sha256(names.encode()).hexdigest() == expected["names_sha256"])
    if "string" in expected and name != "query-result-shape":  # its string holds the questions, not the answers
        expect(name, "parameters", close(numbers(word), numbers(expected["string"]), expected.get("param_abs_tol", 1e-9)))
    if "counts" in expected:
        lines = run("derive", grammar(case), "--format", "counts").splitlines()
        found = {line.rsplit(" ", 1)[0]: int(line.rsplit(" ", 1)[1]) for line in lines}
        expect(name, f"counts {found}", found == expected["counts"])


def check_turtle(case):
    expected, name = case["expected"], case["name"]
    form = case.get("grammar") or {}
    whole = {**case, **form}
    if "string" in case:
        whole.update(axiom=case["string"], rules=[], n=0)
    found = json.loads(run("turtle", grammar(whole)))
    for key, value in expected.items():
        if key not in found:
            continue
        flat = [y for x in value for y in (x if isinstance(x, list) else [x])] if isinstance(value, list) else [value]
        got = found[key]
        got = [y for x in got for y in (x if isinstance(x, list) else [x])] if isinstance(got, list) else [got]
        expect(name, f"{key} is {got}, not {flat}", close(got, flat, case.get("abs_tol", 1e-6)))


tried = 0
for known in corpus if isinstance(corpus, list) else corpus["cases"]:
    if known["group"] in ("turtle", "data-guided"):
        check_turtle(known)
    elif known["group"] != "stochastic":  # chance has means, not words
        check_word(known)
    else:
        continue
    tried += 1
print("\n".join(faults))
print(f"{tried} cases, {len(faults)} faults")
sys.exit(1 if faults or tried < 90 else 0)
