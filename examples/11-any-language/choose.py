#!/usr/bin/env python3
"""Decides between two behaviours: who avoids has the wheels while it is much more active than usual, else both have a part."""
import json
import sys

for line in sys.stdin:
    heard = json.loads(line)
    answer = {}
    if "time" in heard:
        activation = {member["name"]: member["activation"] for member in heard["members"]}
        alarm = activation["avoid_obstacle"]
        share = {"avoid_obstacle": alarm, "go_to_point": 0.0 if alarm > 0.5 else 1.0 - alarm}
        answer["weights"] = [share[member["name"]] for member in heard["members"]]
    print(json.dumps(answer), flush=True)
