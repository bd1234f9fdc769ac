#!/usr/bin/env python3
"""Decides between two behaviours: the nearer an obstacle is, the less the goal counts; after an alarm it counts little for a while."""
import json
import sys

calm = 1.0
for line in sys.stdin:
    heard = json.loads(line)
    answer = {}
    if "time" in heard:
        activation = {member["name"]: member["activation"] for member in heard["members"]}
        alarm = activation["avoid_obstacle"]
        calm = min(1.0 - alarm, calm + 0.01)
        share = {"avoid_obstacle": 1.0 - calm, "go_to_point": calm}
        answer["weights"] = [share[member["name"]] for member in heard["members"]]
    print(json.dumps(answer), flush=True)
