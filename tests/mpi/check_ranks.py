#!/usr/bin/env python3
"""graze-mpi against the program: the same bytes for any number of ranks and after any kill.

    python3 tests/mpi/check_ranks.py GRAZE GRAZE_MPI SCENES FOLDER [KILLS]

GRAZE and GRAZE_MPI are the programs, SCENES is data/scenes, FOLDER is made anew; KILLS (default 100)
is how often a rank or the whole job is killed. Needs mpirun. Exit 1 where something differs.
"""
import itertools
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import time

GRAZE, GRAZE_MPI, SCENES, FOLDER = (pathlib.Path(word).resolve() for word in sys.argv[1:5])
KILLS = int(sys.argv[5]) if len(sys.argv) > 5 else 100
failures = 0
locked_up = 0  # how often mpirun did not end, though all its ranks had

BEAM = str(SCENES / "05_wagg_one_mode.toml")
BALL = str(SCENES / "06_bouncing_ball.toml")
FREQUENCY = ["--parameter", "forcing.frequency", "--from", "15", "--to", "120"]
GAP = ["--second", "stop.gap", "--second-from", "0.5e-3", "--second-to", "2e-3"]
WORK = {
    "sweep": ["diagram", BEAM, *FREQUENCY, "--points", "300", "--branches", "none"],
    "sweep_down": ["diagram", BEAM, *FREQUENCY, "--points", "150", "--direction", "down"],
    "balls": ["diagram", BALL, "--duration", "3", "--parameter", "stop.restitution", "--from", "0",
              "--to", "0.8", "--points", "17"],
    "map": ["map", BEAM, *FREQUENCY, "--points", "40", *GAP, "--second-points", "30"],
    "comparison": ["compare", BEAM, "--against", "stop.restitution=0.5", *FREQUENCY, "--points",
                   "12", *GAP, "--second-points", "9"],
}


def note(good, sentence):
    global failures
    if not good:
        failures += 1
        print("FAILED: " + sentence, flush=True)


def mpirun(ranks, *options):
    return ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), *options,
            str(GRAZE_MPI)]


def run(command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=600,
                          **options)


def kept(folder):
    """What a run leaves but for the journal and the first line of record.json, which tells how the
    program was called."""
    files = {}
    for file in sorted(folder.iterdir()):
        if file.suffix == ".journal":
            continue
        content = file.read_bytes()
        files[file.name] = content.partition(b"\n")[2] if file.name == "record.json" else content
    return files


def note_same(folder, name, what):
    ours, theirs = kept(folder), kept(FOLDER / name)
    note(len(theirs) > 3 and ours.keys() == theirs.keys(), f"{what}: files {sorted(ours)}")
    for file, content in theirs.items():
        note(ours.get(file) == content, f"{what}: {file} differs")


def ranks_of(job):
    """The processes of the ranks on this machine, children of mpirun."""
    ranks = []
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            after_name = (entry / "stat").read_text().rpartition(")")[2].split()
            if int(after_name[1]) == job.pid and after_name[0] != "Z":
                ranks.append(int(entry.name))
        except (OSError, IndexError):
            pass
    return sorted(ranks)


def kill(process, number):
    try:
        os.kill(process, number)
    except ProcessLookupError:
        pass


def is_there(process):
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def check_numbers_of_ranks():
    for name, work in WORK.items():
        whole = run([str(GRAZE), *work, "--quiet", "--json", "--out", str(FOLDER / name)])
        note(whole.returncode == 0, f"{name}: {whole.stderr}")
        for ranks in (1, 2, 3, 8) if name != "map" else range(1, 9):
            out = FOLDER / f"{name}_{ranks}"
            shared = run([*mpirun(ranks), *work, "--quiet", "--json", "--out", str(out)])
            what = f"{name} by {ranks} ranks"
            note(shared.returncode == 0, f"{what}: {shared.returncode} {shared.stderr}")
            note(shared.stdout == whole.stdout, f"{what}: what is printed differs")
            note_same(out, name, what)
        # Without a folder, and with threads of each rank.
        shared = run([*mpirun(2, "--bind-to", "none"), *work, "--quiet", "--json", "--threads", "2"])
        note(shared.stdout == whole.stdout and shared.returncode == 0,
             f"{name} by 2 ranks of 2 threads: what is printed differs")
        print(f"{name}: the same bytes by 1 to 8 ranks", flush=True)


def check_shares():
    out = FOLDER / "shares"
    for part in (1, 2):
        share = run([*mpirun(3), *WORK["sweep"], "--quiet", "--shard", f"{part}/2", "--out", str(out)])
        note(share.returncode == 0, f"share {part}/2 by 3 ranks: {share.stderr}")
    merged = run([str(GRAZE), "merge", str(out), "--quiet", "--out", str(FOLDER / "merged")])
    note(merged.returncode == 0, f"merge: {merged.stderr}")
    note_same(FOLDER / "merged", "sweep", "shares by 3 ranks, merged")


