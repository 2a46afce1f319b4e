"""Judges an Open Job Description template and a job of OpenCue by their rules, and then does what they say.

Usage: job_files.py TEMPLATE.json JOB.xml

Rules: the template schema of Open Job Description 2023-09, and the order of elements that CJSL 1.15 asks for. The steps of the
template are run in their order, then the commands of the XML, which find all done already.
"""

import json
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,63}")
RANGE = re.compile(r"\d+(-\d+)?(,\d+(-\d+)?)*")
EXPRESSION = re.compile(r"\{\{ *([\w.]+) *\}\}")


def expect(condition, what):
    if not condition:
        sys.exit(f"job_files.py: {what}")


def keys(thing, needed, allowed=()):
    expect(set(needed) <= set(thing) <= set(needed) | set(allowed), f"members {sorted(thing)}")


def numbers(text):
    expect(RANGE.fullmatch(text), f"range {text}")
    for part in text.split(","):
        first, _, last = part.partition("-")
        yield from range(int(first), int(last or first) + 1)


def filled(text, values):
    for name in EXPRESSION.findall(text):
        expect(name in values, f"expression {name}")
    rest = EXPRESSION.sub("", text)
    expect("{{" not in rest and "}}" not in rest, f"braces in {text}")
    return EXPRESSION.sub(lambda match: str(values[match.group(1)]), text)


def check_step(step, names):
    keys(step, ["name", "script"], ["description", "dependencies", "parameterSpace", "hostRequirements"])
    expect(1 <= len(step["name"]) <= 64 and step["name"] not in names, "name of a step")
    for dependency in step.get("dependencies", []):
        keys(dependency, ["dependsOn"])
        expect(dependency["dependsOn"] in names, "dependency")
    keys(step["hostRequirements"], [], ["amounts", "attributes"])
    for amount in step["hostRequirements"]["amounts"]:
        keys(amount, ["name"], ["min", "max"])
        expect(amount["name"] in ("amount.worker.vcpu", "amount.worker.memory") and amount["min"] > 0, "amount")
    for attribute in step["hostRequirements"]["attributes"]:
        keys(attribute, ["name", "anyOf"])
    keys(step["script"], ["actions"], ["embeddedFiles"])
    keys(step["script"]["actions"], ["onRun"])
    action = step["script"]["actions"]["onRun"]
    keys(action, ["command"], ["args", "timeout", "cancelation"])
    expect(isinstance(action["timeout"], int) and action["timeout"] == 7 * 60, "timeout")
    cancelation = action["cancelation"]
    keys(cancelation, ["mode"], ["notifyPeriodInSeconds"])
    expect(cancelation["mode"] == "NOTIFY_THEN_TERMINATE" and 1 <= cancelation["notifyPeriodInSeconds"] <= 600, "cancelation")
    return action


def tasks_of(step):
    if "parameterSpace" not in step:
        return [{}]
    keys(step["parameterSpace"], ["taskParameterDefinitions"], ["combination"])
    (definition,) = step["parameterSpace"]["taskParameterDefinitions"]
    keys(definition, ["name", "type", "range"])
    expect(NAME.fullmatch(definition["name"]) and definition["type"] == "INT", "task parameter")
    return [{"Task.Param." + definition["name"]: number} for number in numbers(definition["range"])]


def run_template(path):
    with open(path, encoding="utf-8") as file:
        template = json.load(file)
    keys(template, ["specificationVersion", "name", "steps"], ["description", "parameterDefinitions"])
    expect(template["specificationVersion"] == "jobtemplate-2023-09", "version")
    expect(1 <= len(filled(template["name"], {})) <= 128, "name")
    values = {}
    for parameter in template["parameterDefinitions"]:
        keys(parameter, ["name", "type"], ["default", "description"])
        expect(NAME.fullmatch(parameter["name"]) and parameter["type"] == "STRING", "parameter")
        expect(len(parameter["default"]) <= 1024, "default")
        values["Param." + parameter["name"]] = parameter["default"]
    names = set()
    for step in template["steps"]:
        action = check_step(step, names)
        names.add(step["name"])
        for task in tasks_of(step):
            words = [filled(word, {**values, **task}) for word in [action["command"], *action["args"]]]
            subprocess.run(words, check=True)


# What stands in what, in this order; those with a question mark may be left out.
CHILDREN = {
    "spec": "facility? dept? show shot user email? uid? job depends",
    "job": "paused? priority? maxretries? maxcores? autoeat? os? env? layers",
    "layers": "layer layer",
    "layer": "cmd range chunk cores? threadable? memory? timeout? tags? env? services?",
    "services": "service",
    "depends": "depend",
    "depend": "depjob deplayer? depframe? onjob onlayer? onframe?",
}
ATTRIBUTES = {"job": {"name"}, "layer": {"name", "type"}, "depend": {"type", "anyframe"}}


def check_element(element):
    expect(set(element.attrib) == ATTRIBUTES.get(element.tag, set()), f"attributes of {element.tag}")
    words = CHILDREN.get(element.tag, "").split()
    rule = "".join(f"({word[:-1]} )?" if word.endswith("?") else word + " " for word in words)
    found = "".join(child.tag + " " for child in element)
    expect(re.fullmatch(rule, found), f"{element.tag} holds {found}")
    for child in element:
        check_element(child)


def run_cue(path):
    with open(path, encoding="utf-8") as file:
        expect('<!DOCTYPE spec PUBLIC "SPI Cue Specification Language"' in file.read(), "document type")
    spec = ElementTree.parse(path).getroot()
    check_element(spec)
    expect(spec.tag == "spec" and spec.find("show").text == "a<b", "show")
    expect(re.fullmatch(r"[\w.:-]+", spec.find("job").get("name")), "name of the job")
    layers = {layer.get("name"): layer for layer in spec.iter("layer")}
    depend = spec.find("depends/depend")
    expect(depend.get("type") == "LAYER_ON_LAYER", "type of the dependency")
    expect([depend.find("deplayer").text, depend.find("onlayer").text] == ["film", "render"], "dependency")
    for layer in layers.values():
        expect(layer.get("type") in ("Render", "Util", "Post"), "type of a layer")
        expect(re.fullmatch(r"\d+[mg]", layer.find("memory").text), "memory")
        for number in numbers(layer.find("range").text):
            subprocess.run(["sh", "-c", layer.find("cmd").text.replace("#IFRAME#", str(number))], check=True)


run_template(sys.argv[1])
run_cue(sys.argv[2])
