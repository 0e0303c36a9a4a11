"""What could not be done comes with what was reached; Ctrl-C ends the work; progress is told."""

import os
import signal
import threading
import time

import graze
import pytest


def test_no_orbit_is_a_numerics_error():
    with pytest.raises(graze.NumericsError) as caught:
        graze.orbit("data/scenes/05_wagg_one_mode.toml", set={"stop.gap": 1.0})
    assert caught.value.result.document["outcome"] == caught.value.result.outcome == "none"
    # Options are keywords here.
    assert str(caught.value) == caught.value.result.message.replace("--", "")


def test_a_budget_comes_with_what_was_reached(oscillator):
    with pytest.raises(graze.NumericsError) as caught:
        graze.simulate(oscillator, periods=1000, max_impacts=10)
    assert 0 < caught.value.result.events.rows <= 10
    started = time.monotonic()
    with pytest.raises(graze.NumericsError):
        graze.simulate(oscillator, periods=10**9, record="none", max_seconds=0.3)
    assert 0.2 < time.monotonic() - started < 5.0


def test_time_is_counted_for_each_call(oscillator):
    for _ in range(3):
        time.sleep(0.4)
        graze.simulate(oscillator, periods=3, max_seconds=0.3)


def interrupted_after(seconds, work):
    timer = threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    started = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt) as caught:
            work()
        return caught.value, time.monotonic() - started
    finally:
        timer.cancel()


def test_control_c_ends_the_work_and_keeps_what_was_reached(oscillator):
    error, seconds = interrupted_after(
        0.5, lambda: graze.simulate(oscillator, periods=10**9, record="none")
    )
    assert 0.4 < seconds < 5.0 and error.result.outcome == "interrupted"
    # The next call is not concerned.
    assert graze.simulate(oscillator, periods=3).outcome == "reached_end"


def test_control_c_ends_a_sweep(oscillator):
    error, seconds = interrupted_after(
        0.5, lambda: graze.diagram(oscillator, parameter="stop.gap", from_=0.0, to=0.5, points=100_000,
                                   branches="none")
    )
    assert seconds < 5.0 and error.result.outcome == "interrupted"


def test_control_c_ends_a_continuation():
    def slow(u, p):
        time.sleep(1e-3)
        return u**2 + p**2 - 1.0

    _, seconds = interrupted_after(0.3, lambda: graze.continuation(
        slow, 0.9, 0.1, from_=-2, to=2, max_step=1e-5, max_distance=1e-5))
    assert seconds < 3.0


def test_other_threads_of_python_go_on(oscillator):
    counted = []
    done = threading.Event()

    def count():
        while not done.is_set():
            counted.append(1)
            time.sleep(0.01)

    thread = threading.Thread(target=count)
    thread.start()
    with pytest.raises(graze.NumericsError):
        graze.simulate(oscillator, periods=10**9, record="none", max_seconds=0.5)
    done.set()
    thread.join()
    assert len(counted) > 10


def test_calls_of_several_threads_do_not_meet(oscillator):
    expected = graze.simulate(oscillator, periods=50).to_json()
    found = []
    threads = [
        threading.Thread(target=lambda: found.append(graze.simulate(oscillator, periods=50).to_json()))
        for _ in range(8)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * 8


def test_progress_is_told(oscillator, capfd):
    told = []
    with pytest.raises(graze.NumericsError):
        graze.simulate(oscillator, periods=10**9, record="none", max_seconds=0.5, progress=told.append)
    assert told and all(0.0 <= part <= 1.0 for part in told) and told == sorted(told)
    graze.simulate(oscillator, periods=3, progress=True)
    assert "100 %" in capfd.readouterr().err

    def raises(part):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough") as caught:
        graze.simulate(oscillator, periods=10**9, record="none", max_seconds=20, progress=raises)
    assert caught.value.result.outcome == "interrupted"


def test_a_forked_process_and_a_call_within_a_call_go_on(oscillator):
    def found_in_cells():
        return graze.map(
            oscillator, parameter="forcing.frequency", from_=2.7, to=2.72, second="stop.gap",
            second_from=0.0, second_to=0.02, points=4, second_points=4, periods=20,
        ).to_json()

    expected, cells = graze.simulate(oscillator, periods=50).to_json(), found_in_cells()
    child = os.fork()
    if child == 0:
        same = graze.simulate(oscillator, periods=50).to_json() == expected
        same = same and found_in_cells() == cells
        os._exit(0 if same else 1)
    assert os.waitpid(child, 0)[1] == 0
    found = []
    with pytest.raises(graze.NumericsError):
        graze.simulate(
            oscillator, periods=10**9, record="none", max_seconds=0.3,
            progress=lambda part: found.append(graze.simulate(oscillator, periods=50).to_json()),
        )
    assert set(found) == {expected}
