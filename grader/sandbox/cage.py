"""Runs student code in a sandboxed child process. This file is a script of its own: it does not
import the exercises and holds no key.

``python -I cage.py`` imports what student code may use, then waits for jobs (JSON: cells, givens,
forms, limits). For each job it forks a child, isolates it, and lets it run the cells; the child
sends one line of JSON per problem through a pipe, which is read as data, up to a limit and until a
deadline. Only the parent, which runs no student code, writes to stdout: one reply per job.

The isolation (the "cage"): Linux namespaces (user, mount, pid, network, ipc, uts), a read-only root
with nothing but the interpreter and its libraries, resource limits, an unprivileged user, no
capabilities, no new privileges. Where the kernel refuses namespaces, the child has the resource
limits only and the result says "unsandboxed". Processes that the child leaves running become
children of the parent, which kills them before the next job.
"""

import contextlib
import ctypes
import gc
import importlib
import json
import os
import platform
import re
import resource
import select
import signal
import struct
import sys
import sysconfig
import time

OUTPUT_LIMIT = 2**20  # bytes of the receipts of one submission
LINE_LIMIT = 2**16  # bytes of the receipt of one problem
# of nested lists in a receipt; writing JSON that is nested deeper would exceed the recursion limit
DEPTH = 400
MEMORY = 3 * 2**30
CLONE = {
    "mount": 0x20000,
    "uts": 0x4000000,
    "ipc": 0x8000000,
    "user": 0x10000000,
    "pid": 0x20000000,
    "net": 0x40000000,
}
MS_RDONLY, MS_NOSUID, MS_NODEV, MS_REMOUNT, MS_BIND, MS_REC, MS_PRIVATE = (
    1,
    2,
    4,
    32,
    4096,
    16384,
    1 << 18,
)
PIVOT_ROOT = {"x86_64": 155, "aarch64": 41}
NOBODY = 65534
PRELOAD = (
    "numpy",
    "sympy",
    "mpmath",
    "scipy.linalg",
    "scipy.optimize",
    "scipy.integrate",
    "newton_euler",
    "newton_euler.classroom.answers",
)


class Refused(OSError):
    """The kernel does not allow a namespace or a mount."""


# -- isolation


def _libc():
    return ctypes.CDLL(None, use_errno=True)


def _call(function, *args):
    if function(*args) != 0:
        error = ctypes.get_errno()
        raise Refused(error, os.strerror(error))


def _mount(libc, source, target, kind, flags, data=None):
    text = [x.encode() if isinstance(x, str) else x for x in (source, target, kind, data)]
    _call(libc.mount, text[0], text[1], text[2], ctypes.c_ulong(flags), text[3])


def readable_places():
    """(folders, links) that student code may read: interpreter, installed libraries, engine,
    chapters; never the course or the exercises.
    """
    engine = os.path.dirname(os.path.abspath(importlib.import_module("newton_euler").__file__))
    # in a checkout they are beside the engine
    chapters = importlib.import_module("newton_euler.chapters").__path__
    wanted = [
        engine,
        *chapters,
        "/usr/lib",
        "/usr/lib64",
        "/usr/local/lib",
        "/lib",
        "/lib64",
        "/etc/ld.so.cache",
        "/usr/share/zoneinfo",
    ]
    # not the whole prefixes: /usr and /usr/local also contain /usr/local/share/nbgrader/exchange
    wanted += [
        os.path.join(prefix, lib)
        for prefix in (sys.base_prefix, sys.prefix, sys.base_exec_prefix, sys.exec_prefix)
        for lib in ("lib", "lib64")
    ]
    wanted += [sysconfig.get_path(name) for name in ("stdlib", "platstdlib", "purelib", "platlib")]
    wanted += [
        p
        for p in sys.path
        if os.path.isdir(p) and os.path.basename(p) in ("site-packages", "dist-packages")
    ]
    found = []
    for place in sorted({os.path.realpath(p) for p in wanted if os.path.exists(p)}, key=len):
        if place != "/" and not any(place == f or place.startswith(f + "/") for f in found):
            found.append(place)
    links = [(p, os.path.realpath(p)) for p in wanted if os.path.islink(p)]
    return found, links


def _enter_namespaces(libc):
    root = os.geteuid() == 0
    uid, gid = os.geteuid(), os.getegid()
    kinds = [k for k in CLONE if k != "user" or not root]
    _call(libc.unshare, sum(CLONE[k] for k in kinds))
    if not root:
        for path, text in (
            ("setgroups", "deny"),
            ("uid_map", f"{uid} {uid} 1"),
            ("gid_map", f"{gid} {gid} 1"),
        ):
            with open(f"/proc/self/{path}", "w") as f:
                f.write(text)


