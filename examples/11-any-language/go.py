#!/usr/bin/env python3
"""Drives to the charger of its team, and around what its lidar sees: a potential field."""
import json
import math
import sys
from typing import Any

KEEPS_AWAY = 0.6  # m
FORCE = 0.05


def drive(now: dict[str, Any]) -> dict[str, float]:
    me, goal = now["self"], now["team"]["charger"]
    bearing = math.atan2(goal["y"] - me["y"], goal["x"] - me["x"]) - me["heading"]
    x, y = math.cos(bearing), math.sin(bearing)
    ranges = now["readings"]["lidar"]["ranges"]
    for i, distance in enumerate(ranges):  # from left to right, 180 degrees
        if distance < KEEPS_AWAY:
            azimuth = math.pi * (0.5 - i / (len(ranges) - 1))
            push = FORCE * (1 / distance - 1 / KEEPS_AWAY)
            x, y = x - push * math.cos(azimuth), y - push * math.sin(azimuth)
    turn = math.atan2(y, x)
    return {"forward": 0.2 * max(0.0, math.cos(turn)), "turn": 3 * turn}


for line in sys.stdin:
    heard = json.loads(line)
    print(json.dumps(drive(heard) if "time" in heard else {}), flush=True)
