"""What a call does in Python does not grow with the motion, and is little: its time is the program's."""

import collections
import sys

import graze

FILE = "data/scenes/04_impact_oscillator.toml"


def steps(work):
    """Functions of Python and of C that are called within `work`."""
    counted = collections.Counter()
    sys.setprofile(lambda frame, event, argument: counted.update([event]))
    try:
        work()
    finally:
        sys.setprofile(None)
    return counted["call"], counted["c_call"]


def test_a_call_takes_as_many_steps_of_python_whatever_the_motion():
    scene = graze.Scene.load(FILE)
    graze.simulate(scene, periods=20)
    few = steps(lambda: graze.simulate(scene, periods=20))
    assert steps(lambda: graze.simulate(scene, periods=2000)) == few
    # Its one call of the module, its keywords, and the result around what that returns.
    assert sum(few) <= 50, few