def _build_root(libc):
    """Make a new root on tmpfs that contains the readable places and nothing else, and change to
    it.
    """
    places, links = readable_places()
    _mount(libc, None, "/", None, MS_REC | MS_PRIVATE)
    root = _mount_point(places)
    _mount(libc, "cage", root, "tmpfs", MS_NOSUID | MS_NODEV, "size=64m,mode=755")
    os.makedirs(root + "/tmp")  # before the places, since one of them may be in it
    _mount(libc, "scratch", root + "/tmp", "tmpfs", MS_NOSUID | MS_NODEV, "size=64m,mode=1777")
    for place in places:
        target = root + place
        if os.path.isdir(place):
            os.makedirs(target, exist_ok=True)
        else:
            os.makedirs(os.path.dirname(target), exist_ok=True)
            open(target, "w").close()
        _mount(libc, place, target, None, MS_BIND | MS_REC)
        _mount(
            libc,
            None,
            target,
            None,
            MS_BIND | MS_REMOUNT | MS_RDONLY | MS_NOSUID | _kept_flags(place),
        )
    for link, real in links:
        with contextlib.suppress(FileExistsError):
            os.makedirs(os.path.dirname(root + link), exist_ok=True)
            os.symlink(real, root + link)
    for device in ("null", "zero", "urandom"):
        os.makedirs(root + "/dev", exist_ok=True)
        open(f"{root}/dev/{device}", "w").close()
        _mount(libc, f"/dev/{device}", f"{root}/dev/{device}", None, MS_BIND)
    os.makedirs(root + "/.old")
    _call(libc.syscall, PIVOT_ROOT[platform.machine()], root.encode(), (root + "/.old").encode())
    os.chdir("/")
    _call(libc.umount2, b"/.old", 2)
    os.rmdir("/.old")
    _mount(libc, None, "/", None, MS_BIND | MS_REMOUNT | MS_RDONLY | MS_NOSUID | MS_NODEV)
    os.chdir("/tmp")


def _mount_point(places):
    """An existing folder to mount the new root on; it contains none of the places that the new root
    must show.
    """
    for folder in ("/mnt", "/srv", "/media", "/opt", "/var/tmp", "/tmp"):
        if os.path.isdir(folder) and not any(
            p == folder or p.startswith(folder + "/") for p in places
        ):
            return folder
    raise Refused(
        2,
        "no folder to mount the cage on: all of /mnt, /srv, /media, /opt, /var/tmp and /tmp "
        "hold parts of Python",
    )


def _kept_flags(place):
    """The flags of the mount that a remount in a user namespace must keep."""
    flags = os.statvfs(place).f_flag
    return (
        (flags & os.ST_NODEV and MS_NODEV)
        | (flags & os.ST_NOEXEC and 8)
        | (flags & os.ST_NOATIME and 1024)
        | (flags & os.ST_RELATIME and 1 << 21)
    )


def _memory_in_use():
    try:
        with open("/proc/self/statm") as f:
            return int(f.read().split()[0]) * resource.getpagesize()
    except OSError:  # no /proc, as on macOS
        return 0


def _limit(seconds, used):
    for what, value in (
        (resource.RLIMIT_CPU, int(seconds) + 1),
        (resource.RLIMIT_AS, used + MEMORY),
        (resource.RLIMIT_FSIZE, 16 * 2**20),
        (resource.RLIMIT_NOFILE, 64),
        (resource.RLIMIT_NPROC, 64),
        (resource.RLIMIT_CORE, 0),
    ):
        hard = resource.getrlimit(what)[1]
        value = value if hard == resource.RLIM_INFINITY else min(value, hard)
        resource.setrlimit(what, (value, value))


def _drop_privileges(libc, uid):
    linux = sys.platform == "linux"
    for capability in range(64 if linux else 0):
        libc.prctl(24, capability, 0, 0, 0)  # PR_CAPBSET_DROP
    if os.geteuid() == 0:
        os.setgroups([])
        try:
            os.setresgid(uid, uid, uid)
            os.setresuid(uid, uid, uid)
        except OSError:  # few users are mapped, as in some containers
            os.setresgid(NOBODY, NOBODY, NOBODY)
            os.setresuid(NOBODY, NOBODY, NOBODY)
    if linux:
        # the creator of a user namespace has all capabilities in it and could make the mounts
        # writable again
        _call(libc.capset, (ctypes.c_uint32 * 2)(0x20080522, 0), (ctypes.c_uint32 * 6)())
        libc.prctl(38, 1, 0, 0, 0)  # PR_SET_NO_NEW_PRIVS
        libc.prctl(1, signal.SIGKILL, 0, 0, 0)  # PR_SET_PDEATHSIG: die with the parent