def start(command):
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def killed(job, seconds, choice):
    """Whether the job was killed before its end: a rank, all of them, or mpirun, which is asked to
    end or killed."""
    time.sleep(seconds)
    ranks = ranks_of(job)
    if job.poll() is not None:
        return False
    if choice == "a rank" and ranks:
        kill(random.choice(ranks), signal.SIGKILL)
    elif choice == "the first rank" and ranks:
        kill(ranks[0], signal.SIGKILL)
    elif choice == "all ranks":
        for rank in ranks:
            kill(rank, signal.SIGKILL)
    elif choice == "mpirun":
        kill(job.pid, signal.SIGKILL)
    else:
        kill(job.pid, signal.SIGTERM)
    until = time.monotonic() + 60
    while any(is_there(rank) for rank in ranks) and time.monotonic() < until:
        time.sleep(0.02)
    note(not any(is_there(rank) for rank in ranks), f"{choice} killed: ranks are still there")
    try:
        return job.wait(timeout=20) != 0
    except subprocess.TimeoutExpired:
        # Open MPI's own end can lock itself up (in PMIx_server_finalize) once all ranks are gone.
        job.kill()
        job.wait()
        global locked_up
        locked_up += 1
        return True


def lines_in(journal):
    return journal.read_bytes().count(b"\n") if journal.exists() else 0


def check_kills():
    random.seed(1)
    choices = itertools.cycle(["a rank", "the first rank", "a rank", "all ranks", "a rank", "mpirun",
                               "a rank", "mpirun, asked"])
    names = itertools.cycle(["map", "sweep", "comparison"])
    kills = dict.fromkeys(["a rank", "the first rank", "all ranks", "mpirun", "mpirun, asked"], 0)
    ends = 0
    while sum(kills.values()) < KILLS:
        name = next(names)
        out = FOLDER / "killed"
        shutil.rmtree(out, ignore_errors=True)
        journal = out / "rows.journal"
        had, bare = 0, 0.2
        for turn in itertools.count():
            command = [*WORK[name], "--quiet", "--resume", "--out", str(out)]
            choice = next(choices)
            job = start([*mpirun(random.randint(2, 8)), *command])
            was_killed = killed(job, random.uniform(bare, bare + 1.5), choice)
            kills[choice] += was_killed
            note(lines_in(journal) >= had, f"{name}: the journal was {had} lines long, and lost some")
            had = lines_in(journal)
            if job.returncode == 0 or turn == 6 or sum(kills.values()) >= KILLS:
                break
        # Ranks or the program by itself finish what was left.
        by = [str(GRAZE)] if random.random() < 0.5 else mpirun(random.randint(2, 8))
        rest = run([*by, *command])
        note(rest.returncode == 0, f"{name} after kills: {rest.returncode} {rest.stderr}")
        note_same(out, name, f"{name} after {turn} kills")
        ends += 1
        print(f"{sum(kills.values())} kills", flush=True)
    print(f"{sum(kills.values())} kills ({kills}) in {ends} runs, and the same bytes in the end; "
          f"mpirun locked itself up {locked_up} times", flush=True)


def check_endings():
    """Exit codes are the program's, and what is wrong is told once."""
    cases = [
        (["map", BEAM, *FREQUENCY], 2, b"--second NAME"),
        (["map", BEAM, *FREQUENCY, *GAP, "--plot", "x.bad"], 2, b"x.bad"),
        (["diagram", "no_such.toml", *FREQUENCY], 4, b"no_such.toml"),
        (["simulate", BEAM], 2, b"no blocks for 3 ranks to share"),
        (["compare", BEAM, "--modes", "1:2"], 2, b"no blocks for 3 ranks to share"),
        ([*WORK["map"], "--max-seconds", "0.05"], 3, b""),
    ]
    for arguments, code, words in cases:
        ended = run([*mpirun(3), *arguments])
        note(ended.returncode == code, f"{arguments}: {ended.returncode} in place of {code}")
        note(words == b"" or ended.stderr.count(words) == 1, f"{arguments}: {ended.stderr}")
    # Two jobs cannot write one journal.
    out = FOLDER / "locked"
    slow = ["map", BEAM, *FREQUENCY, "--points", "400", *GAP, "--second-points", "300", "--quiet",
            "--out", str(out)]
    job = start([*mpirun(2), *slow])
    while lines_in(out / "rows.journal") < 20:
        time.sleep(0.05)
    second = run([*mpirun(2), *slow])
    note(second.returncode == 4 and second.stderr.count(b"another run is writing") == 1,
         f"a second job in the folder: {second.returncode} {second.stderr}")
    # Interrupted as by Ctrl-C or a batch system that signals every rank: 130, and what was done stands.
    for rank in ranks_of(job):
        kill(rank, signal.SIGINT)
    code = job.wait(timeout=60)
    note(code == 130, f"interrupted: {code} in place of 130")
    note((out / "result.json").exists() and b"interrupted" in (out / "result.json").read_bytes(),
         "interrupted: no result of what was finished")
    # One rank alone is asked to end.
    job = start([*mpirun(3), *slow, "--resume"])
    time.sleep(1.5)
    kill(ranks_of(job)[-1], signal.SIGTERM)
    code = job.wait(timeout=60)
    note(code == 130, f"the last rank asked to end: {code} in place of 130")
    print("exit codes and sentences are the program's", flush=True)


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    check_numbers_of_ranks()
    check_shares()
    check_endings()
    check_kills()
    return 1 if failures else 0


sys.exit(main())
