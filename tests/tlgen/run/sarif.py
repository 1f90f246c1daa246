"""Holds a SARIF file against what version 2.1.0 requires of it, and prints a line per result: LEVEL ID FILE LINE COLUMN.

sarif.py FILE
"""
import json
import sys
from urllib.parse import unquote

LEVELS = {"none", "note", "warning", "error"}


def want(condition, what):
    if not condition:
        sys.exit(f"{sys.argv[1]}: {what}")


with open(sys.argv[1], encoding="utf-8") as file:
    log = json.load(file)
want(log.get("version") == "2.1.0", "version is not 2.1.0")
want(log.get("$schema", "").endswith("sarif-2.1.0.json"), "$schema is not that of 2.1.0")
want(isinstance(log.get("runs"), list) and len(log["runs"]) == 1, "runs is not a list of one")
run = log["runs"][0]
driver = run["tool"]["driver"]
want(driver.get("name") == "tlgen" and driver.get("version"), "the driver has no name or version")
rules = driver["rules"]
want(len({rule["id"] for rule in rules}) == len(rules) > 0, "rules without or with the same id")
for rule in rules:
    want(rule["shortDescription"]["text"] and rule["help"]["text"], f"rule {rule['id']} says nothing")
    want(rule["defaultConfiguration"]["level"] in LEVELS, f"rule {rule['id']} has another level")
for invocation in run["invocations"]:
    want(isinstance(invocation["executionSuccessful"], bool), "executionSuccessful is not a boolean")
want(isinstance(run["results"], list), "results is not a list")
for result in run["results"]:
    want(rules[result["ruleIndex"]]["id"] == result["ruleId"], "ruleIndex is not that of ruleId")
    want(result["level"] in LEVELS, "level")
    want(result["message"]["text"], "a message without a text")
    want(isinstance(result["locations"], list), "locations is not a list")
    place = [""]
    for location in result["locations"]:
        physical = location["physicalLocation"]
        uri = physical["artifactLocation"]["uri"]
        want(uri and " " not in uri, "a uri that is none")
        place = [unquote(uri)]
        if "region" in physical:
            region = physical["region"]
            want(region["startLine"] >= 1 and region["startColumn"] >= 1, "a region counts from 1")
            place += [str(region["startLine"]), str(region["startColumn"])]
    print(result["level"], result["ruleId"], *place)
want(run["invocations"][0]["executionSuccessful"] == all(r["level"] != "error" for r in run["results"]), "executionSuccessful")