def _close_all_but(*kept):
    for fd in range(3, 256):
        if fd not in kept:
            with contextlib.suppress(OSError):
                os.close(fd)


def _caged(job, out, mode_out):
    """In the child: isolate this process, then run the student's cells. Never returns."""
    libc, caged, used = _libc(), job.get("sandbox", True), _memory_in_use()
    null = os.open(os.devnull, os.O_RDWR)
    for fd in (0, 1, 2):
        os.dup2(null, fd)
    _close_all_but(out, mode_out)
    if caged:
        try:
            if platform.machine() not in PIVOT_ROOT:
                raise Refused(0, f"no pivot_root number for {platform.machine()}")
            _enter_namespaces(libc)
        except (OSError, AttributeError) as error:
            caged, job["refused"] = False, str(error)
    # the first child of a new pid namespace is its init: when it dies, the kernel kills all others
    inner = os.fork() if caged else 0
    if inner:
        libc.prctl(1, signal.SIGKILL, 0, 0, 0)
        os.close(out)
        os.close(mode_out)
        os.waitpid(inner, 0)
        os._exit(0)
    if caged:
        try:
            _build_root(libc)
        except OSError as error:
            caged, job["refused"] = False, str(error)
            if job.get("insist"):
                os._exit(3)
    # after the namespaces, since making them would count against the limits
    _limit(job["seconds"], used)
    _drop_privileges(libc, job.get("uid", NOBODY))
    os.write(
        mode_out,
        b"namespaces"
        if caged
        else b"unsandboxed: " + str(job.get("refused", "asked for")).encode()[:200],
    )
    os.close(mode_out)
    try:
        run_cells(job, lambda line: os.write(out, line))
    finally:
        os._exit(0)


# -- running cells


class _TooLong(Exception):
    """A cell ran longer than its time limit."""


def run_cells(job, send):
    """Run the answer cells in order, with common variables, and send the receipt of each problem as
    a line of JSON.
    """
    answers = importlib.import_module("newton_euler.classroom.answers")
    space = {"__name__": "__main__", "__builtins__": __builtins__}
    _run(job.get("setup", ""), space, job["cell_seconds"])
    for problem in job["problems"]:
        forms = {key: answers.Form.read(text) for key, text in problem["forms"].items()}
        for key in forms:
            space.pop(key, None)
        error = _run(problem["givens"], space, job["cell_seconds"]) or _run(
            problem["cell"], space, job["cell_seconds"]
        )
        try:
            signal.setitimer(signal.ITIMER_REAL, job["cell_seconds"])
            read, faults = answers.record(
                forms, problem["symbols"], {key: space.get(key) for key in forms}
            )
        except BaseException as fault:
            read, faults = {}, {key: f"{type(fault).__name__}: {fault}"[:300] for key in forms}
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
        line = json.dumps({"id": problem["id"], "answers": read, "faults": faults, "error": error})
        if len(line) > LINE_LIMIT:
            line = json.dumps(
                {
                    "id": problem["id"],
                    "answers": {},
                    "faults": {},
                    "error": "the answers are too long to be read",
                }
            )
        send(line.encode() + b"\n")


def _run(text, space, seconds):
    """Run one cell; returns the error as a sentence, or None."""

    def too_long(*_):
        raise _TooLong(
            f"the cell ran longer than {seconds:g} s; look for a loop that does not end, or a "
            "simplify on a long formula"
        )

    magics = re.sub(r"(?m)^(\s*)[%!].*$", r"\1pass", text)
    signal.signal(signal.SIGALRM, too_long)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        exec(compile(magics, "<answer>", "exec"), space)
    except SyntaxError as error:
        return f"SyntaxError: {error.msg}, line {error.lineno}: {(error.text or '').strip()}"[:500]
    except BaseException as error:
        line = _line_of(error)
        return f"{type(error).__name__}{line}: {error}"[:500]
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
    return None


def _line_of(error):
    at, line = error.__traceback__, ""
    while at:
        if at.tb_frame.f_code.co_filename == "<answer>":
            line = f", line {at.tb_lineno}"
        at = at.tb_next
    return line


# -- the parent


def _watch(pid, out, mode, seconds):
    """Read what the child sends, up to the limits and the deadline, then kill it and all its
    descendants; returns (data, sandbox, how it ended).
    """
    deadline, data, how, ended = time.monotonic() + seconds, bytearray(), b"", "done"
    open_ends = [out, mode]
    while open_ends:
        left = deadline - time.monotonic()
        ready = select.select(open_ends, [], [], max(left, 0))[0]
        if not ready:
            ended = f"stopped after {seconds:g} s"
            break
        for fd in ready:
            chunk = os.read(fd, 65536)
            if not chunk:
                open_ends.remove(fd)
            elif fd == mode:
                how += chunk[:1000]
            else:
                data += chunk
        if len(data) > OUTPUT_LIMIT:
            ended = f"stopped after {OUTPUT_LIMIT} bytes of output"
            break
    _end(pid)
    return bytes(data), how.decode(errors="replace"), ended


def _adopt_orphans():
    """Make this process the new parent of every descendant whose parent ends, also of daemons."""
    if sys.platform == "linux":
        _libc().prctl(36, 1, 0, 0, 0)  # PR_SET_CHILD_SUBREAPER


def _end(pid):
    """Kill the child and all its descendants, and wait for them."""
    rounds = 0
    while True:
        if rounds == 5:
            _freeze()
        for child in (_children() if rounds < 5 else _descendants()) or [pid]:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.kill(child, signal.SIGKILL)
        try:
            os.waitpid(-1, 0)
        except ChildProcessError:
            return
        rounds += 1


def _freeze():
    """Stop all descendants until none runs that could start another; killing the processes of a
    fork bomb one by one only makes room for more.
    """
    quiet = 0
    while quiet < 3:
        running = [p for p, state in _descendants().items() if state not in "TtZX"]
        for p in running:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.kill(p, signal.SIGSTOP)
        quiet = 0 if running else quiet + 1


def _children():
    try:
        with open(f"/proc/self/task/{os.getpid()}/children") as f:
            return [int(x) for x in f.read().split()]
    except OSError:
        return []


def _descendants():
    """{pid: state} of all descendants of this process."""
    found = {}
    for name in os.listdir("/proc") if os.path.isdir("/proc") else ():
        if name.isdigit():
            with contextlib.suppress(OSError), open(f"/proc/{name}/stat") as f:
                state, parent = f.read().rpartition(")")[2].split()[:2]
                found[int(name)] = (int(parent), state)
    below, level = {}, {os.getpid()}
    while level:
        level = {p for p, (parent, _) in found.items() if parent in level} - set(below)
        below.update((p, found[p][1]) for p in level)
    return below


def _receipts(data):
    """The lines of ``data`` that are receipts. Ids are not checked here but by the grader, which
    knows the problems.
    """
    found = []
    for line in data.split(b"\n"):
        try:
            entry = json.loads(line)
        except (ValueError, RecursionError):
            continue
        if isinstance(entry, dict) and isinstance(entry.get("id"), str) and _is_shallow(entry):
            found.append({k: entry.get(k) for k in ("id", "answers", "faults", "error")})
    return found


def _is_shallow(value):
    level = [value]
    for _ in range(DEPTH):
        level = [
            x
            for v in level
            if isinstance(v, (list, dict))
            for x in (v.values() if isinstance(v, dict) else v)
        ]
        if not level:
            return True
    return False


def run_job(job):
    """Run a job in a sandboxed child; returns {"receipts": [...], "sandbox": how, "ended": how,
    "seconds": elapsed}.
    """
    # a separate user for each worker, so that limits counted by user do not affect other workers
    job = {"uid": 2**20 + os.getpid(), **job}
    out, out_end = os.pipe()
    mode, mode_end = os.pipe()
    start = time.perf_counter()
    pid = os.fork()
    if pid == 0:
        try:
            os.close(out)
            os.close(mode)
            _caged(job, out_end, mode_end)
        finally:
            os._exit(1)
    os.close(out_end)
    os.close(mode_end)
    data, how, ended = _watch(pid, out, mode, job["seconds"])
    os.close(out)
    os.close(mode)
    return {
        "receipts": _receipts(data),
        "sandbox": how or "failed",
        "ended": ended,
        "seconds": round(time.perf_counter() - start, 4),
    }


def main():
    """Import the libraries, then serve jobs: length-prefixed JSON on stdin, length-prefixed JSON on
    stdout.
    """
    for name in PRELOAD:
        importlib.import_module(name)
    sympy = sys.modules["sympy"]
    # what every submission would have to repeat: the first sum imports sympy.tensor, which takes as
    # long as all cells of a notebook together
    x, y = sympy.symbols("x y", real=True)
    str(
        sympy.sqrt(sympy.sin(x) ** 2 / 3 + y * sympy.tan(x) - sympy.Abs(y))
        + sympy.Matrix([x + y, x, sympy.atan2(y, x)]).dot([y, x, 1]) * sympy.cos(x + y)
    )
    _adopt_orphans()
    gc.collect()
    gc.freeze()
    stdin, stdout = sys.stdin.buffer, sys.stdout.buffer
    while header := stdin.read(4):
        job = json.loads(stdin.read(struct.unpack("<I", header)[0]))
        reply = json.dumps(run_job(job)).encode()
        stdout.write(struct.pack("<I", len(reply)) + reply)
        stdout.flush()


if __name__ == "__main__":
    main()
